/* A foreign FMU for the tests of the importer: mass, spring and damper under a force held over each step,
 *
 *     m x'' + c x' + k x = F,      0 < c < 2 sqrt(k m),
 *
 * advanced by its closed form, so that no step size matters. It can fail on purpose: the string parameter `fault`
 * is "<function>:<status>", for example "fmi2DoStep:3"; the fault strikes from time `faultTime` on. Every call of
 * its life is written to `trace.txt` in the resources. Other faults are "nan", "terminate", "short", "half", "crumbs", "down", "up", "meet",
 * which waits in each step until as many instances of this FMU as `faultTime` says are in it, and "logger", which calls the logger in every way that the standard does not foresee. In the place of a status "crash",
 * "abort", "exit" and "hang" do not come back, "sleep" takes 0.05 s, "print" writes to standard output and reads
 * standard input. Built with WITHOUT_DO_STEP, WITHOUT_STATES, UNDEFINED_SYMBOL, OTHER_VERSION, OTHER_TYPES,
 * NO_INSTANCE, SETUP_FAILS, LOAD_EXITS or INSTANCE_EXITS it is a library that cannot be loaded, lacks something, or
 * fails before a parameter can be set.
 */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "fmi2.h"

#define GUID "{foreign-oscillator}"

/* Value references; each type counts for itself. */
enum { X, V, FORCE, MASS, DAMPING, STIFFNESS, FAULT_TIME, ECHO, REALS };
enum { STEPS, LEVEL, LEVEL_ECHO, INTEGERS };
enum { FROZEN, BOOLEANS };
enum { LABEL, GREETING, FAULT, STRINGS };

typedef struct {
    double real[REALS];
    int integer[INTEGERS];
    int boolean[BOOLEANS];
    char string[STRINGS][64];
    double time;
} State;

typedef struct {
    State state;
    fmi2CallbackFunctions callbacks;
    char name[64];
    char trace[1024];
    double reached;
    int terminated;
} Instance;

#ifdef UNDEFINED_SYMBOL
double symbol_that_no_library_has(double);
#endif

#ifdef LOAD_EXITS
__attribute__((constructor)) static void leave(void) {
    exit(0);
}
#endif

static void trace(const Instance *instance, const char *function) {
    FILE *file = fopen(instance->trace, "a");
    if (file == NULL) return;
    fprintf(file, "%s\n", function);
    fclose(file);
}

/* An address that no process has, which the compiler does not know. */
static int *volatile nowhere = NULL;

/* Waits up to 20 s until that many instances have come to this step; each writes a letter into one file. */
static fmi2Status meet(const Instance *instance, int count) {
    char path[1100];
    snprintf(path, sizeof path, "%s.met", instance->trace);
    FILE *file = fopen(path, "a");
    if (file == NULL) return fmi2Error;
    fputc('x', file);
    fclose(file);
    long all = (long)count * (instance->state.integer[STEPS] + 1);
    for (int k = 0; k < 20000; k++) {
        file = fopen(path, "r");
        if (file == NULL) return fmi2Error;
        fseek(file, 0, SEEK_END);
        long come = ftell(file);
        fclose(file);
        if (come >= all) return fmi2OK;
        usleep(1000);
    }
    return fmi2Error;
}

/* The status that the fault parameter asks of this function. */
static fmi2Status fault(Instance *instance, const char *function) {
    const char *wish = instance->state.string[FAULT];
    const char *colon = strchr(wish, ':');
    size_t length = strlen(function);
    if (colon == NULL || (size_t)(colon - wish) != length || strncmp(wish, function, length) != 0) return fmi2OK;
    if (instance->state.time < instance->state.real[FAULT_TIME] - 1e-12) return fmi2OK;
    const char *what = colon + 1;
    if (strcmp(what, "crash") == 0) *nowhere = 1;
    if (strcmp(what, "abort") == 0) abort();
    if (strcmp(what, "exit") == 0) exit(0);
    if (strcmp(what, "sleep") == 0) usleep(50000);
    if (strcmp(what, "print") == 0) {
        printf("from the library, %d\n", getchar());
        fflush(stdout);
    }
    for (volatile int once = 1; strcmp(what, "hang") == 0;) (void)once;
    fmi2Status status = (fmi2Status)atoi(what);
    if (status != fmi2OK) {
        instance->callbacks.logger(instance->callbacks.componentEnvironment, instance->name, status, "logStatusError",
                                   "%s", "failed on purpose, 100 %");
    }
    return status;
}

