<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" sourcelanguage="en" language="de">
  <context>
    <name>GPS</name>
    <message>
      <source>, for orientation only,</source>
      <translation>, nur zur Ausrichtung,</translation>
    </message>
    <message>
      <source>; the other {n} no datum of it can lock</source>
      <translation>; die übrigen ({n}) kann kein Bezug an ihm festlegen</translation>
    </message>
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
      <source>CZ holds the features of the group to one another, without a datum</source>
      <translation>CZ hält die Geometrieelemente der Gruppe zueinander, ohne Bezug</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translation>Abbrechen</translation>
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
      <source>Coaxial group</source>
      <translation>Koaxiale Gruppe</translation>
    </message>
    <message>
      <source>Concave radius</source>
      <translation>Innenrundung</translation>
    </message>
    <message>
      <source>Cone</source>
      <translation>Kegel</translation>
    </message>
    <message>
      <source>Convex radius</source>
      <translation>Außenrundung</translation>
    </message>
    <message>
      <source>Corrected: the paper's flow, errors mended</source>
      <translation>Korrigiert: Ablauf des Artikels, Fehler behoben</translation>
    </message>
    <message>
      <source>Counterbore</source>
      <translation>Zylindersenkung</translation>
    </message>
    <message>
      <source>Countersink</source>
      <translation>Kegelsenkung</translation>
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
      <source>Datum system {system}</source>
      <translation>Bezugssystem {system}</translation>
    </message>
    <message>
      <source>Datum {letter}</source>
      <translation>Bezug {letter}</translation>
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
      <source>Freeform</source>
      <translation>Freiform</translation>
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
      <source>Helicoid</source>
      <translation>Schraubenfläche</translation>
    </message>
    <message>
      <source>Hole</source>
      <translation>Bohrung</translation>
    </message>
    <message>
      <source>Hole pattern</source>
      <translation>Bohrungsmuster</translation>
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
      <source>N must be a whole number from {least} to {most}</source>
      <translation>N muss eine ganze Zahl von {least} bis {most} sein</translation>
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
      <source>Of the part {free}.</source>
      <translation>Am Teil: {free}.</translation>
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
      <source>PMI is appended to the text of {path}</source>
      <translation>PMI ist an den Text von {path} angehängt</translation>
    </message>
    <message>
      <source>PMI is not on the original STEP text but on the part as FreeCAD writes it: {why}</source>
      <translation>PMI steht nicht am ursprünglichen STEP-Text, sondern am Teil, wie FreeCAD es schreibt: {why}</translation>
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
      <source>Pin pattern</source>
      <translation>Zapfenmuster</translation>
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
      <source>Rib</source>
      <translation>Steg</translation>
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
      <source>STEP, faces named and coloured by class</source>
      <translation>STEP, Flächen nach Klasse benannt und gefärbt</translation>
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
      <source>Shaft</source>
      <translation>Welle</translation>
    </message>
    <message>
      <source>Situation feature</source>
      <translation>Situationselement</translation>
    </message>
    <message>
      <source>Slot</source>
      <translation>Nut</translation>
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
      <source>SØ{value:.6g}</source>
      <translation>SØ{value:.6g}</translation>
    </message>
    <message>
      <source>Thick frame: recommended; thin: allowed; none, grey: not allowed.</source>
      <translation>Dicker Rahmen: empfohlen; dünner: erlaubt; keiner, grau: nicht erlaubt.</translation>
    </message>
    <message>
      <source>Together they lock {n} of six: complete{rest}.</source>
      <translation>Zusammen festgelegt: {n} von sechs, also vollständig{rest}.</translation>
    </message>
    <message>
      <source>Together they lock {n} of the {needed} degrees of freedom that this part's datums can lock: not complete.</source>
      <translation>Zusammen festgelegt: {n} von {needed} Freiheitsgraden, die Bezüge an diesem Teil festlegen können, also nicht vollständig.</translation>
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
      <source>Unrecognised</source>
      <translation>Nicht erkannt</translation>
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
      <source>a class is given with the action 'class', and only with it</source>
      <translation>eine Klasse gehört zur Handlung 'class', und nur zu ihr</translation>
    </message>
    <message>
      <source>a datum of {system} isn't there</source>
      <translation>ein Bezug von {system} ist nicht da</translation>
    </message>
    <message>
      <source>a form tolerance takes no datum</source>
      <translation>eine Formtoleranz hat keinen Bezug</translation>
    </message>
    <message>
      <source>a freeform surface is located by a surface profile</source>
      <translation>eine Freiformfläche wird durch ein Flächenprofil verortet</translation>
    </message>
    <message>
      <source>a mesh has no CAD faces</source>
      <translation>ein Netz hat keine CAD-Flächen</translation>
    </message>
    <message>
      <source>a part of {n} points without extent has no GPS features</source>
      <translation>ein Teil aus {n} Punkten ohne Ausdehnung hat keine GPS-Geometrieelemente</translation>
    </message>
    <message>
      <source>a task panel is open: close it first</source>
      <translation>ein Aufgabenfenster ist offen: erst schließen</translation>
    </message>
    <message>
      <source>a tolerance class is for linear sizes</source>
      <translation>eine Toleranzklasse gilt für lineare Maße</translation>
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
      <source>an arc of at most half a turn has no median line</source>
      <translation>ein Bogen von höchstens einer halben Umdrehung hat keine mittlere Linie</translation>
    </message>
    <message>
      <source>an edge length of {size:.3g} mm would make about {expected:.2g} triangles; at most {most} are possible</source>
      <translation>eine Kantenlänge von {size:.3g} mm ergäbe etwa {expected:.2g} Dreiecke; höchstens {most} sind möglich</translation>
    </message>
    <message>
      <source>angle {value:.6g}°</source>
      <translation>Winkel {value:.6g}°</translation>
    </message>
    <message>
      <source>angularity</source>
      <translation>Neigung</translation>
    </message>
    <message>
      <source>any direction</source>
      <translation>jede Richtung</translation>
    </message>
    <message>
      <source>any direction perpendicular to {normal}</source>
      <translation>jede Richtung senkrecht zu {normal}</translation>
    </message>
    <message>
      <source>as measured</source>
      <translation>wie gemessen</translation>
    </message>
    <message>
      <source>between two coaxial cylinders</source>
      <translation>zwischen zwei koaxialen Zylindern</translation>
    </message>
    <message>
      <source>between two concentric circles about the datum axis, in each section</source>
      <translation>in jedem Schnitt zwischen zwei konzentrischen Kreisen um die Bezugsachse</translation>
    </message>
    <message>
      <source>between two concentric circles in each section</source>
      <translation>in jedem Schnitt zwischen zwei konzentrischen Kreisen</translation>
    </message>
    <message>
      <source>between two cylinders about the datum axis</source>
      <translation>zwischen zwei Zylindern um die Bezugsachse</translation>
    </message>
    <message>
      <source>between two equal circles on each cylinder about the datum axis</source>
      <translation>auf jedem Zylinder um die Bezugsachse zwischen zwei gleichen Kreisen</translation>
    </message>
    <message>
      <source>between two lines equidistant from the nominal line, in each section</source>
      <translation>in jedem Schnitt zwischen zwei Linien in gleichem Abstand von der Nennlinie</translation>
    </message>
    <message>
      <source>between two parallel planes</source>
      <translation>zwischen zwei parallelen Ebenen</translation>
    </message>
    <message>
      <source>between two parallel planes perpendicular to the datum axis</source>
      <translation>zwischen zwei parallelen Ebenen senkrecht zur Bezugsachse</translation>
    </message>
    <message>
      <source>between two parallel straight lines for each line element</source>
      <translation>je Linienelement zwischen zwei parallelen Geraden</translation>
    </message>
    <message>
      <source>between two surfaces equidistant from the nominal surface</source>
      <translation>zwischen zwei Flächen in gleichem Abstand von der Nennfläche</translation>
    </message>
    <message>
      <source>can't write {path}: it is a file, not a directory</source>
      <translation>{path} kann nicht geschrieben werden: es ist eine Datei, kein Verzeichnis</translation>
    </message>
    <message>
      <source>can't write {path}: {why}</source>
      <translation>{path} kann nicht geschrieben werden: {why}</translation>
    </message>
    <message>
      <source>circle about the datum's centre, in each section</source>
      <translation>in jedem Schnitt ein Kreis um den Mittelpunkt des Bezugs</translation>
    </message>
    <message>
      <source>circular run-out</source>
      <translation>Rundlauf</translation>
    </message>
    <message>
      <source>class</source>
      <translation>Klasse</translation>
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
      <source>datum {letter} is given twice</source>
      <translation>Bezug {letter} ist zweimal angegeben</translation>
    </message>
    <message>
      <source>datum {letter}: {why}</source>
      <translation>Bezug {letter}: {why}</translation>
    </message>
    <message>
      <source>datum {name} in {text!r} isn't assigned to a feature</source>
      <translation>Bezug {name} in {text!r} gehört zu keinem Geometrieelement</translation>
    </message>
    <message>
      <source>datum {name} stands twice in {text!r}</source>
      <translation>Bezug {name} steht zweimal in {text!r}</translation>
    </message>
    <message>
      <source>density {text!r} isn't valid ({why}): use one of {forms}</source>
      <translation>Dichte {text!r} ist ungültig ({why}): eine von {forms} angeben</translation>
    </message>
    <message>
      <source>density {text!r} isn't valid: use one of {forms}</source>
      <translation>Dichte {text!r} ist ungültig: eine von {forms} angeben</translation>
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
      <source>five</source>
      <translation>fünf</translation>
    </message>
    <message>
      <source>flatness</source>
      <translation>Ebenheit</translation>
    </message>
    <message>
      <source>form of each of its features by itself, without a datum</source>
      <translation>Form jedes seiner Geometrieelemente für sich, ohne Bezug</translation>
    </message>
    <message>
      <source>form of the feature itself, without a datum</source>
      <translation>Form des Geometrieelements selbst, ohne Bezug</translation>
    </message>
    <message>
      <source>four</source>
      <translation>vier</translation>
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
      <source>is redundant: it locks nothing that isn't locked already</source>
      <translation>ist überflüssig: er legt nichts fest, was nicht schon festliegt</translation>
    </message>
    <message>
      <source>it doesn't turn about an axis</source>
      <translation>es dreht sich um keine Achse</translation>
    </message>
    <message>
      <source>it doesn't turn about an axis of these datums</source>
      <translation>es dreht sich um keine Achse dieser Bezüge</translation>
    </message>
    <message>
      <source>it has no axis</source>
      <translation>es hat keine Achse</translation>
    </message>
    <message>
      <source>it has no centre point</source>
      <translation>es hat keinen Mittelpunkt</translation>
    </message>
    <message>
      <source>it has no direction to orient</source>
      <translation>es hat keine Richtung</translation>
    </message>
    <message>
      <source>it has no face</source>
      <translation>es hat keine Fläche</translation>
    </message>
    <message>
      <source>it has no median plane or line</source>
      <translation>es hat keine mittlere Ebene oder Linie</translation>
    </message>
    <message>
      <source>it has no straight line elements</source>
      <translation>es hat keine geraden Linienelemente</translation>
    </message>
    <message>
      <source>it is no feature of size</source>
      <translation>es ist kein Maßelement</translation>
    </message>
    <message>
      <source>it isn't a cylinder</source>
      <translation>es ist kein Zylinder</translation>
    </message>
    <message>
      <source>it isn't flat</source>
      <translation>es ist nicht eben</translation>
    </message>
    <message>
      <source>it needs a datum, and none stands before this feature</source>
      <translation>es braucht einen Bezug, und vor diesem Geometrieelement steht keiner</translation>
    </message>
    <message>
      <source>it needs a value above 0, or none</source>
      <translation>es braucht einen Wert über 0, oder keinen</translation>
    </message>
    <message>
      <source>it needs a value of at least 0, or none</source>
      <translation>es braucht einen Wert von mindestens 0, oder keinen</translation>
    </message>
    <message>
      <source>it needs both deviations, or none</source>
      <translation>es braucht beide Abmaße, oder keines</translation>
    </message>
    <message>
      <source>it serves any angle to the datums</source>
      <translation>sie gilt für jeden Winkel zu den Bezügen</translation>
    </message>
    <message>
      <source>it turns about the datum axis</source>
      <translation>es dreht sich um die Bezugsachse</translation>
    </message>
    <message>
      <source>its axis isn't a datum axis: use position</source>
      <translation>seine Achse ist keine Bezugsachse: Position verwenden</translation>
    </message>
    <message>
      <source>its centre isn't on a datum axis or point: use position</source>
      <translation>sein Mittelpunkt liegt auf keiner Bezugsachse und keinem Bezugspunkt: Position verwenden</translation>
    </message>
    <message>
      <source>its median feature isn't that of a datum: use position</source>
      <translation>sein mittleres Geometrieelement ist nicht das eines Bezugs: Position verwenden</translation>
    </message>
    <message>
      <source>its numbers must be positive</source>
      <translation>ihre Zahlen müssen positiv sein</translation>
    </message>
    <message>
      <source>its sections aren't circles</source>
      <translation>seine Schnitte sind keine Kreise</translation>
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
      <source>locks {what}</source>
      <translation>legt {what} fest</translation>
    </message>
    <message>
      <source>locks {what} and {also}</source>
      <translation>legt {what} und {also} fest</translation>
    </message>
    <message>
      <source>lower</source>
      <translation>unteres Abmaß</translation>
    </message>
    <message>
      <source>merge</source>
      <translation>vereinen</translation>
    </message>
    <message>
      <source>merging takes at least two faces</source>
      <translation>zum Vereinen braucht es mindestens zwei Flächen</translation>
    </message>
    <message>
      <source>needs more than {limit} MB of memory</source>
      <translation>braucht mehr als {limit} MB Speicher</translation>
    </message>
    <message>
      <source>no</source>
      <translation>keiner</translation>
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
      <source>no face is chosen</source>
      <translation>keine Fläche ist gewählt</translation>
    </message>
    <message>
      <source>no face {name!r}</source>
      <translation>keine Fläche {name!r}</translation>
    </message>
    <message>
      <source>no result within {seconds:g} s</source>
      <translation>kein Ergebnis binnen {seconds:g} s</translation>
    </message>
    <message>
      <source>no surface can be laid through {n} points</source>
      <translation>durch {n} Punkte lässt sich keine Fläche legen</translation>
    </message>
    <message>
      <source>none</source>
      <translation>keine</translation>
    </message>
    <message>
      <source>none of its datums is there</source>
      <translation>keiner seiner Bezüge ist da</translation>
    </message>
    <message>
      <source>none of {n} triangles has an area</source>
      <translation>keines von {n} Dreiecken hat eine Fläche</translation>
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
      <source>not recognised: no region of the mesh lies on it</source>
      <translation>nicht erkannt: keine Region des Netzes liegt darauf</translation>
    </message>
    <message>
      <source>one</source>
      <translation>einer</translation>
    </message>
    <message>
      <source>one rotation</source>
      <translation>eine Drehung</translation>
    </message>
    <message>
      <source>one translation</source>
      <translation>eine Verschiebung</translation>
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
      <source>part or settings have changed: run it again</source>
      <translation>Teil oder Einstellungen haben sich geändert: erneut ausführen</translation>
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
      <source>region {region} is {kind} but has no {lacking}</source>
      <translation>Region {region} ist {kind}, hat aber kein {lacking}</translation>
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
      <source>rotation about {about} stays free</source>
      <translation>frei bleibt: Drehung um {about}</translation>
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
      <source>six</source>
      <translation>sechs</translation>
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
      <source>specification of {feature!r}: that is {names}; name one feature</source>
      <translation>Spezifikation von {feature!r}: das sind {names}; ein Geometrieelement nennen</translation>
    </message>
    <message>
      <source>specification {characteristic}: {why}</source>
      <translation>Spezifikation {characteristic}: {why}</translation>
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
      <source>split</source>
      <translation>teilen</translation>
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
      <source>that is the nominal angle to a datum</source>
      <translation>das ist der Nennwinkel zu einem Bezug</translation>
    </message>
    <message>
      <source>the CAD class is disputed</source>
      <translation>die CAD-Klasse ist strittig</translation>
    </message>
    <message>
      <source>the CAD kernel crashed ({signal})</source>
      <translation>der CAD-Kern ist abgestürzt ({signal})</translation>
    </message>
    <message>
      <source>the angle must be below 180 degrees</source>
      <translation>der Winkel muss kleiner als 180 Grad sein</translation>
    </message>
    <message>
      <source>the annotation is damaged ({error})</source>
      <translation>die Annotation ist beschädigt ({error})</translation>
    </message>
    <message>
      <source>the annotation is of schema {found!r}, not {known!r}</source>
      <translation>die Annotation hat das Schema {found!r}, nicht {known!r}</translation>
    </message>
    <message>
      <source>the datums have no direction</source>
      <translation>die Bezüge haben keine Richtung</translation>
    </message>
    <message>
      <source>the datums locate it fully</source>
      <translation>die Bezüge bestimmen es vollständig</translation>
    </message>
    <message>
      <source>the isolated process failed: {why}</source>
      <translation>der eigene Prozess ist gescheitert: {why}</translation>
    </message>
    <message>
      <source>the lower deviation is above the upper one</source>
      <translation>das untere Abmaß liegt über dem oberen</translation>
    </message>
    <message>
      <source>the nominal angle to the first datum is {angle:.4g}°: use {characteristic}</source>
      <translation>der Nennwinkel zum ersten Bezug ist {angle:.4g}°: {characteristic} verwenden</translation>
    </message>
    <message>
      <source>the panel is closed: what it worked on is gone</source>
      <translation>das Fenster ist geschlossen: woran es arbeitete, ist gelöscht</translation>
    </message>
    <message>
      <source>the part has changed since it was imported from {path}</source>
      <translation>das Teil hat sich geändert, seit es aus {path} importiert wurde</translation>
    </message>
    <message>
      <source>the part wasn't imported from a STEP file by GPS</source>
      <translation>das Teil wurde nicht von GPS aus einer STEP-Datei importiert</translation>
    </message>
    <message>
      <source>the result of {part} is damaged ({error})</source>
      <translation>das Ergebnis von {part} ist beschädigt ({error})</translation>
    </message>
    <message>
      <source>the stored overrides are damaged ({error})</source>
      <translation>die gespeicherten Änderungen sind beschädigt ({error})</translation>
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
      <source>there is no such suggestion</source>
      <translation>einen solchen Vorschlag gibt es nicht</translation>
    </message>
    <message>
      <source>three</source>
      <translation>drei</translation>
    </message>
    <message>
      <source>three rotations</source>
      <translation>drei Drehungen</translation>
    </message>
    <message>
      <source>three translations</source>
      <translation>drei Verschiebungen</translation>
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
      <source>total run-out is defined for cylinders and planes</source>
      <translation>Gesamtlauf ist für Zylinder und Ebenen erklärt</translation>
    </message>
    <message>
      <source>translation along {along} and rotation about {about} stays free</source>
      <translation>frei bleiben: Verschiebung entlang {along} und Drehung um {about}</translation>
    </message>
    <message>
      <source>translation along {along} stays free</source>
      <translation>frei bleibt: Verschiebung entlang {along}</translation>
    </message>
    <message>
      <source>trough</source>
      <translation>Mulde</translation>
    </message>
    <message>
      <source>two</source>
      <translation>zwei</translation>
    </message>
    <message>
      <source>two rotations</source>
      <translation>zwei Drehungen</translation>
    </message>
    <message>
      <source>two translations</source>
      <translation>zwei Verschiebungen</translation>
    </message>
    <message>
      <source>upper</source>
      <translation>oberes Abmaß</translation>
    </message>
    <message>
      <source>value</source>
      <translation>Wert</translation>
    </message>
    <message>
      <source>width {value:.6g}</source>
      <translation>Breite {value:.6g}</translation>
    </message>
    <message>
      <source>without a datum it bounds the form</source>
      <translation>ohne Bezug begrenzt es die Form</translation>
    </message>
    <message>
      <source>{characteristic} of {feature!r}: {why}</source>
      <translation>{characteristic} von {feature!r}: {why}</translation>
    </message>
    <message>
      <source>{different} different points among {n}: a surface needs at least {least}</source>
      <translation>{different} verschiedene Punkte unter {n}: eine Fläche braucht mindestens {least}</translation>
    </message>
    <message>
      <source>{face} has changed</source>
      <translation>{face} hat sich geändert</translation>
    </message>
    <message>
      <source>{face} is gone</source>
      <translation>{face} ist nicht mehr da</translation>
    </message>
    <message>
      <source>{face} is now {other}</source>
      <translation>{face} ist jetzt {other}</translation>
    </message>
    <message>
      <source>{feature} holds a {surface}: {why}</source>
      <translation>{feature} enthält {surface}: {why}</translation>
    </message>
    <message>
      <source>{feature} is no feature of size</source>
      <translation>{feature} ist kein Maßelement</translation>
    </message>
    <message>
      <source>{feature} is {why}</source>
      <translation>{feature} ist {why}</translation>
    </message>
    <message>
      <source>{fit} is a class of holes and slots, {feature} is external</source>
      <translation>{fit} ist eine Klasse für Bohrungen und Nuten, {feature} ist außen</translation>
    </message>
    <message>
      <source>{fit} is a class of shafts and ribs, {feature} is internal</source>
      <translation>{fit} ist eine Klasse für Wellen und Stege, {feature} ist innen</translation>
    </message>
    <message>
      <source>{lines}, or a cylinder Ø for the median line</source>
      <translation>{lines}, oder ein Zylinder Ø für die mittlere Linie</translation>
    </message>
    <message>
      <source>{modifier} doesn't go with it (ISO 2692)</source>
      <translation>{modifier} passt nicht dazu (ISO 2692)</translation>
    </message>
    <message>
      <source>{name}: the name must end in one of {suffixes}</source>
      <translation>{name}: der Name muss auf eines von {suffixes} enden</translation>
    </message>
    <message>
      <source>{name}: {kind}: {part} is a mesh without CAD faces</source>
      <translation>{name}: {kind}: {part} ist ein Netz ohne CAD-Flächen</translation>
    </message>
    <message>
      <source>{n} points are more than {most}: thin the cloud first</source>
      <translation>{n} Punkte sind mehr als {most}: die Wolke erst ausdünnen</translation>
    </message>
    <message>
      <source>{n} points span no surface: they lie on a line</source>
      <translation>{n} Punkte spannen keine Fläche auf: sie liegen auf einer Geraden</translation>
    </message>
    <message>
      <source>{one} with {other}</source>
      <translation>{one} mit {other}</translation>
    </message>
    <message>
      <source>{part!r} in {text!r} is no datum; write A|B-C|D&gt;&lt;</source>
      <translation>{part!r} in {text!r} ist kein Bezug; A|B-C|D&gt;&lt; schreiben</translation>
    </message>
    <message>
      <source>{part} has no faces to partition</source>
      <translation>{part} hat keine Flächen zum Partitionieren</translation>
    </message>
    <message>
      <source>{part} has no result yet</source>
      <translation>{part} hat noch kein Ergebnis</translation>
    </message>
    <message>
      <source>{part} is empty</source>
      <translation>{part} ist leer</translation>
    </message>
    <message>
      <source>{path} has changed since the part was imported</source>
      <translation>{path} hat sich geändert, seit das Teil importiert wurde</translation>
    </message>
    <message>
      <source>{path}: FreeCAD can't read the file ({reason})</source>
      <translation>{path}: FreeCAD kann die Datei nicht lesen ({reason})</translation>
    </message>
    <message>
      <source>{path}: can't be read ({reason})</source>
      <translation>{path}: nicht lesbar ({reason})</translation>
    </message>
    <message>
      <source>{path}: is a directory, not a file</source>
      <translation>{path}: ist ein Verzeichnis, keine Datei</translation>
    </message>
    <message>
      <source>{path}: its text holds no B-rep face to colour</source>
      <translation>{path}: sein Text enthält keine B-Rep-Fläche zum Färben</translation>
    </message>
    <message>
      <source>{path}: no face of the shape can be tessellated</source>
      <translation>{path}: keine Fläche der Form lässt sich vernetzen</translation>
    </message>
    <message>
      <source>{path}: no such file</source>
      <translation>{path}: keine solche Datei</translation>
    </message>
    <message>
      <source>{path}: not a STEP file (ISO-10303-21 is missing)</source>
      <translation>{path}: keine STEP-Datei (ISO-10303-21 fehlt)</translation>
    </message>
    <message>
      <source>{path}: not an FCStd document (no zip archive)</source>
      <translation>{path}: kein FCStd-Dokument (kein Zip-Archiv)</translation>
    </message>
    <message>
      <source>{path}: not an OCCT BREP file</source>
      <translation>{path}: keine BREP-Datei von OCCT</translation>
    </message>
    <message>
      <source>{path}: the STEP file is truncated (END-ISO-10303-21 is missing)</source>
      <translation>{path}: die STEP-Datei ist abgeschnitten (END-ISO-10303-21 fehlt)</translation>
    </message>
    <message>
      <source>{path}: the file holds no faces</source>
      <translation>{path}: die Datei enthält keine Flächen</translation>
    </message>
    <message>
      <source>{path}: the file holds nothing to partition</source>
      <translation>{path}: die Datei enthält nichts zum Partitionieren</translation>
    </message>
    <message>
      <source>{path}: the file is empty</source>
      <translation>{path}: die Datei ist leer</translation>
    </message>
    <message>
      <source>{path}: unknown format {suffix!r}; expected {known}</source>
      <translation>{path}: unbekanntes Format {suffix!r}; erwartet: {known}</translation>
    </message>
    <message>
      <source>{said}; did you mean {word!r}?</source>
      <translation>{said}; gemeint war {word!r}?</translation>
    </message>
    <message>
      <source>{text!r} is no datum letter; A to ZZZ are</source>
      <translation>{text!r} ist kein Bezugsbuchstabe; A bis ZZZ sind es</translation>
    </message>
    <message>
      <source>{text!r} is no datum; write A=Face1,B=Face5+Face6</source>
      <translation>{text!r} ist kein Bezug; A=Face1,B=Face5+Face6 schreiben</translation>
    </message>
    <message>
      <source>{what} of {feature}</source>
      <translation>{what} von {feature}</translation>
    </message>
    <message>
      <source>{where}: feature and characteristic are needed</source>
      <translation>{where}: Geometrieelement und Eigenschaft fehlen</translation>
    </message>
    <message>
      <source>{where}: modifier {word!r} is none of M, L, R</source>
      <translation>{where}: Modifikator {word!r} ist keiner von M, L, R</translation>
    </message>
    <message>
      <source>{where}: {key} is neither text nor a number</source>
      <translation>{where}: {key} ist weder Text noch Zahl</translation>
    </message>
    <message>
      <source>{where}: {key} {text!r} is not a number</source>
      <translation>{where}: {key} {text!r} ist keine Zahl</translation>
    </message>
    <message>
      <source>{where}: {word!r} is no tolerance class as H7 or g6</source>
      <translation>{where}: {word!r} ist keine Toleranzklasse wie H7 oder g6</translation>
    </message>
    <message>
      <source>{where}: {word!r} is none of {known}</source>
      <translation>{where}: {word!r} ist keines von {known}</translation>
    </message>
    <message>
      <source>{word!r} in {text!r}</source>
      <translation>{word!r} in {text!r}</translation>
    </message>
    <message>
      <source>{word!r} is no characteristic of ISO 1101, nor 'size'</source>
      <translation>{word!r} ist keine Eigenschaft der ISO 1101 und nicht 'size'</translation>
    </message>
    <message>
      <source>{wrong} is neither a feature nor a face of one</source>
      <translation>{wrong} ist weder ein Geometrieelement noch eine Fläche davon</translation>
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
      <source>{} regions; colours only tell neighbours apart.</source>
      <translation>{} Regionen; die Farben unterscheiden nur Nachbarn.</translation>
    </message>
    <message>
      <source>{} triangles</source>
      <translation>{} Dreiecke</translation>
    </message>
    <message>
      <source>Ø{value:.6g}</source>
      <translation>Ø{value:.6g}</translation>
    </message>
    <message>
      <source>Ⓜ and Ⓛ exclude each other (ISO 2692)</source>
      <translation>Ⓜ und Ⓛ schließen einander aus (ISO 2692)</translation>
    </message>
    <message>
      <source>Ⓡ stands after Ⓜ or Ⓛ only (ISO 2692)</source>
      <translation>Ⓡ steht nur nach Ⓜ oder Ⓛ (ISO 2692)</translation>
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
