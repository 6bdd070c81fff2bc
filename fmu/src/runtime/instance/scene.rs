//! The scene of an instance: read anew with the values of its parameters.

use std::sync::Arc;

use super::Instance;
use crate::runtime::life_cycle::LifeCycle;
use crate::runtime::refusal::Refusal;

impl Instance {
    /// Builds the scene that its parameters ask for. What an importer has left as in the scene is then as in the new one.
    pub(super) fn build(&mut self) -> Result<(), Refusal> {
        let run = &mut self.run;
        if run.values == run.built {
            return Ok(());
        }
        let scene = self.model.scene_with(&run.values)?;
        run.parameters.follow(&self.base, &scene);
        let boundaries = self.base.boundaries.iter().zip(&scene.boundaries);
        for (command, (old, new)) in run.commands.iter_mut().zip(boundaries) {
            if *command == old.rest() {
                *command = new.rest();
            }
        }
        run.built.clone_from(&run.values);
        run.stepped.clone_from(&run.values);
        self.base = Arc::clone(&scene);
        self.latest = scene;
        Ok(())
    }

    /// Takes new values of the scene's parameters; between steps the scene must take them.
    pub(super) fn turn(&mut self, values: Vec<f64>) -> Result<(), Refusal> {
        if values == self.run.values {
            return Ok(());
        }
        if !matches!(
            self.run.stage,
            LifeCycle::Instantiated | LifeCycle::Initialization
        ) {
            let scene = self.model.scene_with(&values)?;
            let gravity = scene.settings.gravity;
            if gravity != self.latest.settings.gravity {
                self.run.parameters.settings.gravity = gravity;
            }
            self.latest = scene;
        }
        self.run.values = values;
        Ok(())
    }
}
