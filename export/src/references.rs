//! What an FMU proves itself with: a smoke test, in the form of FMI-LS-REF, and checksums of all its files.
//!
//! ```text
//! extra/org.fmi-standard.fmi-ls-ref/fmi-ls-manifest.xml    what there is, and what for
//! extra/org.fmi-standard.fmi-ls-ref/smoke-test.exp         times, tolerances, which inputs and results
//! extra/org.fmi-standard.fmi-ls-ref/smoke-test-in.csv      inputs over time, if there are any
//! extra/org.fmi-standard.fmi-ls-ref/smoke-test-out.csv     outputs over time
//! extra/org.fmi-standard.fmi-ls-ref/checksums.sha256       of all other files: what `sha256sum --check` reads in this folder
//! ```

use sphere_dda_fmi_interface::checksum;
use sphere_dda_fmu::model::{SCENE_FILE, START_FILE};
use sphere_dda_model_description::Error;
use sphere_dda_model_description::references::{
    CHECKSUMS_FILE, Data, EXPERIMENTS, Experiment, Experiments, FOLDER, MANIFEST_FILE, Manifest,
    Related, Tolerances,
};

const TEST: &str = "smoke-test.exp";
const INPUTS: &str = "smoke-test-in.csv";
const RESULTS: &str = "smoke-test-out.csv";

/// A run of the FMU with its results.
#[derive(Debug, Clone)]
pub struct SmokeTest {
    /// Its end \[s\]; it begins at 0.
    pub stop: f64,
    /// Communication step \[s\].
    pub step: f64,
    /// Inputs over time, CSV.
    pub inputs: Option<Vec<u8>>,
    /// Outputs over time, CSV.
    pub results: Vec<u8>,
}

impl SmokeTest {
    /// Its files, by their paths in an archive of these other `files`.
    pub(crate) fn files(&self, files: &[(String, &[u8])]) -> Result<Vec<(String, Vec<u8>)>, Error> {
        let mut own = vec![
            (MANIFEST_FILE, self.manifest(files).to_xml()?.into_bytes()),
            (TEST, self.experiments().to_xml()?.into_bytes()),
            (RESULTS, self.results.clone()),
        ];
        own.extend(self.inputs.clone().map(|inputs| (INPUTS, inputs)));
        let others = files
            .iter()
            .map(|(path, content)| (format!("../../{path}"), *content));
        let others: Vec<(String, &[u8])> = others.collect();
        let listed = others.iter().map(|(path, content)| (&**path, *content));
        let listed = listed.chain(own.iter().map(|(name, content)| (*name, &**content)));
        let checksums = checksum::lines(listed).into_bytes();
        own.push((CHECKSUMS_FILE, checksums));
        let placed = own.into_iter();
        Ok(placed
            .map(|(name, content)| (format!("{FOLDER}/{name}"), content))
            .collect())
    }

    fn manifest(&self, files: &[(String, &[u8])]) -> Manifest {
        let csv = "text/csv";
        let mut related = vec![Related::new(
            EXPERIMENTS,
            TEST,
            "experiment/smoke-test",
            "A short run with its results",
        )];
        if self.inputs.is_some() {
            let text = "Inputs of the smoke test over time";
            related.push(Related::new(csv, INPUTS, "testcase", text));
        }
        let text = "Outputs of the smoke test over time";
        related.push(Related::new(csv, RESULTS, "result", text));
        let resources = [
            (SCENE_FILE, "application/toml", "model", "The scene"),
            (
                START_FILE,
                "application/octet-stream",
                "other",
                "The settled spheres at t = 0",
            ),
        ];
        for (name, media_type, role, text) in resources {
            let path = format!("resources/{name}");
            if files.iter().any(|(packed, _)| *packed == path) {
                related.push(Related::new(
                    media_type,
                    &format!("../../{path}"),
                    role,
                    text,
                ));
            }
        }
        let text = "SHA-256 of all other files";
        related.push(Related::new(
            "text/plain",
            CHECKSUMS_FILE,
            "signature",
            text,
        ));
        Manifest::new(related)
    }

    fn experiments(&self) -> Experiments {
        let test = Experiment {
            name: "smoke test".to_owned(),
            description: Some("A short run with its results".to_owned()),
            start: Some(0.0),
            stop: Some(self.stop),
            step: Some(self.step),
            stimuli: self.inputs.as_ref().map(|_| Data::of(INPUTS)),
            references: Some(Data::of(RESULTS)),
            ..Experiment::default()
        };
        Experiments {
            name: "smoke test".to_owned(),
            list: vec![test.within(Tolerances::default())],
        }
    }
}
