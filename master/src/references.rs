//! What an FMU brings along to be checked with: smoke tests in the form of the layered standard FMI-LS-REF, and checksums.

use std::fs;
use std::path::{Path, PathBuf};

use csv::{ReaderBuilder, Trim};
use percent_encoding::percent_decode_str;
use sphere_dda_fmi_interface::checksum::sha256;
use sphere_dda_model_description::references::{
    CHECKSUMS_FILE, Data, Experiment, Experiments, FOLDER, MANIFEST_FILE, Manifest, Related,
    Tolerances, Transient,
};
use thiserror::Error;

use crate::fmu::Fmu;
use crate::run::Table;
use crate::value::{Value, Values};

/// Share of a time by which two that are equal may differ.
const SAME_TIME: f64 = 1e-9;
/// Most faults of a list in a message.
const SHOWN: usize = 10;

/// Why there is no evidence to check an FMU with.
#[derive(Debug, Error)]
#[error("{}: {}", path.display(), listed(faults))]
pub struct ReferencesError {
    path: PathBuf,
    faults: Vec<String>,
}

fn listed(faults: &[String]) -> String {
    let mut text = faults[..faults.len().min(SHOWN)].join("; ");
    if faults.len() > SHOWN {
        text += &format!("; and {} more", faults.len() - SHOWN);
    }
    text
}

/// What an FMU brings along.
#[derive(Debug)]
pub struct References {
    /// The smoke tests, at least one.
    pub tests: Vec<SmokeTest>,
    /// Number of files whose checksums are right; `None`: it has no checksums.
    pub checked: Option<usize>,
}

/// A run with expected results.
#[derive(Debug)]
pub struct SmokeTest {
    /// Its name.
    pub name: String,
    /// When.
    pub times: Transient,
    /// Inputs over time, CSV.
    pub inputs: Option<PathBuf>,
    /// What is expected; without it the run only has to reach its end.
    pub expected: Option<Expected>,
    /// How far results may be from it.
    pub tolerances: Tolerances,
}

/// Values of variables over time, as text.
#[derive(Debug)]
pub struct Expected {
    /// Names of the variables.
    pub names: Vec<String>,
    rows: Vec<(f64, Vec<String>)>,
}

/// How a run compares with what is expected.
#[derive(Debug, Default)]
pub struct Comparison {
    /// Largest deviation over what is allowed \[-\].
    pub worst: f64,
    /// What is beyond, for each variable the first.
    pub faults: Vec<String>,
}

impl References {
    /// Reads what `fmu` brings along, and judges its checksums.
    ///
    /// # Errors
    /// [`ReferencesError`]: there is nothing, or files are missing, changed or broken: all of them.
    pub fn of(fmu: &Fmu) -> Result<Self, ReferencesError> {
        let failed = |faults: Vec<String>| ReferencesError {
            path: fmu.path().to_path_buf(),
            faults,
        };
        let folder = Folder {
            root: fmu.folder(),
            own: fmu.folder().join(FOLDER),
        };
        if !folder.own.join(MANIFEST_FILE).exists() {
            return Err(failed(vec![format!(
                "found no `{FOLDER}/{MANIFEST_FILE}`, expected an FMU with a smoke test, as `export --smoke-test` makes them"
            )]));
        }
        let checked = folder.checksums().map_err(failed)?;
        if checked.is_none() && fmu.description().is_of("sphere-dda ") {
            return Err(failed(vec![format!(
                "found no `{FOLDER}/{CHECKSUMS_FILE}`, expected it in an FMU of sphere-dda: it was taken out"
            )]));
        }
        let tests = folder.tests().map_err(|fault| failed(vec![fault]))?;
        if tests.is_empty() {
            return Err(failed(vec![format!(
                "`{FOLDER}/{MANIFEST_FILE}`: found no experiment of the role `experiment/smoke-test`, expected one"
            )]));
        }
        Ok(Self { tests, checked })
    }
}

/// The unpacked archive, and the folder of the layered standard in it.
struct Folder<'a> {
    root: &'a Path,
    own: PathBuf,
}

