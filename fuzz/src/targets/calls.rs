//! Calls of both C interfaces in any order, as an input's bytes say: any instance, reference, number, length.

use std::ffi::{CString, c_char, c_int, c_void};
use std::path::Path;
use std::ptr::{null, null_mut};
use std::sync::OnceLock;

use sphere_dda_fmu::model::Model;
use sphere_dda_fmu::version::Version;

use super::Target;

type Handle = *mut c_void;

// The functions of the library that this program links, as the headers of the standard declare them.
#[rustfmt::skip]
unsafe extern "C" {
    fn fmi2Instantiate(name: *const c_char, kind: c_int, guid: *const c_char, resources: *const c_char, callbacks: *const c_void, visible: c_int, logging: c_int) -> Handle;
    fn fmi2FreeInstance(c: Handle);
    fn fmi2SetupExperiment(c: Handle, has_tolerance: c_int, tolerance: f64, start: f64, has_stop: c_int, stop: f64) -> c_int;
    fn fmi2EnterInitializationMode(c: Handle) -> c_int;
    fn fmi2ExitInitializationMode(c: Handle) -> c_int;
    fn fmi2Terminate(c: Handle) -> c_int;
    fn fmi2Reset(c: Handle) -> c_int;
    fn fmi2GetReal(c: Handle, references: *const u32, count: usize, values: *mut f64) -> c_int;
    fn fmi2SetReal(c: Handle, references: *const u32, count: usize, values: *const f64) -> c_int;
    fn fmi2GetInteger(c: Handle, references: *const u32, count: usize, values: *mut c_int) -> c_int;
    fn fmi2SetInteger(c: Handle, references: *const u32, count: usize, values: *const c_int) -> c_int;
    fn fmi2GetString(c: Handle, references: *const u32, count: usize, values: *mut *const c_char) -> c_int;
    fn fmi2GetFMUstate(c: Handle, state: *mut Handle) -> c_int;
    fn fmi2SetFMUstate(c: Handle, state: Handle) -> c_int;
    fn fmi2FreeFMUstate(c: Handle, state: *mut Handle) -> c_int;
    fn fmi2SerializedFMUstateSize(c: Handle, state: Handle, size: *mut usize) -> c_int;
    fn fmi2SerializeFMUstate(c: Handle, state: Handle, bytes: *mut c_char, size: usize) -> c_int;
    fn fmi2DeSerializeFMUstate(c: Handle, bytes: *const c_char, size: usize, state: *mut Handle) -> c_int;
    fn fmi2GetDirectionalDerivative(c: Handle, unknowns: *const u32, n: usize, knowns: *const u32, m: usize, seed: *const f64, out: *mut f64) -> c_int;
    fn fmi2SetRealInputDerivatives(c: Handle, references: *const u32, count: usize, orders: *const c_int, values: *const f64) -> c_int;
    fn fmi2DoStep(c: Handle, time: f64, step: f64, final_past: c_int) -> c_int;
    fn fmi3InstantiateCoSimulation(name: *const c_char, token: *const c_char, resources: *const c_char, visible: bool, logging: bool, events: bool, early: bool, required: *const u32, count: usize, environment: *mut c_void, log: *const c_void, update: *const c_void) -> Handle;
    fn fmi3FreeInstance(c: Handle);
    fn fmi3EnterInitializationMode(c: Handle, has_tolerance: bool, tolerance: f64, start: f64, has_stop: bool, stop: f64) -> c_int;
    fn fmi3ExitInitializationMode(c: Handle) -> c_int;
    fn fmi3Terminate(c: Handle) -> c_int;
    fn fmi3Reset(c: Handle) -> c_int;
    fn fmi3GetFloat64(c: Handle, references: *const u32, count: usize, values: *mut f64, length: usize) -> c_int;
    fn fmi3SetFloat64(c: Handle, references: *const u32, count: usize, values: *const f64, length: usize) -> c_int;
    fn fmi3GetFMUState(c: Handle, state: *mut Handle) -> c_int;
    fn fmi3SetFMUState(c: Handle, state: Handle) -> c_int;
    fn fmi3FreeFMUState(c: Handle, state: *mut Handle) -> c_int;
    fn fmi3DoStep(c: Handle, time: f64, step: f64, final_past: bool, event: *mut bool, terminate: *mut bool, early: *mut bool, last: *mut f64) -> c_int;
}

/// A model and the folder that instances read it from.
pub(super) struct Resources {
    folder: tempfile::TempDir,
    model: Model,
    references: u32,
}

