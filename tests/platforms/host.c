/* A host for Windows and Unix: loads a library of an FMU of FMI 2.0, takes steps, saves and restores, and prints outputs.
 *
 *     host LIBRARY GUID RESOURCES STEP COUNT REFERENCE...
 *
 * One line per step with the values of the real variables REFERENCE; the last line, after going back to the middle, must
 * be the last line of the way there. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef _WIN32
#include <windows.h>
typedef HMODULE Library;
typedef FARPROC Function;
#else
#include <dlfcn.h>
typedef void *Library;
typedef void *Function;
#define LoadLibraryA(path) dlopen(path, RTLD_NOW | RTLD_LOCAL)
#define GetProcAddress dlsym
#define FreeLibrary dlclose
#define GetLastError() (fputs(dlerror(), stderr), 0UL)
#endif

typedef void *Component;
typedef struct {
    void (*logger)(void *, const char *, int, const char *, const char *, ...);
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void *finished;
    void *environment;
} Callbacks;

static void logger(void *e, const char *name, int status, const char *category, const char *text, ...) {
    va_list rest;
    (void)e;
    fprintf(stderr, "%s %d %s: ", name, status, category);
    va_start(rest, text);
    vfprintf(stderr, text, rest);
    va_end(rest);
    fputc('\n', stderr);
}

static Library library;

static Function function(const char *name) {
    Function found = GetProcAddress(library, name);
    if (!found) {
        fprintf(stderr, "no %s\n", name);
        exit(1);
    }
    return found;
}

static void check(int status, const char *what) {
    if (status != 0) {
        fprintf(stderr, "%s: status %d\n", what, status);
        exit(1);
    }
}

int main(int argc, char **argv) {
    if (argc < 7)
        return 2;
    library = LoadLibraryA(argv[1]);
    if (!library) {
        fprintf(stderr, "LoadLibrary: error %lu\n", GetLastError());
        return 1;
    }
    Component (*instantiate)(const char *, int, const char *, const char *, const Callbacks *, int, int) =
        (void *)function("fmi2Instantiate");
    int (*set_up)(Component, int, double, double, int, double) = (void *)function("fmi2SetupExperiment");
    int (*enter)(Component) = (void *)function("fmi2EnterInitializationMode");
    int (*leave)(Component) = (void *)function("fmi2ExitInitializationMode");
    int (*step)(Component, double, double, int) = (void *)function("fmi2DoStep");
    int (*get)(Component, const unsigned *, size_t, double *) = (void *)function("fmi2GetReal");
    int (*save)(Component, void **) = (void *)function("fmi2GetFMUstate");
    int (*restore)(Component, void *) = (void *)function("fmi2SetFMUstate");
    int (*forget)(Component, void **) = (void *)function("fmi2FreeFMUstate");
    int (*terminate)(Component) = (void *)function("fmi2Terminate");
    void (*release)(Component) = (void *)function("fmi2FreeInstance");

    double h = atof(argv[4]), values[64];
    int count = atoi(argv[5]), n = argc - 6;
    unsigned references[64];
    for (int k = 0; k < n && k < 64; k++)
        references[k] = (unsigned)atoi(argv[6 + k]);
    Callbacks callbacks = {logger, calloc, free, NULL, NULL};
    Component c = instantiate("host", 1, argv[2], argv[3], &callbacks, 0, 0);
    if (!c)
        return 1;
    check(set_up(c, 0, 0, 0, 0, 0), "fmi2SetupExperiment");
    check(enter(c), "fmi2EnterInitializationMode");
    check(leave(c), "fmi2ExitInitializationMode");
    void *state = NULL;
    for (int pass = 0; pass < 2; pass++) {
        if (pass)
            check(restore(c, state), "fmi2SetFMUstate");
        for (int k = pass ? count / 2 : 0; k < count; k++) {
            if (!pass && k == count / 2)
                check(save(c, &state), "fmi2GetFMUstate");
            check(step(c, k * h, h, 0), "fmi2DoStep");
            if (pass && k + 1 < count)
                continue;
            check(get(c, references, (size_t)n, values), "fmi2GetReal");
            for (int j = 0; j < n; j++)
                printf("%.17g%c", values[j], j + 1 < n ? ' ' : '\n');
        }
    }
    check(forget(c, &state), "fmi2FreeFMUstate");
    check(terminate(c), "fmi2Terminate");
    release(c);
    FreeLibrary(library);
    return 0;
}
