//! The contacts of a step's problem without its bodies: `W` from the bodies' masses, bilateral rows eliminated.

use nalgebra::{DMatrix, DVector, Matrix3};

use super::friction::FrictionProblem;
use super::{GROUND, Law, Problem, Row};
use crate::Vec3;

/// Most bilateral rows that are eliminated: their inverse is dense.
const MOST_BILATERAL: usize = 300;
/// Singular value over the largest below which a direction of bilateral rows is held already.
const HELD: f64 = 1e-12;

/// Contacts of a [`Problem`] without its bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct Reduction {
    /// The contacts, in the order of their rows.
    pub problem: FrictionProblem,
    /// Row of each contact, `[C]`.
    pub rows: Vec<usize>,
    /// Axes of each contact as columns: normal from B to A, and two tangents, `[C]`.
    pub axes: Vec<Matrix3<f64>>,
    /// Bilateral rows (joints, springs) that are part of `W` and `q`.
    pub eliminated: usize,
    /// Rows that act with the impulses given, as no contact law can express them: resistances, and bilateral rows where there
    /// are more than 300.
    pub held: usize,
}

impl Reduction {
    /// Reduces `problem`; rows that a contact problem cannot express act with their part of `impulses`, `[C]` \[N s\].
    #[must_use]
    pub fn of(problem: &Problem, impulses: &[Vec3]) -> Self {
        let all: Vec<Row> = problem.rows.iter().collect();
        let of_law = |wanted: fn(&Law) -> bool| -> Vec<usize> {
            (0..all.len()).filter(|&k| wanted(&all[k].law)).collect()
        };
        let rows = of_law(|law| matches!(law, Law::Contact { .. }));
        let mut bilateral = of_law(|law| matches!(law, Law::Bilateral));
        let mut held = of_law(|law| matches!(law, Law::Resistance { .. }));
        if bilateral.len() > MOST_BILATERAL {
            held.append(&mut bilateral);
        }
        let mut velocity = problem.free.clone();
        for &k in &held {
            problem.apply(&all[k], &mut velocity, impulses[k]);
        }
        // Contacts first, then bilateral rows.
        let kept: Vec<Row> = rows.iter().chain(&bilateral).map(|&k| all[k]).collect();
        let axes: Vec<Matrix3<f64>> = kept.iter().map(|row| axes(row.normal)).collect();
        let free = |k: usize| {
            let row = &kept[k];
            axes[k].transpose() * (row.relative_velocity(&velocity) + row.bias)
        };
        let operator = Operator::of(problem, &kept, &axes);
        let contacts = rows.len();
        let mut q: Vec<Vec3> = (0..contacts).map(free).collect();
        let mut blocks = operator.blocks(contacts);
        if !bilateral.is_empty() {
            let q_b = DVector::from_fn(3 * bilateral.len(), |i, _| free(contacts + i / 3)[i % 3]);
            operator.eliminate((contacts, bilateral.len()), &q_b, &mut blocks, &mut q);
        }
        let friction = rows.iter().map(|&k| match all[k].law {
            Law::Contact { mu } => mu,
            Law::Bilateral | Law::Resistance { .. } => 0.0,
        });
        let friction = friction.collect();
        Self {
            problem: FrictionProblem::new(blocks, q, friction),
            axes: axes[..contacts].to_vec(),
            rows,
            eliminated: bilateral.len(),
            held: held.len(),
        }
    }

    /// Contact impulses in their own axes as the step's rows have them, `[C]` \[N s\].
    #[must_use]
    pub fn own(&self, impulses: &[Vec3]) -> Vec<Vec3> {
        let rows = self.rows.iter().zip(&self.axes);
        rows.map(|(&k, axes)| axes.transpose() * impulses[k])
            .collect()
    }
}

/// Normal and two tangents as columns.
fn axes(normal: Vec3) -> Matrix3<f64> {
    let [t1, t2] = tangents(normal);
    Matrix3::from_columns(&[normal, t1, t2])
}

/// `W` between rows that share a body: blocks `(row, column, block)`.
struct Operator(Vec<(u32, u32, Matrix3<f64>)>);

