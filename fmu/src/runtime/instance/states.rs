//! Saved states of an instance.

use std::sync::Arc;

use sphere_dda::scene::Scene;
use sphere_dda::simulation::{Saved, Simulation};

use super::{Instance, Measured};
use crate::runtime::life_cycle::LifeCycle;
use crate::runtime::refusal::Refusal;
use crate::runtime::state::{InstanceState, SavedState, StateError, check_stage};
use sphere_dda_fmi_interface::log::Level;

/// A complete state of an instance, kept in memory: it shares what no step has changed since.
#[derive(Debug)]
pub struct Kept {
    guid: String,
    run: InstanceState,
    /// The scene with the values it was built with.
    base: Arc<Scene>,
    /// The scene with the values that are set.
    latest: Arc<Scene>,
    simulation: Option<Saved>,
}

impl Kept {
    /// The state as bytes: see [`crate::runtime::state`].
    ///
    /// # Errors
    /// [`Refusal::State`] if the serializer fails.
    pub fn encode(&self) -> Result<Vec<u8>, Refusal> {
        let replay = self.simulation.as_ref().and_then(Saved::replay_record);
        let saved = SavedState {
            guid: self.guid.clone(),
            run: self.run.clone(),
            snapshot: self.simulation.as_ref().map(Saved::snapshot),
            replay: replay.cloned(),
        };
        Ok(saved.encode()?)
    }
}

impl Instance {
    /// The complete state, kept in memory.
    #[must_use]
    pub fn keep(&self) -> Kept {
        Kept {
            guid: self.model.guid.clone(),
            run: self.run.clone(),
            base: Arc::clone(&self.base),
            latest: Arc::clone(&self.latest),
            simulation: self.simulation.as_ref().map(Simulation::save),
        }
    }

    /// Puts the instance into a state that this or another instance of the model has kept.
    ///
    /// # Errors
    /// [`Refusal::State`] if it is of another model, or none to go on from: the instance is as before.
    pub fn restore(&mut self, kept: &Kept) -> Result<(), Refusal> {
        if kept.guid != self.model.guid {
            return Err(Refusal::State(StateError::Model {
                found: kept.guid.clone(),
                expected: self.model.guid.clone(),
            }));
        }
        check_stage(kept.run.stage)?;
        match (&mut self.simulation, &kept.simulation) {
            (Some(simulation), Some(saved)) => simulation.load(saved),
            (simulation, saved) => *simulation = saved.as_ref().map(Saved::to_simulation),
        }
        self.base = Arc::clone(&kept.base);
        self.latest = Arc::clone(&kept.latest);
        self.run.clone_from(&kept.run);
        self.restored();
        Ok(())
    }

    /// The complete state as bytes: see [`crate::runtime::state`].
    ///
    /// # Errors
    /// [`Refusal::State`] if the serializer fails.
    pub fn save(&self) -> Result<Vec<u8>, Refusal> {
        self.keep().encode()
    }

    /// Whether bytes are a state of this model.
    ///
    /// # Errors
    /// [`Refusal::State`].
    pub fn verify(&self, bytes: &[u8]) -> Result<(), Refusal> {
        Ok(SavedState::decode(bytes, &self.model.guid)?.check(&self.run)?)
    }

    /// Puts the instance into a saved state, also one of another instance or process.
    ///
    /// # Errors
    /// [`Refusal::State`], [`Refusal::Snapshot`]: the instance is as before.
    pub fn load(&mut self, bytes: &[u8]) -> Result<(), Refusal> {
        let saved = SavedState::decode(bytes, &self.model.guid)?;
        saved.check(&self.run)?;
        let (parameters, values) = (&saved.run.parameters, &saved.run.values);
        let base = match saved.run.built == self.run.built {
            true => Arc::clone(&self.base),
            false => self.model.scene_with(&saved.run.built)?,
        };
        let known = |scene: &Scene| {
            scene
                .parameters
                .iter()
                .map(|p| p.value)
                .eq(values.iter().copied())
        };
        let latest = match [&base, &self.latest].into_iter().find(|scene| known(scene)) {
            Some(scene) => Arc::clone(scene),
            None => self.model.scene_with(values)?,
        };
        let same = saved.run.built == self.run.built && saved.run.stepped == self.run.stepped;
        match &saved.snapshot {
            None => self.simulation = None,
            Some(snapshot) => match self
                .simulation
                .as_mut()
                .filter(|s| same && parameters.fit(s.scene()))
            {
                Some(simulation) => simulation.resume(snapshot, saved.replay)?,
                None => {
                    let mut scene = parameters.apply(&base);
                    if saved.run.stepped != saved.run.built {
                        scene = scene.tuned(&*self.model.scene_with(&saved.run.stepped)?);
                    }
                    let mut simulation = Simulation::new(scene.into())?;
                    simulation.resume(snapshot, saved.replay)?;
                    self.simulation = Some(simulation);
                }
            },
        }
        (self.base, self.latest) = (base, latest);
        self.run = saved.run;
        self.restored();
        Ok(())
    }

    /// Lets what is measured and recorded follow a restored state.
    fn restored(&mut self) {
        self.measured = Measured::default();
        match &self.simulation {
            Some(simulation) if self.run.stage == LifeCycle::StepComplete => {
                self.recorder
                    .follow(&self.name, &self.run.parameters, simulation, &self.log);
            }
            Some(_) if self.run.stage == LifeCycle::StepFailed => {}
            _ => {
                // The log tells of files that were not written; the restored state is whole all the same.
                self.recorder.close(&self.log);
            }
        }
        self.log.write(
            Level::Ok,
            format_args!("restored the state of t = {} s", self.run.time),
        );
    }
}