/// The model of all calls and states. Its sweeps are bounded: a state may ask for steps of any work otherwise.
pub(super) fn model() -> &'static Resources {
    static MODEL: OnceLock<Resources> = OnceLock::new();
    MODEL.get_or_init(|| {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("scene.toml");
        let scene = include_str!("corpus/machine.toml");
        let scene = scene.replace("accuracy = \"fast\"", "accuracy = \"fast\"\nsweeps = 20");
        std::fs::write(&path, scene).expect("a file in it");
        let model = Model::read(&path, None).expect("the scene is sound");
        let references = model.table.entries(Version::Two).len() as u32;
        Resources {
            folder,
            model,
            references,
        }
    })
}

fn text(text: &str) -> CString {
    CString::new(text).expect("a text without NUL")
}

/// An instance of FMI 2.0.
pub(super) struct Two<'a> {
    handle: Handle,
    of: &'a Resources,
}

impl Drop for Two<'_> {
    fn drop(&mut self) {
        // SAFETY: the handle is of fmi2Instantiate, not freed before.
        unsafe { fmi2FreeInstance(self.handle) };
    }
}

impl<'a> Two<'a> {
    pub(super) fn new(of: &'a Resources) -> Self {
        let callbacks = [null::<c_void>(); 5];
        let uri = format!("file://{}", of.folder.path().display());
        let (name, guid, uri) = (text("x"), text(&of.model.guid), text(&uri));
        // SAFETY: texts end with NUL and live through the call, as do the callbacks, all of which are NULL.
        let handle = unsafe {
            let callbacks = callbacks.as_ptr().cast();
            fmi2Instantiate(
                name.as_ptr(),
                1,
                guid.as_ptr(),
                uri.as_ptr(),
                callbacks,
                0,
                0,
            )
        };
        assert!(!handle.is_null(), "no instance");
        Self { handle, of }
    }

    pub(super) fn initialize(&self) {
        // SAFETY: the handle is alive.
        unsafe {
            fmi2SetupExperiment(self.handle, 0, 0.0, 0.0, 0, 0.0);
            fmi2EnterInitializationMode(self.handle);
            fmi2ExitInitializationMode(self.handle);
        }
    }

    pub(super) fn step(&self, time: f64, step: f64) {
        // SAFETY: the handle is alive.
        unsafe { fmi2DoStep(self.handle, time, step, 0) };
    }

    pub(super) fn read_all(&self) {
        for reference in 0..self.of.references {
            let mut value = 0.0;
            // SAFETY: one reference, room for one value.
            unsafe { fmi2GetReal(self.handle, &raw const reference, 1, &raw mut value) };
        }
    }

    /// The serialized state.
    pub(super) fn saved(&self) -> Vec<u8> {
        let (mut state, mut size) = (null_mut(), 0);
        // SAFETY: places for a state and a size; the buffer has the length that is passed.
        unsafe {
            fmi2GetFMUstate(self.handle, &raw mut state);
            fmi2SerializedFMUstateSize(self.handle, state, &raw mut size);
            let mut bytes = vec![0_u8; size];
            fmi2SerializeFMUstate(self.handle, state, bytes.as_mut_ptr().cast(), size);
            fmi2FreeFMUstate(self.handle, &raw mut state);
            bytes
        }
    }

    /// Goes to a serialized state, if it is taken.
    pub(super) fn load(&self, bytes: &[u8]) -> bool {
        let mut state = null_mut();
        // SAFETY: the bytes have the length that is passed; the state is one of the library.
        unsafe {
            let read = fmi2DeSerializeFMUstate(
                self.handle,
                bytes.as_ptr().cast(),
                bytes.len(),
                &raw mut state,
            );
            let taken = read == 0 && fmi2SetFMUstate(self.handle, state) == 0;
            if read == 0 {
                fmi2FreeFMUstate(self.handle, &raw mut state);
            }
            taken
        }
    }
}

pub(super) struct Calls;

impl Target for Calls {
    fn name(&self) -> &'static str {
        "calls"
    }

    fn corpus(&self) -> Vec<Vec<u8>> {
        let start = [0, 1, 2];
        let steps = |count: usize| [11, 0, 2, 8, 3, 1, 9, 5, 1].repeat(count);
        let states = [12, 11, 0, 2, 13, 0, 11, 0, 2, 15, 14, 0];
        let bodies = [
            [&start[..], &steps(6)].concat(),
            [&start[..], &steps(2), &states, &steps(2), &[3, 4]].concat(),
            (0..=255).collect(),
        ];
        let versions = [2, 3];
        let inputs = versions
            .iter()
            .flat_map(|version| bodies.iter().map(|body| [&[*version], &body[..]].concat()));
        inputs.collect()
    }

    fn attempt(&self, input: &[u8]) -> bool {
        let Some((version, rest)) = input.split_first() else {
            return false;
        };
        let bytes = Bytes(rest);
        match version % 2 {
            0 => calls2(bytes),
            _ => calls3(bytes),
        }
        true
    }
}

