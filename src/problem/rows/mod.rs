//! The rows of a problem in order. Contacts of spheres on each other or on ground at rest, which nearly all rows are, take 72
//! bytes each; every other row is kept whole as well.

use serde::{Deserialize, Serialize};

use super::{GROUND, Law, Row};
use crate::Vec3;
use crate::memory;
use crate::parallel::Pieces;
use crate::sorting::insert_all;
use crate::spatial::SpatialVector;

/// Relative rounding within which a contact's arm is its sphere's radius along the normal.
const SAME: f64 = 1e-12;

/// Rows, `[C]`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(from = "Vec<Row>", into = "Vec<Row>")]
pub struct Rows {
    bodies: Vec<[u32; 2]>,
    compact: Vec<SphereContact>,
    /// Rows that are no plain contact of spheres, by [`SphereContact::general`].
    general: Vec<Row>,
    /// Whether these are contacts all the same whose arms are radii of bodies A and B.
    radial: Vec<[bool; 2]>,
    /// Radius at which contacts touch each body \[m\]; zero as long as no contact has set it.
    radius: Vec<f64>,
}

/// A contact of spheres without its bodies: as many numbers as a body has for sweeps, so that both are read alike.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C, align(64))]
pub(crate) struct SphereContact(pub(crate) [f64; 8]);

/// Numbers of [`SphereContact`] after the normal.
pub(crate) const BIAS: usize = 3;
pub(crate) const FRICTION: usize = 4;
pub(crate) const RADIUS: usize = 5;
pub(crate) const SCALE: usize = 6;
/// Whose bits are one more than where the row is kept whole; zero if it need not be.
const GENERAL: usize = 7;
/// Of a row that has to be kept whole and is not yet.
const DUE: usize = usize::MAX;

/// Rows to be written, by pieces where there are threads.
pub(crate) struct RowWriter<'a> {
    bodies: &'a mut [[u32; 2]],
    compact: &'a mut [SphereContact],
}

impl RowWriter<'_> {
    /// Writes row `k` of these; `plain` says that it is a rigid contact whose arms are the radii of its spheres, on ground at rest
    /// if it is on ground.
    #[inline]
    pub(crate) fn write(&mut self, k: usize, row: &Row, plain: bool) {
        self.bodies[k] = [row.a, row.b];
        self.compact[k] = SphereContact::of(row, 0);
        if !plain {
            self.compact[k].set_general(DUE);
        }
    }
}

impl Pieces for RowWriter<'_> {
    fn count(&self) -> usize {
        self.bodies.len()
    }

    fn cut(self, at: usize) -> (Self, Self) {
        let (bodies, other_bodies) = self.bodies.split_at_mut(at);
        let (compact, other_compact) = self.compact.split_at_mut(at);
        let others = Self {
            bodies: other_bodies,
            compact: other_compact,
        };
        (Self { bodies, compact }, others)
    }
}

impl SphereContact {
    fn of(row: &Row, general: usize) -> Self {
        let n = row.normal;
        let mu = match row.law {
            Law::Contact { mu } => mu,
            Law::Bilateral | Law::Resistance { .. } => 0.0,
        };
        let bias = row.bias.dot(&n);
        let (radius, scale) = (row.radius, row.impulse_scale);
        let mut contact = Self([n.x, n.y, n.z, bias, mu, radius, scale, 0.0]);
        contact.set_general(general);
        contact
    }

    #[inline]
    fn set_general(&mut self, general: usize) {
        self.0[GENERAL] = f64::from_bits(general as u64);
    }

    #[inline]
    fn normal(&self) -> Vec3 {
        let [x, y, z, ..] = self.0;
        Vec3::new(x, y, z)
    }

    #[inline]
    fn is_due(&self) -> bool {
        self.0[GENERAL].to_bits() == DUE as u64
    }

    /// Which row is kept whole for it, if one is.
    #[inline]
    fn general(&self) -> Option<usize> {
        (self.0[GENERAL].to_bits() as usize).checked_sub(1)
    }
}