/* Formats, texts and numbers that no reasonable library passes. */
static void abuse_logger(const Instance *instance) {
    void (*tell)(void *, fmi2String, fmi2Status, fmi2String, fmi2String, ...) = instance->callbacks.logger;
    void *environment = instance->callbacks.componentEnvironment;
    static char endless[100000];
    memset(endless, 'x', sizeof endless - 1);
    tell(environment, NULL, fmi2OK, NULL, NULL);
    tell(environment, "", (fmi2Status)77, "", "");
    tell(environment, "name", fmi2Error, "logStatusError", "%s", (const char *)NULL);
    tell(environment, "name", fmi2Error, "logStatusError", "%");
    tell(environment, "name", fmi2Error, "logStatusError", "%%%");
    tell(environment, "name", fmi2Error, "logStatusError", "%d of %f, %n and %*s", 1, 2.0);
    tell(environment, "\xff\xfe", fmi2Error, "\x80", "\xc3\x28 is not UTF-8");
    tell(environment, "name", fmi2Error, "logStatusError", "%s", endless);
    tell(environment, "name", fmi2Error, "logStatusError", "\033[2J#r1# and a line\nbreak");
    for (int k = 0; k < 20000; k++) tell(environment, "name", fmi2OK, "logEvents", "again");
    tell(environment, "name", fmi2Error, "logStatusError", "the last word");
}

#define RETURN_IF_FAULT(function)                                                                                  \
    do {                                                                                                           \
        fmi2Status status = fault(instance, function);                                                             \
        if (status != fmi2OK && status != fmi2Warning) return status;                                              \
    } while (0)

static void defaults(State *state) {
    memset(state, 0, sizeof *state);
    state->real[X] = 1.0;
    state->real[MASS] = 2.0;
    state->real[DAMPING] = 0.4;
    state->real[STIFFNESS] = 8.0;
    strcpy(state->string[LABEL], "nobody");
}

FMI2_EXPORT const char *fmi2GetTypesPlatform(void) {
#ifdef OTHER_TYPES
    return NULL;
#else
    return "default";
#endif
}

FMI2_EXPORT const char *fmi2GetVersion(void) {
#ifdef OTHER_VERSION
    return "1.0";
#else
    return "2.0";
#endif
}

FMI2_EXPORT fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n, const fmi2String categories[]) {
    (void)c, (void)on, (void)n, (void)categories;
    return fmi2OK;
}

FMI2_EXPORT fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                                          const fmi2CallbackFunctions *callbacks, fmi2Boolean visible,
                                          fmi2Boolean logging) {
    (void)visible;
    if (type != fmi2CoSimulation || strcmp(guid, GUID) != 0) {
        callbacks->logger(callbacks->componentEnvironment, name, fmi2Error, "logStatusError", "wrong guid %s", guid);
        return NULL;
    }
#ifdef INSTANCE_EXITS
    exit(0);
#endif
#ifdef NO_INSTANCE
    return NULL;
#endif
    Instance *instance = callbacks->allocateMemory(1, sizeof *instance);
    if (instance == NULL) return NULL;
    defaults(&instance->state);
    instance->callbacks = *callbacks;
    snprintf(instance->name, sizeof instance->name, "%s", name);
    /* Test folders have no characters that a URI would encode. */
    const char *path = strncmp(resources, "file://", 7) == 0 ? resources + 7 : resources;
    snprintf(instance->trace, sizeof instance->trace, "%s/trace.txt", path);
    trace(instance, "fmi2Instantiate");
    if (logging) {
        callbacks->logger(callbacks->componentEnvironment, name, fmi2OK, "logEvents", "made at 100%%, part %d of %d",
                          1, 2);
    }
    return instance;
}

FMI2_EXPORT void fmi2FreeInstance(fmi2Component c) {
    Instance *instance = c;
    if (instance == NULL) return;
    trace(instance, "fmi2FreeInstance");
    fault(instance, "fmi2FreeInstance");
    instance->callbacks.freeMemory(instance);
}

FMI2_EXPORT fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                                           fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop) {
    Instance *instance = c;
    (void)tolerance_defined, (void)tolerance, (void)stop_defined, (void)stop;
    trace(instance, "fmi2SetupExperiment");
    instance->state.time = start;
#ifdef SETUP_FAILS
    return fmi2Error;
#endif
    return fmi2OK;
}

