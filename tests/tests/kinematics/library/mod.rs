//! The machines of the library: the suite of every machine, their chains written out by hand, LinuxCNC's own modules
//! for those that have one, and a sample posted and checked with the configuration of `examples/config`.

mod chains;
mod modules;
mod samples;

use machine_library::{
    BridgeMill, HaasRotary, HaasTrunnion, HaasUmc, IntegrexI200, Max5, ObliqueYLathe, PocketNcV2, XyzabTdr, XyzacTrt,
    XyzacbTrsrn, XyzbcTrt,
};
use tests::conformance;

conformance!(BridgeMill, bridge_mill, sample = { pivot_length: 250.0 });
conformance!(HaasRotary, haas_rotary);
conformance!(HaasTrunnion, haas_trunnion, sample = { tilt_y: 0.0, tilt_z: 40.0 });
conformance!(HaasUmc, haas_umc, sample = { tilt_x: 0.0, tilt_z: 50.0 });
conformance!(IntegrexI200, integrex_i200, sample = { head_x: 0.0, head_z: 200.0 });
conformance!(Max5, max5, sample = { pivot_length: 60.0 });
conformance!(ObliqueYLathe, oblique_y_lathe, sample = { slant: -0.5 });
conformance!(PocketNcV2, pocketnc_v2);
conformance!(XyzabTdr, xyzab_tdr, sample = { x_offset: -20.0, z_offset: -10.0 });
conformance!(XyzacTrt, xyzac_trt, sample = { y_offset: 20.0, z_offset: 10.0 });
conformance!(XyzacbTrsrn, xyzacb_trsrn, sample = { x_offset: 0.0, y_offset: 50.0, y_pivot: 120.0, z_pivot: 200.0 });
conformance!(XyzbcTrt, xyzbc_trt, sample = { x_offset: -20.0, z_offset: -15.0 });

#[test]
fn required_dimensions_without_a_sample_are_named_in_one_sentence() {
    let fault = pp_conformance::conformance::find_fault::<HaasTrunnion>(1).expect("its dimensions are required");
    assert_eq!(
        fault.details,
        "machine HaasTrunnion: give a sample of its dimensions, in mm and rad, such as `sample = { tilt_y: 100.0, tilt_z: \
         100.0 }`, as the last argument of `conformance!`"
    );
}
