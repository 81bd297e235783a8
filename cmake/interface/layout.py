# SPDX-License-Identifier: MIT
"""How the lines of generated files are broken."""

import textwrap


def comment(prefix, text, width):
    """Lines of a comment."""
    return textwrap.wrap(" ".join(text.split()), width, initial_indent=prefix, subsequent_indent=prefix,
                         break_long_words=False, break_on_hyphens=False)


def with_comment(line, mark, text, width):
    """A line with a comment behind it, or before it where that would be too long; as lines."""
    joined = f"{line}  {mark} {text}"
    if not text or len(joined) <= width:
        return [joined if text else line]
    indent = line[:len(line) - len(line.lstrip())]
    return [*comment(f"{indent}{mark} ", text, width), line]
