//! What the report says without measuring it: the loop, the slips of the print, the reconstruction.

use super::stepping::Tally;
use crate::table::number;

/// The paper's Fig. 2 as implemented.
pub(super) const LOOP: &str = r#"
flowchart TD
  A["start of the step: candidates, gaps M, normals n<br/>multipliers p from the last step's forces"] --> B
  B["augmented multipliers at D<br/>p^ = max(0, p - P d_n), Coulomb disc of the last p_n"] --> C
  C["K D = F by sparse Cholesky<br/>line search on the step's energy"] --> D
  D{"contact states settled?<br/>(open / stick / slip)"}
  D -- "no: open-close iteration" --> B
  D -- "yes" --> E["multiplier update p <- p^<br/>(eq 8 with the projection)"]
  E --> S["60 Gauss-Seidel sweeps<br/>(none if the penalty is held)"]
  S --> F{"gap, slip and force<br/>residual within tolerance?"}
  F -- "no, gained less than 4x" --> G["P <- 8 P<br/>(not if the penalty is held)"] --> B
  F -- "no" --> B
  F -- "yes" --> H["true gaps at the end of the step"]
  H --> I{"an overlap above tolerance,<br/>or a contact not foreseen?"}
  I -- "yes: re-linearise the gap, add the contact" --> B
  I -- "no" --> J["velocities from the forces, next step"]
"#;

/// The paper's slips in print.
pub(super) const MISPRINTS: &str = "\
All sign slips come from two conventions that meet; with `d_n = M + H D_i - Q D_j` (its eq 9) the last column follows, and is implemented.

| equation | printed | right |
|---|---|---|
| 7 | r, s = 1..3, \"disk\" | 1..6, sphere |
| 8 | multiplier update without projection | `p <- max(0, p - P d_n)`, `p = -lambda`: a contact cannot pull |
| 8, 13-18 | i counts iterations and spheres | two indices |
| 14, 23, 24 | M/l | M |
| 18, 24 | `f_j = -(..) Q_j` | `f_j = +(..) Q_j^T` |
| 19 | `H_i^T H` | `H_i^T H_i` |
| 20, 21 | `K_ij = +P H_i^T Q_j` | `K_ij = -P H_i^T Q_j`, `K_ji = K_ij^T` |
| 4 | sum of rotations about single axes | not orthogonal when two angles are non-zero: the exact exponential is used |
| text of both examples | \"using the penalty method and the ALM, respectively\" | the captions have it: Figs 4 and 7 are ALM, 5 and 8 penalty |";

/// What is the paper's and what is not.
pub(super) const RECONSTRUCTION: &str = "\
| | funnel | slopes |
|---|---|---|
| given in the paper | two layers of spheres of different sizes, 2500 kg/m3, P = 1e5 N/m, step 0.01 s, friction angle 5 degrees, pictures at 6 and 8.6 s | five planes, 180 spheres on the highest, 3500 kg/m3, P = 1e7 N/m, step 0.05 s, pictures at 20, 47 and 63 s |
| reconstructed here | 10 x 10 spheres of 0.25 m below, 10 x 10 of 0.15 m above, 5 % jitter; cone of half-angle 45 degrees, outlet 1.4 m, mouth 8 m, layers just above it | planes of 10, 8, 6, 4 and 2 degrees, each 422 m long, flat run-out, side walls 80 m apart; block of 10 x 6 x 3 spheres of 5 m, friction angle 5 degrees |

**No radius, length, angle of a plane or count of the funnel's spheres is printed. The geometry is a reconstruction that runs by the printed clock; \
it is not the authors' geometry, and single spheres cannot be compared.** The printed integrator is taken to be DDA's constant acceleration (`shi`): the paper \
refers to its reference 1 for it. The planes' length is what lets all spheres be on planes 1-2 at 20 s, on planes 3-4 at 47 s and past plane 4 at 63 s with \
`moreau`; with `shi`, whose rebound depends on the phase of the step, a few lag behind. The funnel empties sooner with `moreau`, which does not rebound \
(restitution 0), than with `shi`.";

/// Definitions under the tables.
pub(super) const DEFINITIONS: &str = "\
**Overlap/R**: true geometric overlap at the end of a step over the smaller radius of the pair; RMS over all pairs that overlap. Facets and cones are thin sheets with \
two sides: a sphere whose centre has crossed one overlaps it from the other side, so overlaps with boundaries never exceed 1 and those after a crossing look smaller than \
they are. **Beyond a boundary**: spheres whose centre lies behind a half-space, or has crossed a facet or cone an odd number of times; so their overlap was more than their radius. \
**Augmentations**: multiplier updates in a step, all passes of re-linearisation together. **Linear solves**: open-close iterations, each one solve of `K D = F`; a penalty step has no augmentation \
beyond the first.";

pub(super) fn mean(tally: Tally, steps: u64) -> String {
    number(tally.sum as f64 / steps.max(1) as f64)
}