impl Rows {
    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.compact.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.compact.is_empty()
    }

    /// Row `k`.
    ///
    /// # Panics
    /// If there are fewer.
    #[must_use]
    #[inline]
    pub fn get(&self, k: usize) -> Row {
        let compact = &self.compact[k];
        if let Some(general) = compact.general() {
            return self.general[general];
        }
        let [a, b] = self.bodies[k];
        let n = compact.normal();
        let [.., bias, mu, radius, impulse_scale, _] = compact.0;
        Row {
            a,
            b,
            normal: n,
            arm_a: n * -self.radius[a as usize],
            arm_b: match b {
                GROUND => Vec3::zeros(),
                b => n * self.radius[b as usize],
            },
            prescribed_velocity: Vec3::zeros(),
            bias: n * bias,
            compliance_n: 0.0,
            compliance_t: 0.0,
            law: Law::Contact { mu },
            radius,
            impulse_scale,
        }
    }

    /// What `look` finds at row `k`, which is not copied if it is kept whole.
    #[inline]
    pub(crate) fn with<R>(&self, k: usize, look: impl FnOnce(&Row) -> R) -> R {
        match self.general(k) {
            Some(row) => look(row),
            None => look(&self.get(k)),
        }
    }

    /// All of them.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Row> + Clone {
        (0..self.len()).map(|k| self.get(k))
    }

    /// Bodies A and B of row `k`.
    #[inline]
    pub(crate) fn bodies(&self, k: usize) -> [u32; 2] {
        self.bodies[k]
    }

    /// Those of all rows, `[C]`.
    pub(crate) fn all_bodies(&self) -> &[[u32; 2]] {
        &self.bodies
    }

    /// Normal of row `k`.
    #[must_use]
    #[inline]
    pub fn normal(&self, k: usize) -> Vec3 {
        self.compact[k].normal()
    }

    /// Bias along the normal of row `k` \[m/s\].
    #[inline]
    pub(crate) fn bias(&self, k: usize) -> f64 {
        self.compact[k].0[BIAS]
    }

    /// Smaller radius \[m\] of the pair of row `k`.
    #[inline]
    pub(crate) fn radius(&self, k: usize) -> f64 {
        self.compact[k].0[RADIUS]
    }

    /// Row `k`, if there is one and it is no rigid contact of spheres on each other or on ground at rest.
    #[inline]
    pub(crate) fn general(&self, k: usize) -> Option<&Row> {
        let general = self.compact.get(k)?.general()?;
        Some(&self.general[general])
    }

    /// Whether all are contacts whose arms are radii of their bodies.
    pub(crate) fn are_of_spheres(&self) -> bool {
        self.radial.iter().all(|radial| radial[1])
    }

    /// Whether all are rigid besides, and on each other or on ground at rest.
    pub(crate) fn are_plain(&self) -> bool {
        self.general.is_empty()
    }

    /// The rows that are resistances, and the contacts that they belong to.
    pub(crate) fn resistances(&self) -> impl Iterator<Item = (usize, usize)> {
        // Mostly there is nothing to look for.
        let rows = if self.general.is_empty() {
            0
        } else {
            self.len()
        };
        (0..rows).filter_map(|k| match self.general(k)?.law {
            Law::Resistance { contact, .. } => Some((k, contact as usize)),
            _ => None,
        })
    }

    /// Whether row `k` is a contact whose arms are radii of its bodies.
    #[inline]
    pub(crate) fn is_of_spheres(&self, k: usize) -> bool {
        self.is_radial(k)[1]
    }

    /// Whether row `k` is a contact whose arm is the radius of its body A, and of B too.
    #[inline]
    pub(crate) fn is_radial(&self, k: usize) -> [bool; 2] {
        let general = self.compact[k].general();
        general.map_or([true; 2], |general| self.radial[general])
    }

    /// Arm \[m\] of row `k` from its body B, which is not the ground.
    #[inline]
    pub(crate) fn arm_b(&self, k: usize) -> Vec3 {
        match self.general(k) {
            Some(row) => row.arm_b,
            None => self.normal(k) * self.radius[self.bodies[k][1] as usize],
        }
    }

    /// Compliance along the normal of row `k` \[m/(s N s)\].
    #[inline]
    pub(crate) fn compliance(&self, k: usize) -> f64 {
        self.general(k).map_or(0.0, |row| row.compliance_n)
    }

    /// Relative velocity \[m/s\] at row `k` where `velocity` gives that of a body.
    #[inline]
    pub(crate) fn relative(&self, k: usize, velocity: impl Fn(usize) -> SpatialVector) -> Vec3 {
        if let Some(row) = self.general(k) {
            return row.relative(velocity);
        }
        let [a, b] = self.bodies[k];
        let n = self.normal(k);
        let one = |body: u32| {
            let v = velocity(body as usize);
            (v.linear, v.angular * self.radius[body as usize])
        };
        let (linear, surface) = one(a);
        match b {
            GROUND => linear - surface.cross(&n),
            b => {
                let (other, turning) = one(b);
                linear - other - (surface + turning).cross(&n)
            }
        }
    }

    /// Momenta \[N s\], \[N m s\] that an impulse \[N s\] of row `k` gives its bodies: [`Row::momenta`]; of the ground anything.
    #[inline]
    pub(crate) fn momenta(&self, k: usize, impulse: Vec3) -> [SpatialVector; 2] {
        if let Some(row) = self.general(k) {
            return row.momenta(impulse);
        }
        let turn = impulse.cross(&self.normal(k));
        let [a, b] = self.bodies[k];
        [(a, impulse), (b, -impulse)].map(|(body, linear)| SpatialVector {
            linear,
            angular: turn * self.radius_of(body as usize),
        })
    }

    /// Radius at which contacts touch `body` \[m\]: zero where no contact has set it.
    pub(crate) fn radius_of(&self, body: usize) -> f64 {
        self.radius.get(body).copied().unwrap_or(0.0)
    }

    pub(crate) fn compact(&self) -> &[SphereContact] {
        &self.compact
    }

    /// Forgets all rows; spheres of the given radii \[m\], `[N]`, are the next ones' bodies.
    pub(crate) fn restart(&mut self, radii: &[f64]) {
        self.rewrite(radii, 0);
    }

    /// Likewise; `count` rows are to be written, then [`Self::settle`] is due.
    pub(crate) fn rewrite(&mut self, radii: &[f64], count: usize) -> RowWriter<'_> {
        self.general.clear();
        self.radial.clear();
        self.radius.clear();
        self.radius.extend_from_slice(radii);
        memory::resize(&mut self.bodies, count, [GROUND; 2]);
        memory::resize(&mut self.compact, count, SphereContact([0.0; 8]));
        RowWriter {
            bodies: &mut self.bodies,
            compact: &mut self.compact,
        }
    }

    /// Adds a row.
    #[inline]
    pub fn push(&mut self, row: Row) {
        let general = self.place(&row);
        self.bodies.push([row.a, row.b]);
        self.compact.push(SphereContact::of(&row, general));
    }

    /// Takes the rows that were written as no plain ones, in order.
    pub(crate) fn settle(&mut self, mut whole: impl Iterator<Item = Row>) {
        for k in 0..self.len() {
            if self.compact[k].is_due()
                && let Some(row) = whole.next()
            {
                let general = self.place(&row);
                self.compact[k].set_general(general);
            }
        }
    }

    /// Adds `new` contacts, each before the row that is at its place in `places`, which ascend.
    ///
    /// # Panics
    /// If there are fewer rows.
    pub(crate) fn insert_all(&mut self, places: &[usize], new: &[Row]) {
        let bodies = new.iter().map(|row| [row.a, row.b]).collect();
        let compact = new
            .iter()
            .map(|row| SphereContact::of(row, self.place(row)));
        let compact = compact.collect();
        insert_all(&mut self.bodies, places, bodies);
        insert_all(&mut self.compact, places, compact);
        let before = |contact| places.partition_point(|place| *place <= contact as usize);
        self.bind(|contact| *contact += before(*contact) as u32);
    }

    /// Changes row `k`.
    ///
    /// # Panics
    /// If there are fewer.
    pub fn update(&mut self, k: usize, change: impl FnOnce(&mut Row)) {
        let mut row = self.get(k);
        change(&mut row);
        self.bodies[k] = [row.a, row.b];
        let general = match self.compact[k].general() {
            Some(general) => {
                self.radial[general] = self.radial(&row);
                self.general[general] = row;
                general + 1
            }
            None => self.place(&row),
        };
        self.compact[k] = SphereContact::of(&row, general);
    }

    /// Changes all rows.
    pub(crate) fn update_all(&mut self, mut change: impl FnMut(usize, &mut Row)) {
        for k in 0..self.len() {
            self.update(k, |row| change(k, row));
        }
    }

    /// Binds resistances to other contacts.
    pub(crate) fn bind(&mut self, mut change: impl FnMut(&mut u32)) {
        for row in &mut self.general {
            if let Law::Resistance { contact, .. } = &mut row.law {
                change(contact);
            }
        }
    }

    /// Gives row `k`, which gives way, another compliance along its normal \[m/(s N s)\].
    pub(crate) fn set_compliance(&mut self, k: usize, compliance: f64) {
        if let Some(general) = self.compact[k].general() {
            self.general[general].compliance_n = compliance;
        }
    }

    /// Adds `change` to the bias of row `k` along its normal \[m/s\].
    pub(crate) fn shift(&mut self, k: usize, change: f64) {
        let compact = &mut self.compact[k];
        compact.0[BIAS] += change;
        if let Some(general) = compact.general() {
            self.general[general].bias += compact.normal() * change;
        }
    }

    /// Keeps the first `count`.
    pub fn truncate(&mut self, count: usize) {
        self.bodies.truncate(count);
        self.compact.truncate(count);
    }

    /// One more than where `row` is kept whole; zero if it need not be.
    #[inline]
    fn place(&mut self, row: &Row) -> usize {
        let radial = self.radial(row);
        if radial[1] && row.is_rigid() && is_still(row) {
            return 0;
        }
        self.general.push(*row);
        self.radial.push(radial);
        self.general.len()
    }

    /// Whether a row is a contact whose arm is the radius of its body A along the normal, and of B too; the first contact of a body
    /// is where it gets its radius.
    fn radial(&mut self, row: &Row) -> [bool; 2] {
        let a = row.is_contact() && self.is_radius(row.a, -row.arm_a, row.normal);
        let b = a && (row.b == GROUND || self.is_radius(row.b, row.arm_b, row.normal));
        [a, b]
    }

    /// Whether a contact touches `body` at its radius along the normal.
    fn is_radius(&mut self, body: u32, arm: Vec3, normal: Vec3) -> bool {
        let body = body as usize;
        if body >= self.radius.len() {
            self.radius.resize(body + 1, 0.0);
        }
        let known = &mut self.radius[body];
        if *known == 0.0 {
            *known = arm.dot(&normal).max(0.0);
        }
        *known > 0.0 && radial(arm, normal, *known)
    }

    /// Keeps the rows whose flag is set; rows beyond the flags stay.
    pub(crate) fn retain(&mut self, keep: &[bool]) {
        retain(&mut self.bodies, keep);
        retain(&mut self.compact, keep);
    }
}

