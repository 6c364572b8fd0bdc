# SPDX-License-Identifier: GPL-3.0-or-later
# Types of the package. SI everywhere; the meaning of each name is in its docstring.
from collections.abc import Callable, Iterator, Mapping, Sequence
from os import PathLike
from typing import Any, Generic, Literal, Optional, TypeVar, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import Error as Error
from ._errors import FileError as FileError
from ._errors import InvalidArgument as InvalidArgument
from ._errors import NotConverged as NotConverged
from ._errors import Stopped as Stopped

__all__ = [
    "AnisotropyEstimate",
    "AxialStress",
    "CarriedContacts",
    "Compression",
    "ContactCounts",
    "ContactMeans",
    "ContactPrior",
    "ContactStress",
    "Contacts",
    "Counts",
    "Distribution",
    "EngineeringModuli",
    "Error",
    "Estimate",
    "Exponents",
    "Fabric",
    "FabricMeasures",
    "FileError",
    "Fit",
    "Forces",
    "Frames",
    "Gradation",
    "GroundStress",
    "Inference",
    "Interior",
    "InvalidArgument",
    "Isotropic",
    "IsotropicAverages",
    "IsotropicModuli",
    "KnownSand",
    "Ladder",
    "LawCheck",
    "LikelihoodEstimate",
    "Measured",
    "MeasuredLaw",
    "MeasuredRows",
    "Measurement",
    "Microstructure",
    "Mineral",
    "Moduli",
    "ModulusErrors",
    "Network",
    "NormalLaw",
    "NotConverged",
    "Packing",
    "PackingAnswer",
    "PathPoint",
    "PlaneWaves",
    "ProbeResult",
    "Range",
    "Record",
    "RoseBin",
    "Rung",
    "RungAssessment",
    "SandInference",
    "Shearing",
    "Sizes",
    "Specimen",
    "State",
    "Stopped",
    "Study",
    "SymmetryDistances",
    "ThomsenParameters",
    "Verdict",
    "answer",
    "bulk_density",
    "carried_contacts",
    "cement_at_contacts",
    "cement_in_surface_layer",
    "compress",
    "cone",
    "contact_law",
    "contact_prior",
    "digby",
    "engineering_moduli",
    "estimate",
    "estimate_anisotropy",
    "estimate_anisotropy_by_likelihood",
    "expected_contact_means",
    "exponents",
    "fabric_cumulative_probability",
    "fabric_density",
    "fabric_measures",
    "fabric_polar_cosine_quantile",
    "failure_ratio",
    "fit",
    "flat_punch",
    "formats",
    "frames",
    "free_spin",
    "from_lammps",
    "from_yade",
    "gradation",
    "ground_stress",
    "hardin",
    "hertz_mindlin",
    "infer",
    "isotropic",
    "isotropic_averages",
    "isotropic_projection",
    "isotropy_p_value",
    "jenkins_shear_modulus",
    "known_sands",
    "measure",
    "measured_laws",
    "mindlin_stiffness_ratio",
    "minerals",
    "murphy_coordination_number",
    "norris_johnson",
    "norris_johnson_stress",
    "overlap_contacts",
    "packing",
    "packing_answer",
    "pair_radius",
    "plane_waves",
    "power_law",
    "probe",
    "read",
    "relaxed",
    "rose",
    "rotate",
    "rough_sphere",
    "rungs",
    "sample_normals",
    "sand_shear_modulus",
    "saturated",
    "shear",
    "soft_sand",
    "specimen",
    "sphere",
    "stiff_sand",
    "stress_on_path",
    "symmetry_distances",
    "thomsen_parameters",
    "transversely_isotropic_projection",
    "uniform_strain",
    "uniform_strain_kinematic",
    "uniform_strain_moduli",
    "uniform_stress",
    "uniform_stress_kinematic",
    "verify",
    "void_ratio_of_relative_density",
    "walton_uniaxial",
    "walton_uniaxial_stress",
    "water_and_air_bulk_modulus",
    "__version__",
]
__version__: str

# A float for a call with numbers only, an array for a call with arrays.
_N = TypeVar("_N", float, NDArray[np.float64])
_Array = NDArray[np.float64]
_Path = Union[str, PathLike[str]]
_RungName = Union[int, str]
_Range = Optional[tuple[Optional[float], Optional[float]]]
_TurningSpring = Union[None, float, tuple[float, str], Literal["marshall"]]
_Modulus = Literal["K", "G_hh", "G_vh", "E_v", "E_h", "C11", "C33", "C12", "C13"]

class _Result:
    def to_dict(self) -> dict[str, Any]: ...
    def to_columns(self) -> dict[str, NDArray[Any]]: ...
    def __eq__(self, other: object) -> bool: ...

class Record(_Result):
    def __init__(self, kind: str, values: dict[str, Any]) -> None: ...
    def __getattr__(self, name: str) -> Any: ...
    def __setattr__(self, name: str, value: Any) -> None: ...

class AnisotropyEstimate(_Result):
    @property
    def F33(self) -> float: ...
    @property
    def anisotropy(self) -> float: ...
    @property
    def contacts(self) -> int: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def standard_error(self) -> float: ...

class AxialStress(_Result, Generic[_N]):
    @property
    def errors(self) -> dict[tuple[int, ...], str]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def shape(self) -> tuple[int, ...]: ...
    @property
    def stress_v(self) -> _N: ...
    @property
    def stress_h(self) -> _N: ...

class CarriedContacts(_Result):
    @property
    def coordination_error(self) -> float: ...
    @property
    def counts(self) -> ContactCounts: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def void_ratio(self) -> float: ...

class Compression:
    def __iter__(self) -> Iterator[State]: ...
    def __next__(self) -> State: ...

class ContactCounts(_Result):
    @property
    def coordination_number(self) -> float: ...
    @property
    def mechanical_coordination_number(self) -> float: ...
    @property
    def rattler_fraction(self) -> float: ...

class ContactMeans:
    def __init__(
        self,
        *,
        branch: float = ...,
        branch_square: float = ...,
        pair_radius: float = ...,
        grain_volume: float = ...,
    ) -> None: ...
    def __eq__(self, arg0: object) -> bool: ...
    @property
    def branch(self) -> float: ...
    @property
    def branch_square(self) -> float: ...
    @property
    def grain_volume(self) -> float: ...
    @property
    def pair_radius(self) -> float: ...
    def with_reference(self, scale: float) -> ContactMeans: ...

class ContactPrior(_Result):
    @property
    def coordination_error(self) -> float: ...
    @property
    def densest(self) -> ContactCounts: ...
    @property
    def loosest(self) -> ContactCounts: ...
    @property
    def middle(self) -> ContactCounts: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def rattler_error(self) -> float: ...
    @property
    def relative_overlap(self) -> float: ...

class ContactStress(_Result):
    @property
    def asymmetry(self) -> float: ...
    @property
    def mean(self) -> float: ...
    @property
    def symmetric(self) -> NDArray[np.float64]: ...
    @property
    def tensor(self) -> NDArray[np.float64]: ...

class Contacts(_Result):
    def __len__(self) -> int: ...
    @property
    def branch(self) -> NDArray[np.float64]: ...
    @property
    def i(self) -> NDArray[np.uint32]: ...
    @property
    def j(self) -> NDArray[np.uint32]: ...
    @property
    def normal(self) -> NDArray[np.float64]: ...
    @property
    def normal_force(self) -> NDArray[np.float64]: ...
    @property
    def normal_stiffness(self) -> NDArray[np.float64]: ...
    @property
    def overlap(self) -> NDArray[np.float64]: ...
    @property
    def rolling_stiffness(self) -> NDArray[np.float64]: ...
    @property
    def sliding(self) -> NDArray[np.bool_]: ...
    @property
    def tangential_force(self) -> NDArray[np.float64]: ...
    @property
    def tangential_stiffness(self) -> NDArray[np.float64]: ...
    @property
    def twisting_stiffness(self) -> NDArray[np.float64]: ...

class Counts(_Result):
    @property
    def contacts(self) -> int: ...
    @property
    def coordination_error(self) -> float: ...
    @property
    def coordination_number(self) -> float: ...
    @property
    def coordination_number_with_walls(self) -> float: ...
    @property
    def grains(self) -> int: ...
    @property
    def is_rattler(self) -> NDArray[np.bool_]: ...
    @property
    def mechanical_coordination_number(self) -> float: ...
    @property
    def rattler_fraction(self) -> float: ...
    @property
    def rattlers(self) -> int: ...
    @property
    def sliding_fraction(self) -> float: ...
    @property
    def touching_coordination_number(self) -> float: ...
    @property
    def wall_contacts(self) -> int: ...
    @property
    def without_contact(self) -> int: ...

