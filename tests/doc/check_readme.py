"""The README shows the examples that are tested, names every function of the library, and points at files that exist.

usage: check_readme.py TOP_FOLDER
"""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cmake/interface"))

import header  # noqa: E402 - from the project


def code_blocks(text, language):
    return re.findall(rf"^```{language}\n(.*?)^```$", text, flags=re.MULTILINE | re.DOTALL)


NAME = r"`(nurbs_[a-z\d_]+)`"


def named_functions(text):
    """Those in a line behind "`nurbs_X_with` for" are named with this second form."""
    forms = " ".join(re.findall(r"`nurbs_X_with` for(.*)", text))
    return {*re.findall(NAME, text), *(f"{name}_with" for name in re.findall(NAME, forms))}


def linked_files(text):
    return [target for target in re.findall(r"\]\(([^)#]+)\)", text) if "://" not in target]


def problems(top):
    text = (top / "README.md").read_text(encoding="utf-8")
    for language, name in (("c", "readme.c"), ("python", "readme.py")):
        if code_blocks(text, language) != [(top / "capi/examples" / name).read_text(encoding="utf-8")]:
            yield f"the {language} program of the README is not capi/examples/{name}"
    manual = header.read(top)
    functions = [function.name for function in manual.functions]
    types = {*manual.handles, *manual.aliases, *manual.callbacks, *(struct.name for struct in manual.structs)}
    for name in functions:
        if name not in named_functions(text):
            yield f"{name} is not mentioned"
    for name in named_functions(text) - set(functions) - types:
        yield f"{name} is mentioned but does not exist"
    for target in linked_files(text):
        if not (top / target).exists():
            yield f"the link to {target} leads nowhere"


def main():
    messages = list(problems(Path(sys.argv[1])))
    print("\n".join(messages) or "the README agrees with the tree")
    return 1 if messages else 0


if __name__ == "__main__":
    sys.exit(main())