impl Row {
    /// Normal impulse \[N s\] of the contact that bounds a resistance; zero for all other rows.
    pub(crate) fn load(&self, rows: &Rows, impulses: &[Vec3]) -> f64 {
        match self.law {
            Law::Resistance { contact, .. } => {
                let contact = contact as usize;
                impulses[contact].dot(&rows.normal(contact)).max(0.0)
            }
            _ => 0.0,
        }
    }
}

/// Keeps the entries whose flag is set; entries beyond the flags stay.
pub(crate) fn retain<T>(items: &mut Vec<T>, keep: &[bool]) {
    let mut flags = keep.iter();
    items.retain(|_| flags.next().copied().unwrap_or(true));
}

/// Whether `arm` leads along the normal as far as `radius`.
fn radial(arm: Vec3, normal: Vec3, radius: f64) -> bool {
    (arm - normal * radius).norm_squared() <= (SAME * radius).powi(2)
}

/// Whether the ground of a row does not move, and its bias is along the normal.
fn is_still(row: &Row) -> bool {
    let across = row.across();
    row.prescribed_velocity == Vec3::zeros()
        && across.norm_squared() <= (SAME * row.bias.dot(&row.normal)).powi(2)
}

impl Extend<Row> for Rows {
    fn extend<I: IntoIterator<Item = Row>>(&mut self, rows: I) {
        rows.into_iter().for_each(|row| self.push(row));
    }
}

impl FromIterator<Row> for Rows {
    fn from_iter<I: IntoIterator<Item = Row>>(rows: I) -> Self {
        let mut all = Self::default();
        all.extend(rows);
        all
    }
}

impl From<Vec<Row>> for Rows {
    fn from(rows: Vec<Row>) -> Self {
        rows.into_iter().collect()
    }
}

impl From<Rows> for Vec<Row> {
    fn from(rows: Rows) -> Self {
        rows.iter().collect()
    }
}

mod tests;
