//! The internal steps of a communication step: equal, or as long as wanted, landing exactly on its end.

/// In how many equal steps of at most `step` \[s\] a time `h` \[s\] goes; a margin keeps what is a whole number but for rounding.
fn pieces(h: f64, step: f64) -> u64 {
    (h / step * (1.0 - 1e-9)).ceil().max(1.0) as u64
}

/// `h` \[s\] without the rounding of whoever subtracted two times: the number of six digits, or the whole multiple of `step`
/// \[s\], that is within 1e-9 of it, so that masters whose times differ by rounding get the same bits.
fn unrounded(h: f64, step: f64) -> f64 {
    let near = |value: f64| ((value - h).abs() <= 1e-9 * h).then_some(value);
    let decimal = format!("{h:.5e}").parse().ok().and_then(near);
    let whole = near((h / step).round() * step);
    decimal.or(whole).unwrap_or(h)
}

/// The internal steps of a communication step.
#[derive(Debug)]
pub(super) struct StepPlan {
    start: f64,
    end: f64,
    /// `end - start` \[s\] without rounding, and how much of it has been taken.
    length: f64,
    elapsed: f64,
    steps: u64,
    done: u64,
}

impl StepPlan {
    /// From `start` to `end` \[s\] in steps of at most `wanted` \[s\]; `step` \[s\] is that of the scene.
    pub(super) fn new(start: f64, end: f64, wanted: f64, step: f64) -> Self {
        let length = unrounded(end - start, step);
        Self {
            start,
            end,
            length,
            elapsed: 0.0,
            steps: pieces(length, wanted),
            done: 0,
        }
    }

    /// Length of the communication step \[s\].
    pub(super) fn length(&self) -> f64 {
        self.length
    }

    /// Begin of the communication step \[s\].
    pub(super) fn start(&self) -> f64 {
        self.start
    }

    /// How many steps are left.
    pub(super) fn left(&self) -> u64 {
        self.steps - self.done
    }

    /// End and length of the next step from the time `now` \[s\]; what is left is divided anew by `wanted` \[s\], if given.
    pub(super) fn next(&mut self, now: f64, wanted: Option<f64>) -> (f64, f64) {
        self.done += 1;
        let (mut target, dt) = match wanted {
            None => {
                let share = self.done as f64 / self.steps as f64;
                let target = self.start + (self.end - self.start) * share;
                (target, self.length / self.steps as f64)
            }
            Some(wanted) => {
                let rest = self.length - self.elapsed;
                let left = pieces(rest, wanted);
                self.steps = self.done - 1 + left;
                let dt = rest / left as f64;
                (now + dt, dt)
            }
        };
        if self.left() == 0 {
            target = self.end;
        }
        self.elapsed += dt;
        (target, dt)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Times that differ by rounding give the same steps, and the last one ends where the communication step does.
    #[test]
    fn steps_end_at_the_end() {
        for start in [0.0, 0.1, 1.0 / 3.0] {
            let end = start + 0.01;
            let mut plan = StepPlan::new(start, end, 1e-3, 1e-3);
            assert_eq!(plan.left(), 10, "{start}");
            let (mut now, mut sum) = (start, 0.0);
            while plan.left() > 0 {
                let (target, dt) = plan.next(now, None);
                assert!(target > now && dt == 0.01 / 10.0);
                (now, sum) = (target, sum + dt);
            }
            assert!(now == end && (sum - 0.01).abs() < 1e-15);
        }
    }

    /// A wanted length changes how many steps are left.
    #[test]
    fn a_wanted_length_divides_what_is_left() {
        let mut plan = StepPlan::new(0.0, 1.0, 0.5, 0.5);
        assert_eq!(plan.next(0.0, Some(0.5)), (0.5, 0.5));
        assert_eq!(plan.next(0.5, Some(0.2)).1, 0.5 / 3.0);
        assert_eq!(plan.left(), 2);
        assert_eq!(plan.next(0.7, Some(1.0)).0, 1.0);
        assert_eq!(plan.left(), 0);
    }
}