#define PLAIN(function, body)                                                                                      \
    FMI2_EXPORT fmi2Status function(fmi2Component c) {                                                             \
        Instance *instance = c;                                                                                    \
        trace(instance, #function);                                                                                \
        RETURN_IF_FAULT(#function);                                                                                \
        body return fmi2OK;                                                                                        \
    }

PLAIN(fmi2EnterInitializationMode, )
PLAIN(fmi2ExitInitializationMode,
      snprintf(instance->state.string[GREETING], sizeof instance->state.string[GREETING], "hello, %.50s",
               instance->state.string[LABEL]);)
PLAIN(fmi2Terminate, )
PLAIN(fmi2Reset, defaults(&instance->state);)
PLAIN(fmi2CancelStep, return fmi2Error;)

#define GET_AND_SET(Name, type, field, count)                                                                      \
    FMI2_EXPORT fmi2Status fmi2Get##Name(fmi2Component c, const fmi2ValueReference vr[], size_t n, type value[]) { \
        Instance *instance = c;                                                                                    \
        RETURN_IF_FAULT("fmi2Get" #Name);                                                                          \
        for (size_t i = 0; i < n; i++) {                                                                           \
            if (vr[i] >= count) return fmi2Error;                                                                  \
            value[i] = instance->state.field[vr[i]];                                                               \
        }                                                                                                          \
        return fmi2OK;                                                                                             \
    }                                                                                                              \
    FMI2_EXPORT fmi2Status fmi2Set##Name(fmi2Component c, const fmi2ValueReference vr[], size_t n,                 \
                                         const type value[]) {                                                     \
        Instance *instance = c;                                                                                    \
        RETURN_IF_FAULT("fmi2Set" #Name);                                                                          \
        for (size_t i = 0; i < n; i++) {                                                                           \
            if (vr[i] >= count) return fmi2Error;                                                                  \
            STORE(instance->state.field[vr[i]], value[i]);                                                         \
        }                                                                                                          \
        return fmi2OK;                                                                                             \
    }

#define STORE(to, from) (to) = (from)
GET_AND_SET(Real, fmi2Real, real, REALS)
GET_AND_SET(Integer, fmi2Integer, integer, INTEGERS)
GET_AND_SET(Boolean, fmi2Boolean, boolean, BOOLEANS)
#undef STORE
#define STORE(to, from) snprintf(to, sizeof(to), "%s", from)
GET_AND_SET(String, fmi2String, string, STRINGS)

#ifndef WITHOUT_DO_STEP
/* The closed form over h [s] from x and v, the force held. */
static void advance(State *state, double h) {
    const double *r = state->real;
    double rest = r[FORCE] / r[STIFFNESS];
    double decay = r[DAMPING] / (2.0 * r[MASS]);
    double omega = sqrt(r[STIFFNESS] / r[MASS] - decay * decay);
    double a = r[X] - rest;
    double b = (r[V] + decay * a) / omega;
    double e = exp(-decay * h), s = sin(omega * h), c = cos(omega * h);
    state->real[X] = rest + e * (a * c + b * s);
    state->real[V] = e * ((b * omega - decay * a) * c - (a * omega + decay * b) * s);
}

FMI2_EXPORT fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real h, fmi2Boolean no_rollback) {
    Instance *instance = c;
    State *state = &instance->state;
    (void)no_rollback;
    trace(instance, "fmi2DoStep");
    if (fabs(time - state->time) > 1e-9 * h) return fmi2Error;
    instance->reached = time;
    instance->terminated = 0;
    if (strcmp(state->string[FAULT], "logger") == 0) {
        abuse_logger(instance);
        return fmi2Error;
    }
    if (strcmp(state->string[FAULT], "nan") == 0 && time >= state->real[FAULT_TIME] - 1e-12) {
        state->real[X] = NAN;
        state->time = time + h;
        return fmi2OK;
    }
    if (strcmp(state->string[FAULT], "terminate") == 0 && time + h > state->real[FAULT_TIME]) {
        advance(state, state->real[FAULT_TIME] - time);
        instance->reached = state->time = state->real[FAULT_TIME];
        instance->terminated = 1;
        return fmi2Discard;
    }
    /* No more than 2 ms at a time. */
    if (strcmp(state->string[FAULT], "crumbs") == 0 && h > 0.0021) {
        advance(state, 0.002);
        instance->reached = state->time = time + 0.002;
        return fmi2Discard;
    }
    /* Ends where it comes to a displacement of `faultTime`, from above or from below. */
    int down = strcmp(state->string[FAULT], "down") == 0, up = strcmp(state->string[FAULT], "up") == 0;
    if (down || up) {
        State after = *state;
        advance(&after, h);
        double past = after.real[X] - state->real[FAULT_TIME];
        if (down ? past < 0 : past > 0) {
            instance->terminated = 1;
            return fmi2Discard;
        }
    }
    if (strcmp(state->string[FAULT], "meet") == 0 && meet(instance, (int)state->real[FAULT_TIME]) != fmi2OK) {
        return fmi2Error;
    }
    /* Steps longer than 0.03 s are refused altogether, or done by half. */
    if (strcmp(state->string[FAULT], "short") == 0 && h > 0.03) return fmi2Discard;
    if (strcmp(state->string[FAULT], "half") == 0 && h > 0.03) {
        advance(state, 0.5 * h);
        instance->reached = state->time = time + 0.5 * h;
        return fmi2Discard;
    }
    fmi2Status status = fault(instance, "fmi2DoStep");
    if (status != fmi2OK && status != fmi2Warning) return status;
#ifdef UNDEFINED_SYMBOL
    h = symbol_that_no_library_has(h);
#endif
    if (!state->boolean[FROZEN]) advance(state, h);
    state->real[ECHO] = state->real[FORCE];
    state->integer[LEVEL_ECHO] = state->integer[LEVEL];
    state->integer[STEPS]++;
    state->time = time + h;
    return status;
}
#endif

FMI2_EXPORT fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Status *value) {
    (void)c, (void)kind, (void)value;
    return fmi2Discard;
}

