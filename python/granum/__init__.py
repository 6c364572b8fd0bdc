# SPDX-License-Identifier: GPL-3.0-or-later
"""Stiffness of granular packings: closed forms, contact networks and a compact DEM verifier.

The library granum on numpy arrays. All numbers are in SI, compression is positive, axis 3 ("v") is the axis of
symmetry. See docs/python.md.
"""

from ._errors import Error, FileError, InvalidArgument, NotConverged, Stopped
from ._files import frames, read
from ._granum import (
    ContactMeans,
    Contacts,
    Counts,
    ContactStress,
    Distribution,
    EngineeringModuli,
    Estimate,
    Fabric,
    Forces,
    Frames,
    Gradation,
    IsotropicModuli,
    LawCheck,
    Measurement,
    Microstructure,
    Moduli,
    ModulusErrors,
    Network,
    Packing,
    PowerLaw,
    RoseBin,
    Rung,
    Sizes,
    SymmetryDistances,
    __version__,
    answer,
    cement_at_contacts,
    cement_in_surface_layer,
    cone,
    digby,
    expected_contact_means,
    flat_punch,
    formats,
    free_spin,
    gradation,
    hertz_mindlin,
    jenkins_shear_modulus,
    measure,
    mindlin_stiffness_ratio,
    murphy_coordination_number,
    packing,
    pair_radius,
    power_law,
    relaxed,
    rungs,
    soft_sand,
    sphere,
    stiff_sand,
    uniform_strain,
    uniform_strain_kinematic,
    uniform_strain_moduli,
    uniform_stress,
    uniform_stress_kinematic,
)

__all__ = [name for name in dir() if not name.startswith("_")] + ["__version__"]
