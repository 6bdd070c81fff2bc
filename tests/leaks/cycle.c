/* Loads the FMU's library, runs instances through a whole life, unloads it, and counts what is left behind.
 *
 *   cycle LIBRARY GUID RESOURCES_URI CYCLES THREADS INSTANCES
 *
 * A cycle: load, then in each thread INSTANCES instances side by side: set up, initialize, step, save, serialize, restore, step,
 * a refused call, terminate, free; join; unload. Prints the bytes in use after half of the cycles and after the last one, and
 * the number of threads then: the two numbers of bytes are the same, but for the rounding of chunks, if a cycle leaves nothing. */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <malloc.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

typedef void *Component;
typedef void *State;
typedef struct {
    void (*logger)(void *, const char *, int, const char *, const char *, ...);
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void *finished;
    void *environment;
} Callbacks;

static void silent(void *environment, const char *name, int status, const char *category, const char *message, ...) {
    (void)environment, (void)name, (void)status, (void)category, (void)message;
}

static const Callbacks CALLBACKS = {silent, calloc, free, NULL, NULL};

static const char *guid, *resources;
static int instances;

typedef struct {
    Component (*instantiate)(const char *, int, const char *, const char *, const Callbacks *, int, int);
    void (*free_instance)(Component);
    int (*set_up)(Component, int, double, double, int, double);
    int (*enter)(Component);
    int (*leave)(Component);
    int (*step)(Component, double, double, int);
    int (*terminate)(Component);
    int (*get_state)(Component, State *);
    int (*set_state)(Component, State);
    int (*free_state)(Component, State *);
    int (*size)(Component, State, size_t *);
    int (*serialize)(Component, State, char *, size_t);
    int (*deserialize)(Component, const char *, size_t, State *);
} Library;

static void check(int status, const char *what) {
    if (status != 0) {
        fprintf(stderr, "%s: status %d\n", what, status);
        exit(1);
    }
}

#define CHECK(call) check(call, #call)

static void *live(void *argument) {
    const Library *fmu = argument;
    Component all[64];
    for (int i = 0; i < instances; i++) {
        all[i] = fmu->instantiate("cycle", 1, guid, resources, &CALLBACKS, 0, 0);
        if (!all[i]) exit(1);
        CHECK(fmu->set_up(all[i], 0, 0.0, 0.0, 0, 0.0));
        CHECK(fmu->enter(all[i]));
        CHECK(fmu->leave(all[i]));
    }
    for (int i = 0; i < instances; i++) {
        CHECK(fmu->step(all[i], 0.0, 2e-3, 0));
        State state = NULL, copy = NULL;
        size_t size;
        CHECK(fmu->get_state(all[i], &state));
        CHECK(fmu->size(all[i], state, &size));
        char *bytes = malloc(size);
        CHECK(fmu->serialize(all[i], state, bytes, size));
        CHECK(fmu->deserialize(all[i], bytes, size, &copy));
        free(bytes);
        CHECK(fmu->step(all[i], 2e-3, 2e-3, 0));
        CHECK(fmu->set_state(all[i], copy));
        CHECK(fmu->step(all[i], 2e-3, 2e-3, 0));
        CHECK(fmu->set_state(all[i], state));
        CHECK(fmu->step(all[i], 2e-3, 2e-3, 0));
        CHECK(fmu->free_state(all[i], &state));
        CHECK(fmu->free_state(all[i], &copy));
        /* A call that is refused leaves nothing either: a step from the wrong time. */
        if (fmu->step(all[i], 1.0, 2e-3, 0) == 0) exit(1);
    }
    for (int i = 0; i < instances; i++) {
        CHECK(fmu->terminate(all[i]));
        fmu->free_instance(all[i]);
    }
    return NULL;
}

static int running(void) {
    int count = 0;
    DIR *tasks = opendir("/proc/self/task");
    for (struct dirent *entry; (entry = readdir(tasks));) count += entry->d_name[0] != '.';
    closedir(tasks);
    return count;
}

int main(int count, char **argument) {
    if (count != 7) return 2;
    guid = argument[2], resources = argument[3], instances = atoi(argument[6]);
    int cycles = atoi(argument[4]), threads = atoi(argument[5]);
    /* One arena, so that its account is that of all threads; chunks kept for reuse count as used: none are kept here, and none by
     * threads (GLIBC_TUNABLES=glibc.malloc.tcache_count=0). */
    mallopt(M_ARENA_MAX, 1);
    mallopt(M_MXFAST, 0);
    size_t early = 0;
    for (int cycle = 1; cycle <= cycles; cycle++) {
        void *handle = dlopen(argument[1], RTLD_NOW | RTLD_LOCAL);
        if (!handle) return fprintf(stderr, "%s\n", dlerror()), 1;
        Library fmu;
        void **slots = (void **)&fmu;
        static const char *const names[] = {
            "fmi2Instantiate", "fmi2FreeInstance", "fmi2SetupExperiment", "fmi2EnterInitializationMode",
            "fmi2ExitInitializationMode", "fmi2DoStep", "fmi2Terminate", "fmi2GetFMUstate", "fmi2SetFMUstate", "fmi2FreeFMUstate",
            "fmi2SerializedFMUstateSize", "fmi2SerializeFMUstate", "fmi2DeSerializeFMUstate"};
        for (size_t k = 0; k < sizeof names / sizeof *names; k++)
            if (!(slots[k] = dlsym(handle, names[k]))) return 1;
        if (threads == 0) {
            live(&fmu);
        } else {
            pthread_t side[64];
            for (int t = 0; t < threads; t++) pthread_create(&side[t], NULL, live, &fmu);
            for (int t = 0; t < threads; t++) pthread_join(side[t], NULL);
        }
        dlclose(handle);
        struct mallinfo2 used = mallinfo2();
        if (cycle == (cycles + 1) / 2) early = used.uordblks + used.hblkhd;
        if (cycle == cycles) printf("%zu %zu %d\n", early, used.uordblks + used.hblkhd, running());
    }
    return 0;
}
