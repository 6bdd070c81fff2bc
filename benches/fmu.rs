//! What the FMU costs over the library: the bed of 1000 spheres in communication steps of 1 ms, in turns.
//!
//! ```sh
//! sphere-dda export examples/dropped/dropped.toml -o bed.fmu
//! cargo bench -p sphere-dda-fmu --bench fmu -- bed.fmu
//! ```
//!
//! Wall time, on a machine that does nothing else: CPU time comes in ticks of milliseconds. The FMU is the archive's own
//! release library behind its C interface; after every step the wrench of the box and all scalar outputs are read, as masters do: `reading us` is what that takes, the median of the steps.
//! `state us` is what it takes to save a state, to restore it and to free it, a step lying between; likewise.

use std::sync::Arc;
use std::time::{Duration, Instant};

use sphere_dda::simulation::Simulation;
use sphere_dda_fmu::model::Model;
use sphere_dda_master::{Fmu, Instance2};
use sphere_dda_model_description::fmi2::{Causality, VariableType};

const STEP: f64 = 1e-3;
const STEPS: u32 = 300;
const ROUNDS: usize = 15;

/// Median time of saving, restoring and freeing a state that the instance has left \[us\].
fn state_time(instance: &mut Instance2) -> f64 {
    let time = f64::from(STEPS) * STEP;
    let mut taken: Vec<Duration> = (0..100)
        .map(|_| {
            let start = Instant::now();
            let state = instance.save_state().expect("a state");
            let saving = start.elapsed();
            instance.do_step(time, STEP, false).expect("a step");
            let start = Instant::now();
            instance.restore_state(&state).expect("restored");
            instance.free_state(state).expect("freed");
            saving + start.elapsed()
        })
        .collect();
    taken.sort_unstable();
    taken[taken.len() / 2].as_secs_f64() * 1e6
}

fn main() {
    let path = std::env::args().skip(1).find(|a| !a.starts_with('-'));
    let path = path.expect("the path of the exported bed after `--`");
    let fmu = Fmu::open(path).expect("an FMU");
    let model = Model::read(&fmu.folder().join("resources/scene.toml"), None).expect("its scene");
    let scene = Arc::clone(&model.scene);
    let description = fmu.description().version_2().expect("an FMU of FMI 2.0");
    let variables = description.model_variables.iter();
    let outputs: Vec<u32> = variables
        .filter(|v| {
            matches!(v.causality, Causality::Output | Causality::Local)
                && matches!(v.variable_type, VariableType::Real(_))
        })
        .map(|v| v.value_reference)
        .collect();
    println!(
        "round  library s  FMU s  ratio   reading us  state us   ({STEPS} steps, {} outputs read after each)",
        outputs.len()
    );
    let (mut best, mut ratios) = ([f64::INFINITY; 2], Vec::new());
    for round in 0..ROUNDS {
        let mut library = Simulation::new(Arc::clone(&scene)).expect("a start");
        let start = Instant::now();
        for k in 1..=STEPS {
            library.advance_to(f64::from(k) * STEP).expect("a step");
        }
        let alone = start.elapsed().as_secs_f64();
        let mut instance = fmu.instantiate("bed", false).expect("an instance");
        instance.setup_experiment(None, 0.0, None).expect("set up");
        instance.enter_initialization_mode().expect("initialized");
        instance.exit_initialization_mode().expect("ready");
        let start = Instant::now();
        let (mut last, mut reading) = (Vec::new(), Vec::new());
        for k in 0..STEPS {
            instance
                .do_step(f64::from(k) * STEP, STEP, true)
                .expect("a step");
            let asked = Instant::now();
            last = instance.get_real(&outputs).expect("values");
            reading.push(asked.elapsed());
        }
        let packed = start.elapsed().as_secs_f64();
        reading.sort_unstable();
        let reading = reading[reading.len() / 2].as_secs_f64() * 1e6;
        assert!(last.iter().all(|x| x.is_finite()));
        let state = state_time(&mut instance);
        ratios.push(packed / alone);
        best = [best[0].min(alone), best[1].min(packed)];
        println!(
            "{round:5}  {alone:9.3}  {packed:5.3}  {:.4}  {reading:10.1}  {state:8.1}",
            packed / alone
        );
    }
    ratios.sort_by(f64::total_cmp);
    println!("median of the ratios {:.4}", ratios[ROUNDS / 2]);
    println!(
        " best  {:9.3}  {:5.3}  {:.4}",
        best[0],
        best[1],
        best[1] / best[0]
    );
}
