//! Saved states of an instance.

use std::sync::Arc;

use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;

use super::{Instance, Measured};
use crate::runtime::life_cycle::LifeCycle;
use crate::runtime::refusal::Refusal;
use crate::runtime::state::SavedState;
use sphere_dda_fmi_interface::log::Level;

impl Instance {
    /// The complete state as bytes: see [`crate::runtime::state`].
    ///
    /// # Errors
    /// [`Refusal::State`] if the serializer fails.
    pub fn save(&self) -> Result<Vec<u8>, Refusal> {
        let saved = SavedState {
            guid: self.model.guid.clone(),
            run: self.run.clone(),
            snapshot: self.simulation.as_ref().map(Simulation::snapshot),
            replay: self
                .simulation
                .as_ref()
                .and_then(Simulation::replay_record)
                .cloned(),
        };
        Ok(saved.encode()?)
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
        Ok(())
    }
}