class Distribution:
    def __init__(self, text: str) -> None: ...
    def __eq__(self, arg0: object) -> bool: ...
    def gradation(self, *, mean_radius: float) -> Gradation: ...
    @property
    def largest(self) -> float: ...
    @property
    def mean_radius(self) -> Optional[float]: ...
    def mean_radius_of(self, *, d50: float) -> float: ...
    def moment(self, k: float) -> float: ...
    def quantile(self, share: float, k: float = ...) -> float: ...
    def sample(self, *, count: int, seed: int) -> NDArray[np.float64]: ...
    def share_below(self, x: float, k: float = ...) -> float: ...
    @property
    def size_ratio(self) -> float: ...
    @property
    def smallest(self) -> float: ...
    @property
    def text(self) -> str: ...

class EngineeringModuli(_Result):
    @property
    def C44(self) -> float: ...
    @property
    def C55(self) -> float: ...
    @property
    def C66(self) -> float: ...
    @property
    def E_1(self) -> float: ...
    @property
    def E_2(self) -> float: ...
    @property
    def E_3(self) -> float: ...
    @property
    def bulk_modulus(self) -> float: ...

class Estimate(_Result, Generic[_N]):
    @property
    def C11(self) -> _N: ...
    @property
    def C12(self) -> _N: ...
    @property
    def C13(self) -> _N: ...
    @property
    def C33(self) -> _N: ...
    @property
    def C44(self) -> _N: ...
    @property
    def C66(self) -> _N: ...
    @property
    def E_h(self) -> _N: ...
    @property
    def E_v(self) -> _N: ...
    @property
    def G_hh(self) -> _N: ...
    @property
    def G_vh(self) -> _N: ...
    @property
    def bulk_modulus(self) -> _N: ...
    @property
    def errors(self) -> dict[tuple[int, ...], str]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def nu_hh(self) -> _N: ...
    @property
    def nu_hv(self) -> _N: ...
    @property
    def nu_vh(self) -> _N: ...
    @property
    def relative_error(self) -> Optional[ModulusErrors[_N]]: ...
    @property
    def shape(self) -> tuple[int, ...]: ...
    @property
    def stiffness(self) -> NDArray[np.float64]: ...

class Exponents(_Result, Generic[_N]):
    @property
    def errors(self) -> dict[tuple[int, ...], str]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def shape(self) -> tuple[int, ...]: ...
    @property
    def stress_h(self) -> _N: ...
    @property
    def stress_v(self) -> _N: ...
    @property
    def sum(self) -> _N: ...

class Fabric(_Result):
    @property
    def anisotropy(self) -> float: ...
    @property
    def contacts(self) -> int: ...
    @property
    def isotropy_p_value(self) -> Optional[float]: ...
    @property
    def likeliest_anisotropy(self) -> Optional[float]: ...
    @property
    def rose(self) -> list[RoseBin]: ...
    @property
    def standard_error(self) -> float: ...
    @property
    def tensor(self) -> NDArray[np.float64]: ...
    def plot(self, ax: Any = ...) -> Any: ...

class FabricMeasures(_Result):
    @property
    def F11(self) -> float: ...
    @property
    def F33(self) -> float: ...
    @property
    def P2_coefficient(self) -> float: ...
    @property
    def anisotropy(self) -> float: ...
    @property
    def mean_cos_2gamma(self) -> float: ...
    @property
    def notes(self) -> list[str]: ...

class Fit(_Result):
    @property
    def coefficient(self) -> Measured: ...
    @property
    def exponent_i(self) -> Optional[Measured]: ...
    @property
    def exponent_j(self) -> Optional[Measured]: ...
    @property
    def exponent_sum(self) -> Measured: ...
    @property
    def parameters(self) -> list[str]: ...
    @property
    def covariance(self) -> NDArray[np.float64]: ...
    @property
    def r_squared(self) -> Optional[float]: ...
    @property
    def residuals(self) -> NDArray[np.float64]: ...
    @property
    def rms_relative_residual(self) -> float: ...
    @property
    def degrees_of_freedom(self) -> int: ...
    @property
    def notes(self) -> list[str]: ...

class Forces(_Result):
    @property
    def Z_2(self) -> float: ...
    @property
    def friction_coefficient(self) -> Optional[float]: ...
    @property
    def in_tension(self) -> int: ...
    @property
    def largest(self) -> float: ...
    @property
    def mean(self) -> float: ...
    @property
    def mean_tangential_over_normal(self) -> Optional[float]: ...
    @property
    def pressing(self) -> int: ...
    @property
    def sliding_fraction(self) -> Optional[float]: ...
    @property
    def unbalanced_force_ratio(self) -> Optional[float]: ...

class Frames:
    def __iter__(self) -> Iterator[Packing]: ...
    def __next__(self) -> Packing: ...
    @property
    def skipped(self) -> int: ...

class Gradation(_Result):
    @property
    def d10(self) -> float: ...
    @property
    def d50(self) -> float: ...
    @property
    def d60(self) -> float: ...
    @property
    def uniformity(self) -> float: ...

class GroundStress(_Result, Generic[_N]):
    @property
    def errors(self) -> dict[tuple[int, ...], str]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def shape(self) -> tuple[int, ...]: ...
    @property
    def stress_v(self) -> _N: ...
    @property
    def stress_h(self) -> _N: ...
    @property
    def total_v(self) -> _N: ...
    @property
    def total_h(self) -> _N: ...
    @property
    def pore_pressure(self) -> _N: ...

class Inference(_Result):
    @property
    def alone(self) -> list[Optional[Measured]]: ...
    @property
    def chi_square(self) -> float: ...
    @property
    def contact_law(self) -> Optional[NormalLaw]: ...
    @property
    def contact_numbers(self) -> dict[str, Measured]: ...
    @property
    def coordination_number(self) -> Measured: ...
    @property
    def degrees_of_freedom(self) -> int: ...
    @property
    def deviations(self) -> list[float]: ...
    @property
    def error_shares(self) -> dict[str, float]: ...
    @property
    def explained(self) -> bool: ...
    @property
    def fitted(self) -> list[Measured]: ...
    @property
    def growth_exponent(self) -> Optional[Measured]: ...
    @property
    def mechanical_coordination_number(self) -> Measured: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def pressure(self) -> float: ...
    @property
    def probability(self) -> float: ...
    @property
    def rattler_fraction(self) -> Measured: ...
    @property
    def undetermined(self) -> list[str]: ...
    @property
    def would_determine(self) -> Optional[str]: ...
    def plot(self, ax: Any = ..., *, quantity: str = ..., pressure: ArrayLike) -> Any: ...
    @overload
    def predict(  # type: ignore[misc]
        self,
        quantity: str,
        *,
        pressure: Optional[float] = ...,
        stress_v: Optional[float] = ...,
        stress_h: Optional[float] = ...,
        void_ratio: Optional[float] = ...,
        specimen: str = ...,
    ) -> MeasuredRows[float]: ...
    @overload
    def predict(
        self,
        quantity: str,
        *,
        pressure: Optional[ArrayLike] = ...,
        stress_v: Optional[ArrayLike] = ...,
        stress_h: Optional[ArrayLike] = ...,
        void_ratio: Optional[ArrayLike] = ...,
        specimen: str = ...,
    ) -> MeasuredRows[_Array]: ...

class Interior(_Result):
    @property
    def grains(self) -> int: ...
    @property
    def void_ratio(self) -> float: ...
    @property
    def microstructure(self) -> Microstructure: ...
    @property
    def stress(self) -> NDArray[np.float64]: ...

class Isotropic:
    @property
    def bulk_modulus(self) -> float: ...
    @property
    def lame_lambda(self) -> float: ...
    @property
    def poisson_ratio(self) -> float: ...
    @property
    def shear_modulus(self) -> float: ...
    @property
    def stiffness(self) -> NDArray[np.float64]: ...
    def wave_speeds(self, *, bulk_density: float) -> dict[str, float]: ...
    @property
    def young_modulus(self) -> float: ...

class IsotropicAverages(_Result):
    @property
    def hill(self) -> Isotropic: ...
    @property
    def reuss(self) -> Isotropic: ...
    @property
    def voigt(self) -> Isotropic: ...

class IsotropicModuli(_Result, Generic[_N]):
    @property
    def bulk_modulus(self) -> _N: ...
    @property
    def errors(self) -> dict[tuple[int, ...], str]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def shape(self) -> tuple[int, ...]: ...
    @property
    def shear_modulus(self) -> _N: ...

