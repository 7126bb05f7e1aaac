"""Results of diefill as NumPy arrays, without copies. SI units; arrays are read-only."""
from typing import Dict, List, Tuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

class ResultError(ValueError): ...

class Powder:
    """Powder at one instant; arrays run over grains."""
    time: float
    """s since the start of the scene"""
    grain_diameter: float
    """m, size d of the model grains"""
    sphere_radius: float
    """m, radius R of the basic spheres"""
    grain_mass: float
    """kg"""
    grain_solid_volume: float
    """m^3, union of the spheres"""
    period: List[float]
    """m, periodic lengths along x, y, z; 0: none"""
    @property
    def sphere_offsets(self) -> Floats:
        """(s, 3) m, sphere centres in the grain's body frame"""
    @property
    def id(self) -> NDArray[np.uint64]:
        """(n,) identity of the grain"""
    @property
    def position(self) -> Floats:
        """(n, 3) m, grain centres, laboratory frame, z up"""
    @property
    def orientation(self) -> Floats:
        """(n, 4) unit quaternion w, x, y, z, body to laboratory"""
    @property
    def velocity(self) -> Floats:
        """(n, 3) m/s"""
    @property
    def angular_velocity(self) -> Floats:
        """(n, 3) rad/s, laboratory frame"""
    @property
    def kind(self) -> NDArray[np.uint8]:
        """(n,) number of the grain's type; empty for powder of one size"""
    @property
    def diameter(self) -> Floats:
        """(n,) m, a copy"""
    @property
    def mass(self) -> Floats:
        """(n,) kg, a copy"""
    def __len__(self) -> int: ...

class SolidFraction:
    """Voronoi measure of every grain."""
    @property
    def cell_volume(self) -> Floats:
        """(n,) m^3"""
    @property
    def solid_fraction(self) -> Floats:
        """(n,) grain volume over cell volume"""
    @property
    def open(self) -> NDArray[np.bool_]:
        """(n,) true where the cell reaches a free surface: its values mean nothing"""
    @property
    def in_cavity(self) -> NDArray[np.bool_]:
        """(n,) true where the grain's centre lies in the cavity"""

class ContactStress:
    """Stress times volume carried by contacts through every grain, compression negative."""
    @property
    def normal(self) -> Floats:
        """(n, 3) J: xx, yy, zz"""
    @property
    def shear(self) -> Floats:
        """(n, 3) J: yz, xz, xy"""

class Summary:
    """Solid fraction over the closed cells of the cavity at least 2 d below the powder's surface."""
    mean: float
    """sum of solid volumes over sum of cell volumes"""
    arithmetic_mean: float
    """of the grains' values"""
    std: float
    min: float
    max: float
    cv: float
    """std over arithmetic_mean"""
    grains: int
    """grains counted"""

class Instant:
    """Powder and places of the tools at an earlier time of the run."""
    time: float
    """s since the start of the scene"""
    @property
    def id(self) -> NDArray[np.uint64]: ...
    @property
    def position(self) -> Floats:
        """(n, 3) m, laboratory frame"""
    @property
    def orientation(self) -> Floats:
        """(n, 4) unit quaternion w, x, y, z, body to laboratory"""
    @property
    def velocity(self) -> Floats:
        """(n, 3) m/s"""
    @property
    def kind(self) -> NDArray[np.uint8]:
        """(n,) number of the grain's type; empty for powder of one size"""
    @property
    def tool_orientation(self) -> Floats:
        """(tools, 4) unit quaternion from the tool's place at the end of the run"""
    @property
    def tool_displacement(self) -> Floats:
        """(tools, 3) m, added after turning about the origin"""
    def __len__(self) -> int: ...

class Field:
    """A field on a rectangular grid."""
    quantity: str
    first_name: str
    first_unit: str
    second_name: str
    second_unit: str
    averaging_width: float
    """m, sigma of Bierwisch 2009, Eq. 2.27"""
    @property
    def first(self) -> Floats:
        """(a,) nodes in first_unit"""
    @property
    def second(self) -> Floats:
        """(b,) nodes in second_unit"""
    @property
    def values(self) -> Floats:
        """(b, a): values[j, i] at first[i], second[j]; NaN: no powder"""

