//! Outputs that a scene names: `[fmu] outputs`.

use sphere_dda_model_description::fmi2::Causality;
use thiserror::Error;
use wildmatch::WildMatch;

use super::variable::Variable;

/// Patterns that name nothing that is measured.
#[derive(Debug, Error)]
#[error("{}", .0.join("; "))]
pub struct UnknownOutputs(Vec<String>);

/// Makes what `patterns` name, and nothing else that is measured, an output. An element, `x[3]`, names the whole vector.
pub(super) fn choose(
    patterns: &[String],
    variables: &mut [Variable],
) -> Result<(), UnknownOutputs> {
    let wanted = patterns
        .iter()
        .map(|pattern| WildMatch::new(whole(pattern)));
    let mut wanted: Vec<(WildMatch, bool)> = wanted.map(|pattern| (pattern, false)).collect();
    for variable in variables
        .iter_mut()
        .filter(|variable| is_measured(variable))
    {
        variable.causality = Causality::Local;
        for (pattern, names) in &mut wanted {
            if pattern.matches(&variable.name) {
                (*names, variable.causality) = (true, Causality::Output);
            }
        }
    }
    let unknown = patterns
        .iter()
        .zip(&wanted)
        .filter(|(_, (_, names))| !names);
    let faults: Vec<String> = unknown
        .map(|(pattern, _)| fault(pattern, variables))
        .collect();
    match faults.is_empty() {
        true => Ok(()),
        false => Err(UnknownOutputs(faults)),
    }
}

fn is_measured(variable: &Variable) -> bool {
    matches!(variable.causality, Causality::Output | Causality::Local)
}

/// The name without the index of an element.
fn whole(pattern: &str) -> &str {
    pattern.split_once('[').map_or(pattern, |(name, _)| name)
}

fn fault(pattern: &str, variables: &[Variable]) -> String {
    let similarity = |variable: &&Variable| {
        let similarity = strsim::jaro_winkler(whole(pattern), &variable.name);
        (1e6 * similarity) as u32
    };
    let nearest = variables.iter().filter(|variable| is_measured(variable));
    let nearest = nearest.max_by_key(similarity);
    let nearest = nearest.map_or("maxOverlap", |variable| &variable.name);
    format!(
        "`[fmu] outputs`: found `{pattern}`, expected the name of a measured variable; did you mean `{nearest}`? \
         `*` stands for any text"
    )
}