class KnownSand(_Result):
    @property
    def key(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def source(self) -> str: ...
    @property
    def mineral(self) -> str: ...
    @property
    def d50(self) -> Optional[float]: ...
    @property
    def uniformity(self) -> Optional[float]: ...
    @property
    def least_void_ratio(self) -> Optional[float]: ...
    @property
    def largest_void_ratio(self) -> Optional[float]: ...

class Ladder(_Result):
    @property
    def advice(self) -> list[str]: ...
    @property
    def choice(self) -> RungAssessment: ...
    @property
    def mechanical_coordination_number(self) -> list[float]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def rungs(self) -> list[RungAssessment]: ...
    @property
    def tolerance(self) -> float: ...
    @property
    def tolerance_met(self) -> bool: ...
    def plot(self, ax: Any = ...) -> Any: ...

class LawCheck(_Result):
    @property
    def coefficient_ratio(self) -> Optional[float]: ...
    @property
    def contacts(self) -> int: ...
    @property
    def force_exponent(self) -> Optional[float]: ...
    @property
    def median_misfit(self) -> float: ...
    @property
    def worst_misfit(self) -> float: ...

class LikelihoodEstimate(_Result):
    @property
    def anisotropy(self) -> float: ...
    @property
    def at_boundary(self) -> bool: ...
    @property
    def contacts(self) -> int: ...
    @property
    def log_likelihood_gain(self) -> float: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def standard_error(self) -> float: ...

class Measured(_Result):
    @property
    def standard_error(self) -> float: ...
    @property
    def value(self) -> float: ...

class MeasuredLaw(_Result):
    @property
    def key(self) -> str: ...
    @property
    def sand(self) -> str: ...
    @property
    def source(self) -> str: ...
    @property
    def formula(self) -> str: ...
    @property
    def bias(self) -> float: ...
    @property
    def rms_log10(self) -> float: ...

class MeasuredRows(_Result, Generic[_N]):
    @property
    def errors(self) -> dict[tuple[int, ...], str]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def shape(self) -> tuple[int, ...]: ...
    @property
    def standard_error(self) -> _N: ...
    @property
    def value(self) -> _N: ...

class Measurement(_Result):
    @property
    def bulk_density(self) -> Optional[float]: ...
    @property
    def counts(self) -> Counts: ...
    @property
    def fabric(self) -> Optional[Fabric]: ...
    @property
    def forces(self) -> Optional[Forces]: ...
    @property
    def interior(self) -> Optional[Interior]: ...
    @property
    def law(self) -> Optional[NormalLaw]: ...
    @property
    def law_check(self) -> Optional[LawCheck]: ...
    @property
    def microstructure(self) -> Microstructure: ...
    @property
    def network(self) -> Optional[Network]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def rungs(self) -> dict[str, Estimate[float]]: ...
    @property
    def sizes(self) -> Sizes: ...
    @property
    def stress(self) -> Optional[ContactStress]: ...
    @property
    def void_ratio(self) -> float: ...
    @property
    def volume(self) -> float: ...
    @property
    def warnings(self) -> list[str]: ...

class Microstructure(_Result):
    @property
    def coordination_number(self) -> float: ...
    @property
    def fabric_anisotropy(self) -> float: ...
    @property
    def fabric_anisotropy_error(self) -> float: ...
    @property
    def mechanical_coordination_number(self) -> float: ...
    @property
    def rattler_fraction(self) -> float: ...
    @property
    def sliding_fraction(self) -> float: ...

class Mineral(_Result):
    @property
    def key(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def source(self) -> str: ...
    @property
    def shear_modulus(self) -> float: ...
    @property
    def poisson_ratio(self) -> float: ...
    @property
    def bulk_modulus(self) -> float: ...
    @property
    def density(self) -> float: ...
    @property
    def modulus_spread(self) -> float: ...

class Moduli(_Result, Generic[_N]):
    @property
    def bulk_modulus(self) -> _N: ...
    @property
    def errors(self) -> dict[tuple[int, ...], str]: ...
    @property
    def shear_modulus(self) -> _N: ...

class ModulusErrors(_Result, Generic[_N]):
    @property
    def G_hh(self) -> _N: ...
    @property
    def G_vh(self) -> _N: ...
    @property
    def bulk_modulus(self) -> _N: ...

class Network(_Result):
    @property
    def G_hh(self) -> float: ...
    @property
    def G_vh(self) -> float: ...
    @property
    def affine(self) -> NDArray[np.float64]: ...
    @property
    def bulk_modulus(self) -> float: ...
    @property
    def bulk_modulus_bounds(self) -> tuple[float, float]: ...
    @property
    def contacts(self) -> int: ...
    @property
    def converged(self) -> bool: ...
    @property
    def grains(self) -> int: ...
    @property
    def iterations(self) -> int: ...
    @property
    def moduli(self) -> EngineeringModuli: ...
    @property
    def relaxed(self) -> NDArray[np.float64]: ...
    @property
    def residual(self) -> float: ...
    @property
    def shear_modulus(self) -> float: ...
    @property
    def symmetry(self) -> SymmetryDistances: ...

class NormalLaw:
    @property
    def alpha(self) -> float: ...
    @property
    def bulk_modulus(self) -> float: ...
    @property
    def coefficient(self) -> float: ...
    @overload
    def contact_radius(self, overlap: float) -> float: ...  # type: ignore[misc]
    @overload
    def contact_radius(self, overlap: ArrayLike) -> _Array: ...
    @overload
    def energy(self, overlap: float) -> float: ...  # type: ignore[misc]
    @overload
    def energy(self, overlap: ArrayLike) -> _Array: ...
    @overload
    def exponent_at_force(self, force: float) -> float: ...  # type: ignore[misc]
    @overload
    def exponent_at_force(self, force: ArrayLike) -> _Array: ...
    @overload
    def force(self, overlap: float) -> float: ...  # type: ignore[misc]
    @overload
    def force(self, overlap: ArrayLike) -> _Array: ...
    @property
    def force_exponent(self) -> float: ...
    @overload
    def overlap(self, force: float) -> float: ...  # type: ignore[misc]
    @overload
    def overlap(self, force: ArrayLike) -> _Array: ...
    @property
    def poisson_ratio(self) -> float: ...
    @property
    def profile_constant(self) -> float: ...
    @property
    def shear_modulus(self) -> float: ...
    @overload
    def stiffness_at_force(self, force: float) -> float: ...  # type: ignore[misc]
    @overload
    def stiffness_at_force(self, force: ArrayLike) -> _Array: ...
    @overload
    def stiffness_at_overlap(self, overlap: float) -> float: ...  # type: ignore[misc]
    @overload
    def stiffness_at_overlap(self, overlap: ArrayLike) -> _Array: ...
    @property
    def stiffness_exponent(self) -> float: ...
    def times(self, factor: float) -> NormalLaw: ...


class Packing:
    def __eq__(self, arg0: object) -> bool: ...
    def __len__(self) -> int: ...
    @property
    def body(self) -> NDArray[np.uint32]: ...
    @property
    def cell(self) -> NDArray[np.float64]: ...
    @property
    def contacts(self) -> Contacts: ...
    @property
    def id(self) -> NDArray[np.int64]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def periodic(self) -> tuple[bool, bool, bool]: ...
    @property
    def position(self) -> NDArray[np.float64]: ...
    @property
    def radius(self) -> NDArray[np.float64]: ...
    @property
    def step(self) -> int: ...
    @property
    def time(self) -> Optional[float]: ...
    @property
    def type(self) -> NDArray[np.int64]: ...
    @property
    def void_ratio(self) -> float: ...
    @property
    def volume(self) -> float: ...
    @property
    def wall_contacts(self) -> Contacts: ...
    def __copy__(self) -> Packing: ...
    def __deepcopy__(self, arg0: object) -> Packing: ...
    def plot(self, ax: Any = ..., *, across: int = ..., up: int = ...) -> Any: ...

class PackingAnswer(_Result, Generic[_N]):
    @property
    def bulk_density(self) -> Range[_N]: ...
    @property
    def bulk_modulus(self) -> Range[_N]: ...
    @property
    def compression_wave_speed(self) -> Range[_N]: ...
    @property
    def contact_softness(self) -> Range[_N]: ...
    @property
    def coordination_number(self) -> Range[_N]: ...
    @property
    def damping_ratio(self) -> Range[_N]: ...
    @property
    def horizontal_compression_wave_speed(self) -> Range[_N]: ...
    @property
    def horizontal_exponent(self) -> Range[_N]: ...
    @property
    def horizontal_shear_modulus(self) -> Range[_N]: ...
    @property
    def horizontal_shear_wave_speed(self) -> Range[_N]: ...
    @property
    def horizontal_young_modulus(self) -> Range[_N]: ...
    @property
    def mechanical_coordination_number(self) -> Range[_N]: ...
    @property
    def modulus_ratio(self) -> Range[_N]: ...
    @property
    def poisson_ratio(self) -> Range[_N]: ...
    @property
    def rattler_fraction(self) -> Range[_N]: ...
    @property
    def shear_modulus(self) -> Range[_N]: ...
    @property
    def shear_wave_speed(self) -> Range[_N]: ...
    @property
    def slip_strain(self) -> Range[_N]: ...
    @property
    def strained_shear_modulus(self) -> Range[_N]: ...
    @property
    def stress_exponent(self) -> Range[_N]: ...
    @property
    def vertical_exponent(self) -> Range[_N]: ...
    @property
    def young_modulus(self) -> Range[_N]: ...
    @property
    def errors(self) -> dict[tuple[int, ...], str]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def shape(self) -> tuple[int, ...]: ...
    @property
    def shares(self) -> dict[str, _N]: ...

class PathPoint(_Result):
    @property
    def axial_strain(self) -> float: ...
    @property
    def eta(self) -> float: ...
    @property
    def mean_stress(self) -> float: ...
    @property
    def packing(self) -> Packing: ...
    @property
    def specimen(self) -> Specimen: ...
    @property
    def step(self) -> int: ...
    @property
    def stress_h(self) -> float: ...
    @property
    def stress_v(self) -> float: ...
    @property
    def volumetric_strain(self) -> float: ...

class PlaneWaves(_Result):
    @property
    def polarisation(self) -> NDArray[np.float64]: ...
    @property
    def speed(self) -> NDArray[np.float64]: ...

class ProbeResult(_Result):
    @property
    def amplitude(self) -> float: ...
    @property
    def converged(self) -> bool: ...
    @property
    def opening(self) -> float: ...
    @property
    def shear_modulus(self) -> float: ...
    @property
    def steps(self) -> int: ...
    @property
    def unbalanced_force_ratio(self) -> float: ...

class Range(_Result, Generic[_N]):
    @property
    def high(self) -> _N: ...
    @property
    def low(self) -> _N: ...
    @property
    def value(self) -> _N: ...

class RoseBin(_Result):
    @property
    def count(self) -> int: ...
    @property
    def density(self) -> float: ...
    @property
    def density_error(self) -> float: ...
    @property
    def expected_density(self) -> float: ...
    @property
    def high(self) -> float: ...
    @property
    def low(self) -> float: ...

class Rung(_Result):
    @property
    def description(self) -> str: ...
    @property
    def error_source(self) -> str: ...
    @property
    def key(self) -> str: ...
    @property
    def needs(self) -> str: ...
    @property
    def number(self) -> Optional[int]: ...
    @property
    def title(self) -> str: ...
    @property
    def typical_time(self) -> float: ...

class RungAssessment(_Result):
    @property
    def error_source(self) -> str: ...
    @property
    def estimate(self) -> Optional[Estimate[float]]: ...
    @property
    def largest_error(self) -> Optional[float]: ...
    @property
    def missing(self) -> list[str]: ...
    @property
    def reason(self) -> str: ...
    @property
    def rung(self) -> int: ...
    @property
    def title(self) -> str: ...
    @property
    def typical_time(self) -> float: ...
    @property
    def verdict(self) -> str: ...

class SandInference(_Result):
    @property
    def level(self) -> Measured: ...
    @property
    def stress_exponent(self) -> Measured: ...
    @property
    def poisson_ratio(self) -> Measured: ...
    @property
    def mechanical_coordination_number(self) -> Range[float]: ...
    @property
    def contact_softness(self) -> Range[float]: ...
    @property
    def tells_contacts(self) -> bool: ...
    @property
    def pressure(self) -> float: ...
    @property
    def fitted(self) -> list[Measured]: ...
    @property
    def deviations(self) -> list[float]: ...
    @property
    def chi_square(self) -> float: ...
    @property
    def degrees_of_freedom(self) -> int: ...
    @property
    def probability(self) -> float: ...
    @property
    def widening(self) -> float: ...
    @property
    def notes(self) -> list[str]: ...
    def plot(self, ax: Any = ..., *, quantity: str = ..., pressure: ArrayLike) -> Any: ...
    @overload
    def predict(  # type: ignore[misc]
        self,
        quantity: str,
        *,
        pressure: Optional[float] = ...,
        stress_v: Optional[float] = ...,
        stress_h: Optional[float] = ...,
        void_ratio: Optional[float] = ...,
    ) -> MeasuredRows[float]: ...
    @overload
    def predict(
        self,
        quantity: str,
        *,
        pressure: Optional[ArrayLike] = ...,
        stress_v: Optional[ArrayLike] = ...,
        stress_h: Optional[ArrayLike] = ...,
        void_ratio: Optional[ArrayLike] = ...,
    ) -> MeasuredRows[_Array]: ...

class Shearing:
    def __iter__(self) -> Iterator[PathPoint]: ...
    def __next__(self) -> PathPoint: ...

class Sizes(_Result):
    @property
    def contacts(self) -> ContactMeans: ...
    @property
    def equivalent(self) -> float: ...
    @property
    def gradation(self) -> Gradation: ...
    @property
    def largest(self) -> float: ...
    @property
    def smallest(self) -> float: ...

class Specimen:
    def __eq__(self, arg0: object) -> bool: ...
    def __len__(self) -> int: ...
    @property
    def packing(self) -> Packing: ...
    @property
    def void_ratio(self) -> float: ...

class State(_Result):
    @property
    def packing(self) -> Packing: ...
    @property
    def pressure(self) -> float: ...
    @property
    def specimen(self) -> Specimen: ...
    @property
    def steps(self) -> int: ...
    @property
    def stress(self) -> NDArray[np.float64]: ...
    @property
    def unbalanced_force_ratio(self) -> float: ...

class Study(_Result):
    @property
    def exponents(self) -> dict[str, Any]: ...
    @property
    def failures(self) -> list[str]: ...
    @property
    def states(self) -> dict[str, Any]: ...
    @property
    def verdicts(self) -> list[Verdict]: ...
    def plot(self, ax: Any = ...) -> Any: ...

class SymmetryDistances(_Result):
    @property
    def cubic(self) -> float: ...
    @property
    def isotropic(self) -> float: ...
    @property
    def orthotropic(self) -> float: ...
    @property
    def transversely_isotropic(self) -> float: ...

class ThomsenParameters(_Result):
    @property
    def delta(self) -> float: ...
    @property
    def epsilon(self) -> float: ...
    @property
    def gamma(self) -> float: ...

class Verdict(_Result):
    @property
    def claim(self) -> str: ...
    @property
    def holds(self) -> bool: ...
    @property
    def measured(self) -> str: ...

@overload
def answer(  # type: ignore[misc]
    *,
    law: NormalLaw,
    radius: float,
    void_ratio: float,
    coordination_number: float,
    pressure: Optional[float] = None,
    stress_v: Optional[float] = None,
    stress_h: Optional[float] = None,
    fabric_anisotropy: float = 0.0,
    tangential_ratio: Optional[float] = None,
    mechanical_coordination_number: Optional[float] = None,
    rattler_fraction: Optional[float] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
    rung: _RungName,
) -> Estimate[float]: ...
@overload
def answer(
    *,
    law: NormalLaw,
    radius: ArrayLike,
    void_ratio: ArrayLike,
    coordination_number: ArrayLike,
    pressure: Optional[ArrayLike] = None,
    stress_v: Optional[ArrayLike] = None,
    stress_h: Optional[ArrayLike] = None,
    fabric_anisotropy: ArrayLike = 0.0,
    tangential_ratio: Optional[ArrayLike] = None,
    mechanical_coordination_number: Optional[ArrayLike] = None,
    rattler_fraction: Optional[ArrayLike] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
    rung: _RungName,
) -> Estimate[_Array]: ...
def bulk_density(*, grain_density: float, void_ratio: float, pore_density: float = ...) -> float: ...
def carried_contacts(
    *,
    law: NormalLaw,
    radius: float,
    void_ratio: float,
    pressure: float,
    contact_means: Optional[ContactMeans] = None,
    mechanical_coordination_number: float,
    rattler_fraction: float,
    to_pressure: float,
) -> CarriedContacts: ...
@overload
def cement_at_contacts(  # type: ignore[misc]
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    cement_shear_modulus: float,
    cement_poisson_ratio: Optional[float] = None,
    porosity: float,
    coordination_number: float,
    cement_saturation: float,
    strict: bool = False,
    bulk_modulus: Optional[float] = None,
    cement_bulk_modulus: Optional[float] = None,
) -> IsotropicModuli[float]: ...
@overload
def cement_at_contacts(
    *,
    shear_modulus: ArrayLike,
    poisson_ratio: Optional[ArrayLike] = None,
    cement_shear_modulus: ArrayLike,
    cement_poisson_ratio: Optional[ArrayLike] = None,
    porosity: ArrayLike,
    coordination_number: ArrayLike,
    cement_saturation: ArrayLike,
    strict: bool = False,
    bulk_modulus: Optional[ArrayLike] = None,
    cement_bulk_modulus: Optional[ArrayLike] = None,
) -> IsotropicModuli[_Array]: ...
@overload
def cement_in_surface_layer(  # type: ignore[misc]
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    cement_shear_modulus: float,
    cement_poisson_ratio: Optional[float] = None,
    porosity: float,
    coordination_number: float,
    cement_saturation: float,
    strict: bool = False,
    bulk_modulus: Optional[float] = None,
    cement_bulk_modulus: Optional[float] = None,
) -> IsotropicModuli[float]: ...
@overload
def cement_in_surface_layer(
    *,
    shear_modulus: ArrayLike,
    poisson_ratio: Optional[ArrayLike] = None,
    cement_shear_modulus: ArrayLike,
    cement_poisson_ratio: Optional[ArrayLike] = None,
    porosity: ArrayLike,
    coordination_number: ArrayLike,
    cement_saturation: ArrayLike,
    strict: bool = False,
    bulk_modulus: Optional[ArrayLike] = None,
    cement_bulk_modulus: Optional[ArrayLike] = None,
) -> IsotropicModuli[_Array]: ...
def compress(specimen: Specimen, pressures: ArrayLike) -> Compression: ...
def cone(
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    slope: float,
    bulk_modulus: Optional[float] = None,
) -> NormalLaw: ...
def contact_law(
    shape: str,
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    radius: Optional[float] = None,
    bulk_modulus: Optional[float] = None,
    **kwargs: float,
) -> NormalLaw: ...
def contact_prior(
    *,
    law: NormalLaw,
    radius: float,
    void_ratio: float,
    pressure: float,
    contact_means: Optional[ContactMeans] = None,
    preparation: Optional[str] = None,
) -> ContactPrior: ...
@overload
def digby(  # type: ignore[misc]
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    porosity: float,
    coordination_number: float,
    pressure: float,
    bond_radius_ratio: float,
    strict: bool = False,
    bulk_modulus: Optional[float] = None,
) -> IsotropicModuli[float]: ...
@overload
def digby(
    *,
    shear_modulus: ArrayLike,
    poisson_ratio: Optional[ArrayLike] = None,
    porosity: ArrayLike,
    coordination_number: ArrayLike,
    pressure: ArrayLike,
    bond_radius_ratio: ArrayLike,
    strict: bool = False,
    bulk_modulus: Optional[ArrayLike] = None,
) -> IsotropicModuli[_Array]: ...
def engineering_moduli(stiffness: ArrayLike) -> EngineeringModuli: ...
def estimate(
    *,
    law: NormalLaw,
    radius: float,
    void_ratio: float,
    coordination_number: Optional[float] = ...,
    pressure: Optional[float] = ...,
    stress_v: Optional[float] = ...,
    stress_h: Optional[float] = ...,
    fabric_anisotropy: float = ...,
    tangential_ratio: Optional[float] = ...,
    mechanical_coordination_number: Optional[float] = ...,
    rattler_fraction: Optional[float] = ...,
    contact_means: Optional[ContactMeans] = ...,
    strict: bool = ...,
    preparation: Optional[str] = ...,
    grain_density: Optional[float] = ...,
    saturation: float = ...,
    uncertainty: Optional[Mapping[str, float]] = ...,
    grain_shape: Optional[str] = ...,
    sand: Optional[str] = ...,
    uniformity: Optional[float] = ...,
    least_void_ratio: Optional[float] = ...,
    largest_void_ratio: Optional[float] = ...,
    relative_density: Optional[float] = ...,
    d50: Optional[float] = ...,
    shear_strain: Optional[float] = ...,
    tolerance: float,
) -> Ladder: ...
def estimate_anisotropy(normals: ArrayLike) -> AnisotropyEstimate: ...
def estimate_anisotropy_by_likelihood(normals: ArrayLike) -> LikelihoodEstimate: ...
def expected_contact_means(sizes: Distribution, *, rattler_fraction: float = ...) -> ContactMeans: ...
@overload
def exponents(  # type: ignore[misc]
    *,
    law: NormalLaw,
    radius: float,
    void_ratio: float,
    coordination_number: float,
    pressure: Optional[float] = None,
    stress_v: Optional[float] = None,
    stress_h: Optional[float] = None,
    fabric_anisotropy: float = 0.0,
    tangential_ratio: Optional[float] = None,
    mechanical_coordination_number: Optional[float] = None,
    rattler_fraction: Optional[float] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
    rung: _RungName,
    modulus: _Modulus,
) -> Exponents[float]: ...
@overload
def exponents(
    *,
    law: NormalLaw,
    radius: ArrayLike,
    void_ratio: ArrayLike,
    coordination_number: ArrayLike,
    pressure: Optional[ArrayLike] = None,
    stress_v: Optional[ArrayLike] = None,
    stress_h: Optional[ArrayLike] = None,
    fabric_anisotropy: ArrayLike = 0.0,
    tangential_ratio: Optional[ArrayLike] = None,
    mechanical_coordination_number: Optional[ArrayLike] = None,
    rattler_fraction: Optional[ArrayLike] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
    rung: _RungName,
    modulus: _Modulus,
) -> Exponents[_Array]: ...
@overload
def fabric_cumulative_probability(  # type: ignore[misc]
    *, polar_cosine: float, anisotropy: float
) -> float: ...
@overload
def fabric_cumulative_probability(*, polar_cosine: ArrayLike, anisotropy: ArrayLike) -> _Array: ...
@overload
def fabric_density(*, polar_angle: float, anisotropy: float) -> float: ...  # type: ignore[misc]
@overload
def fabric_density(*, polar_angle: ArrayLike, anisotropy: ArrayLike) -> _Array: ...
def fabric_measures(
    *, anisotropy: float = ..., F33: float = ..., P2_coefficient: float = ..., mean_cos_2gamma: float = ...
) -> FabricMeasures: ...
@overload
def fabric_polar_cosine_quantile(*, probability: float, anisotropy: float) -> float: ...  # type: ignore[misc]
@overload
def fabric_polar_cosine_quantile(*, probability: ArrayLike, anisotropy: ArrayLike) -> _Array: ...
@overload
def failure_ratio(  # type: ignore[misc]
    *, path: Literal["txc", "rtxc", "rtxe", "txe"], friction_angle: float
) -> float: ...
@overload
def failure_ratio(*, path: Literal["txc", "rtxc", "rtxe", "txe"], friction_angle: ArrayLike) -> _Array: ...
def fit(
    *,
    shear_modulus: ArrayLike,
    stress_i: ArrayLike,
    stress_j: ArrayLike,
    void_ratio: ArrayLike,
    atmospheric_pressure: float,
    void_ratio_function: str = "hardin-richart-round",
    weights: Literal["relative", "absolute"] = "relative",
    sum_only: bool = False,
) -> Fit: ...
def flat_punch(
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    punch_radius: float,
    bulk_modulus: Optional[float] = None,
) -> NormalLaw: ...
def formats() -> dict[str, str]: ...
def frames(
    *files: _Path, box: Optional[ArrayLike] = None, columns: Optional[Mapping[str, str]] = None
) -> Frames: ...
@overload
def free_spin(  # type: ignore[misc]
    *,
    law: NormalLaw,
    radius: float,
    void_ratio: float,
    coordination_number: float,
    pressure: Optional[float] = None,
    stress_v: Optional[float] = None,
    stress_h: Optional[float] = None,
    fabric_anisotropy: float = 0.0,
    tangential_ratio: Optional[float] = None,
    mechanical_coordination_number: Optional[float] = None,
    rattler_fraction: Optional[float] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
) -> Estimate[float]: ...
@overload
def free_spin(
    *,
    law: NormalLaw,
    radius: ArrayLike,
    void_ratio: ArrayLike,
    coordination_number: ArrayLike,
    pressure: Optional[ArrayLike] = None,
    stress_v: Optional[ArrayLike] = None,
    stress_h: Optional[ArrayLike] = None,
    fabric_anisotropy: ArrayLike = 0.0,
    tangential_ratio: Optional[ArrayLike] = None,
    mechanical_coordination_number: Optional[ArrayLike] = None,
    rattler_fraction: Optional[ArrayLike] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
) -> Estimate[_Array]: ...
def from_lammps(
    lmp: Any, *, contacts: Union[str, Sequence[str]] = (), columns: Optional[Mapping[str, str]] = None
) -> Packing: ...
def from_yade(scene: Any) -> Packing: ...
def gradation(radius: ArrayLike) -> Gradation: ...
@overload
def ground_stress(  # type: ignore[misc]
    *,
    depth: float,
    unit_weight: float,
    saturated_unit_weight: Optional[float] = None,
    water_table: Optional[float] = None,
    water_unit_weight: Optional[float] = None,
    earth_pressure_at_rest: float,
    surcharge: float = 0.0,
    strict: bool = False,
) -> GroundStress[float]: ...
@overload
def ground_stress(
    *,
    depth: ArrayLike,
    unit_weight: ArrayLike,
    saturated_unit_weight: Optional[ArrayLike] = None,
    water_table: Optional[ArrayLike] = None,
    water_unit_weight: Optional[ArrayLike] = None,
    earth_pressure_at_rest: ArrayLike,
    surcharge: ArrayLike = 0.0,
    strict: bool = False,
) -> GroundStress[_Array]: ...
@overload
def hardin(  # type: ignore[misc]
    *,
    coefficient: float,
    exponent_i: float,
    exponent_j: float,
    atmospheric_pressure: float,
    stress_i: float,
    stress_j: float,
    void_ratio: float,
    void_ratio_function: str = "hardin-richart-round",
) -> float: ...
@overload
def hardin(
    *,
    coefficient: ArrayLike,
    exponent_i: ArrayLike,
    exponent_j: ArrayLike,
    atmospheric_pressure: ArrayLike,
    stress_i: ArrayLike,
    stress_j: ArrayLike,
    void_ratio: ArrayLike,
    void_ratio_function: str = "hardin-richart-round",
) -> _Array: ...
@overload
def hertz_mindlin(  # type: ignore[misc]
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    porosity: float,
    coordination_number: float,
    pressure: float,
    no_slip_fraction: float = 1.0,
    strict: bool = False,
    bulk_modulus: Optional[float] = None,
) -> IsotropicModuli[float]: ...
@overload
def hertz_mindlin(
    *,
    shear_modulus: ArrayLike,
    poisson_ratio: Optional[ArrayLike] = None,
    porosity: ArrayLike,
    coordination_number: ArrayLike,
    pressure: ArrayLike,
    no_slip_fraction: ArrayLike = 1.0,
    strict: bool = False,
    bulk_modulus: Optional[ArrayLike] = None,
) -> IsotropicModuli[_Array]: ...
@overload
def infer(  # type: ignore[misc]
    *,
    law: NormalLaw,
    radius: ArrayLike,
    void_ratio: ArrayLike,
    pressure: Optional[ArrayLike] = ...,
    stress_v: Optional[ArrayLike] = ...,
    stress_h: Optional[ArrayLike] = ...,
    fabric_anisotropy: ArrayLike = ...,
    tangential_ratio: Optional[ArrayLike] = ...,
    contact_means: Optional[ContactMeans] = ...,
    relative_error: ArrayLike,
    grain_density: Optional[float] = ...,
    growth: Optional[Literal["sand", "fitted"]] = ...,
    saturation: float = ...,
    grain_shape: Literal["sand"] = ...,
    sand: str,
    uniformity: Optional[float] = ...,
    least_void_ratio: Optional[float] = ...,
    largest_void_ratio: Optional[float] = ...,
    relative_density: Optional[float] = ...,
    d50: Optional[float] = ...,
    G: Optional[ArrayLike] = ...,
    G_hh: Optional[ArrayLike] = ...,
    K: Optional[ArrayLike] = ...,
    V_s: Optional[ArrayLike] = ...,
    V_s_hh: Optional[ArrayLike] = ...,
    V_p: Optional[ArrayLike] = ...,
    V_p_h: Optional[ArrayLike] = ...,
) -> SandInference: ...
@overload
def infer(
    *,
    law: NormalLaw,
    radius: ArrayLike,
    void_ratio: ArrayLike,
    pressure: Optional[ArrayLike] = ...,
    stress_v: Optional[ArrayLike] = ...,
    stress_h: Optional[ArrayLike] = ...,
    fabric_anisotropy: ArrayLike = ...,
    tangential_ratio: Optional[ArrayLike] = ...,
    contact_means: Optional[ContactMeans] = ...,
    relative_error: ArrayLike,
    grain_density: Optional[float] = ...,
    growth: Optional[Literal["sand", "fitted"]] = ...,
    saturation: float = ...,
    grain_shape: Literal["sand"],
    sand: Optional[str] = ...,
    uniformity: Optional[float] = ...,
    least_void_ratio: Optional[float] = ...,
    largest_void_ratio: Optional[float] = ...,
    relative_density: Optional[float] = ...,
    d50: Optional[float] = ...,
    G: Optional[ArrayLike] = ...,
    G_hh: Optional[ArrayLike] = ...,
    K: Optional[ArrayLike] = ...,
    V_s: Optional[ArrayLike] = ...,
    V_s_hh: Optional[ArrayLike] = ...,
    V_p: Optional[ArrayLike] = ...,
    V_p_h: Optional[ArrayLike] = ...,
) -> SandInference: ...
@overload
def infer(
    *,
    law: NormalLaw,
    radius: ArrayLike,
    void_ratio: ArrayLike,
    pressure: Optional[ArrayLike] = ...,
    stress_v: Optional[ArrayLike] = ...,
    stress_h: Optional[ArrayLike] = ...,
    fabric_anisotropy: ArrayLike = ...,
    tangential_ratio: Optional[ArrayLike] = ...,
    contact_means: Optional[ContactMeans] = ...,
    relative_error: ArrayLike,
    grain_density: Optional[float] = ...,
    pore_density: float = ...,
    rattler_fraction: Optional[float] = ...,
    growth: Optional[Literal["packings", "fixed", "fitted"]] = ...,
    contacts: Literal["given", "rough", "power-law"] = ...,
    uncertainty: Optional[Mapping[str, float]] = ...,
    saturation: float = ...,
    grain_shape: Literal["sphere"] = ...,
    sand: Optional[str] = ...,
    G: Optional[ArrayLike] = ...,
    G_hh: Optional[ArrayLike] = ...,
    K: Optional[ArrayLike] = ...,
    V_s: Optional[ArrayLike] = ...,
    V_s_hh: Optional[ArrayLike] = ...,
    V_p: Optional[ArrayLike] = ...,
    V_p_h: Optional[ArrayLike] = ...,
) -> Inference: ...
def isotropic(*, bulk_modulus: float, shear_modulus: float) -> Isotropic: ...
def isotropic_averages(stiffness: ArrayLike) -> IsotropicAverages: ...
def isotropic_projection(stiffness: ArrayLike) -> Isotropic: ...
def isotropy_p_value(normals: ArrayLike) -> float: ...
@overload
def jenkins_shear_modulus(  # type: ignore[misc]
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    porosity: float,
    coordination_number: float,
    pressure: float,
    strict: bool = False,
    bulk_modulus: Optional[float] = None,
) -> IsotropicModuli[float]: ...
@overload
def jenkins_shear_modulus(
    *,
    shear_modulus: ArrayLike,
    poisson_ratio: Optional[ArrayLike] = None,
    porosity: ArrayLike,
    coordination_number: ArrayLike,
    pressure: ArrayLike,
    strict: bool = False,
    bulk_modulus: Optional[ArrayLike] = None,
) -> IsotropicModuli[_Array]: ...
def known_sands() -> dict[str, KnownSand]: ...
def measure(
    packing: Packing,
    *,
    law: Optional[NormalLaw] = None,
    grain_shear_modulus: Optional[float] = None,
    grain_poisson_ratio: Optional[float] = None,
    materials: Optional[Mapping[int, tuple[float, float]]] = None,
    tangential_ratio: Optional[float] = None,
    friction_coefficient: Optional[float] = None,
    grain_density: Optional[float] = None,
    stiffness_from: Optional[Literal["overlap", "force", "ratio"]] = None,
    network: bool = True,
    prestress: bool = False,
    window: Union[None, Literal["auto"], Sequence[_Range]] = "auto",
    rolling_stiffness: _TurningSpring = None,
    twisting_stiffness: _TurningSpring = None,
    grain_bulk_modulus: Optional[float] = None,
) -> Measurement: ...
def measured_laws() -> dict[str, MeasuredLaw]: ...
@overload
def mindlin_stiffness_ratio(poisson_ratio: float) -> float: ...  # type: ignore[misc]
@overload
def mindlin_stiffness_ratio(poisson_ratio: ArrayLike) -> _Array: ...
def minerals() -> dict[str, Mineral]: ...
@overload
def murphy_coordination_number(  # type: ignore[misc]
    *, porosity: float, relation: Literal["table", "quadratic", "exponential"]
) -> float: ...
@overload
def murphy_coordination_number(
    *, porosity: ArrayLike, relation: Literal["table", "quadratic", "exponential"]
) -> _Array: ...
@overload
def norris_johnson(  # type: ignore[misc]
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    porosity: float,
    coordination_number: float,
    hydrostatic_strain: float,
    uniaxial_strain: float,
    no_slip_fraction: float = 1.0,
    strict: bool = False,
    bulk_modulus: Optional[float] = None,
) -> Estimate[float]: ...
@overload
def norris_johnson(
    *,
    shear_modulus: ArrayLike,
    poisson_ratio: Optional[ArrayLike] = None,
    porosity: ArrayLike,
    coordination_number: ArrayLike,
    hydrostatic_strain: ArrayLike,
    uniaxial_strain: ArrayLike,
    no_slip_fraction: ArrayLike = 1.0,
    strict: bool = False,
    bulk_modulus: Optional[ArrayLike] = None,
) -> Estimate[_Array]: ...
@overload
def norris_johnson_stress(  # type: ignore[misc]
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    porosity: float,
    coordination_number: float,
    hydrostatic_strain: float,
    uniaxial_strain: float,
    no_slip_fraction: float = 1.0,
    strict: bool = False,
    bulk_modulus: Optional[float] = None,
    path: Literal["hydrostatic_first", "uniaxial_first", "simultaneous"],
) -> AxialStress[float]: ...
@overload
def norris_johnson_stress(
    *,
    shear_modulus: ArrayLike,
    poisson_ratio: Optional[ArrayLike] = None,
    porosity: ArrayLike,
    coordination_number: ArrayLike,
    hydrostatic_strain: ArrayLike,
    uniaxial_strain: ArrayLike,
    no_slip_fraction: ArrayLike = 1.0,
    strict: bool = False,
    bulk_modulus: Optional[ArrayLike] = None,
    path: Literal["hydrostatic_first", "uniaxial_first", "simultaneous"],
) -> AxialStress[_Array]: ...
def overlap_contacts(packing: Packing, *, law: Optional[NormalLaw] = None) -> Packing: ...
def packing(
    *,
    position: ArrayLike,
    radius: ArrayLike,
    cell: Optional[ArrayLike] = None,
    periodic: Sequence[bool] = (True, True, True),
    contacts: Optional[ArrayLike] = None,
    forces: Optional[ArrayLike] = None,
    branch: Optional[ArrayLike] = None,
    overlap: Optional[ArrayLike] = None,
    normal_force: Optional[ArrayLike] = None,
    tangential_force: Optional[ArrayLike] = None,
    normal_stiffness: Optional[ArrayLike] = None,
    tangential_stiffness: Optional[ArrayLike] = None,
    sliding: Optional[ArrayLike] = None,
    rolling_stiffness: Optional[ArrayLike] = None,
    twisting_stiffness: Optional[ArrayLike] = None,
    body: Optional[Sequence[int]] = None,
) -> Packing: ...
@overload
def packing_answer(  # type: ignore[misc]
    *,
    law: NormalLaw,
    radius: float,
    void_ratio: float,
    coordination_number: Optional[float] = ...,
    pressure: Optional[float] = ...,
    stress_v: Optional[float] = ...,
    stress_h: Optional[float] = ...,
    fabric_anisotropy: float = ...,
    tangential_ratio: Optional[float] = ...,
    mechanical_coordination_number: Optional[float] = ...,
    rattler_fraction: Optional[float] = ...,
    contact_means: Optional[ContactMeans] = ...,
    strict: bool = ...,
    preparation: Optional[str] = ...,
    grain_density: Optional[float] = ...,
    saturation: float = ...,
    uncertainty: Optional[Mapping[str, float]] = ...,
    grain_shape: Optional[str] = ...,
    sand: Optional[str] = ...,
    uniformity: Optional[float] = ...,
    least_void_ratio: Optional[float] = ...,
    largest_void_ratio: Optional[float] = ...,
    relative_density: Optional[float] = ...,
    d50: Optional[float] = ...,
    shear_strain: Optional[float] = ...,
) -> PackingAnswer[float]: ...
@overload
def packing_answer(
    *,
    law: NormalLaw,
    radius: ArrayLike,
    void_ratio: ArrayLike,
    coordination_number: Optional[ArrayLike] = ...,
    pressure: Optional[ArrayLike] = ...,
    stress_v: Optional[ArrayLike] = ...,
    stress_h: Optional[ArrayLike] = ...,
    fabric_anisotropy: ArrayLike = ...,
    tangential_ratio: Optional[ArrayLike] = ...,
    mechanical_coordination_number: Optional[ArrayLike] = ...,
    rattler_fraction: Optional[ArrayLike] = ...,
    contact_means: Optional[ContactMeans] = ...,
    strict: bool = ...,
    preparation: Optional[str] = ...,
    grain_density: Optional[ArrayLike] = ...,
    saturation: ArrayLike = ...,
    uncertainty: Optional[Mapping[str, float]] = ...,
    grain_shape: Optional[str] = ...,
    sand: Optional[str] = ...,
    uniformity: Optional[ArrayLike] = ...,
    least_void_ratio: Optional[ArrayLike] = ...,
    largest_void_ratio: Optional[ArrayLike] = ...,
    relative_density: Optional[ArrayLike] = ...,
    d50: Optional[ArrayLike] = ...,
    shear_strain: Optional[ArrayLike] = ...,
) -> PackingAnswer[_Array]: ...
def pair_radius(*, radius_i: float, radius_j: float) -> float: ...
def plane_waves(stiffness: ArrayLike, *, bulk_density: float, direction: ArrayLike) -> PlaneWaves: ...
def power_law(
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    alpha: float,
    profile_constant: float,
    bulk_modulus: Optional[float] = None,
) -> NormalLaw: ...
def probe(
    specimen: Specimen,
    *,
    mode: Literal["hh", "hv", "vh"],
    amplitude: Optional[float] = None,
    sliding: bool = False,
) -> ProbeResult: ...
def read(
    *files: _Path, box: Optional[ArrayLike] = None, columns: Optional[Mapping[str, str]] = None
) -> Packing: ...
@overload
def relaxed(  # type: ignore[misc]
    *,
    law: NormalLaw,
    radius: float,
    void_ratio: float,
    coordination_number: float,
    pressure: Optional[float] = None,
    stress_v: Optional[float] = None,
    stress_h: Optional[float] = None,
    fabric_anisotropy: float = 0.0,
    tangential_ratio: Optional[float] = None,
    mechanical_coordination_number: Optional[float] = None,
    rattler_fraction: Optional[float] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
) -> Estimate[float]: ...
@overload
def relaxed(
    *,
    law: NormalLaw,
    radius: ArrayLike,
    void_ratio: ArrayLike,
    coordination_number: ArrayLike,
    pressure: Optional[ArrayLike] = None,
    stress_v: Optional[ArrayLike] = None,
    stress_h: Optional[ArrayLike] = None,
    fabric_anisotropy: ArrayLike = 0.0,
    tangential_ratio: Optional[ArrayLike] = None,
    mechanical_coordination_number: Optional[ArrayLike] = None,
    rattler_fraction: Optional[ArrayLike] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
) -> Estimate[_Array]: ...
def rose(normals: ArrayLike, *, anisotropy: float, bins: int) -> list[RoseBin]: ...
def rotate(stiffness: ArrayLike, *, rotation: ArrayLike) -> NDArray[np.float64]: ...
def rough_sphere(
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    radius: float,
    roughness: float,
    bulk_modulus: Optional[float] = None,
) -> NormalLaw: ...
def rungs() -> list[Rung]: ...
def sample_normals(*, anisotropy: float, count: int, seed: int) -> NDArray[np.float64]: ...
@overload
def sand_shear_modulus(  # type: ignore[misc]
    *,
    law: str,
    void_ratio: float,
    pressure: float,
    uniformity: float = 1.5,
    d50: float = 0.0004,
    strict: bool = False,
) -> IsotropicModuli[float]: ...
@overload
def sand_shear_modulus(
    *,
    law: str,
    void_ratio: ArrayLike,
    pressure: ArrayLike,
    uniformity: ArrayLike = 1.5,
    d50: ArrayLike = 0.0004,
    strict: bool = False,
) -> IsotropicModuli[_Array]: ...
@overload
def saturated(  # type: ignore[misc]
    stiffness: float, *, grain_bulk_modulus: float, fluid_bulk_modulus: float, void_ratio: float
) -> Estimate[float]: ...
@overload
def saturated(
    stiffness: ArrayLike, *, grain_bulk_modulus: float, fluid_bulk_modulus: float, void_ratio: float
) -> Estimate[_Array]: ...
def shear(
    specimen: Specimen,
    *,
    path: str,
    mean_stress: float,
    eta_step: Optional[float] = None,
    strain_step: Optional[float] = None,
    largest_strain: Optional[float] = None,
    inertial_number: Optional[float] = None,
) -> Shearing: ...
@overload
def soft_sand(  # type: ignore[misc]
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    critical_porosity: float,
    coordination_number: float,
    pressure: float,
    no_slip_fraction: float = 1.0,
    strict: bool = False,
    porosity: float,
    bulk_modulus: Optional[float] = None,
) -> IsotropicModuli[float]: ...
@overload
def soft_sand(
    *,
    shear_modulus: ArrayLike,
    poisson_ratio: Optional[ArrayLike] = None,
    critical_porosity: ArrayLike,
    coordination_number: ArrayLike,
    pressure: ArrayLike,
    no_slip_fraction: ArrayLike = 1.0,
    strict: bool = False,
    porosity: ArrayLike,
    bulk_modulus: Optional[ArrayLike] = None,
) -> IsotropicModuli[_Array]: ...
def specimen(
    *,
    law: NormalLaw,
    radius: float,
    friction_coefficient: float,
    kind: Literal["dense", "loose"],
    grains: Optional[int] = None,
    seed: Optional[int] = None,
    first_pressure: Optional[float] = None,
    tangential_ratio: Optional[float] = None,
    density: Optional[float] = None,
    sizes: Optional[Distribution] = None,
    wall_friction: Optional[float] = None,
) -> Specimen: ...
def sphere(
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    radius: float,
    bulk_modulus: Optional[float] = None,
) -> NormalLaw: ...
@overload
def stiff_sand(  # type: ignore[misc]
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    critical_porosity: float,
    coordination_number: float,
    pressure: float,
    no_slip_fraction: float = 1.0,
    strict: bool = False,
    porosity: float,
    bulk_modulus: Optional[float] = None,
) -> IsotropicModuli[float]: ...
@overload
def stiff_sand(
    *,
    shear_modulus: ArrayLike,
    poisson_ratio: Optional[ArrayLike] = None,
    critical_porosity: ArrayLike,
    coordination_number: ArrayLike,
    pressure: ArrayLike,
    no_slip_fraction: ArrayLike = 1.0,
    strict: bool = False,
    porosity: ArrayLike,
    bulk_modulus: Optional[ArrayLike] = None,
) -> IsotropicModuli[_Array]: ...
@overload
def stress_on_path(  # type: ignore[misc]
    *, path: Literal["txc", "rtxc", "rtxe", "txe"], pressure: float, eta: float, strict: bool = False
) -> AxialStress[float]: ...
@overload
def stress_on_path(
    *, path: Literal["txc", "rtxc", "rtxe", "txe"], pressure: ArrayLike, eta: ArrayLike, strict: bool = False
) -> AxialStress[_Array]: ...
def symmetry_distances(stiffness: ArrayLike) -> SymmetryDistances: ...
def thomsen_parameters(stiffness: ArrayLike, *, weak: bool = ...) -> ThomsenParameters: ...
@overload
def transversely_isotropic_projection(  # type: ignore[misc]
    stiffness: float, *, axis: Optional[float] = ...
) -> Estimate[float]: ...
@overload
def transversely_isotropic_projection(
    stiffness: ArrayLike, *, axis: Optional[ArrayLike] = ...
) -> Estimate[_Array]: ...
@overload
def uniform_strain(  # type: ignore[misc]
    *,
    law: NormalLaw,
    radius: float,
    void_ratio: float,
    coordination_number: float,
    pressure: Optional[float] = None,
    stress_v: Optional[float] = None,
    stress_h: Optional[float] = None,
    fabric_anisotropy: float = 0.0,
    tangential_ratio: Optional[float] = None,
    mechanical_coordination_number: Optional[float] = None,
    rattler_fraction: Optional[float] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
) -> Estimate[float]: ...
@overload
def uniform_strain(
    *,
    law: NormalLaw,
    radius: ArrayLike,
    void_ratio: ArrayLike,
    coordination_number: ArrayLike,
    pressure: Optional[ArrayLike] = None,
    stress_v: Optional[ArrayLike] = None,
    stress_h: Optional[ArrayLike] = None,
    fabric_anisotropy: ArrayLike = 0.0,
    tangential_ratio: Optional[ArrayLike] = None,
    mechanical_coordination_number: Optional[ArrayLike] = None,
    rattler_fraction: Optional[ArrayLike] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
) -> Estimate[_Array]: ...
@overload
def uniform_strain_kinematic(  # type: ignore[misc]
    *,
    law: NormalLaw,
    radius: float,
    void_ratio: float,
    coordination_number: float,
    pressure: Optional[float] = None,
    stress_v: Optional[float] = None,
    stress_h: Optional[float] = None,
    fabric_anisotropy: float = 0.0,
    tangential_ratio: Optional[float] = None,
    mechanical_coordination_number: Optional[float] = None,
    rattler_fraction: Optional[float] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
) -> Estimate[float]: ...
@overload
def uniform_strain_kinematic(
    *,
    law: NormalLaw,
    radius: ArrayLike,
    void_ratio: ArrayLike,
    coordination_number: ArrayLike,
    pressure: Optional[ArrayLike] = None,
    stress_v: Optional[ArrayLike] = None,
    stress_h: Optional[ArrayLike] = None,
    fabric_anisotropy: ArrayLike = 0.0,
    tangential_ratio: Optional[ArrayLike] = None,
    mechanical_coordination_number: Optional[ArrayLike] = None,
    rattler_fraction: Optional[ArrayLike] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
) -> Estimate[_Array]: ...
@overload
def uniform_strain_moduli(  # type: ignore[misc]
    *,
    law: NormalLaw,
    radius: float,
    porosity: float,
    coordination_number: float,
    pressure: float,
    tangential_ratio: Optional[float] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
    out: Optional[Sequence[NDArray[np.float64]]] = None,
) -> Moduli[float]: ...
@overload
def uniform_strain_moduli(
    *,
    law: NormalLaw,
    radius: float,
    porosity: ArrayLike,
    coordination_number: ArrayLike,
    pressure: ArrayLike,
    tangential_ratio: Optional[float] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
    out: Optional[Sequence[NDArray[np.float64]]] = None,
) -> Moduli[_Array]: ...
@overload
def uniform_stress(  # type: ignore[misc]
    *,
    law: NormalLaw,
    radius: float,
    void_ratio: float,
    coordination_number: float,
    pressure: Optional[float] = None,
    stress_v: Optional[float] = None,
    stress_h: Optional[float] = None,
    fabric_anisotropy: float = 0.0,
    tangential_ratio: Optional[float] = None,
    mechanical_coordination_number: Optional[float] = None,
    rattler_fraction: Optional[float] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
) -> Estimate[float]: ...
@overload
def uniform_stress(
    *,
    law: NormalLaw,
    radius: ArrayLike,
    void_ratio: ArrayLike,
    coordination_number: ArrayLike,
    pressure: Optional[ArrayLike] = None,
    stress_v: Optional[ArrayLike] = None,
    stress_h: Optional[ArrayLike] = None,
    fabric_anisotropy: ArrayLike = 0.0,
    tangential_ratio: Optional[ArrayLike] = None,
    mechanical_coordination_number: Optional[ArrayLike] = None,
    rattler_fraction: Optional[ArrayLike] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
) -> Estimate[_Array]: ...
@overload
def uniform_stress_kinematic(  # type: ignore[misc]
    *,
    law: NormalLaw,
    radius: float,
    void_ratio: float,
    coordination_number: float,
    pressure: Optional[float] = None,
    stress_v: Optional[float] = None,
    stress_h: Optional[float] = None,
    fabric_anisotropy: float = 0.0,
    tangential_ratio: Optional[float] = None,
    mechanical_coordination_number: Optional[float] = None,
    rattler_fraction: Optional[float] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
) -> Estimate[float]: ...
@overload
def uniform_stress_kinematic(
    *,
    law: NormalLaw,
    radius: ArrayLike,
    void_ratio: ArrayLike,
    coordination_number: ArrayLike,
    pressure: Optional[ArrayLike] = None,
    stress_v: Optional[ArrayLike] = None,
    stress_h: Optional[ArrayLike] = None,
    fabric_anisotropy: ArrayLike = 0.0,
    tangential_ratio: Optional[ArrayLike] = None,
    mechanical_coordination_number: Optional[ArrayLike] = None,
    rattler_fraction: Optional[ArrayLike] = None,
    contact_means: Optional[ContactMeans] = None,
    strict: bool = False,
) -> Estimate[_Array]: ...
def verify(
    scene: Union[None, Mapping[str, Any], _Path] = None,
    *,
    progress: Union[None, Literal["tqdm"], Callable[[float, str], object]] = None,
) -> Study: ...
@overload
def void_ratio_of_relative_density(  # type: ignore[misc]
    *, relative_density: float, least_void_ratio: float, largest_void_ratio: float
) -> float: ...
@overload
def void_ratio_of_relative_density(
    *, relative_density: ArrayLike, least_void_ratio: ArrayLike, largest_void_ratio: ArrayLike
) -> _Array: ...
@overload
def walton_uniaxial(  # type: ignore[misc]
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    porosity: float,
    coordination_number: float,
    uniaxial_strain: float,
    no_slip_fraction: float = 1.0,
    strict: bool = False,
    bulk_modulus: Optional[float] = None,
) -> Estimate[float]: ...
@overload
def walton_uniaxial(
    *,
    shear_modulus: ArrayLike,
    poisson_ratio: Optional[ArrayLike] = None,
    porosity: ArrayLike,
    coordination_number: ArrayLike,
    uniaxial_strain: ArrayLike,
    no_slip_fraction: ArrayLike = 1.0,
    strict: bool = False,
    bulk_modulus: Optional[ArrayLike] = None,
) -> Estimate[_Array]: ...
@overload
def walton_uniaxial_stress(  # type: ignore[misc]
    *,
    shear_modulus: float,
    poisson_ratio: Optional[float] = None,
    porosity: float,
    coordination_number: float,
    uniaxial_strain: float,
    no_slip_fraction: float = 1.0,
    strict: bool = False,
    bulk_modulus: Optional[float] = None,
) -> AxialStress[float]: ...
@overload
def walton_uniaxial_stress(
    *,
    shear_modulus: ArrayLike,
    poisson_ratio: Optional[ArrayLike] = None,
    porosity: ArrayLike,
    coordination_number: ArrayLike,
    uniaxial_strain: ArrayLike,
    no_slip_fraction: ArrayLike = 1.0,
    strict: bool = False,
    bulk_modulus: Optional[ArrayLike] = None,
) -> AxialStress[_Array]: ...
def water_and_air_bulk_modulus(saturation: float) -> float: ...
