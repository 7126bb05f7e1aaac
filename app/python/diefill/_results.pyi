"""Results of diefill as NumPy arrays, without copies. SI units; arrays are read-only."""
from typing import Dict, List, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

class ResultError(ValueError):
    """Results that are missing, damaged or of a version that cannot be read; diefill.read raises BadInput instead."""

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
    def __len__(self) -> int:
        """Number of grains."""

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
    """standard deviation of the grains' values"""
    min: float
    """of the grains' values"""
    max: float
    """of the grains' values"""
    cv: float
    """std over arithmetic_mean"""
    grains: int
    """grains counted"""

class Instant:
    """Powder and places of the tools at an earlier time of the run."""
    time: float
    """s since the start of the scene"""
    @property
    def id(self) -> NDArray[np.uint64]:
        """(n,) identity of the grain"""
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
    def __len__(self) -> int:
        """Number of grains."""

class Field:
    """A field on a rectangular grid."""
    quantity: str
    """such as: solid fraction"""
    first_name: str
    """of the coordinate that varies along a row of values"""
    first_unit: str
    """of first"""
    second_name: str
    """of the coordinate that varies along a column of values"""
    second_unit: str
    """of second"""
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
    """on the plane, in mm from origin along first_axis and second_axis"""
    @property
    def name(self) -> str:
        """such as: along the shoe's motion"""
    @property
    def origin(self) -> Floats:
        """(3,) m, where both coordinates are 0"""
    @property
    def normal(self) -> Floats:
        """(3,) unit vector"""
    @property
    def first_axis(self) -> Floats:
        """(3,) unit vector"""
    @property
    def second_axis(self) -> Floats:
        """(3,) unit vector"""

class Profile:
    """A curve, such as the fill level over the azimuth."""
    quantity: str
    """such as: fill level"""
    unit: str
    """of y"""
    x_name: str
    """such as: azimuth"""
    x_unit: str
    """of x"""
    @property
    def x(self) -> Floats:
        """(n,) in x_unit"""
    @property
    def y(self) -> Floats:
        """(n,) in unit; NaN where nothing was found"""

class Probe:
    """What a probe recorded while the scene ran; probe[column] is one column."""
    name: str
    """in the scene"""
    columns: List[str]
    """names; the first is the time"""
    units: List[str]
    """one a column"""
    @property
    def values(self) -> Floats:
        """(rows, columns)"""
    def __getitem__(self, name: str) -> Floats:
        """(rows,) one column, in its unit. Raises KeyError for an unknown name, TypeError for what is no text."""

class Stage:
    """One stage of the schedule as it happened."""
    tool: str
    """tool that moved; empty: none"""
    words: str
    """such as: 1 passage at 0.2 m/s"""
    start: float
    """s since the start of the scene"""
    end: float
    """s since the start of the scene"""

class ToolCheck:
    """What the check of a tool's mesh and wall spheres found."""
    tool: str
    """its name in the scene"""
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
    """in the scene"""
    role: str
    """die, core, punch, shoe or plate"""
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
    """whether a core stands in its middle"""
    inner_radius: float
    """m, of rings"""
    outer_radius: float
    """m, of rings"""
    volume: float
    """m^3 below the fill plane; 0: unknown"""
    narrowest_width: float
    """m; 0: unknown"""
    @property
    def axis_origin(self) -> Floats:
        """(3,) m, of rings: where their vertical axis meets the fill plane"""
    @property
    def lower_corner(self) -> Floats:
        """(3,) m, of the box around the cavity"""
    @property
    def upper_corner(self) -> Floats:
        """(3,) m, of the box around the cavity; its z is the fill plane"""

class Results:
    """One run: powder, tools, fields and figures."""
    title: str
    """of the scene"""
    strategy: str
    """one line, such as: 1 passage at 0.2 m/s"""
    powder_name: str
    """such as: Distaloy AE"""
    scene_text: str
    """the scene file as it was run"""
    program_version: str
    """of the program that ran it"""
    seed: int
    """of the random numbers that place and turn the grains"""
    state_hash: str
    """the same hash: the same state, bit for bit"""
    warnings: List[str]
    """remarks of the run"""
    powder: Powder
    """at the end of the run"""
    solid_fraction: SolidFraction
    """of every grain"""
    contact_stress: ContactStress
    """of every grain"""
    cavity: Cavity
    """the largest one"""
    summary: Summary
    """solid fraction of the grains in the cavity"""
    figures: Dict[str, float]
    """numbers of report.json by name; figure_meaning() explains them"""
    phase_seconds: Dict[str, float]
    """s of wall-clock time by phase of the step, since the last restart"""
    @property
    def topics(self) -> Dict[str, Dict[str, str]]:
        """statements on powder, model, walls, numerics, ..."""
    @property
    def maps(self) -> Dict[str, Field]:
        """fields by quantity"""
    @property
    def sections(self) -> Dict[str, Section]:
        """fields on planes by name of the plane"""
    @property
    def profiles(self) -> Dict[str, Profile]:
        """curves by quantity; where several have one quantity, by "quantity over axis", such as
        "mean grain diameter over height" and "mean grain diameter over azimuth"."""
    @property
    def probes(self) -> Dict[str, Probe]:
        """by name in the scene"""
    @property
    def tools(self) -> Dict[str, Tool]:
        """by name in the scene"""
    @property
    def instants(self) -> List[Instant]:
        """earlier times, ascending (measure.snapshot_interval)"""
    @property
    def stages(self) -> List[Stage]:
        """the schedule as it happened"""
    @property
    def other_cavities(self) -> List[Cavity]:
        """smaller ones; figures and maps are of `cavity`"""
    @property
    def tool_checks(self) -> Dict[str, ToolCheck]:
        """by name of the tool"""

def read(directory: Union[str, bytes]) -> Results:
    """Reads directory/results.h5. Raises ResultError naming the file and what is wrong with it."""

def figure_meaning(name: str) -> Optional[Tuple[str, str]]:
    """Unit of a figure ("1": a plain number), and how it is formed; None: there is no such figure."""

def figure_names() -> List[str]:
    """Names of all figures; * stands for the name of an item of a scene."""