class Section:
    """A field on a plane, coordinates in mm from its origin."""
    field: Field
    @property
    def name(self) -> str: ...
    @property
    def origin(self) -> Floats:
        """(3,) m"""
    @property
    def normal(self) -> Floats: ...
    @property
    def first_axis(self) -> Floats: ...
    @property
    def second_axis(self) -> Floats: ...

class Profile:
    """A curve, such as the fill level over the azimuth."""
    quantity: str
    unit: str
    x_name: str
    x_unit: str
    @property
    def x(self) -> Floats:
        """(n,) in x_unit"""
    @property
    def y(self) -> Floats:
        """(n,) in unit; NaN where nothing was found"""

class Probe:
    """What a probe recorded while the scene ran; probe[column] is one column."""
    name: str
    columns: List[str]
    units: List[str]
    @property
    def values(self) -> Floats:
        """(rows, columns)"""
    def __getitem__(self, name: str) -> Floats: ...

class Stage:
    """One stage of the schedule as it happened."""
    tool: str
    """tool that moved; empty: none"""
    words: str
    """for people, such as: 1 passage at 0.2 m/s"""
    start: float
    """s since the start of the scene"""
    end: float
    """s since the start of the scene"""

class ToolCheck:
    """What the check of a tool's mesh and wall spheres found."""
    tool: str
    file: str
    """its CAD file, without folders"""
    findings: List[str]
    """about the mesh; empty: none"""
    volume: float
    """m^3, enclosed by the mesh"""
    mean_deviation: float
    """m, of the wall spheres' envelope from the CAD surface"""
    largest_deviation: float
    """m"""
    largest_gap: float
    """m, between wall spheres"""

class Tool:
    """A tool as it stood at the end of the run, laboratory frame."""
    name: str
    role: str
    wall_sphere_radius: float
    """m"""
    @property
    def vertices(self) -> Floats:
        """(v, 3) m"""
    @property
    def triangles(self) -> NDArray[np.int32]:
        """(t, 3) numbers of vertices, counter-clockwise seen from outside"""
    @property
    def wall_sphere_centres(self) -> Floats:
        """(w, 3) m"""

class Cavity:
    """Where the powder is collected."""
    is_ring: bool
    inner_radius: float
    """m, of rings"""
    outer_radius: float
    """m, of rings"""
    volume: float
    """m^3 below the fill plane; 0: unknown"""
    narrowest_width: float
    """m; 0: unknown"""
    @property
    def axis_origin(self) -> Floats: ...
    @property
    def lower_corner(self) -> Floats:
        """(3,) m"""
    @property
    def upper_corner(self) -> Floats:
        """(3,) m; its z is the fill plane"""

class Results:
    """One run: powder, tools, fields and figures."""
    title: str
    strategy: str
    powder_name: str
    scene_text: str
    program_version: str
    seed: int
    state_hash: str
    warnings: List[str]
    powder: Powder
    solid_fraction: SolidFraction
    contact_stress: ContactStress
    cavity: Cavity
    summary: Summary
    """solid fraction of the grains in the cavity"""
    figures: Dict[str, float]
    """numbers of report.json by name; figure_meaning() explains them"""
    phase_seconds: Dict[str, float]
    """s of wall-clock time by phase of the step"""
    @property
    def topics(self) -> Dict[str, Dict[str, str]]: ...
    @property
    def maps(self) -> Dict[str, Field]: ...
    @property
    def sections(self) -> Dict[str, Section]: ...
    @property
    def profiles(self) -> Dict[str, Profile]: ...
    @property
    def probes(self) -> Dict[str, Probe]: ...
    @property
    def tools(self) -> Dict[str, Tool]: ...
    @property
    def instants(self) -> List[Instant]: ...
    @property
    def stages(self) -> List[Stage]:
        """the schedule as it happened"""
    @property
    def other_cavities(self) -> List[Cavity]:
        """smaller ones; figures and maps are of `cavity`"""
    @property
    def tool_checks(self) -> Dict[str, ToolCheck]:
        """by name of the tool"""

def read(directory: str) -> Results:
    """Reads directory/results.h5. Raises ResultError naming the file and what is wrong with it."""

def figure_meaning(name: str) -> Tuple[str, str]:
    """Unit of a figure ("1": a plain number), and how it is formed."""
