//! Observers and the results directory. The states are synthetic: no solver takes part. Frames are left in the
//! target directory with the values they should hold, for `tests/python/test_vtk.py` to read with meshio and VTK.

mod energy;
mod frames;
mod killed;
mod made;
mod session;
mod simulated;
mod vtu;
