/* A foreign FMU of FMI 3.0 that needs its importer for events: it refuses to be made without event mode.
 *
 * `rings` counts a bell at 0.25 s, 0.5 s, ..., times that it announces (nextEventTime). `level` rises by 1/s and is emptied when
 * it reaches 0.37, which the FMU finds within a step (eventHandlingNeeded, earlyReturn); `resets` counts that. The discrete input
 * `load` can be set in event mode only; `sum` adds it up at each event that it changes in. An event takes `updates` calls of
 * fmi3UpdateDiscreteStates. From the time `last` on it wants to end. Every call out of turn is an error, as are steps beyond an
 * announced time of an FMU whose steps may have any length (built with ANY_STEP), or early returns that are not allowed.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fmi3Functions.h"

enum { RINGS = 1, LOAD, SUM, LEVEL, RESETS, UPDATES, LAST, EARLY };
enum { MADE, INITIALIZATION, STEP, EVENT, DONE };

typedef struct {
    int mode, rings, load, old_load, sum, resets, updates, left, early;
    double level, time, last;
} State;

typedef struct {
    State state;
    int early_allowed;
} Instance;

#define PERIOD 0.25
#define FULL 0.37
#define NEAR 1e-9

static double next_ring(const State *s) {
    return PERIOD * (s->rings + 1);
}

fmi3Status fmi3EnterEventMode(fmi3Instance i) {
    State *s = i;
    if (s->mode != STEP) return fmi3Error;
    s->mode = EVENT;
    s->left = s->updates;
    return fmi3OK;
}

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance i, fmi3Boolean *again, fmi3Boolean *terminate, fmi3Boolean *nominals,
                                    fmi3Boolean *values, fmi3Boolean *defined, fmi3Float64 *next) {
    State *s = i;
    if (s->mode != EVENT) return fmi3Error;
    if (s->time >= next_ring(s) - NEAR) s->rings++;
    if (s->level >= FULL - NEAR) s->level -= FULL, s->resets++;
    if (s->load != s->old_load) s->sum += s->load, s->old_load = s->load;
    *again = s->updates < 0 || --s->left > 0;
    *terminate = s->time >= s->last - NEAR;
    *nominals = *values = fmi3False;
    *defined = fmi3True;
    *next = next_ring(s);
    return fmi3OK;
}

fmi3Status fmi3EnterStepMode(fmi3Instance i) {
    State *s = i;
    if (s->mode != EVENT || s->left > 0) return fmi3Error;
    s->mode = STEP;
    return fmi3OK;
}

fmi3Status fmi3DoStep(fmi3Instance i, fmi3Float64 t, fmi3Float64 h, fmi3Boolean no_rollback, fmi3Boolean *event,
                      fmi3Boolean *terminate, fmi3Boolean *early, fmi3Float64 *last) {
    Instance *instance = i;
    State *s = i;
    (void)no_rollback;
    if (s->mode != STEP || fabs(t - s->time) > NEAR || h <= 0) return fmi3Error;
    if (s->time >= next_ring(s) - NEAR) return fmi3Error;
#ifdef ANY_STEP
    if (!instance->early_allowed || t + h > next_ring(s) + NEAR) return fmi3Error;
#else
    if (instance->early_allowed) return fmi3Error;
#endif
    double full = t + FULL - s->level, end = t + h;
    *event = full <= end + NEAR;
    *terminate = *early = fmi3False;
    if (*event && instance->early_allowed && full < end - NEAR) {
        *early = fmi3True;
        s->early++;
        end = full;
    }
    s->level += end - t;
    *last = s->time = end;
    return fmi3OK;
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                         fmi3Boolean logging, fmi3Boolean events, fmi3Boolean early_allowed,
                                         const fmi3ValueReference required[], size_t n, fmi3InstanceEnvironment environment,
                                         fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback intermediate) {
    (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)required, (void)n, (void)intermediate;
    if (!events) {
        log(environment, fmi3Error, "logStatusError", "found no event mode, expected it");
        return NULL;
    }
    Instance *instance = calloc(1, sizeof *instance);
    if (instance == NULL) return NULL;
    instance->early_allowed = early_allowed;
    instance->state.updates = 1;
    instance->state.last = HUGE_VAL;
    return instance;
}

void fmi3FreeInstance(fmi3Instance i) {
    free(i);
}

const char *fmi3GetVersion(void) {
    return "3.0";
}

static fmi3Status move(State *s, int from, int to) {
    if (s->mode != from) return fmi3Error;
    s->mode = to;
    return fmi3OK;
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance i, fmi3Boolean defined, fmi3Float64 tolerance, fmi3Float64 start,
                                       fmi3Boolean stop_defined, fmi3Float64 stop) {
    (void)defined, (void)tolerance, (void)stop_defined, (void)stop;
    ((State *)i)->time = start;
    return move(i, MADE, INITIALIZATION);
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance i) {
    State *s = i;
    s->old_load = s->load;
    s->left = s->updates;
    return move(i, INITIALIZATION, EVENT);
}

fmi3Status fmi3Terminate(fmi3Instance i) {
    return move(i, STEP, DONE);
}

fmi3Status fmi3GetInt32(fmi3Instance i, const fmi3ValueReference vr[], size_t n, fmi3Int32 value[], size_t count) {
    const State *s = i;
    if (n != count) return fmi3Error;
    for (size_t k = 0; k < n; k++) {
        const int all[] = {0, s->rings, s->load, s->sum, 0, s->resets, s->updates, 0, s->early};
        value[k] = all[vr[k]];
    }
    return fmi3OK;
}

fmi3Status fmi3SetInt32(fmi3Instance i, const fmi3ValueReference vr[], size_t n, const fmi3Int32 value[], size_t count) {
    State *s = i;
    if (n != count) return fmi3Error;
    for (size_t k = 0; k < n; k++) {
        if (vr[k] == UPDATES) {
            s->updates = value[k];
        } else if (vr[k] == LOAD) {
            if (s->mode == STEP && value[k] != s->load) return fmi3Error;
            s->load = value[k];
        }
    }
    return fmi3OK;
}

fmi3Status fmi3GetFloat64(fmi3Instance i, const fmi3ValueReference vr[], size_t n, fmi3Float64 value[], size_t count) {
    const State *s = i;
    if (n != count) return fmi3Error;
    for (size_t k = 0; k < n; k++) value[k] = vr[k] == LEVEL ? s->level : vr[k] == LAST ? s->last : s->time;
    return fmi3OK;
}

fmi3Status fmi3SetFloat64(fmi3Instance i, const fmi3ValueReference vr[], size_t n, const fmi3Float64 value[], size_t count) {
    State *s = i;
    if (n != count) return fmi3Error;
    for (size_t k = 0; k < n; k++) {
        if (vr[k] != LAST) return fmi3Error;
        s->last = value[k];
    }
    return fmi3OK;
}

fmi3Status fmi3GetFMUState(fmi3Instance i, fmi3FMUState *state) {
    if (*state == NULL) *state = malloc(sizeof(State));
    if (*state == NULL) return fmi3Error;
    memcpy(*state, i, sizeof(State));
    return fmi3OK;
}

fmi3Status fmi3SetFMUState(fmi3Instance i, fmi3FMUState state) {
    memcpy(i, state, sizeof(State));
    return fmi3OK;
}

fmi3Status fmi3FreeFMUState(fmi3Instance i, fmi3FMUState *state) {
    (void)i;
    free(*state);
    *state = NULL;
    return fmi3OK;
}