/// What is left of an input; zeros after its end.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn next(&mut self) -> Option<u8> {
        let (first, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(*first)
    }

    fn byte(&mut self) -> u8 {
        self.next().unwrap_or(0)
    }

    fn number(&mut self) -> f64 {
        const NUMBERS: [f64; 16] = [
            0.0,
            0.001,
            0.01,
            0.02,
            0.1,
            1.0,
            -1.0,
            -0.0,
            1e-12,
            1e-300,
            1e9,
            1e30,
            1e160,
            f64::MAX,
            f64::NAN,
            f64::INFINITY,
        ];
        NUMBERS[usize::from(self.byte() % 16)]
    }

    /// Some references, most of them of the model.
    fn references(&mut self, count: u32) -> Vec<u32> {
        let length = self.byte() % 4;
        let reference = |bytes: &mut Self| match bytes.byte() {
            255 => u32::MAX,
            byte => (u32::from(byte) * 256 + u32::from(bytes.byte())) % (count + 2),
        };
        (0..length).map(|_| reference(self)).collect()
    }

    fn numbers(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.number()).collect()
    }
}

/// One of the saved states, or NULL.
fn pick(states: &[Handle], byte: u8) -> Handle {
    states.get(usize::from(byte)).copied().unwrap_or(null_mut())
}

fn calls2(mut bytes: Bytes<'_>) {
    let of = model();
    let instance = Two::new(of);
    let handle = instance.handle;
    let mut states: Vec<Handle> = Vec::new();
    let mut time = 0.0;
    while let Some(call) = bytes.next() {
        let references = match call % 20 {
            5..=10 | 16 | 17 => bytes.references(of.references),
            _ => Vec::new(),
        };
        let (pointer, count) = (references.as_ptr(), references.len());
        // SAFETY: the instance is alive, states are those of the library and not freed, or NULL; slices have the lengths that
        // are passed.
        unsafe {
            match call % 20 {
                0 => drop(fmi2SetupExperiment(
                    handle,
                    0,
                    0.0,
                    bytes.number(),
                    c_int::from(bytes.byte() % 2),
                    bytes.number(),
                )),
                1 => drop(fmi2EnterInitializationMode(handle)),
                2 => drop(fmi2ExitInitializationMode(handle)),
                3 => drop(fmi2Terminate(handle)),
                4 => drop(fmi2Reset(handle)),
                5 => drop(fmi2GetReal(
                    handle,
                    pointer,
                    count,
                    vec![0.0; count].as_mut_ptr(),
                )),
                6 | 8 => drop(fmi2SetReal(
                    handle,
                    pointer,
                    count,
                    bytes.numbers(count).as_ptr(),
                )),
                7 => drop(fmi2GetInteger(
                    handle,
                    pointer,
                    count,
                    vec![0; count].as_mut_ptr(),
                )),
                9 => drop(fmi2SetInteger(
                    handle,
                    pointer,
                    count,
                    vec![c_int::from(bytes.byte()); count].as_ptr(),
                )),
                10 => drop(fmi2GetString(
                    handle,
                    pointer,
                    count,
                    vec![null(); count].as_mut_ptr(),
                )),
                11 | 18 | 19 => {
                    let (off, step) = (bytes.byte(), bytes.number());
                    let at = if off > 200 { bytes.number() } else { time };
                    if fmi2DoStep(handle, at, step.min(0.1), c_int::from(off % 2)) <= 1 {
                        time += step.min(0.1);
                    }
                }
                12 => {
                    let mut state = null_mut();
                    if states.len() < 8 && fmi2GetFMUstate(handle, &raw mut state) == 0 {
                        states.push(state);
                    }
                }
                13 => drop(fmi2SetFMUstate(handle, pick(&states, bytes.byte()))),
                14 => {
                    let at = usize::from(bytes.byte());
                    if at < states.len() {
                        let mut state = states.swap_remove(at);
                        fmi2FreeFMUstate(handle, &raw mut state);
                    }
                }
                15 => {
                    let mut size = 0;
                    let state = pick(&states, bytes.byte());
                    if fmi2SerializedFMUstateSize(handle, state, &raw mut size) == 0 {
                        let mut room = vec![0_u8; size];
                        fmi2SerializeFMUstate(
                            handle,
                            state,
                            room.as_mut_ptr().cast(),
                            size / (1 + usize::from(bytes.byte() % 2)),
                        );
                    }
                }
                16 => {
                    let knowns = bytes.references(of.references);
                    let seed = bytes.numbers(knowns.len());
                    let mut out = vec![0.0; count];
                    fmi2GetDirectionalDerivative(
                        handle,
                        pointer,
                        count,
                        knowns.as_ptr(),
                        knowns.len(),
                        seed.as_ptr(),
                        out.as_mut_ptr(),
                    );
                }
                _ => {
                    let orders = vec![c_int::from(bytes.byte() % 3); count];
                    fmi2SetRealInputDerivatives(
                        handle,
                        pointer,
                        count,
                        orders.as_ptr(),
                        bytes.numbers(count).as_ptr(),
                    );
                }
            }
        }
    }
    for mut state in states {
        // SAFETY: a state of this instance, not freed before.
        unsafe { fmi2FreeFMUstate(handle, &raw mut state) };
    }
}