impl Folder<'_> {
    /// The file that a relative URI names, which is inside the archive.
    fn file(&self, source: &str) -> Result<PathBuf, String> {
        let decoded = percent_decode_str(source).decode_utf8_lossy();
        let inside = "a file of the archive, relative to the manifest";
        let path = self.own.join(&*decoded);
        let path = fs::canonicalize(&path)
            .map_err(|error| format!("`{source}`: {error}; expected {inside}"))?;
        match fs::canonicalize(self.root) {
            Ok(root) if path.starts_with(&root) => Ok(path),
            _ => Err(format!("found `{source}`, expected {inside}")),
        }
    }

    fn text(&self, source: &str) -> Result<String, String> {
        fs::read_to_string(self.file(source)?).map_err(|error| format!("`{source}`: {error}"))
    }

    /// Number of files whose checksums are right, or all that are wrong; `None`: there are no checksums.
    fn checksums(&self) -> Result<Option<usize>, Vec<String>> {
        if !self.own.join(CHECKSUMS_FILE).exists() {
            return Ok(None);
        }
        let text = self.text(CHECKSUMS_FILE).map_err(|fault| vec![fault])?;
        let (mut checked, mut faults) = (0, Vec::new());
        let mut manifest = false;
        for (line, entry) in (1..).zip(text.lines()) {
            let Some((expected, source)) = entry.split_once("  ") else {
                faults.push(format!(
                    "`{CHECKSUMS_FILE}`, line {line}: found `{entry}`, expected a checksum, two blanks and a path"
                ));
                continue;
            };
            manifest |= source == MANIFEST_FILE;
            let content = self
                .file(source)
                .and_then(|path| fs::read(path).map_err(|error| format!("`{source}`: {error}")));
            let shown = source.trim_start_matches("../");
            match content {
                Err(_) => faults.push(format!("`{shown}` is missing, expected it as it was exported")),
                Ok(content) if sha256(&content) != expected => faults.push(format!(
                    "`{shown}` was changed after the export: its SHA-256 is not that of `{CHECKSUMS_FILE}`"
                )),
                Ok(_) => checked += 1,
            }
        }
        if !manifest {
            faults.push(format!(
                "`{CHECKSUMS_FILE}`: found no checksum of `{MANIFEST_FILE}`, expected one"
            ));
        }
        match faults.is_empty() {
            true => Ok(Some(checked)),
            false => Err(faults),
        }
    }

    fn tests(&self) -> Result<Vec<SmokeTest>, String> {
        let manifest = Manifest::from_xml(&self.text(MANIFEST_FILE)?)
            .map_err(|error| format!("`{FOLDER}/{MANIFEST_FILE}`: {error}"))?;
        let mut tests = Vec::new();
        for related in manifest
            .related
            .iter()
            .filter(|r| Related::is_smoke_test(r))
        {
            let source = &related.source;
            let experiments = Experiments::from_xml(&self.text(source)?)
                .map_err(|error| format!("`{source}`: {error}"))?;
            // Its own files are relative to it.
            let base = source.rsplit_once('/').map_or("", |(folder, _)| folder);
            for experiment in &experiments.list {
                tests.push(self.test(experiment, base)?);
            }
        }
        Ok(tests)
    }

    fn test(&self, experiment: &Experiment, base: &str) -> Result<SmokeTest, String> {
        let name = &experiment.name;
        if experiment.parameters.is_some() {
            return Err(format!(
                "experiment `{name}`: found `Parameters`, expected none: sets of parameters are not read"
            ));
        }
        let file = |data: &Option<Data>| {
            let Some(data) = data else {
                return Ok(None);
            };
            match data.media_type.as_deref() {
                None | Some("text/csv") => self
                    .file(&Path::new(base).join(&data.source).to_string_lossy())
                    .map(Some),
                Some(other) => Err(format!(
                    "experiment `{name}`, `{}`: found type `{other}`, expected `text/csv`",
                    data.source
                )),
            }
        };
        let expected = file(&experiment.references)?;
        Ok(SmokeTest {
            name: name.clone(),
            times: experiment.times(),
            inputs: file(&experiment.stimuli)?,
            expected: expected.map(|path| Expected::read(&path)).transpose()?,
            tolerances: experiment.tolerances().unwrap_or_default(),
        })
    }
}

