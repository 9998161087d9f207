<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" sourcelanguage="en" language="en">
  <context>
    <name>GPS</name>
    <message>
      <source>, for orientation only,</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>; the other {n} no datum of it can lock</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A-B is a common datum, A&gt;&lt; only orients; empty: each letter in turn</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>AP242 with semantic PMI</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Add</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Agreement</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>All faces agree.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Area</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Area accuracy</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>As FreeCAD's STL export</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>As recognised</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Automatic: follows curvature</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>BSpline</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Bezier</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>CAD</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>CAD surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>CZ holds the features of the group to one another, without a datum</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cancel</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Change</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Change class …</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Change regions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Class</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click a face of the part.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Coarse</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Coaxial group</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Concave radius</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Convex radius</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Corrected: the paper's flow, errors mended</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Counterbore</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Countersink</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Curvature and shape types</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cylinder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Datum system</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Datum system {system}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Datum {letter}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Datums</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Deflection</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Densities in the command line's words, separated by semicolons</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Density</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Direction</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Edge length</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Elements a turn</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Export</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Extrusion</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>F1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Face</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Face accuracy</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Faces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Faces that disagree; a click selects one:</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fine</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Freeform</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>GPS Partition of {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>GPS features</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>GPS features, table</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>GPS legend</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Given specifications, table</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Half angle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Helicoid</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hole</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hole pattern</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Initial regions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Lead</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Lower deviation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Medium</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Merge regions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mesh coloured by class</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mesh with labels</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Meshing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mode</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Modifiers</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Move frame</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>N must be a whole number from {least} to {most}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nested classes rank close: the simplest that fits is taken.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No faces for this letter</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No partition is shown.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Normal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Null</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Of the part {free}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Offset</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Other</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>PMI is appended to the text of {path}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>PMI is not on the original STEP text but on the part as FreeCAD writes it: {why}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Paper: as printed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Partition</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Permitted specifications, table</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pin pattern</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Plane</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Press a letter, then select its faces.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>QIF 3.0</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Query face</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Radius</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Radius of the centre circle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Radius of the tube</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Ranking by log-likelihood</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reading the shape</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recognised</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recognition</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Refined regions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Region</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Region F1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Regions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Report</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Residual</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Result</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Revolution</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Rib</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Robust: consensus of vertex positions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Run</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Runner-up</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>STEP, faces named and coloured by class</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save table</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Save table…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Select a face of the part.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Shaft</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Situation feature</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Slot</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Specification</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sphere</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Split into faces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Storing the result</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Suggested</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sweep density</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>SØ{value:.6g}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Thick frame: recommended; thin: allowed; none, grey: not allowed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Together they lock {n} of six: complete{rest}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Together they lock {n} of the {needed} degrees of freedom that this part's datums can lock: not complete.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Tolerance class</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Torus</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Triangles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Undecided</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Unrecognised</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Upper deviation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Validation against CAD</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Value</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Vertices</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Width or diameter of the zone, mm; ? is open</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Without a datum nothing is locked.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>You know better</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Zone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>a class is given with the action 'class', and only with it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>a datum of {system} isn't there</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>a form tolerance takes no datum</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>a freeform surface is located by a surface profile</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>a mesh has no CAD faces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>a part of {n} points without extent has no GPS features</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>a task panel is open: close it first</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>a tolerance class is for linear sizes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>agreement with CAD</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>agrees</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>allowed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>an arc of at most half a turn has no median line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>an edge length of {size:.3g} mm would make about {expected:.2g} triangles; at most {most} are possible</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>angle {value:.6g}°</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>angularity</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>any direction</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>any direction perpendicular to {normal}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>as measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>between two coaxial cylinders</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>between two concentric circles about the datum axis, in each section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>between two concentric circles in each section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>between two cylinders about the datum axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>between two equal circles on each cylinder about the datum axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>between two lines equidistant from the nominal line, in each section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>between two parallel planes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>between two parallel planes perpendicular to the datum axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>between two parallel straight lines for each line element</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>between two surfaces equidistant from the nominal surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>can't write {path}: it is a file, not a directory</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>can't write {path}: {why}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>circle about the datum's centre, in each section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>circular run-out</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>class</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>click a part in the 3-D view or the tree</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>coaxiality</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>complex</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>concentricity</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>cone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>constraint state</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>counting …</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>cylinder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>cylindrical</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>cylindricity</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>datum</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>datum {letter} is given twice</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>datum {letter}: {why}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>datum {name} in {text!r} isn't assigned to a feature</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>datum {name} stands twice in {text!r}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>density {text!r} isn't valid ({why}): use one of {forms}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>density {text!r} isn't valid: use one of {forms}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>disagrees</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>dome</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>extrusion</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>five</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>flatness</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>form of each of its features by itself, without a datum</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>form of the feature itself, without a datum</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>four</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>freeform</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>fully located</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>helical</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>helicoid</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>helix</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>in no feature</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>initial region</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>invariance class</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>is redundant: it locks nothing that isn't locked already</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it doesn't turn about an axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it doesn't turn about an axis of these datums</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it has no axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it has no centre point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it has no direction to orient</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it has no face</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it has no median plane or line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it has no straight line elements</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it is no feature of size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it isn't a cylinder</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it isn't flat</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it needs a datum, and none stands before this feature</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it needs a value above 0, or none</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it needs a value of at least 0, or none</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it needs both deviations, or none</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it serves any angle to the datums</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>it turns about the datum axis</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>its axis isn't a datum axis: use position</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>its centre isn't on a datum axis or point: use position</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>its median feature isn't that of a datum: use position</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>its numbers must be positive</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>its sections aren't circles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>line and point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>line profile</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>locks {what}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>locks {what} and {also}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>lower</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>merge</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>merging takes at least two faces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>needs more than {limit} MB of memory</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no CAD class</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no density is given</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no face is chosen</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no face {name!r}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no result within {seconds:g} s</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no surface can be laid through {n} points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>none</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>none of its datums is there</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>none of {n} triangles has an area</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>not allowed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>not oriented</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>not recognised: no region of the mesh lies on it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>one</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>one rotation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>one translation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>oriented, not located</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>parallelism</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>part or settings have changed: run it again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>partition a part first, or select one of the partitions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>perpendicularity</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>planar</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>plane</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>plane and line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>plane, line and point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>point</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>position</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>prismatic</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>recommended</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>refined region</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>region {region} is {kind} but has no {lacking}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>revolute</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>revolution</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>ridge</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>rotation about {about} stays free</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>roundness</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>rut</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>s</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>saddle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>saddle ridge</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>saddle rut</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>select a part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>shape type</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>sharp edge</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>six</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>size, with deviations or a tolerance class</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>specification of {feature!r}: that is {names}; name one feature</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>specification {characteristic}: {why}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>sphere</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>spherical</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>spherical cap</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>spherical cup</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>split</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>straightness</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>surface profile</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>symmetry</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>that is the nominal angle to a datum</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the CAD class is disputed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the CAD kernel crashed ({signal})</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the angle must be below 180 degrees</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the annotation is damaged ({error})</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the annotation is of schema {found!r}, not {known!r}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the datums have no direction</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the datums locate it fully</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the isolated process failed: {why}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the lower deviation is above the upper one</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the nominal angle to the first datum is {angle:.4g}°: use {characteristic}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the panel is closed: what it worked on is gone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the part has changed since it was imported from {path}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the part wasn't imported from a STEP file by GPS</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the result of {part} is damaged ({error})</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the stored overrides are damaged ({error})</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>there are no frames in this view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>there is no part: import one</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>there is no such suggestion</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>three</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>three rotations</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>three translations</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>torus</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>total run-out</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>total run-out is defined for cylinders and planes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>translation along {along} and rotation about {about} stays free</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>translation along {along} stays free</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>trough</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>two</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>two rotations</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>two translations</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>upper</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>value</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>width {value:.6g}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>without a datum it bounds the form</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{characteristic} of {feature!r}: {why}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{different} different points among {n}: a surface needs at least {least}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{face} has changed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{face} is gone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{face} is now {other}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{feature} holds a {surface}: {why}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{feature} is no feature of size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{feature} is {why}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{fit} is a class of holes and slots, {feature} is external</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{fit} is a class of shafts and ribs, {feature} is internal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{lines}, or a cylinder Ø for the median line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{modifier} doesn't go with it (ISO 2692)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name}: the name must end in one of {suffixes}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{name}: {kind}: {part} is a mesh without CAD faces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{n} points are more than {most}: thin the cloud first</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{n} points span no surface: they lie on a line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{one} with {other}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{part!r} in {text!r} is no datum; write A|B-C|D&gt;&lt;</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{part} has no faces to partition</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{part} has no result yet</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{part} is empty</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path} has changed since the part was imported</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path}: FreeCAD can't read the file ({reason})</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path}: can't be read ({reason})</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path}: is a directory, not a file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path}: its text holds no B-rep face to colour</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path}: no face of the shape can be tessellated</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path}: no such file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path}: not a STEP file (ISO-10303-21 is missing)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path}: not an FCStd document (no zip archive)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path}: not an OCCT BREP file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path}: the STEP file is truncated (END-ISO-10303-21 is missing)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path}: the file holds no faces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path}: the file holds nothing to partition</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path}: the file is empty</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{path}: unknown format {suffix!r}; expected {known}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{said}; did you mean {word!r}?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{text!r} is no datum letter; A to ZZZ are</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{text!r} is no datum; write A=Face1,B=Face5+Face6</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{what} of {feature}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{where}: feature and characteristic are needed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{where}: modifier {word!r} is none of M, L, R</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{where}: {key} is neither text nor a number</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{where}: {key} {text!r} is not a number</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{where}: {word!r} is no tolerance class as H7 or g6</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{where}: {word!r} is none of {known}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{word!r} in {text!r}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{word!r} is no characteristic of ISO 1101, nor 'size'</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{wrong} is neither a feature nor a face of one</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{} % of its area</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{} faces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{} faces are selected; this is the last.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{} of {} features, in {} regions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{} points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{} regions; colours only tell neighbours apart.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{} triangles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Ø{value:.6g}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Ⓜ and Ⓛ exclude each other (ISO 2692)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Ⓡ stands after Ⓜ or Ⓛ only (ISO 2692)</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Annotate</name>
    <message>
      <source>Put a specification on a feature: what ISO 1101 permits there, and why not the rest</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Specification…</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Colour</name>
    <message>
      <source>Colour</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What the colours show</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Colour_0</name>
    <message>
      <source>By invariance class</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The seven classes in the colours of the wheel</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Colour_1</name>
    <message>
      <source>By shape type</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cup, rut, saddle, ridge, cap, plane, from curvature</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Colour_2</name>
    <message>
      <source>By initial region</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What the first step found</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Colour_3</name>
    <message>
      <source>By refined region</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What the second step made of it</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Colour_4</name>
    <message>
      <source>By agreement with CAD</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Where the recognised class is that of the CAD surface</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Colour_5</name>
    <message>
      <source>By constraint state</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What the datum system fixes of each feature</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Colour_Facets</name>
    <message>
      <source>On the mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show the mesh with a colour a facet, or the part's faces again</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Datums</name>
    <message>
      <source>Choose datum features, or take the suggested ones: what each letter locks</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Datum system…</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Export</name>
    <message>
      <source>Export…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Write result, faces, GPS features, report or mesh as a file</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Frames</name>
    <message>
      <source>Lay the frames out beside the part as this view shows it, none over another</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Place frames</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Import</name>
    <message>
      <source>Bring a part into the document: STEP, BREP, mesh or points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Import part</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Import part…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Parts</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Legend</name>
    <message>
      <source>Legend</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What the colours mean, how many faces have each; a click selects them</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Partition</name>
    <message>
      <source>Mesh a part, divide the mesh into regions and recognise the invariance class of each</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Partition…</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Query</name>
    <message>
      <source>Click a face: its class, situation feature, intrinsic values, agreement and ranking</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Query face</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Report</name>
    <message>
      <source>Report</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Write the report (one page, no network) and open it in the browser</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Sweep</name>
    <message>
      <source>Partition the part at several densities and compare the accuracy</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sweep density…</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GPS_Validate</name>
    <message>
      <source>Compare the recognised classes with those of the CAD surfaces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Validate</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>GpsPreferences</name>
    <message>
      <source> s</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>A partition that took longer is marked as stale when its part changes, and waits for you to run it again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>As FreeCAD's STL export</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Automatic: follows curvature</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Coarse</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Colours of the classes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Corrected</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Density</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Fine</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>For colour-blind eyes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>General</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>How fine the mesh is, where the panel says nothing else</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Medium</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mode</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>New features show their axis, centre or plane</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>New partitions</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Paper</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Recompute by itself up to</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Robust</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The paper's wheel</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>View</source>
      <translation type="unfinished" />
    </message>
  </context>
</TS>