fn calls3(mut bytes: Bytes<'_>) {
    let of = model();
    let folder = format!("{}/", of.folder.path().display());
    let (name, token, folder) = (text("x"), text(&of.model.guid), text(&folder));
    let early = bytes.byte() % 2 == 1;
    // SAFETY: texts end with NUL and live through the call; there are no callbacks and no required variables.
    let handle = unsafe {
        fmi3InstantiateCoSimulation(
            name.as_ptr(),
            token.as_ptr(),
            folder.as_ptr(),
            false,
            false,
            false,
            early,
            null(),
            0,
            null_mut(),
            null(),
            null(),
        )
    };
    assert!(
        !handle.is_null(),
        "no instance in {}",
        Path::new(&of.folder.path()).display()
    );
    let mut states: Vec<Handle> = Vec::new();
    let mut time = 0.0;
    while let Some(call) = bytes.next() {
        let references = match call % 16 {
            5..=8 => bytes.references(of.references),
            _ => Vec::new(),
        };
        let (pointer, count) = (references.as_ptr(), references.len());
        let length = count * usize::from(bytes.byte() % 4);
        // SAFETY: as in `calls2`.
        unsafe {
            match call % 16 {
                0 | 1 => drop(fmi3EnterInitializationMode(
                    handle,
                    false,
                    0.0,
                    bytes.number(),
                    bytes.byte() % 2 == 1,
                    bytes.number(),
                )),
                2 => drop(fmi3ExitInitializationMode(handle)),
                3 => drop(fmi3Terminate(handle)),
                4 => drop(fmi3Reset(handle)),
                5 | 7 => drop(fmi3GetFloat64(
                    handle,
                    pointer,
                    count,
                    vec![0.0; length].as_mut_ptr(),
                    length,
                )),
                6 | 8 => drop(fmi3SetFloat64(
                    handle,
                    pointer,
                    count,
                    bytes.numbers(length).as_ptr(),
                    length,
                )),
                12 => {
                    let mut state = null_mut();
                    if states.len() < 8 && fmi3GetFMUState(handle, &raw mut state) == 0 {
                        states.push(state);
                    }
                }
                13 => drop(fmi3SetFMUState(handle, pick(&states, bytes.byte()))),
                14 => {
                    let at = usize::from(bytes.byte());
                    if at < states.len() {
                        let mut state = states.swap_remove(at);
                        fmi3FreeFMUState(handle, &raw mut state);
                    }
                }
                _ => {
                    let (mut event, mut terminate, mut early, mut last) =
                        (false, false, false, 0.0);
                    let step = bytes.number().min(0.1);
                    let (e, t, r) = (&raw mut event, &raw mut terminate, &raw mut early);
                    if fmi3DoStep(
                        handle,
                        time,
                        step,
                        bytes.byte() % 2 == 1,
                        e,
                        t,
                        r,
                        &raw mut last,
                    ) <= 1
                    {
                        time = last;
                    }
                }
            }
        }
    }
    // SAFETY: states of this instance, not freed before; the instance is freed after them.
    unsafe {
        for mut state in states {
            fmi3FreeFMUState(handle, &raw mut state);
        }
        fmi3FreeInstance(handle);
    }
}
