<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" sourcelanguage="en" language="en">
  <context>
    <name>GPS</name>
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
      <source>Colours only tell neighbours apart.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cone</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Corrected: the paper's flow, errors mended</source>
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
      <source>Offset</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Other</source>
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
      <source>Situation feature</source>
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
      <source>Thick frame: recommended; thin: allowed; none, grey: not allowed.</source>
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
      <source>a mesh has no CAD faces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>a task panel is open: close it first</source>
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
      <source>angularity</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>as measured</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>circular run-out</source>
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
      <source>flatness</source>
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
      <source>it is no feature of size</source>
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
      <source>no CAD class</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>no density is given</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>none</source>
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
      <source>oriented, not located</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>parallelism</source>
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
      <source>size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>size, with deviations or a tolerance class</source>
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
      <source>the CAD class is disputed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>the panel is closed: what it worked on is gone</source>
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
      <source>torus</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>total run-out</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>trough</source>
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
      <source>{} triangles</source>
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
