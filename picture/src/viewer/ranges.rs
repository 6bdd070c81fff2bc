//! Where colours end: nearly all sampled values lie below.

/// Values of a frame that are sampled.
pub(super) const SAMPLES: usize = 400;
/// Share of the sampled values that lies below the top of the colours.
const TOP: f64 = 0.99;

/// The top of the colours of these samples.
pub(super) fn top(samples: &[f64]) -> f64 {
    quantile(samples, TOP)
}

/// The value below which lies this share of the samples.
pub(super) fn quantile(samples: &[f64], share: f64) -> f64 {
    let mut sorted = samples.to_vec();
    sorted.sort_by(f64::total_cmp);
    let at = (share * sorted.len().saturating_sub(1) as f64).round() as usize;
    sorted.get(at).copied().unwrap_or(0.0)
}
