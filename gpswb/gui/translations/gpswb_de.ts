<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" sourcelanguage="en" language="de">
  <context>
    <name>GPS</name>
    <message>
      <source>A-B is a common datum, A&gt;&lt; only orients; empty: each letter in turn</source>
      <translation>A-B ist ein gemeinsamer Bezug, A&gt;&lt; richtet nur aus; leer: jeder Buchstabe der Reihe nach</translation>
    </message>
    <message>
      <source>AP242 with semantic PMI</source>
      <translation>AP242 mit semantischer PMI</translation>
    </message>
    <message>
      <source>Add</source>
      <translation>Hinzufügen</translation>
    </message>
    <message>
      <source>Agreement</source>
      <translation>Übereinstimmung</translation>
    </message>
    <message>
      <source>All faces agree.</source>
      <translation>Alle Flächen stimmen überein.</translation>
    </message>
    <message>
      <source>Area</source>
      <translation>Fläche</translation>
    </message>
    <message>
      <source>Area accuracy</source>
      <translation>Genauigkeit nach Fläche</translation>
    </message>
    <message>
      <source>As FreeCAD's STL export</source>
      <translation>Wie FreeCADs STL-Export</translation>
    </message>
    <message>
      <source>As recognised</source>
      <translation>Wie erkannt</translation>
    </message>
    <message>
      <source>Automatic: follows curvature</source>
      <translation>Automatisch: folgt der Krümmung</translation>
    </message>
    <message>
      <source>BSpline</source>
      <translation>B-Spline</translation>
    </message>
    <message>
      <source>Bezier</source>
      <translation>Bézier</translation>
    </message>
    <message>
      <source>CAD</source>
      <translation>CAD</translation>
    </message>
    <message>
      <source>CAD surface</source>
      <translation>CAD-Fläche</translation>
    </message>
    <message>
      <source>Change</source>
      <translation>Ändern</translation>
    </message>
    <message>
      <source>Change class …</source>
      <translation>Klasse ändern …</translation>
    </message>
    <message>
      <source>Change regions</source>
      <translation>Regionen ändern</translation>
    </message>
    <message>
      <source>Class</source>
      <translation>Klasse</translation>
    </message>
    <message>
      <source>Click a face of the part.</source>
      <translation>Klicken Sie eine Fläche des Teils an.</translation>
    </message>
    <message>
      <source>Coarse</source>
      <translation>Grob</translation>
    </message>
    <message>
      <source>Colours only tell neighbours apart.</source>
      <translation>Die Farben unterscheiden nur Nachbarn.</translation>
    </message>
    <message>
      <source>Cone</source>
      <translation>Kegel</translation>
    </message>
    <message>
      <source>Corrected: the paper's flow, errors mended</source>
      <translation>Korrigiert: Ablauf des Artikels, Fehler behoben</translation>
    </message>
    <message>
      <source>Curvature and shape types</source>
      <translation>Krümmung und Formtypen</translation>
    </message>
    <message>
      <source>Cylinder</source>
      <translation>Zylinder</translation>
    </message>
    <message>
      <source>Datum system</source>
      <translation>Bezugssystem</translation>
    </message>
    <message>
      <source>Datums</source>
      <translation>Bezüge</translation>
    </message>
    <message>
      <source>Deflection</source>
      <translation>Sehnenabweichung</translation>
    </message>
    <message>
      <source>Densities in the command line's words, separated by semicolons</source>
      <translation>Dichten in den Worten der Befehlszeile, durch Semikolon getrennt</translation>
    </message>
    <message>
      <source>Density</source>
      <translation>Dichte</translation>
    </message>
    <message>
      <source>Direction</source>
      <translation>Richtung</translation>
    </message>
    <message>
      <source>Edge length</source>
      <translation>Kantenlänge</translation>
    </message>
    <message>
      <source>Elements a turn</source>
      <translation>Elemente je Umdrehung</translation>
    </message>
    <message>
      <source>Export</source>
      <translation>Exportieren</translation>
    </message>
    <message>
      <source>Extrusion</source>
      <translation>Extrusion</translation>
    </message>
    <message>
      <source>F1</source>
      <translation>F1</translation>
    </message>
    <message>
      <source>Face</source>
      <translation>Fläche</translation>
    </message>
    <message>
      <source>Face accuracy</source>
      <translation>Genauigkeit nach Flächen</translation>
    </message>
    <message>
      <source>Faces</source>
      <translation>Flächen</translation>
    </message>
    <message>
      <source>Faces that disagree; a click selects one:</source>
      <translation>Abweichende Flächen; ein Klick wählt eine aus:</translation>
    </message>
    <message>
      <source>Fine</source>
      <translation>Fein</translation>
    </message>
    <message>
      <source>GPS Partition of {}</source>
      <translation>GPS-Partition von {}</translation>
    </message>
    <message>
      <source>GPS features</source>
      <translation>GPS-Geometrieelemente</translation>
    </message>
    <message>
      <source>GPS features, table</source>
      <translation>GPS-Geometrieelemente, Tabelle</translation>
    </message>
    <message>
      <source>GPS legend</source>
      <translation>GPS-Legende</translation>
    </message>
    <message>
      <source>Given specifications, table</source>
      <translation>Gegebene Spezifikationen, Tabelle</translation>
    </message>
    <message>
      <source>Half angle</source>
      <translation>Halber Winkel</translation>
    </message>
    <message>
      <source>Initial regions</source>
      <translation>Anfangsregionen</translation>
    </message>
    <message>
      <source>Lead</source>
      <translation>Steigung</translation>
    </message>
    <message>
      <source>Lower deviation</source>
      <translation>Unteres Abmaß</translation>
    </message>
    <message>
      <source>Medium</source>
      <translation>Mittel</translation>
    </message>
    <message>
      <source>Merge regions</source>
      <translation>Regionen vereinen</translation>
    </message>
    <message>
      <source>Mesh coloured by class</source>
      <translation>Netz in den Farben der Klassen</translation>
    </message>
    <message>
      <source>Mesh with labels</source>
      <translation>Netz mit Kennzeichen</translation>
    </message>
    <message>
      <source>Meshing</source>
      <translation>Vernetzung</translation>
    </message>
    <message>
      <source>Mode</source>
      <translation>Modus</translation>
    </message>
    <message>
      <source>Modifiers</source>
      <translation>Modifikatoren</translation>
    </message>
    <message>
      <source>Move frame</source>
      <translation>Rahmen verschieben</translation>
    </message>
    <message>
      <source>Nested classes rank close: the simplest that fits is taken.</source>
      <translation>Verschachtelte Klassen liegen nah beieinander: die einfachste, die passt, gilt.</translation>
    </message>
    <message>
      <source>No faces for this letter</source>
      <translation>Keine Flächen für diesen Buchstaben</translation>
    </message>
    <message>
      <source>No partition is shown.</source>
      <translation>Keine Partition wird gezeigt.</translation>
    </message>
    <message>
      <source>Normal</source>
      <translation>Normale</translation>
    </message>
    <message>
      <source>Null</source>
      <translation>Ohne Fläche</translation>
    </message>
    <message>
      <source>Offset</source>
      <translation>Versatzfläche</translation>
    </message>
    <message>
      <source>Other</source>
      <translation>Andere</translation>
    </message>
    <message>
      <source>Paper: as printed</source>
      <translation>Artikel: wie gedruckt</translation>
    </message>
    <message>
      <source>Part</source>
      <translation>Teil</translation>
    </message>
    <message>
      <source>Partition</source>
      <translation>Partitionieren</translation>
    </message>
    <message>
      <source>Permitted specifications, table</source>
      <translation>Zulässige Spezifikationen, Tabelle</translation>
    </message>
    <message>
      <source>Plane</source>
      <translation>Ebene</translation>
    </message>
    <message>
      <source>Point</source>
      <translation>Punkt</translation>
    </message>
    <message>
      <source>Press a letter, then select its faces.</source>
      <translation>Einen Buchstaben drücken, dann seine Flächen wählen.</translation>
    </message>
    <message>
      <source>QIF 3.0</source>
      <translation>QIF 3.0</translation>
    </message>
    <message>
      <source>Query face</source>
      <translation>Fläche abfragen</translation>
    </message>
    <message>
      <source>Radius</source>
      <translation>Radius</translation>
    </message>
    <message>
      <source>Radius of the centre circle</source>
      <translation>Radius des Mittenkreises</translation>
    </message>
    <message>
      <source>Radius of the tube</source>
      <translation>Radius der Röhre</translation>
    </message>
    <message>
      <source>Ranking by log-likelihood</source>
      <translation>Rangfolge nach Log-Likelihood</translation>
    </message>
    <message>
      <source>Reading the shape</source>
      <translation>Form wird gelesen</translation>
    </message>
    <message>
      <source>Recognised</source>
      <translation>Erkannt</translation>
    </message>
    <message>
      <source>Recognition</source>
      <translation>Erkennung</translation>
    </message>
    <message>
      <source>Refined regions</source>
      <translation>Verfeinerte Regionen</translation>
    </message>
    <message>
      <source>Region</source>
      <translation>Region</translation>
    </message>
    <message>
      <source>Region F1</source>
      <translation>F1 der Regionen</translation>
    </message>
    <message>
      <source>Regions</source>
      <translation>Regionen</translation>
    </message>
    <message>
      <source>Report</source>
      <translation>Bericht</translation>
    </message>
    <message>
      <source>Residual</source>
      <translation>Restabweichung</translation>
    </message>
    <message>
      <source>Result</source>
      <translation>Ergebnis</translation>
    </message>
    <message>
      <source>Revolution</source>
      <translation>Rotationsfläche</translation>
    </message>
    <message>
      <source>Robust: consensus of vertex positions</source>
      <translation>Robust: Konsens der Knotenlagen</translation>
    </message>
    <message>
      <source>Run</source>
      <translation>Starten</translation>
    </message>
    <message>
      <source>Runner-up</source>
      <translation>Zweiter Vorschlag</translation>
    </message>
    <message>
      <source>Save table</source>
      <translation>Tabelle speichern</translation>
    </message>
    <message>
      <source>Save table…</source>
      <translation>Tabelle speichern…</translation>
    </message>
    <message>
      <source>Select a face of the part.</source>
      <translation>Eine Fläche des Teils wählen.</translation>
    </message>
    <message>
      <source>Situation feature</source>
      <translation>Situationselement</translation>
    </message>
    <message>
      <source>Specification</source>
      <translation>Spezifikation</translation>
    </message>
    <message>
      <source>Sphere</source>
      <translation>Kugel</translation>
    </message>
    <message>
      <source>Split into faces</source>
      <translation>In Flächen teilen</translation>
    </message>
    <message>
      <source>Storing the result</source>
      <translation>Ergebnis wird gespeichert</translation>
    </message>
    <message>
      <source>Suggested</source>
      <translation>Vorschlag</translation>
    </message>
    <message>
      <source>Surface</source>
      <translation>Oberfläche</translation>
    </message>
    <message>
      <source>Sweep density</source>
      <translation>Dichte variieren</translation>
    </message>
    <message>
      <source>Thick frame: recommended; thin: allowed; none, grey: not allowed.</source>
      <translation>Dicker Rahmen: empfohlen; dünner: erlaubt; keiner, grau: nicht erlaubt.</translation>
    </message>
    <message>
      <source>Tolerance class</source>
      <translation>Toleranzklasse</translation>
    </message>
    <message>
      <source>Torus</source>
      <translation>Torus</translation>
    </message>
    <message>
      <source>Triangles</source>
      <translation>Dreiecke</translation>
    </message>
    <message>
      <source>Undecided</source>
      <translation>Unentschieden</translation>
    </message>
    <message>
      <source>Upper deviation</source>
      <translation>Oberes Abmaß</translation>
    </message>
    <message>
      <source>Validation against CAD</source>
      <translation>Vergleich mit CAD</translation>
    </message>
    <message>
      <source>Value</source>
      <translation>Wert</translation>
    </message>
    <message>
      <source>Vertices</source>
      <translation>Knoten</translation>
    </message>
    <message>
      <source>Width or diameter of the zone, mm; ? is open</source>
      <translation>Breite oder Durchmesser der Zone, mm; ? ist offen</translation>
    </message>
    <message>
      <source>Without a datum nothing is locked.</source>
      <translation>Ohne Bezug ist nichts festgelegt.</translation>
    </message>
    <message>
      <source>You know better</source>
      <translation>Sie wissen es besser</translation>
    </message>
    <message>
      <source>Zone</source>
      <translation>Zone</translation>
    </message>
    <message>
      <source>a mesh has no CAD faces</source>
      <translation>ein Netz hat keine CAD-Flächen</translation>
    </message>
    <message>
      <source>a task panel is open: close it first</source>
      <translation>ein Aufgabenfenster ist offen: erst schließen</translation>
    </message>
    <message>
      <source>agreement with CAD</source>
      <translation>Übereinstimmung mit CAD</translation>
    </message>
    <message>
      <source>agrees</source>
      <translation>stimmt überein</translation>
    </message>
    <message>
      <source>allowed</source>
      <translation>erlaubt</translation>
    </message>
    <message>
      <source>angularity</source>
      <translation>Neigung</translation>
    </message>
    <message>
      <source>as measured</source>
      <translation>wie gemessen</translation>
    </message>
    <message>
      <source>circular run-out</source>
      <translation>Rundlauf</translation>
    </message>
    <message>
      <source>click a part in the 3-D view or the tree</source>
      <translation>ein Teil in der 3D-Ansicht oder im Baum anklicken</translation>
    </message>
    <message>
      <source>coaxiality</source>
      <translation>Koaxialität</translation>
    </message>
    <message>
      <source>complex</source>
      <translation>komplex</translation>
    </message>
    <message>
      <source>concentricity</source>
      <translation>Konzentrizität</translation>
    </message>
    <message>
      <source>cone</source>
      <translation>Kegel</translation>
    </message>
    <message>
      <source>constraint state</source>
      <translation>Bestimmtheit</translation>
    </message>
    <message>
      <source>counting …</source>
      <translation>wird gezählt …</translation>
    </message>
    <message>
      <source>cylinder</source>
      <translation>Zylinder</translation>
    </message>
    <message>
      <source>cylindrical</source>
      <translation>zylindrisch</translation>
    </message>
    <message>
      <source>cylindricity</source>
      <translation>Zylindrizität</translation>
    </message>
    <message>
      <source>datum</source>
      <translation>Bezug</translation>
    </message>
    <message>
      <source>disagrees</source>
      <translation>weicht ab</translation>
    </message>
    <message>
      <source>dome</source>
      <translation>Kuppel</translation>
    </message>
    <message>
      <source>extrusion</source>
      <translation>Extrusion</translation>
    </message>
    <message>
      <source>flatness</source>
      <translation>Ebenheit</translation>
    </message>
    <message>
      <source>freeform</source>
      <translation>Freiform</translation>
    </message>
    <message>
      <source>fully located</source>
      <translation>vollständig bestimmt</translation>
    </message>
    <message>
      <source>helical</source>
      <translation>schraubenförmig</translation>
    </message>
    <message>
      <source>helicoid</source>
      <translation>Schraubenfläche</translation>
    </message>
    <message>
      <source>helix</source>
      <translation>Schraubenlinie</translation>
    </message>
    <message>
      <source>in no feature</source>
      <translation>in keinem Geometrieelement</translation>
    </message>
    <message>
      <source>initial region</source>
      <translation>Anfangsregion</translation>
    </message>
    <message>
      <source>invariance class</source>
      <translation>Invarianzklasse</translation>
    </message>
    <message>
      <source>it is no feature of size</source>
      <translation>es ist kein Maßelement</translation>
    </message>
    <message>
      <source>line</source>
      <translation>Gerade</translation>
    </message>
    <message>
      <source>line and point</source>
      <translation>Gerade und Punkt</translation>
    </message>
    <message>
      <source>line profile</source>
      <translation>Linienprofil</translation>
    </message>
    <message>
      <source>no CAD class</source>
      <translation>keine CAD-Klasse</translation>
    </message>
    <message>
      <source>no density is given</source>
      <translation>keine Dichte ist angegeben</translation>
    </message>
    <message>
      <source>none</source>
      <translation>keine</translation>
    </message>
    <message>
      <source>not allowed</source>
      <translation>nicht erlaubt</translation>
    </message>
    <message>
      <source>not oriented</source>
      <translation>nicht ausgerichtet</translation>
    </message>
    <message>
      <source>oriented, not located</source>
      <translation>ausgerichtet, nicht verortet</translation>
    </message>
    <message>
      <source>parallelism</source>
      <translation>Parallelität</translation>
    </message>
    <message>
      <source>partition a part first, or select one of the partitions</source>
      <translation>erst ein Teil partitionieren, oder eine der Partitionen auswählen</translation>
    </message>
    <message>
      <source>perpendicularity</source>
      <translation>Rechtwinkligkeit</translation>
    </message>
    <message>
      <source>planar</source>
      <translation>eben</translation>
    </message>
    <message>
      <source>plane</source>
      <translation>Ebene</translation>
    </message>
    <message>
      <source>plane and line</source>
      <translation>Ebene und Gerade</translation>
    </message>
    <message>
      <source>plane, line and point</source>
      <translation>Ebene, Gerade und Punkt</translation>
    </message>
    <message>
      <source>point</source>
      <translation>Punkt</translation>
    </message>
    <message>
      <source>position</source>
      <translation>Position</translation>
    </message>
    <message>
      <source>prismatic</source>
      <translation>prismatisch</translation>
    </message>
    <message>
      <source>recommended</source>
      <translation>empfohlen</translation>
    </message>
    <message>
      <source>refined region</source>
      <translation>Verfeinerte Region</translation>
    </message>
    <message>
      <source>revolute</source>
      <translation>rotatorisch</translation>
    </message>
    <message>
      <source>revolution</source>
      <translation>Rotationsfläche</translation>
    </message>
    <message>
      <source>ridge</source>
      <translation>Rücken</translation>
    </message>
    <message>
      <source>roundness</source>
      <translation>Rundheit</translation>
    </message>
    <message>
      <source>rut</source>
      <translation>Rinne</translation>
    </message>
    <message>
      <source>s</source>
      <translation>s</translation>
    </message>
    <message>
      <source>saddle</source>
      <translation>Sattel</translation>
    </message>
    <message>
      <source>saddle ridge</source>
      <translation>Sattelrücken</translation>
    </message>
    <message>
      <source>saddle rut</source>
      <translation>Sattelrinne</translation>
    </message>
    <message>
      <source>select a part</source>
      <translation>ein Teil auswählen</translation>
    </message>
    <message>
      <source>shape type</source>
      <translation>Formtyp</translation>
    </message>
    <message>
      <source>sharp edge</source>
      <translation>scharfe Kante</translation>
    </message>
    <message>
      <source>size</source>
      <translation>Maß</translation>
    </message>
    <message>
      <source>size, with deviations or a tolerance class</source>
      <translation>Maß, mit Abmaßen oder Toleranzklasse</translation>
    </message>
    <message>
      <source>sphere</source>
      <translation>Kugel</translation>
    </message>
    <message>
      <source>spherical</source>
      <translation>kugelig</translation>
    </message>
    <message>
      <source>spherical cap</source>
      <translation>Kugelkappe</translation>
    </message>
    <message>
      <source>spherical cup</source>
      <translation>Kugelschale</translation>
    </message>
    <message>
      <source>straightness</source>
      <translation>Geradheit</translation>
    </message>
    <message>
      <source>surface profile</source>
      <translation>Flächenprofil</translation>
    </message>
    <message>
      <source>symmetry</source>
      <translation>Symmetrie</translation>
    </message>
    <message>
      <source>the CAD class is disputed</source>
      <translation>die CAD-Klasse ist strittig</translation>
    </message>
    <message>
      <source>the panel is closed: what it worked on is gone</source>
      <translation>das Fenster ist geschlossen: woran es arbeitete, ist gelöscht</translation>
    </message>
    <message>
      <source>there are no frames in this view</source>
      <translation>in dieser Ansicht sind keine Rahmen</translation>
    </message>
    <message>
      <source>there is no part: import one</source>
      <translation>es ist kein Teil da: eines importieren</translation>
    </message>
    <message>
      <source>torus</source>
      <translation>Torus</translation>
    </message>
    <message>
      <source>total run-out</source>
      <translation>Gesamtlauf</translation>
    </message>
    <message>
      <source>trough</source>
      <translation>Mulde</translation>
    </message>
    <message>
      <source>{} % of its area</source>
      <translation>{} % ihrer Fläche</translation>
    </message>
    <message>
      <source>{} faces</source>
      <translation>{} Flächen</translation>
    </message>
    <message>
      <source>{} faces are selected; this is the last.</source>
      <translation>{} Flächen sind gewählt; dies ist die letzte.</translation>
    </message>
    <message>
      <source>{} of {} features, in {} regions</source>
      <translation>{} von {} Geometrieelementen, in {} Regionen</translation>
    </message>
    <message>
      <source>{} points</source>
      <translation>{} Punkte</translation>
    </message>
    <message>
      <source>{} triangles</source>
      <translation>{} Dreiecke</translation>
    </message>
  </context>
  <context>
    <name>GPS_Annotate</name>
    <message>
      <source>Put a specification on a feature: what ISO 1101 permits there, and why not the rest</source>
      <translation>Eine Spezifikation an ein Geometrieelement setzen: was ISO 1101 dort erlaubt, und warum das Übrige nicht</translation>
    </message>
    <message>
      <source>Specification…</source>
      <translation>Spezifikation…</translation>
    </message>
  </context>
  <context>
    <name>GPS_Colour</name>
    <message>
      <source>Colour</source>
      <translation>Färben</translation>
    </message>
    <message>
      <source>What the colours show</source>
      <translation>Was die Farben zeigen</translation>
    </message>
  </context>
  <context>
    <name>GPS_Colour_0</name>
    <message>
      <source>By invariance class</source>
      <translation>Nach Invarianzklasse</translation>
    </message>
    <message>
      <source>The seven classes in the colours of the wheel</source>
      <translation>Die sieben Klassen in den Farben des Rades</translation>
    </message>
  </context>
  <context>
    <name>GPS_Colour_1</name>
    <message>
      <source>By shape type</source>
      <translation>Nach Formtyp</translation>
    </message>
    <message>
      <source>Cup, rut, saddle, ridge, cap, plane, from curvature</source>
      <translation>Schale, Rinne, Sattel, Rücken, Kappe, Ebene, aus der Krümmung</translation>
    </message>
  </context>
  <context>
    <name>GPS_Colour_2</name>
    <message>
      <source>By initial region</source>
      <translation>Nach Anfangsregion</translation>
    </message>
    <message>
      <source>What the first step found</source>
      <translation>Was der erste Schritt fand</translation>
    </message>
  </context>
  <context>
    <name>GPS_Colour_3</name>
    <message>
      <source>By refined region</source>
      <translation>Nach verfeinerter Region</translation>
    </message>
    <message>
      <source>What the second step made of it</source>
      <translation>Was der zweite Schritt daraus machte</translation>
    </message>
  </context>
  <context>
    <name>GPS_Colour_4</name>
    <message>
      <source>By agreement with CAD</source>
      <translation>Nach Übereinstimmung mit CAD</translation>
    </message>
    <message>
      <source>Where the recognised class is that of the CAD surface</source>
      <translation>Wo die erkannte Klasse die der CAD-Fläche ist</translation>
    </message>
  </context>
  <context>
    <name>GPS_Colour_5</name>
    <message>
      <source>By constraint state</source>
      <translation>Nach Bestimmtheit</translation>
    </message>
    <message>
      <source>What the datum system fixes of each feature</source>
      <translation>Was das Bezugssystem an jedem Geometrieelement festlegt</translation>
    </message>
  </context>
  <context>
    <name>GPS_Colour_Facets</name>
    <message>
      <source>On the mesh</source>
      <translation>Auf dem Netz</translation>
    </message>
    <message>
      <source>Show the mesh with a colour a facet, or the part's faces again</source>
      <translation>Das Netz mit einer Farbe je Dreieck zeigen, oder wieder die Flächen des Teils</translation>
    </message>
  </context>
  <context>
    <name>GPS_Datums</name>
    <message>
      <source>Choose datum features, or take the suggested ones: what each letter locks</source>
      <translation>Bezugselemente wählen oder die vorgeschlagenen nehmen: was jeder Buchstabe festlegt</translation>
    </message>
    <message>
      <source>Datum system…</source>
      <translation>Bezugssystem…</translation>
    </message>
  </context>
  <context>
    <name>GPS_Export</name>
    <message>
      <source>Export…</source>
      <translation>Exportieren…</translation>
    </message>
    <message>
      <source>Write result, faces, GPS features, report or mesh as a file</source>
      <translation>Ergebnis, Flächen, GPS-Geometrieelemente, Bericht oder Netz als Datei schreiben</translation>
    </message>
  </context>
  <context>
    <name>GPS_Frames</name>
    <message>
      <source>Lay the frames out beside the part as this view shows it, none over another</source>
      <translation>Die Rahmen neben dem Teil anordnen, wie diese Ansicht es zeigt, keinen über einem anderen</translation>
    </message>
    <message>
      <source>Place frames</source>
      <translation>Rahmen anordnen</translation>
    </message>
  </context>
  <context>
    <name>GPS_Import</name>
    <message>
      <source>Bring a part into the document: STEP, BREP, mesh or points</source>
      <translation>Ein Teil ins Dokument holen: STEP, BREP, Netz oder Punkte</translation>
    </message>
    <message>
      <source>Import part</source>
      <translation>Teil importieren</translation>
    </message>
    <message>
      <source>Import part…</source>
      <translation>Teil importieren…</translation>
    </message>
    <message>
      <source>Parts</source>
      <translation>Teile</translation>
    </message>
  </context>
  <context>
    <name>GPS_Legend</name>
    <message>
      <source>Legend</source>
      <translation>Legende</translation>
    </message>
    <message>
      <source>What the colours mean, how many faces have each; a click selects them</source>
      <translation>Was die Farben bedeuten und wie viele Flächen jede hat; ein Klick wählt sie aus</translation>
    </message>
  </context>
  <context>
    <name>GPS_Partition</name>
    <message>
      <source>Mesh a part, divide the mesh into regions and recognise the invariance class of each</source>
      <translation>Ein Teil vernetzen, das Netz in Regionen teilen und die Invarianzklasse jeder Region erkennen</translation>
    </message>
    <message>
      <source>Partition…</source>
      <translation>Partitionieren…</translation>
    </message>
  </context>
  <context>
    <name>GPS_Query</name>
    <message>
      <source>Click a face: its class, situation feature, intrinsic values, agreement and ranking</source>
      <translation>Eine Fläche anklicken: Klasse, Situationselement, Eigenmaße, Übereinstimmung und Rangfolge</translation>
    </message>
    <message>
      <source>Query face</source>
      <translation>Fläche abfragen</translation>
    </message>
  </context>
  <context>
    <name>GPS_Report</name>
    <message>
      <source>Report</source>
      <translation>Bericht</translation>
    </message>
    <message>
      <source>Write the report (one page, no network) and open it in the browser</source>
      <translation>Den Bericht schreiben (eine Seite, ohne Netzwerk) und im Browser öffnen</translation>
    </message>
  </context>
  <context>
    <name>GPS_Sweep</name>
    <message>
      <source>Partition the part at several densities and compare the accuracy</source>
      <translation>Das Teil mit mehreren Dichten partitionieren und die Genauigkeit vergleichen</translation>
    </message>
    <message>
      <source>Sweep density…</source>
      <translation>Dichte variieren…</translation>
    </message>
  </context>
  <context>
    <name>GPS_Validate</name>
    <message>
      <source>Compare the recognised classes with those of the CAD surfaces</source>
      <translation>Die erkannten Klassen mit denen der CAD-Flächen vergleichen</translation>
    </message>
    <message>
      <source>Validate</source>
      <translation>Vergleichen</translation>
    </message>
  </context>
  <context>
    <name>GpsPreferences</name>
    <message>
      <source> s</source>
      <translation> s</translation>
    </message>
    <message>
      <source>A partition that took longer is marked as stale when its part changes, and waits for you to run it again</source>
      <translation>Eine Partition, die länger dauerte, wird als veraltet gekennzeichnet, wenn sich ihr Teil ändert, und wartet auf einen neuen Lauf</translation>
    </message>
    <message>
      <source>As FreeCAD's STL export</source>
      <translation>Wie FreeCADs STL-Export</translation>
    </message>
    <message>
      <source>Automatic: follows curvature</source>
      <translation>Automatisch: folgt der Krümmung</translation>
    </message>
    <message>
      <source>Coarse</source>
      <translation>Grob</translation>
    </message>
    <message>
      <source>Colours of the classes</source>
      <translation>Farben der Klassen</translation>
    </message>
    <message>
      <source>Corrected</source>
      <translation>Korrigiert</translation>
    </message>
    <message>
      <source>Density</source>
      <translation>Dichte</translation>
    </message>
    <message>
      <source>Fine</source>
      <translation>Fein</translation>
    </message>
    <message>
      <source>For colour-blind eyes</source>
      <translation>Für Farbfehlsichtige</translation>
    </message>
    <message>
      <source>General</source>
      <translation>Allgemein</translation>
    </message>
    <message>
      <source>How fine the mesh is, where the panel says nothing else</source>
      <translation>Wie fein das Netz ist, wenn im Fenster nichts anderes steht</translation>
    </message>
    <message>
      <source>Medium</source>
      <translation>Mittel</translation>
    </message>
    <message>
      <source>Mode</source>
      <translation>Modus</translation>
    </message>
    <message>
      <source>New features show their axis, centre or plane</source>
      <translation>Neue Geometrieelemente zeigen Achse, Mitte oder Ebene</translation>
    </message>
    <message>
      <source>New partitions</source>
      <translation>Neue Partitionen</translation>
    </message>
    <message>
      <source>Paper</source>
      <translation>Artikel</translation>
    </message>
    <message>
      <source>Recompute by itself up to</source>
      <translation>Selbsttätig neu berechnen bis</translation>
    </message>
    <message>
      <source>Robust</source>
      <translation>Robust</translation>
    </message>
    <message>
      <source>The paper's wheel</source>
      <translation>Das Rad des Artikels</translation>
    </message>
    <message>
      <source>View</source>
      <translation>Ansicht</translation>
    </message>
  </context>
</TS>
