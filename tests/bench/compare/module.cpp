#include "bench/compare/module.h"

#include <dlfcn.h>
#include <stdexcept>

namespace bench {

namespace {

template <class Function>
Function *symbol(void *module, const char *name) {
    void *const found = dlsym(module, name);
    if (found == nullptr) {
        throw std::runtime_error(std::string("no function ") + name);
    }
    return reinterpret_cast<Function *>(found);
}

} // namespace

Module::Module(const std::filesystem::path &path, bool apart) {
    // Never closed: it lives as long as the program.
    void *const module =
        apart ? dlmopen(LM_ID_NEWLM, path.c_str(), RTLD_NOW) : dlopen(path.c_str(), RTLD_NOW);
    if (module == nullptr) {
        throw std::runtime_error(dlerror());
    }
    open_ = symbol<bench_open_function>(module, "bench_open");
    name_ = symbol<bench_name_function>(module, "bench_name");
    prepare_ = symbol<bench_prepare_function>(module, "bench_prepare");
    run_ = symbol<bench_run_function>(module, "bench_run");
}

std::vector<std::string> families() {
    return {"points", "operations", "queries"};
}

std::filesystem::path module_path(const std::filesystem::path &folder, const std::string &family) {
    return folder / ("bench_rows_" + family + ".so");
}

} // namespace bench