FMI2_EXPORT fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Real *value) {
    Instance *instance = c;
    RETURN_IF_FAULT("fmi2GetRealStatus");
    if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
    *value = instance->reached;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Integer *value) {
    (void)c, (void)kind, (void)value;
    return fmi2Discard;
}

FMI2_EXPORT fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean *value) {
    Instance *instance = c;
    if (kind != fmi2Terminated) return fmi2Discard;
    *value = instance->terminated;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind kind, fmi2String *value) {
    (void)c, (void)kind, (void)value;
    return fmi2Discard;
}

#ifndef WITHOUT_STATES
FMI2_EXPORT fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state) {
    Instance *instance = c;
    RETURN_IF_FAULT("fmi2GetFMUstate");
    if (*state == NULL) *state = instance->callbacks.allocateMemory(1, sizeof(State));
    if (*state == NULL) return fmi2Error;
    memcpy(*state, &instance->state, sizeof(State));
    return fmi2OK;
}

FMI2_EXPORT fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
    Instance *instance = c;
    memcpy(&instance->state, state, sizeof(State));
    return fmi2OK;
}

FMI2_EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state) {
    Instance *instance = c;
    trace(instance, "fmi2FreeFMUstate");
    instance->callbacks.freeMemory(*state);
    *state = NULL;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size) {
    (void)c, (void)state;
    *size = sizeof(State);
    return fmi2OK;
}

FMI2_EXPORT fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
    (void)c;
    if (size < sizeof(State)) return fmi2Error;
    memcpy(bytes, state, sizeof(State));
    return fmi2OK;
}

FMI2_EXPORT fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size,
                                               fmi2FMUstate *state) {
    Instance *instance = c;
    if (size != sizeof(State)) return fmi2Error;
    *state = instance->callbacks.allocateMemory(1, size);
    if (*state == NULL) return fmi2Error;
    memcpy(*state, bytes, size);
    return fmi2OK;
}
#endif

FMI2_EXPORT fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknown[], size_t nu,
                                                    const fmi2ValueReference known[], size_t nk,
                                                    const fmi2Real seed[], fmi2Real value[]) {
    (void)c, (void)unknown, (void)nu, (void)known, (void)nk, (void)seed, (void)value;
    return fmi2Error;
}

FMI2_EXPORT fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                                   const fmi2Integer order[], const fmi2Real value[]) {
    (void)c, (void)vr, (void)n, (void)order, (void)value;
    return fmi2Error;
}

FMI2_EXPORT fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                                    const fmi2Integer order[], fmi2Real value[]) {
    (void)c, (void)vr, (void)n, (void)order, (void)value;
    return fmi2Error;
}