impl Operator {
    fn of(problem: &Problem, rows: &[Row], axes: &[Matrix3<f64>]) -> Self {
        let mut of_body = vec![Vec::new(); problem.free.len()];
        for (k, row) in rows.iter().enumerate() {
            let [grip_a, grip_b] = row.jacobian();
            of_body[row.a as usize].push((k, grip_a, 1.0));
            if row.b != GROUND {
                of_body[row.b as usize].push((k, grip_b, -1.0));
            }
        }
        let mut blocks = Vec::new();
        for (body, grips) in of_body.iter().enumerate() {
            for &(j, from, sign) in grips {
                let changes: [_; 3] = std::array::from_fn(|c| {
                    let impulse = axes[j].column(c) * sign;
                    problem.velocity_change(body as u32, &from.momentum(impulse))
                });
                for &(k, to, side) in grips {
                    let columns = changes.map(|change| to.velocity(&change) * side);
                    let block = axes[k].transpose() * Matrix3::from_columns(&columns);
                    blocks.push((k as u32, j as u32, block));
                }
            }
        }
        for (k, row) in rows.iter().enumerate() {
            let soft = Vec3::new(row.compliance_n, row.compliance_t, row.compliance_t);
            blocks.push((k as u32, k as u32, Matrix3::from_diagonal(&soft)));
        }
        Self(blocks)
    }

    /// Blocks among the first `contacts` rows.
    fn blocks(&self, contacts: usize) -> Vec<(u32, u32, Matrix3<f64>)> {
        let own = self.0.iter().copied();
        own.filter(|(row, column, _)| (*row.max(column) as usize) < contacts)
            .collect()
    }

    /// `W_cc - W_cb W_bb^-1 W_bc` and `q_c - W_cb W_bb^-1 q_b`; a singular `W_bb` by its pseudo-inverse.
    fn eliminate(
        &self,
        (contacts, bilateral): (usize, usize),
        q_b: &DVector<f64>,
        blocks: &mut Vec<(u32, u32, Matrix3<f64>)>,
        q: &mut [Vec3],
    ) {
        let mut own = DMatrix::zeros(3 * bilateral, 3 * bilateral);
        let mut across = DMatrix::zeros(3 * contacts, 3 * bilateral);
        for (row, column, block) in &self.0 {
            let (row, column) = (*row as usize, *column as usize);
            let Some(column) = column.checked_sub(contacts) else {
                continue;
            };
            let place = row.checked_sub(contacts);
            let (matrix, row) = match place {
                Some(row) => (&mut own, row),
                None => (&mut across, row),
            };
            let mut view = matrix.fixed_view_mut::<3, 3>(3 * row, 3 * column);
            view += block;
        }
        let decomposition = own.symmetric_eigen();
        let largest = decomposition.eigenvalues.amax();
        let inverse = decomposition.eigenvalues.map(|w| match w > HELD * largest {
            true => 1.0 / w,
            false => 0.0,
        });
        let vectors = decomposition.eigenvectors;
        let inverse = &vectors * DMatrix::from_diagonal(&inverse) * vectors.transpose();
        // Contacts that no bilateral row reaches stay as they are.
        let reached: Vec<usize> = (0..contacts)
            .filter(|k| across.rows(3 * k, 3).iter().any(|w| *w != 0.0))
            .collect();
        let solved = &across * inverse;
        let change = &solved * q_b;
        for &k in &reached {
            q[k] -= change.fixed_rows::<3>(3 * k);
            for &j in &reached {
                let block = solved.rows(3 * k, 3) * across.rows(3 * j, 3).transpose();
                let block = Matrix3::from_fn(|r, c| -block[(r, c)]);
                blocks.push((k as u32, j as u32, block));
            }
        }
    }
}

/// Two unit vectors that complete the unit vector `n` to an orthonormal frame.
fn tangents(n: Vec3) -> [Vec3; 2] {
    let helper = if n.x.abs() < 0.6 {
        Vec3::x()
    } else {
        Vec3::y()
    };
    let t1 = n.cross(&helper).normalize();
    [t1, n.cross(&t1)]
}