impl Expected {
    /// Reads a table of comma-separated values: time, then the variables.
    fn read(path: &Path) -> Result<Self, String> {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let fault = |error: csv::Error| format!("`{name}`: {error}");
        let mut reader = ReaderBuilder::new()
            .trim(Trim::All)
            .from_path(path)
            .map_err(fault)?;
        let header = reader.headers().map_err(fault)?.clone();
        if header.get(0) != Some("time") || header.len() < 2 {
            return Err(format!(
                "`{name}`, line 1: found first column {:?} of {}, expected `time` and at least one variable",
                header.get(0).unwrap_or_default(),
                header.len()
            ));
        }
        let mut rows = Vec::new();
        for record in reader.records() {
            let record = record.map_err(fault)?;
            let cell = record.get(0).unwrap_or_default();
            let time: Option<f64> = cell.parse().ok().filter(|time: &f64| time.is_finite());
            let Some(time) = time else {
                return Err(format!(
                    "`{name}`: found time {cell:?}, expected a finite number"
                ));
            };
            rows.push((time, record.iter().skip(1).map(str::to_owned).collect()));
        }
        if rows.is_empty() {
            return Err(format!(
                "`{name}`: found no line of values, expected at least one"
            ));
        }
        let names = header.iter().skip(1).map(str::to_owned).collect();
        Ok(Self { names, rows })
    }

    /// Number of times.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether nothing is expected.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Compares with what a run has recorded of [`Self::names`]: numbers within `tolerances`, of which the relative one is of
    /// the largest expected value of the variable, all else as text.
    #[must_use]
    pub fn compare(&self, table: &Table, tolerances: Tolerances) -> Comparison {
        let mut result = Comparison::default();
        for (k, name) in self.names.iter().enumerate() {
            let Some(column) = table.columns.iter().find(|column| column.name == *name) else {
                result
                    .faults
                    .push(format!("`{name}` was not recorded, expected its values"));
                continue;
            };
            let numbers = self
                .rows
                .iter()
                .filter_map(|(_, row)| row[k].parse::<f64>().ok());
            let largest = numbers.fold(0.0, |most: f64, x| most.max(x.abs()));
            let allowed = tolerances.absolute + tolerances.relative * largest;
            for (time, row) in &self.rows {
                let found = at(&table.time, &column.values, *time);
                let deviation = match (&found, row[k].parse::<f64>()) {
                    (Some(Value::Real(found)), Ok(wanted)) => (found - wanted).abs(),
                    (Some(Value::Integer(found)), Ok(wanted)) => (*found as f64 - wanted).abs(),
                    (Some(other), _) if other.to_string() == row[k] => 0.0,
                    _ => f64::INFINITY,
                };
                // NaN is not within either.
                let share = if deviation <= allowed {
                    deviation / allowed.max(f64::MIN_POSITIVE)
                } else {
                    f64::INFINITY
                };
                result.worst = result.worst.max(share);
                if share > 1.0 {
                    let found =
                        found.map_or_else(|| "nothing".to_owned(), |value| value.to_string());
                    result.faults.push(format!(
                        "`{name}` at {time} s: found {found}, expected {} within {allowed:.1e}",
                        row[k]
                    ));
                    break;
                }
            }
        }
        result
    }
}

/// The value at `time`: real numbers are linear between two times, all else is that of the earlier.
fn at(times: &[f64], values: &Values, time: f64) -> Option<Value> {
    let slack = SAME_TIME * time.abs().max(1.0);
    let next = times.partition_point(|t| *t < time - slack);
    let later = *times.get(next)?;
    if (later - time).abs() <= slack {
        return values.get(next);
    }
    let earlier = next.checked_sub(1)?;
    match (values.get(earlier)?, values.get(next)?) {
        (Value::Real(a), Value::Real(b)) => {
            let share = (time - times[earlier]) / (later - times[earlier]);
            Some(Value::Real(a + (b - a) * share))
        }
        (value, _) => Some(value),
    }
}
