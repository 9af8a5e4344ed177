<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>0 makes sheets, 1 makes rods of the texture; -1: fitted to the sample, or 0.3 without one</source>
        <translation>0 ergibt Lamellen, 1 Stäbe der Textur; -1: an die Probe angepasst, ohne Probe 0,3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>A contour that fills so much of its box is a rod, else a plate</source>
        <translation>Eine Kontur, die so viel ihres Rechtecks füllt, ist ein Stab, sonst eine Platte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Axes along which the number of trabeculae per layer is a target too</source>
        <translation>Achsen, entlang denen auch die Zahl der Trabekel je Schicht ein Zielwert ist</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Axes of the planes: x, y, z, or a direction such as 0.6,0.8,0</source>
        <translation>Achsen der Ebenen: x, y, z oder eine Richtung wie 0.6,0.8,0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <location filename="../../freecad_trabecula/features/envelope.py"/>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <location filename="../../freecad_trabecula/features/on_demand.py"/>
        <location filename="../../freecad_trabecula/features/prism_sites.py"/>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Blocks keep volume and areas exactly; smooth keeps the volume</source>
        <translation>Blöcke halten Volumen und Flächen genau ein; glatt hält das Volumen ein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>Body and face of the mark</source>
        <translation>Körper und Fläche der Marke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Body within which voxels may lie; none: the sample's box</source>
        <translation>Körper, in dem Voxel liegen dürfen; keiner: der Quader der Probe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Cell of the field engine</source>
        <translation>Zelle des Feldverfahrens</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Changes of single sites by hand, a JSON record a line: {"site": "Face1.2.3", "action": "off"}</source>
        <translation>Änderungen einzelner Stellen von Hand, je Zeile ein JSON-Datensatz: {"site": "Face1.2.3", "action": "off"}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Closed contours of a shorter perimeter are left out</source>
        <translation>Geschlossene Konturen mit kleinerem Umfang werden weggelassen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Co-ordinates of planes, mm; with at = heights</source>
        <translation>Koordinaten der Ebenen in mm; mit at = heights</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Co-ordinates of the planes along the axis, ascending</source>
        <translation>Koordinaten der Ebenen entlang der Achse, aufsteigend</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Compact layers</source>
        <translation>Kompakte Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Compatible tables by construction, or by the thesis' try-and-repeat</source>
        <translation>Verträgliche Tabellen durch Konstruktion oder durch Versuch und Wiederholung wie in der Dissertation</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Component of the unit tangent at each corner</source>
        <translation>Komponente der Einheitstangente an jeder Ecke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Component of the unit tangent at each corner: direction in which a linear law grows</source>
        <translation>Komponente der Einheitstangente an jeder Ecke: Richtung, in der ein lineares Gesetz wächst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Component of the unit tangent at each corner: formula of x, y, z (mm) and a random u in 0..1</source>
        <translation>Komponente der Einheitstangente an jeder Ecke: Formel mit x, y, z (mm) und einer Zufallszahl u in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Component of the unit tangent at each corner: how it varies over the design</source>
        <translation>Komponente der Einheitstangente an jeder Ecke: wie es sich über den Entwurf ändert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Component of the unit tangent at each corner: the constant value, or the least; linear, radial: at the start</source>
        <translation>Komponente der Einheitstangente an jeder Ecke: der feste Wert oder der kleinste; linear, radial: am Anfang</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Component of the unit tangent at each corner: the greatest value; linear, radial: at the end</source>
        <translation>Komponente der Einheitstangente an jeder Ecke: der größte Wert; linear, radial: am Ende</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Connected parts (6 neighbours)</source>
        <translation>Zusammenhängende Teile (6 Nachbarn)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Connected pieces of the channels</source>
        <translation>Zusammenhängende Teile der Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Connected pieces of the scaffold</source>
        <translation>Zusammenhängende Gerüstteile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Contacts by a corner alone</source>
        <translation>Kontakte nur über eine Ecke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Contacts by an edge alone</source>
        <translation>Kontakte nur über eine Kante</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Contacts that are avoided: none by an edge alone, or none by an edge or a corner alone; any: all are allowed</source>
        <translation>Kontakte, die vermieden werden: keine nur über eine Kante, oder keine nur über Kante oder Ecke; alle erlaubt: jeder Kontakt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Contours are offset by this into the material (tool compensation)</source>
        <translation>Konturen werden um diesen Betrag ins Material versetzt (Werkzeugkorrektur)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Contours of all slices that are counted</source>
        <translation>Gezählte Konturen aller Schnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Contours of no more area are not counted</source>
        <translation>Konturen mit nicht mehr Fläche werden nicht gezählt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Convergence points; none means the centre of the envelope</source>
        <translation>Konvergenzpunkte; keiner bedeutet die Mitte des Hüllkörpers</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Corners of the spline; with 4 they lie on the square, else on a polygon of its area</source>
        <translation>Ecken des Splines; bei 4 liegen sie auf dem Quadrat, sonst auf einem Vieleck seiner Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>Count of faces; points on the face and normals there</source>
        <translation>Anzahl der Flächen; Punkte auf der Fläche und Normalen dort</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Couplings</source>
        <translation>Kopplungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Cross-sections of a rod: one all along, or one at each end</source>
        <translation>Querschnitte eines Stabs: einer auf ganzer Länge oder einer an jedem Ende</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Diameter of the circle, or side of the square through the corners</source>
        <translation>Durchmesser des Kreises oder Seite des Quadrats durch die Ecken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Diameter of the circle, or side of the square through the corners: direction in which a linear law grows</source>
        <translation>Durchmesser des Kreises oder Seite des Quadrats durch die Ecken: Richtung, in der ein lineares Gesetz wächst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Diameter of the circle, or side of the square through the corners: formula of x, y, z (mm) and a random u in 0..1</source>
        <translation>Durchmesser des Kreises oder Seite des Quadrats durch die Ecken: Formel mit x, y, z (mm) und einer Zufallszahl u in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Diameter of the circle, or side of the square through the corners: how it varies over the design</source>
        <translation>Durchmesser des Kreises oder Seite des Quadrats durch die Ecken: wie es sich über den Entwurf ändert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Diameter of the circle, or side of the square through the corners: the constant value, or the least; linear, radial: at the start</source>
        <translation>Durchmesser des Kreises oder Seite des Quadrats durch die Ecken: der feste Wert oder der kleinste; linear, radial: am Anfang</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Diameter of the circle, or side of the square through the corners: the greatest value; linear, radial: at the end</source>
        <translation>Durchmesser des Kreises oder Seite des Quadrats durch die Ecken: der größte Wert; linear, radial: am Ende</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Difference between both volumes, %</source>
        <translation>Unterschied beider Volumen, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Direction of the co-ordinate line u; none means the face's own</source>
        <translation>Richtung der Koordinatenlinie u; keine bedeutet die der Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Direction of the co-ordinate line u; none means the face's own (the zero vector) (d1)</source>
        <translation>Richtung der Koordinatenlinie u; keine bedeutet die der Fläche (der Nullvektor) (d1)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Direction of the co-ordinate line v; none means across d1</source>
        <translation>Richtung der Koordinatenlinie v; keine bedeutet quer zu d1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Direction of the co-ordinate line v; none means across d1 (the zero vector) (d2)</source>
        <translation>Richtung der Koordinatenlinie v; keine bedeutet quer zu d1 (der Nullvektor) (d2)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Distance of triangles from a solid; 0: chosen</source>
        <translation>Abstand der Dreiecke von einem Volumenkörper; 0: wird gewählt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Drawn curve along X: place over the edge, share of the layer; none: the sample's</source>
        <translation>Gezeichnete Kurve entlang X: Ort durch Kante, Anteil der Schicht; keine: die der Probe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Drawn curve along Y</source>
        <translation>Gezeichnete Kurve entlang Y</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Drawn curve along Z</source>
        <translation>Gezeichnete Kurve entlang Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Edges dx, dy, dz of a voxel; one number makes a cube</source>
        <translation>Kanten dx, dy, dz eines Voxels; eine Zahl ergibt einen Würfel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Edges of the box for the random middle point (Eq. 3.1)</source>
        <translation>Kanten des Quaders für den zufälligen Mittelpunkt (Gl. 3.1)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Edges of the box of drawn curves, mm</source>
        <translation>Kanten des Quaders gezeichneter Kurven, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Engine that cut the channels</source>
        <translation>Verfahren, mit dem die Kanäle geschnitten wurden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Face at which the rods start</source>
        <translation>Fläche, an der die Stäbe beginnen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Face at which they end</source>
        <translation>Fläche, an der sie enden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>Face of the envelope</source>
        <translation>Fläche des Hüllkörpers</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Face of the envelope, as FreeCAD names it</source>
        <translation>Fläche des Hüllkörpers, wie FreeCAD sie nennt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Faces to be thickened; none means no layer</source>
        <translation>Flächen, die verdickt werden; keine bedeutet: keine Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Field of the strategies by-field and best-tables: voxels lie where it is high</source>
        <translation>Feld der Strategien nach Feld und beste zu Tabellen: Voxel liegen, wo es hoch ist</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Gap fill: largest gap of an open contour that is closed</source>
        <translation>Lücken schließen: größte Lücke einer offenen Kontur, die geschlossen wird</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Gap fill: rounds of closing</source>
        <translation>Lücken schließen: Anzahl der Durchgänge</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Given table alpha, lines (x, z); none: drawn</source>
        <translation>Gegebene Tabelle alpha, Linien (x, z); keine: gezogen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Given table beta, lines (y, z); none: drawn</source>
        <translation>Gegebene Tabelle beta, Linien (y, z); keine: gezogen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Greatest distance of the triangles from the true rod; 0 chooses 1/40 of the mean size</source>
        <translation>Größter Abstand der Dreiecke vom wahren Stab; 0 wählt 1/40 der mittleren Größe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Greatest number of rods; 0 means as many as the smaller face has sites</source>
        <translation>Größte Zahl von Stäben; 0 bedeutet so viele, wie die kleinere Fläche Stellen hat</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Hash of the numbers of each rod</source>
        <translation>Prüfsumme der Zahlen jedes Stabs</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Height along Z</source>
        <translation>Höhe entlang Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>How a row of a table is drawn: in proportion to what the columns still need, or uniformly as in the thesis</source>
        <translation>Wie eine Tabellenzeile gezogen wird: anteilig zu dem, was die Spalten noch brauchen, oder gleichverteilt wie in der Dissertation</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>How rounded counts are brought to one total: largest remainders, or the thesis' random layers</source>
        <translation>Wie gerundete Anzahlen auf eine Summe gebracht werden: größte Reste oder die zufälligen Schichten der Dissertation</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>How the layers are filled</source>
        <translation>Wie die Schichten gefüllt werden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Keep pieces that channels cut off all round, and closed voids as they are</source>
        <translation>Teile, die Kanäle ringsum abtrennen, und geschlossene Hohlräume behalten, wie sie sind</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/on_demand.py"/>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Key of the inputs of the result</source>
        <translation>Schlüssel der Eingaben des Ergebnisses</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Largest difference of one rod, %</source>
        <translation>Größter Unterschied eines Stabs, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Layers</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Layers along X (N)</source>
        <translation>Schichten entlang X (N)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Layers along Y (M)</source>
        <translation>Schichten entlang Y (M)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Layers along Z (P)</source>
        <translation>Schichten entlang Z (P)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance from the border along u</source>
        <translation>Mindestabstand vom Rand entlang u</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance from the border along u (b_u)</source>
        <translation>Mindestabstand vom Rand entlang u (b_u)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance from the border along v</source>
        <translation>Mindestabstand vom Rand entlang v</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance from the border along v (b_v)</source>
        <translation>Mindestabstand vom Rand entlang v (b_v)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance of the sites from the borders along X</source>
        <translation>Mindestabstand der Stellen von den Rändern entlang X</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance of the sites from the borders along X (a_x)</source>
        <translation>Mindestabstand der Stellen von den Rändern entlang X (a_x)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance of the sites from the borders along Y</source>
        <translation>Mindestabstand der Stellen von den Rändern entlang Y</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance of the sites from the borders along Y (a_y)</source>
        <translation>Mindestabstand der Stellen von den Rändern entlang Y (a_y)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance of the sites from the borders along Z</source>
        <translation>Mindestabstand der Stellen von den Rändern entlang Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance of the sites from the borders along Z (a_z)</source>
        <translation>Mindestabstand der Stellen von den Rändern entlang Z (a_z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Least thickness in voxels</source>
        <translation>Mindestdicke in Voxeln</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Least void between solid in voxels</source>
        <translation>Mindesthohlraum zwischen Material, in Voxeln</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length along X</source>
        <translation>Länge entlang X</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the first end of a 2-point curve</source>
        <translation>Länge der Tangente am ersten Ende einer 2-Punkt-Kurve</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the first end of a 2-point curve: direction in which a linear law grows</source>
        <translation>Länge der Tangente am ersten Ende einer 2-Punkt-Kurve: Richtung, in der ein lineares Gesetz wächst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the first end of a 2-point curve: formula of x, y, z (mm) and a random u in 0..1</source>
        <translation>Länge der Tangente am ersten Ende einer 2-Punkt-Kurve: Formel mit x, y, z (mm) und einer Zufallszahl u in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the first end of a 2-point curve: how it varies over the design</source>
        <translation>Länge der Tangente am ersten Ende einer 2-Punkt-Kurve: wie es sich über den Entwurf ändert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the first end of a 2-point curve: the constant value, or the least; linear, radial: at the start</source>
        <translation>Länge der Tangente am ersten Ende einer 2-Punkt-Kurve: der feste Wert oder der kleinste; linear, radial: am Anfang</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the first end of a 2-point curve: the greatest value; linear, radial: at the end</source>
        <translation>Länge der Tangente am ersten Ende einer 2-Punkt-Kurve: der größte Wert; linear, radial: am Ende</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the second end of a 2-point curve</source>
        <translation>Länge der Tangente am zweiten Ende einer 2-Punkt-Kurve</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the second end of a 2-point curve: direction in which a linear law grows</source>
        <translation>Länge der Tangente am zweiten Ende einer 2-Punkt-Kurve: Richtung, in der ein lineares Gesetz wächst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the second end of a 2-point curve: formula of x, y, z (mm) and a random u in 0..1</source>
        <translation>Länge der Tangente am zweiten Ende einer 2-Punkt-Kurve: Formel mit x, y, z (mm) und einer Zufallszahl u in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the second end of a 2-point curve: how it varies over the design</source>
        <translation>Länge der Tangente am zweiten Ende einer 2-Punkt-Kurve: wie es sich über den Entwurf ändert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the second end of a 2-point curve: the constant value, or the least; linear, radial: at the start</source>
        <translation>Länge der Tangente am zweiten Ende einer 2-Punkt-Kurve: der feste Wert oder der kleinste; linear, radial: am Anfang</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the second end of a 2-point curve: the greatest value; linear, radial: at the end</source>
        <translation>Länge der Tangente am zweiten Ende einer 2-Punkt-Kurve: der größte Wert; linear, radial: am Ende</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangents in sides of the square; 1 is the thesis' unit tangent</source>
        <translation>Länge der Tangenten in Quadratseiten; 1 ist die Einheitstangente der Dissertation</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangents in sides of the square; 1 is the thesis' unit tangent: direction in which a linear law grows</source>
        <translation>Länge der Tangenten in Quadratseiten; 1 ist die Einheitstangente der Dissertation: Richtung, in der ein lineares Gesetz wächst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangents in sides of the square; 1 is the thesis' unit tangent: formula of x, y, z (mm) and a random u in 0..1</source>
        <translation>Länge der Tangenten in Quadratseiten; 1 ist die Einheitstangente der Dissertation: Formel mit x, y, z (mm) und einer Zufallszahl u in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangents in sides of the square; 1 is the thesis' unit tangent: how it varies over the design</source>
        <translation>Länge der Tangenten in Quadratseiten; 1 ist die Einheitstangente der Dissertation: wie es sich über den Entwurf ändert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangents in sides of the square; 1 is the thesis' unit tangent: the constant value, or the least; linear, radial: at the start</source>
        <translation>Länge der Tangenten in Quadratseiten; 1 ist die Einheitstangente der Dissertation: der feste Wert oder der kleinste; linear, radial: am Anfang</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangents in sides of the square; 1 is the thesis' unit tangent: the greatest value; linear, radial: at the end</source>
        <translation>Länge der Tangenten in Quadratseiten; 1 ist die Einheitstangente der Dissertation: der größte Wert; linear, radial: am Ende</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Mean deviation of the numbers of trabeculae per layer along X, Y, Z, %; none if they were not asked for</source>
        <translation>Mittlere Abweichung der Trabekelzahlen je Schicht entlang X, Y, Z, %; keine, wenn sie nicht verlangt waren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Mean of sliced area over envelope area, over the axes, %</source>
        <translation>Mittel von Schnittfläche durch Fläche des Hüllkörpers über die Achsen, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Memory budget of the B-Rep engine</source>
        <translation>Speichergrenze des B-Rep-Verfahrens</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Memory budget of the B-Rep engine (memory_gb)</source>
        <translation>Speichergrenze des B-Rep-Verfahrens (memory_gb)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Minimum zeros propagation: columns are solved one after the other (fewest zeros u), or rows (fewest zeros v)</source>
        <translation>Fortpflanzung der wenigsten Nullen: Spalten werden nacheinander gelöst (wenigste Nullen u) oder Zeilen (wenigste Nullen v)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Most voxels in a line (x, z), thesis 6.2.4.3; 0 means M</source>
        <translation>Höchstens so viele Voxel in einer Linie (x, z), Dissertation 6.2.4.3; 0 bedeutet M</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Most voxels in a line (y, z); 0 means N</source>
        <translation>Höchstens so viele Voxel in einer Linie (y, z); 0 bedeutet N</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Name of the site, e.g. Face1.2.-3; for add: the face and any new word, e.g. Face1.extra</source>
        <translation>Name der Stelle, z. B. Face1.2.-3; zum Hinzufügen: die Fläche und ein neues Wort, z. B. Face1.extra</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Names of the rods in the order of the solids</source>
        <translation>Namen der Stäbe in der Reihenfolge der Volumenkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>New place; it is set on the face</source>
        <translation>Neuer Ort; er wird auf die Fläche gesetzt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>New size of the pore</source>
        <translation>Neue Größe der Pore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>New tangent components, one per corner, in 0..1</source>
        <translation>Neue Tangentenkomponenten, eine je Ecke, in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Number of rods</source>
        <translation>Anzahl der Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Number of triangles</source>
        <translation>Anzahl der Dreiecke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Off: the coupling makes no rods</source>
        <translation>Aus: die Kopplung erzeugt keine Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Offset of the contours into the material</source>
        <translation>Versatz der Konturen ins Material</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>On: also Tb.Th, Tb.Sp, Conn.D, DA ... on voxels; slow</source>
        <translation>Ein: auch Tb.Th, Tb.Sp, Conn.D, DA ... mit Voxeln; langsam</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>On: made after the channels and closes them; off: the channels go through</source>
        <translation>Ein: nach den Kanälen erzeugt und verschließt sie; aus: die Kanäle gehen hindurch</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>On: only from SliceLow to SliceHigh is sliced</source>
        <translation>Ein: nur von SliceLow bis SliceHigh wird geschnitten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>On: the value counts. Origin P of the co-ordinate lines; none means the centre of the face</source>
        <translation>Ein: der Wert gilt. Ursprung P der Koordinatenlinien; keiner bedeutet die Mitte der Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>One number reproduces all draws</source>
        <translation>Eine Zahl, die alle Zufallsziehungen wiederholbar macht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>One number reproduces all random draws</source>
        <translation>Eine Zahl, die alle Zufallsziehungen wiederholbar macht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Open contours shorter than this are left out</source>
        <translation>Kürzere offene Konturen werden weggelassen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Origin P of the co-ordinate lines; none means the centre of the face</source>
        <translation>Ursprung P der Koordinatenlinien; keiner bedeutet die Mitte der Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Pairs of faces in order, a JSON record a line: {"first": "Face1", "second": "Face2", "association": "random"}</source>
        <translation>Flächenpaare der Reihe nach, je Zeile ein JSON-Datensatz: {"first": "Face1", "second": "Face2", "association": "random"}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Pairs of tables that are tried before the search gives up</source>
        <translation>Tabellenpaare, die versucht werden, bevor die Suche aufgibt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Paths</source>
        <translation>Pfade</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Paths of this coupling; none means those of the design</source>
        <translation>Pfade dieser Kopplung; keine bedeutet die des Entwurfs</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Pieces that channels cut off all round</source>
        <translation>Teile, die Kanäle ringsum abtrennen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Plain sum of the rods' volumes over the envelope's, %</source>
        <translation>Einfache Summe der Stabvolumen durch das des Hüllkörpers, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Planes at the layers' middles, at their bottoms (thesis), at heights</source>
        <translation>Ebenen in der Mitte der Schichten, an ihrer Unterseite (Dissertation), auf Höhen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Points that hardly turn a contour are left out</source>
        <translation>Punkte, die eine Kontur kaum knicken, werden weggelassen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Pores</source>
        <translation>Poren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Pores that overlap or reach over a border</source>
        <translation>Poren, die sich überlappen oder über einen Rand reichen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Processor time that it took, s</source>
        <translation>Benötigte Rechenzeit, s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Random displacement of each corner, in sides of the square</source>
        <translation>Zufällige Verschiebung jeder Ecke, in Quadratseiten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Rods</source>
        <translation>Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Rods of the wireframe</source>
        <translation>Stäbe des Drahtmodells</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Rods that leave the envelope between their ends</source>
        <translation>Stäbe, die den Hüllkörper zwischen ihren Enden verlassen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Rods that no remedy mended; they are left out</source>
        <translation>Stäbe, denen nichts abhalf; sie sind weggelassen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Rods that the last recompute built or took anew</source>
        <translation>Stäbe, die die letzte Neuberechnung neu erzeugt oder übernommen hat</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Rods that were cut away</source>
        <translation>Ausgeschnittene Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Rods that were mended: fault, remedy, attempts</source>
        <translation>Reparierte Stäbe: Fehler, Abhilfe, Versuche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>STL, OBJ, PLY or 3MF that is sliced if there is no source</source>
        <translation>STL-, OBJ-, PLY- oder 3MF-Datei, die geschnitten wird, wenn kein Körper gewählt ist</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>STL, OBJ, PLY, 3MF, an analysis' CSV or JSON, NPY</source>
        <translation>STL, OBJ, PLY, 3MF, CSV oder JSON einer Analyse, NPY</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Scaffold</source>
        <translation>Gerüst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sections through which the surface of a solid rod is laid</source>
        <translation>Querschnitte, durch die die Oberfläche eines Stabs als Volumenkörper gelegt wird</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Share of the envelope inside the rods, nothing taken away or filled, %</source>
        <translation>Anteil des Hüllkörpers in den Stäben, nichts weggenommen oder gefüllt, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Share of the envelope that is not scaffold, % (Eq. 2.2)</source>
        <translation>Anteil des Hüllkörpers, der nicht Gerüst ist, % (Gl. 2.2)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Share of the voxels in the largest part, %</source>
        <translation>Anteil der Voxel im größten Teil, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Short name used in couplings and reports, e.g. A; none means the face's own</source>
        <translation>Kurzname in Kopplungen und Berichten, z. B. A; keiner bedeutet der Name der Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Short name used in couplings and reports, e.g. A; none means the face's own (name)</source>
        <translation>Kurzname in Kopplungen und Berichten, z. B. A; keiner bedeutet der Name der Fläche (name)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Sites</source>
        <translation>Stellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sites along X</source>
        <translation>Stellen entlang X</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sites along X (n_x)</source>
        <translation>Stellen entlang X (n_x)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sites along Y</source>
        <translation>Stellen entlang Y</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sites along Y (n_y)</source>
        <translation>Stellen entlang Y (n_y)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sites along Z</source>
        <translation>Stellen entlang Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sites along Z (n_z)</source>
        <translation>Stellen entlang Z (n_z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Sites available, rods, sites left, for each coupling (tables 4.2, 4.5)</source>
        <translation>Verfügbare Stellen, Stäbe und übrige Stellen je Kopplung (Tabellen 4.2, 4.5)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/prism_sites.py"/>
        <source>Sites on all faces</source>
        <translation>Stellen auf allen Flächen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Sites on its faces</source>
        <translation>Stellen auf seinen Flächen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>Sites on the face</source>
        <translation>Stellen auf der Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sites that earlier couplings used may be used again</source>
        <translation>Stellen, die frühere Kopplungen verbraucht haben, dürfen wieder benutzt werden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Sizes of the rods' end sections, mm</source>
        <translation>Größen der Endquerschnitte der Stäbe, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Slices</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Slices along all axes</source>
        <translation>Schnitte entlang aller Achsen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Slices on which the mesh is not closed: their numbers may be wrong</source>
        <translation>Schnitte, in denen das Netz nicht geschlossen ist: ihre Zahlen können falsch sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Solid voxels</source>
        <translation>Volle Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Solid voxels over all of the envelope, %</source>
        <translation>Volle Voxel durch alle des Hüllkörpers, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Spacing of the lines along v</source>
        <translation>Abstand der Linien entlang v</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Spacing of the lines along v (c_v)</source>
        <translation>Abstand der Linien entlang v (c_v)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Spacing of the sites along u</source>
        <translation>Abstand der Stellen entlang u</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Spacing of the sites along u (c_u)</source>
        <translation>Abstand der Stellen entlang u (c_u)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Sum of sliced area x thickness, mean of the axes</source>
        <translation>Summe von Schnittfläche x Dicke, Mittel der Achsen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Sum of the solids' volumes; overlaps count twice</source>
        <translation>Summe der Volumen der Volumenkörper; Überlappungen zählen doppelt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Sum of the volumes of the rods' meshes: the independent route</source>
        <translation>Summe der Volumen der Stabnetze: der unabhängige Weg</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Targets from sections through the middles of the layers (Eq. 6.1), or from the volumes of the slabs</source>
        <translation>Zielwerte aus Schnitten durch die Mitten der Schichten (Gl. 6.1) oder aus den Volumen der Scheiben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>The analysis: its numbers</source>
        <translation>Die Analyse: ihre Zahlen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>The analysis: names, tables, places of its numbers</source>
        <translation>Die Analyse: Namen, Tabellen, Plätze ihrer Zahlen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>The body that is sliced; none: the file</source>
        <translation>Der Körper, der geschnitten wird; keiner: die Datei</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>The body to be filled</source>
        <translation>Der Körper, der gefüllt wird</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>The design: its numbers</source>
        <translation>Der Entwurf: seine Zahlen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>The design: names, places of its numbers</source>
        <translation>Der Entwurf: Namen, Plätze seiner Zahlen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/prism_sites.py"/>
        <source>The prism, a box</source>
        <translation>Das Prisma, ein Quader</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>The sample: a body, or an analysis; none: the file</source>
        <translation>Die Probe: ein Körper oder eine Analyse; keine: die Datei</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>The scaffold of which this is a part</source>
        <translation>Das Gerüst, zu dem dies gehört</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/on_demand.py"/>
        <source>The wireframe whose rods these are</source>
        <translation>Das Drahtmodell, dessen Stäbe dies sind</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>The wireframe: its numbers</source>
        <translation>Das Drahtmodell: seine Zahlen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>The wireframe: names, tables, places of its numbers</source>
        <translation>Das Drahtmodell: Namen, Tabellen, Plätze seiner Zahlen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Thickness of a layer</source>
        <translation>Dicke einer Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Thickness of the layer</source>
        <translation>Dicke der Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Tilt of the inner sections towards the path's normal planes</source>
        <translation>Neigung der inneren Querschnitte zu den Normalebenen des Pfads</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Time budget of the B-Rep engine</source>
        <translation>Zeitgrenze des B-Rep-Verfahrens</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Time budget of the B-Rep engine (seconds)</source>
        <translation>Zeitgrenze des B-Rep-Verfahrens (seconds)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Time that it took, s</source>
        <translation>Benötigte Zeit, s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Times that tangents or middle points are drawn again before the path is changed</source>
        <translation>Wie oft Tangenten oder Mittelpunkte neu gezogen werden, bevor der Pfad geändert wird</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>To whose slices the porosity refers; none: the body's box</source>
        <translation>Auf wessen Schnitte sich die Porosität bezieht; keiner: der Quader um den Körper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Triangles that were sliced</source>
        <translation>Dreiecke, die geschnitten wurden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>True areas of the rods' end sections, mm^2</source>
        <translation>Wahre Flächen der Endquerschnitte der Stäbe, mm^2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Unit of the file; auto: guessed, and said</source>
        <translation>Einheit der Datei; auto: geschätzt, und gesagt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Unit of the numbers before they became mm</source>
        <translation>Einheit der Zahlen, bevor sie mm wurden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>Version of the object</source>
        <translation>Version des Objekts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Voids that no opening reaches</source>
        <translation>Hohlräume ohne Öffnung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Volume of the channels</source>
        <translation>Volumen der Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Volume of the envelope</source>
        <translation>Volumen des Hüllkörpers</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Volume of the layers outside of the envelope</source>
        <translation>Volumen der Schichten außerhalb des Hüllkörpers</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Volume of the mesh: the independent route</source>
        <translation>Volumen des Netzes: der unabhängige Weg</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Volume of the pieces that channels cut off all round</source>
        <translation>Volumen der Teile, die Kanäle ringsum abtrennen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Volume of the same cut by the mesh engine: the independent route</source>
        <translation>Volumen desselben Schnitts mit dem Netzverfahren: der unabhängige Weg</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Volume of the scaffold</source>
        <translation>Volumen des Gerüsts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Volume of the scaffold as it is shown</source>
        <translation>Volumen des Gerüsts, wie es gezeigt wird</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Volume of the solid voxels</source>
        <translation>Volumen der vollen Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Volume of the solid, loose pieces included</source>
        <translation>Volumen des Volumenkörpers samt loser Teile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Volume of the triangles: the independent route</source>
        <translation>Volumen der Dreiecke: der unabhängige Weg</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Volume of the voids that no opening reaches</source>
        <translation>Volumen der Hohlräume ohne Öffnung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Volumes of the rods' meshes, mm^3</source>
        <translation>Volumen der Stabnetze, mm^3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Volumes of the solids, mm^3</source>
        <translation>Volumen der Volumenkörper, mm^3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Voxels at the envelope's boundary belong to it when their centre does, when they touch it, or when they lie inside it whole</source>
        <translation>Voxel am Rand des Hüllkörpers gehören dazu, wenn ihr Mittelpunkt es tut, wenn sie ihn berühren oder wenn sie ganz innen liegen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Wavelengths of the trabecular texture along X, Y, Z; 0: fitted to the sample, or eight voxels without one</source>
        <translation>Wellenlängen der trabekulären Textur entlang X, Y, Z; 0: an die Probe angepasst, ohne Probe acht Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>What is to be known</source>
        <translation>Was zu wissen ist</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>What overlaps counts as often as it overlaps, or once (union)</source>
        <translation>Was sich überlappt, zählt so oft, wie es sich überlappt, oder einmal (Vereinigung)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>What the last recompute said</source>
        <translation>Was die letzte Neuberechnung meldete</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>What this is of the scaffold</source>
        <translation>Welcher Teil des Gerüsts dies ist</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>What was worked out twice, by independent routes, and how far the two differ</source>
        <translation>Was zweimal auf unabhängigen Wegen berechnet wurde, und wie weit beide auseinanderliegen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Where the layers begin</source>
        <translation>Wo die Schichten beginnen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Where the layers begin; nan: where the body does</source>
        <translation>Wo die Schichten beginnen; nan: wo der Körper beginnt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Where the layers end</source>
        <translation>Wo die Schichten enden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Where the layers end; nan: where the body does</source>
        <translation>Wo die Schichten enden; nan: wo der Körper endet</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Whether all rods were cut</source>
        <translation>Ob alle Stäbe ausgeschnitten wurden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Whether every layer along X, Y and Z has the voxels asked for</source>
        <translation>Ob jede Schicht entlang X, Y und Z die verlangten Voxel hat</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Whether scaffold and channels are closed</source>
        <translation>Ob Gerüst und Kanäle geschlossen sind</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Whether the mesh is closed</source>
        <translation>Ob das Netz geschlossen ist</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/on_demand.py"/>
        <source>Whether the result belongs to the present inputs</source>
        <translation>Ob das Ergebnis zu den jetzigen Eingaben gehört</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Which axis' real total is the common one (thesis: z)</source>
        <translation>Die reelle Summe welcher Achse die gemeinsame ist (Dissertation: z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Which of several convergence points a rod takes</source>
        <translation>Welchen von mehreren Konvergenzpunkten ein Stab nimmt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Why it stopped, if it did</source>
        <translation>Warum es abbrach, falls es abbrach</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Why this engine, and what it was expected to take</source>
        <translation>Warum dieses Verfahren, und was es voraussichtlich braucht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Width along Y</source>
        <translation>Breite entlang Y</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>circle, or closed spline through corners with random tangents</source>
        <translation>Kreis oder geschlossener Spline durch Ecken mit zufälligen Tangenten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>inwards: the outer part of the envelope; outwards: added to it</source>
        <translation>nach innen: der äußere Teil des Hüllkörpers; nach außen: kommt hinzu</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>mesh: exact triangles; field: rays and cells, for many rods; brep: STEP</source>
        <translation>Netz: genaue Dreiecke; Feld: Strahlen und Zellen, für viele Stäbe; B-Rep: STEP</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>off, move (to point), add (at point), pore (size and turns)</source>
        <translation>aus, verschieben (zum Punkt), hinzufügen (am Punkt), Pore (Größe und Tangenten)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>orthogonal: along the normal; straight: joins the sites; centre: 3-point curve through a convergence point; box: through a random point of a box about it (Eq. 3.1); tension: 2-point curve along the inner normals</source>
        <translation>senkrecht: entlang der Normalen; gerade: verbindet die Stellen; Mitte: 3-Punkt-Kurve durch einen Konvergenzpunkt; Quader: durch einen zufälligen Punkt eines Quaders um ihn (Gl. 3.1); Spannung: 2-Punkt-Kurve entlang der inneren Normalen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>random pairs of sites, or site (i, j) to site (i, j)</source>
        <translation>zufällige Paare von Stellen oder Stelle (i, j) zu Stelle (i, j)</translation>
    </message>
</context>
<context>
    <name>Choices</name>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>add</source>
        <translation>hinzufügen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>any</source>
        <translation>alle erlaubt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>auto</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>best-tables</source>
        <translation>beste Tabellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>brep</source>
        <translation>B-Rep</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>by-field</source>
        <translation>nach Feld</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>constant</source>
        <translation>konstant</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>constraint</source>
        <translation>mit Bedingung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>corner</source>
        <translation>über Ecke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>coupling</source>
        <translation>Kopplung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>edge</source>
        <translation>über Kante</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>expression</source>
        <translation>Formel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>gyroid</source>
        <translation>Gyroid</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>half</source>
        <translation>zur Hälfte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>heavy</source>
        <translation>stark</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>heights</source>
        <translation>Höhen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>inwards</source>
        <translation>nach innen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>minimum-zeros</source>
        <translation>wenigste Nullen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>move</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>nearest</source>
        <translation>nächster</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>orthogonal</source>
        <translation>senkrecht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>outwards</source>
        <translation>nach außen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>picked faces</source>
        <translation>gewählten Flächen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>plain</source>
        <translation>einfarbig</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>pore</source>
        <translation>Pore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>prism</source>
        <translation>Prisma</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>proportional</source>
        <translation>anteilig</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>radial</source>
        <translation>radial</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>random</source>
        <translation>zufällig</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>random-layers</source>
        <translation>zufällige Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>recovery</source>
        <translation>Behebung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>remainders</source>
        <translation>größte Reste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>repeat</source>
        <translation>wiederholen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>rods and plates</source>
        <translation>Stäbe und Platten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>same</source>
        <translation>gleiche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>sequential</source>
        <translation>der Reihe nach</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>sheets</source>
        <translation>Lamellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>slab</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>smooth</source>
        <translation>glatt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>spline</source>
        <translation>Spline</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>straight</source>
        <translation>gerade</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>tension</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>thesis</source>
        <translation>Dissertation</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>touched</source>
        <translation>berührt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>trabecular</source>
        <translation>trabekulär</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>uniform</source>
        <translation>uniform</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>union</source>
        <translation>Vereinigung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>winding</source>
        <translation>Umlaufzahl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>xy</source>
        <translation>xy</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>xyz</source>
        <translation>xyz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>xz</source>
        <translation>xz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>yz</source>
        <translation>yz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>z</source>
        <translation>z</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source> (closed: make a solid of it first)</source>
        <translation> (geschlossen: zuerst einen Volumenkörper daraus machen)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source> (the widest gap: {} mm)</source>
        <translation> (die breiteste Lücke: {} mm)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source> ({} % of it lie outside any block of 2 x 2 x 2 voxels)</source>
        <translation> ({} % davon liegen außerhalb jedes Blocks von 2 x 2 x 2 Voxeln)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/feasibility.py"/>
        <source> ... ({} layers)</source>
        <translation> ... ({} Schichten)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source> The thesis needed {} s for alpha, beta and the layers of 103 x 94 x 103 voxels by this strategy.</source>
        <translation> Die Dissertation brauchte {} s für alpha, beta und die Schichten von 103 x 94 x 103 Voxeln mit dieser Strategie.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source> about {} mm</source>
        <translation> um {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thresholds.py"/>
        <source> above {}</source>
        <translation> über {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masked_tables.py"/>
        <source> and with {}</source>
        <translation> und mit {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source> and {} more stretches</source>
        <translation> und {} weitere Abschnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source> by an edge</source>
        <translation> durch eine Kante</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source> by an edge or a corner</source>
        <translation> durch eine Kante oder eine Ecke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source> or {}</source>
        <translation> oder {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source> there twice: the material counts twice</source>
        <translation> doppelt vorhanden: das Material zählt zweimal</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source> turned against the neighbours</source>
        <translation> gegen die Nachbarn gedreht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source> within the mask</source>
        <translation> in der Maske</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>, box of {} mm</source>
        <translation>, Quader {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>, one of them in layer {} along Z</source>
        <translation>, einen davon in Schicht {} entlang Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>, {} of them spoilt</source>
        <translation>, {} davon fehlerhaft</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>1 / (Tb.Th + Tb.Sp); programs that measure between mid-axes, or divide BV/TV by Tb.Th, get other numbers</source>
        <translation>1 / (Tb.Th + Tb.Sp); Programme, die zwischen Mittelachsen messen oder BV/TV durch Tb.Th teilen, erhalten andere Zahlen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>1 less what the body adds to the Euler number of the structure it was cut out of: the box's faces count half, its edges a quarter, its corners an eighth</source>
        <translation>1 minus das, was der Körper zur Euler-Zahl der Struktur beiträgt, aus der er geschnitten wurde: Quaderflächen zählen halb, Kanten ein Viertel, Ecken ein Achtel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>100 (1 - V_solid / V_envelope), volumes by the kernel</source>
        <translation>100 (1 - V_solid / V_envelope), Volumen vom Kern</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>100 (1 - sliced area / area of the envelope's slice)</source>
        <translation>100 (1 - Schnittfläche / Fläche des Hüllkörperschnitts)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>100 (V_envelope - V_scaffold) / V_envelope, volumes by the divergence theorem over the triangles of what is exported</source>
        <translation>100 (V_envelope - V_scaffold) / V_envelope, Volumen nach dem Divergenzsatz über die Dreiecke dessen, was exportiert wird</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>100 V_union / V_envelope, the union by the engine, before loose pieces are taken away or voids filled</source>
        <translation>100 V_union / V_envelope, Vereinigung durch das Verfahren, bevor lose Teile entfernt oder Hohlräume gefüllt werden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>100 V_union / V_envelope, the union of the rods by parallel rays through their triangles, with its standard error; loose pieces stay</source>
        <translation>100 V_union / V_envelope, Vereinigung der Stäbe mit parallelen Strahlen durch ihre Dreiecke, mit Standardfehler; lose Teile bleiben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>100 solid voxels / voxels of the envelope</source>
        <translation>100 volle Voxel / Voxel des Hüllkörpers</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>100 sum V_rod / V_envelope, crossings counted as often as they come; what the thesis added up for case 1</source>
        <translation>100 Summe V_rod / V_envelope, Kreuzungen so oft gezählt, wie sie vorkommen; so rechnete die Dissertation bei Fall 1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>100 sum of sliced areas / sum of the envelope's</source>
        <translation>100 Summe der Schnittflächen / Summe der des Hüllkörpers</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>100 times the mean over an axis' layers of |made - asked for| / asked for</source>
        <translation>100 mal das Mittel über die Schichten einer Achse von |erzeugt - verlangt| / verlangt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>100 voxels of the largest part / solid voxels</source>
        <translation>100 Voxel des größten Teils / volle Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>100 x twice the common solid voxels over the sum of both</source>
        <translation>100 x das Doppelte der gemeinsamen vollen Voxel durch die Summe beider</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>1e-9 of it for blocks; told for smooth surfaces</source>
        <translation>1e-9 davon bei Blöcken; bei glatten Oberflächen wird es angegeben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>2 BV / BS over the largest edge of a voxel</source>
        <translation>2 BV / BS durch die größte Kante eines Voxels</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/path_laws.py"/>
        <source>2-point curve along the inner normals</source>
        <translation>2-Punkt-Kurve entlang der inneren Normalen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/path_laws.py"/>
        <source>3-point curve through a convergence point</source>
        <translation>3-Punkt-Kurve durch einen Konvergenzpunkt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>6e-15 on 960 planes; of solids what tessellation changes</source>
        <translation>6e-15 auf 960 Ebenen; bei Volumenkörpern was die Triangulierung ändert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>: the mesh is not watertight</source>
        <translation>: das Netz ist nicht dicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>A graph over the slices (thesis ch. 9): trabeculae are joined where they overlap on neighbouring slices. Its counts depend on the thickness of the layers.</source>
        <translation>Ein Graph über die Schnitte (Dissertation Kap. 9): Trabekel sind verbunden, wo sie sich auf benachbarten Schnitten überlappen. Seine Anzahlen hängen von der Dicke der Schichten ab.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>All checks held.</source>
        <translation>Alle Prüfungen bestanden.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_makers.py"/>
        <source>Analysis {}</source>
        <translation>Analyse {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>BS over BV</source>
        <translation>BS durch BV</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>BV over TV; porosity is 1 less it</source>
        <translation>BV durch TV; Porosität ist 1 minus dies</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>BV/TV is {} by triangles and {} by voxels: parts of the mesh overlap (then the voxels are right), or are thinner than a voxel</source>
        <translation>BV/TV ist {} aus Dreiecken und {} aus Voxeln: Teile des Netzes überlappen sich (dann stimmen die Voxel) oder sind dünner als ein Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Checks</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Choices</source>
        <translation>Wahl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>Conn over TV</source>
        <translation>Conn durch TV</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Couplings</source>
        <translation>Kopplungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>DA by all lines through BS, from its normals: the second route, exact</source>
        <translation>DA mit allen Linien durch BS, aus ihren Normalen: der zweite Weg, exakt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>DA.mesh: {}</source>
        <translation>DA.mesh: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>DA: {}</source>
        <translation>DA: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>Definitions</source>
        <translation>Definitionen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>Design</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>Differences on shared layers</source>
        <translation>Differenzen auf gemeinsamen Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/connectivity.py"/>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>Euler number</source>
        <translation>Euler-Zahl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Exact on every layer of the three axes, but its mesh is not watertight.</source>
        <translation>Exakt auf jeder Schicht der drei Achsen, aber das Netz ist nicht dicht.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Exact on every layer of the three axes.</source>
        <translation>Exakt auf jeder Schicht der drei Achsen.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Exact on every layer of the three axes; the mesh is watertight.</source>
        <translation>Exakt auf jeder Schicht der drei Achsen; das Netz ist dicht.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>FAILED</source>
        <translation>MISSLUNGEN</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Faces and sites</source>
        <translation>Flächen und Stellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/envelope.py"/>
        <source>File from which the envelope was made</source>
        <translation>Datei, aus der der Hüllkörper stammt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>Green's theorem over the cubic pieces, exact</source>
        <translation>Satz von Green über die kubischen Stücke, exakt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Heavy</source>
        <translation>Stark</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>Hellinger distance of the distributions of trabecular area over logarithmic bins, five per decade with borders at 10^(k/5) mm2: sqrt(sum (sqrt p - sqrt q)^2 / 2); 0 = equal, 1 = no bin shared</source>
        <translation>Hellinger-Abstand der Verteilungen der Trabekelfläche über logarithmische Klassen, fünf je Dekade mit Grenzen bei 10^(k/5) mm2: Wurzel(Summe (Wurzel p - Wurzel q)^2 / 2); 0 = gleich, 1 = keine gemeinsame Klasse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>How many designs</source>
        <translation>Wie viele Entwürfe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Input</source>
        <translation>Eingaben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Interconnectivity</source>
        <translation>Verbundenheit der Trabekel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>Kolmogorov-Smirnov distance of the distributions of trabecular area (net of holes, each trabecula of each slice once): largest difference of the two shares of trabeculae up to an area; not binned; 0 = equal, 1 = apart</source>
        <translation>Kolmogorow-Smirnow-Abstand der Verteilungen der Trabekelfläche (ohne Löcher, jedes Trabekel jedes Schnitts einmal): größte Differenz der Anteile bis zu einer Fläche; ohne Klassen; 0 = gleich, 1 = getrennt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Layers</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>Layers of {}</source>
        <translation>Schichten von {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Leave the envelope</source>
        <translation>Verlassen den Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Left out, since nothing mended them</source>
        <translation>Weggelassen, da nichts sie behob</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>Left out, to keep this file small:</source>
        <translation>Weggelassen, um diese Datei klein zu halten:</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>Lengths are mm. Under each table stands why its numbers are what they are.</source>
        <translation>Längen in mm. Unter jeder Tabelle steht, warum ihre Zahlen sind, wie sie sind.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>MIL.max over MIL.min by lines through the voxels, up to 10 % low; 1 = isotropic; 1 - 1/DA^2 goes from 0 to 1</source>
        <translation>MIL.max durch MIL.min mit Linien durch die Voxel, bis 10 % zu niedrig; 1 = isotrop; 1 - 1/DA^2 reicht von 0 bis 1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Made with {}.</source>
        <translation>Erstellt mit {}.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Morphometry</source>
        <translation>Morphometrie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>None.</source>
        <translation>Keine.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>None: the slices came from a file of layers.</source>
        <translation>Keins: die Schnitte kamen aus einer Schichtdatei.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Not all checks held: see Checks.</source>
        <translation>Nicht alle Prüfungen bestanden: siehe Prüfungen.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Not exact: {} layers have other counts than asked for.</source>
        <translation>Nicht exakt: {} Schichten haben andere Anzahlen als verlangt.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Note:</source>
        <translation>Hinweis:</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Of {} pairs of tables drawn without regard for each other {} came to their end; {} % of their layers were compatible, and {} pairs in all layers.</source>
        <translation>Von {} Tabellenpaaren, die ohne Rücksicht aufeinander gezogen wurden, kamen {} zu Ende; {} % ihrer Schichten waren verträglich, und {} Paare in allen Schichten.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/on_demand.py"/>
        <source>On: computed with every recompute; off: shown as out of date until it is updated</source>
        <translation>Ein: bei jeder Neuberechnung berechnet; aus: als veraltet gezeigt, bis es aktualisiert wird</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>On: the value counts. {}</source>
        <translation>Ein: der Wert gilt. {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/trabecular.py"/>
        <source>One connected part of sheets and rods, like the sample's; no floating voxel, no closed cavity</source>
        <translation>Ein zusammenhängender Teil aus Lamellen und Stäben, wie die der Probe; kein schwebendes Voxel, kein geschlossener Hohlraum</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>Pearson's correlation of the profiles over the shared layers; 1 = same shape; none if a profile is constant</source>
        <translation>Pearson-Korrelation der Profile über die gemeinsamen Schichten; 1 = gleiche Form; keine bei konstantem Profil</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Pores</source>
        <translation>Poren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Recoveries</source>
        <translation>Behebungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Rods and plates are outer contours; the thesis classes voids with the plates, and counts every contour as a trabecula. A negative trabecular area is a void's. Porosity refers to {}.</source>
        <translation>Stäbe und Platten sind äußere Konturen; die Dissertation rechnet Hohlräume zu den Platten und zählt jede Kontur als Trabekel. Eine negative Trabekelfläche gehört zu einem Hohlraum. Die Porosität bezieht sich auf {}.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>Rods and plates as in the thesis: every contour, voids too, by area / box.</source>
        <translation>Stäbe und Platten wie in der Dissertation: jede Kontur, auch Hohlräume, nach Fläche / Rechteck.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>Round(sliced area / area of a voxel's face), brought to one total of the three axes</source>
        <translation>Round(Schnittfläche / Fläche einer Voxelseite), auf eine Summe der drei Achsen gebracht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>Samples are laid side by side by {}; differences are against {}.</source>
        <translation>Proben liegen nebeneinander nach {}; Differenzen sind gegen {}.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>Sections with the same value, as the thesis counts them, are where two curves meet.</source>
        <translation>Schnitte mit gleichem Wert, wie die Dissertation sie zählt, liegen, wo zwei Kurven sich treffen.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/makers.py"/>
        <source>Sites {}</source>
        <translation>Stellen {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>Slice analysis</source>
        <translation>Schnittanalyse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>Slice passport</source>
        <translation>Pass</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>Sliced area (mm2)</source>
        <translation>Schnittfläche (mm2)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Slices along the axes</source>
        <translation>Schnitte entlang der Achsen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Slices of {}</source>
        <translation>Schnitte: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/envelope.py"/>
        <source>Solid in that file</source>
        <translation>Volumenkörper in dieser Datei</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>Solid{}{} ({})</source>
        <translation>Solid{}{} ({})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/examples.py"/>
        <source>Specimen {}</source>
        <translation>Probekörper {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Tables that fit</source>
        <translation>Verträgliche Tabellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>The deltas are the common total less the sum of the counts rounded by Eq. 6.1.</source>
        <translation>Die Deltas sind die gemeinsame Summe minus die Summe der nach Gl. 6.1 gerundeten Anzahlen.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>The design</source>
        <translation>Der Entwurf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>The mesh is faulty: the numbers are not to be trusted where it is.</source>
        <translation>Das Netz ist fehlerhaft: dort ist den Zahlen nicht zu trauen.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>The scores are in [{}]({}).</source>
        <translation>Die Werte stehen in [{}]({}).</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>The whole run took {} s.{}</source>
        <translation>Der ganze Lauf dauerte {} s.{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>Total number of plates</source>
        <translation>Gesamtzahl der Platten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>Total number of rods</source>
        <translation>Gesamtzahl der Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>Totals and ranges</source>
        <translation>Summen und Bereiche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>Trabecular area range (mm2)</source>
        <translation>Bereich der Trabekelflächen (mm2)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>Underwood, Quantitative Stereology, 1970 (S_V = 2 P_L)</source>
        <translation>Underwood, Quantitative Stereology, 1970 (S_V = 2 P_L)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>Voxel design</source>
        <translation>Voxelentwurf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Voxel design of {}</source>
        <translation>Voxelentwurf: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>Voxels of drawn curves</source>
        <translation>Voxel aus gezeichneten Kurven</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>Voxels {}</source>
        <translation>Voxel {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Warning: {}</source>
        <translation>Warnung: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/envelope.py"/>
        <source>What was mended in the file's solid, and what looks wrong</source>
        <translation>Was am Volumenkörper der Datei repariert wurde, und was falsch aussieht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>Why? Formulas, sources, second routes</source>
        <translation>Warum? Formeln, Quellen, zweite Wege</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>a 3MF file must be a whole ZIP archive: {}</source>
        <translation>eine 3MF-Datei muss ein vollständiges ZIP-Archiv sein: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>a 3MF file must hold {}</source>
        <translation>eine 3MF-Datei muss {} enthalten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>a Boolean must be one of {}, got {}</source>
        <translation>eine boolesche Operation muss eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_formats.py"/>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>a PLY file must begin with its header</source>
        <translation>eine PLY-Datei muss mit ihrem Kopf beginnen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/install.py"/>
        <source>a Python {} with pip must be there to install manifold3d, and none was found</source>
        <translation>ein Python {} mit pip muss da sein, um manifold3d zu installieren, und keines wurde gefunden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_panel.py"/>
        <source>a body to be sliced must be chosen, got none: choose an object or a file</source>
        <translation>ein Körper, der geschnitten wird, muss gewählt sein, hier keiner: ein Objekt oder eine Datei wählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/voxelise.py"/>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <location filename="../../freecad_trabecula/core/rays.py"/>
        <source>a box must satisfy low &lt; high on every axis, got {} and {} mm</source>
        <translation>für einen Quader muss auf jeder Achse unten &lt; oben gelten, hier {} und {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masked_tables.py"/>
        <source>a cap of {} on {}</source>
        <translation>eine Grenze von {} für {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>a change by hand does not</source>
        <translation>eine Änderung von Hand tut es nicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>a change by hand does not fit the design: {}</source>
        <translation>eine Änderung von Hand passt nicht zum Entwurf: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/sites.py"/>
        <source>a change by hand must name a site of face {} ({} sites), got {}</source>
        <translation>eine Änderung von Hand muss eine Stelle der Fläche {} nennen ({} Stellen), hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/pieces.py"/>
        <source>a closed mesh must hold some volume, got {} mm3</source>
        <translation>ein geschlossenes Netz muss ein Volumen haben, hier {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/coordinate_lines.py"/>
        <source>a co-ordinate line could not be followed for {} mm</source>
        <translation>einer Koordinatenlinie konnte nicht über {} mm gefolgt werden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/coordinate_lines.py"/>
        <source>a co-ordinate line has no end after {} steps and {} mm</source>
        <translation>eine Koordinatenlinie endet nach {} Schritten und {} mm nicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/coordinate_lines.py"/>
        <source>a co-ordinate line left the face unnoticed after {} mm</source>
        <translation>eine Koordinatenlinie hat die Fläche nach {} mm unbemerkt verlassen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/coordinate_lines.py"/>
        <source>a co-ordinate line's plane touches the face</source>
        <translation>die Ebene einer Koordinatenlinie berührt die Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>a comparison needs at least two analyses, got {}</source>
        <translation>ein Vergleich braucht mindestens zwei Analysen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a convergence point's co-ordinate</source>
        <translation>eine Koordinate eines Konvergenzpunkts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/couplings.py"/>
        <source>a coupled face must have at least 1 site, got 0 on face {}: less spacing or border</source>
        <translation>eine gekoppelte Fläche muss mindestens 1 Stelle haben, hier 0 auf Fläche {}: Abstände oder Ränder verkleinern</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a coupling must join faces of the job ({}), got {}</source>
        <translation>eine Kopplung muss Flächen des Auftrags verbinden ({}), hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/couplings.py"/>
        <source>a coupling must join faces that have sites ({}), got {}</source>
        <translation>eine Kopplung muss Flächen mit Stellen verbinden ({}), hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a coupling needs two faces, got {}</source>
        <translation>eine Kopplung braucht zwei Flächen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>a curve along {} must ask for some material, got {}</source>
        <translation>eine Kurve entlang {} muss Material verlangen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>a curve along {} must have at least one point, got {}</source>
        <translation>eine Kurve entlang {} muss mindestens einen Punkt haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>a curve's places along {} must lie in 0..1 of the edge, got {}</source>
        <translation>die Orte einer Kurve entlang {} müssen in 0..1 der Kante liegen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/verification.py"/>
        <source>a design for these targets must have the shape {}, got {}</source>
        <translation>ein Entwurf muss für diese Zielwerte die Form {} haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a design must be an array with three axes, got {}</source>
        <translation>ein Entwurf muss ein Feld mit drei Achsen sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/smooth_surface.py"/>
        <source>a design must have at least one solid voxel to have a surface, got {}</source>
        <translation>ein Entwurf muss für eine Oberfläche mindestens ein volles Voxel haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/blocks.py"/>
        <source>a design must have at least one voxel to have a mesh, got 0</source>
        <translation>ein Entwurf muss für ein Netz mindestens ein Voxel haben, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masks.py"/>
        <source>a design must have at least one voxel; the densities in this mask make, got {}</source>
        <translation>ein Entwurf muss mindestens ein Voxel haben; die Dichten ergeben in dieser Maske, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a design must have at most {} rods; this one would take about {} hours and {} GB, got {}</source>
        <translation>ein Entwurf darf höchstens {} Stäbe haben; dieser bräuchte etwa {} Stunden und {} GB, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>a design must have at most {} voxels; {} would take about {} GB of memory; larger voxels make fewer, got {}</source>
        <translation>ein Entwurf darf höchstens {} Voxel haben; {} bräuchten etwa {} GB Speicher; größere Voxel sind weniger, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/report_sections.py"/>
        <source>a design must have its scaffold to be told of: build it first</source>
        <translation>ein Entwurf muss für den Bericht sein Gerüst haben: zuerst erzeugen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/variants.py"/>
        <source>a design must have solid voxels, got 0</source>
        <translation>ein Entwurf muss volle Voxel haben, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/export_dialog.py"/>
        <source>a design needs a network or a scaffold to be exported, got none: build one first</source>
        <translation>ein Entwurf braucht zum Exportieren ein Netzwerk oder ein Gerüst, hier keines: zuerst eines bauen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/report_sections.py"/>
        <source>a design with its scaffold, an analysis or voxels are needed</source>
        <translation>nötig ist ein Entwurf mit seinem Gerüst, eine Analyse oder Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>a design with these counts and rules exists, but was not found; another seed may do</source>
        <translation>ein Entwurf mit diesen Anzahlen und Regeln existiert, wurde aber nicht gefunden; ein anderer Startwert hilft vielleicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/coordinate_lines.py"/>
        <source>a direction must not be along the face's normal at the origin of its line, got ({}, {}, {})</source>
        <translation>eine Richtung darf am Ursprung ihrer Linie nicht entlang der Flächennormalen liegen, hier ({}, {}, {})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/arguments.py"/>
        <source>a document is needed, got {}</source>
        <translation>nötig ist ein Dokument, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/anisotropy.py"/>
        <source>a fabric ellipsoid needs at least 6 directions, got {}</source>
        <translation>ein Fabric-Ellipsoid braucht mindestens 6 Richtungen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/anisotropy.py"/>
        <source>a fabric needs a surface that lines cross, got none</source>
        <translation>eine Textur braucht eine Oberfläche, die Linien schneiden, hier keine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/couplings.py"/>
        <source>a face can be coupled with itself only if it is curved: rods of the flat face {} would lie in its plane</source>
        <translation>eine Fläche kann nur mit sich selbst gekoppelt werden, wenn sie gekrümmt ist: Stäbe der ebenen Fläche {} lägen in ihrer Ebene</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a face must be named, got {}</source>
        <translation>eine Fläche muss genannt sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>a face must be one of Face1..Face{} or {}, got {}</source>
        <translation>eine Fläche muss eine von Face1..Face{} oder {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>a face must be one of Face1..Face{}, got {}</source>
        <translation>eine Fläche muss eine von Face1..Face{} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_sites.py"/>
        <source>a face must have at most {} sites, but spacings of {} and {} mm give about {} on {}</source>
        <translation>eine Fläche darf höchstens {} Stellen haben, aber Abstände von {} und {} mm ergeben etwa {} auf {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>a face must have one normal per vertex, got {} for {} vertices</source>
        <translation>eine Fläche muss eine Normale je Ecke haben, hier {} für {} Ecken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>a face of {} must be one of Face1..Face{}, got {}</source>
        <translation>eine Fläche von {} muss eine von Face1..Face{} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>a face to be thickened must have at least one triangle, got 0</source>
        <translation>eine zu verdickende Fläche muss mindestens ein Dreieck haben, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>a fault without a name</source>
        <translation>ein Fehler ohne Namen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/nodes.py"/>
        <source>a field may have {} nodes; a cell size of {} mm needs {}</source>
        <translation>ein Feld darf {} Knoten haben; eine Zellgröße von {} mm braucht {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/layer_analysis.py"/>
        <source>a file of layers is read as it is: heights and a range cannot be chosen</source>
        <translation>eine Schichtdatei wird gelesen, wie sie ist: Höhen und Bereich können nicht gewählt werden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>a folder must hold the report.json of design, analyse, compare or voxels, got {} with another record</source>
        <translation>ein Ordner muss die report.json von design, analyse, compare oder voxels enthalten, hier {} mit einem anderen Inhalt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>a folder must hold the report.json of design, analyse, compare or voxels, got {}, which holds no JSON: {}</source>
        <translation>ein Ordner muss die report.json von design, analyse, compare oder voxels enthalten, hier {}, die kein JSON enthält: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>a folder must hold the report.json of design, analyse, compare or voxels, got {}: {}</source>
        <translation>ein Ordner muss die report.json von design, analyse, compare oder voxels enthalten, hier {}: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a job must be JSON: {}</source>
        <translation>ein Auftrag muss JSON sein: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/jobs.py"/>
        <source>a job must have the sites of 1 prism, or those of faces, got {} prisms and {} faces in {}</source>
        <translation>ein Auftrag muss die Stellen von 1 Prisma haben oder die von Flächen, hier {} Prismen und {} Flächen in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a job needs at least one coupling, got {}</source>
        <translation>ein Auftrag braucht mindestens eine Kopplung, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a job needs either an envelope file or a prism, got {}</source>
        <translation>ein Auftrag braucht eine Hüllkörperdatei oder ein Prisma, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a job's numbers must be finite, got {}</source>
        <translation>die Zahlen eines Auftrags müssen endlich sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a key of a job may stand once in its object, got {} twice</source>
        <translation>ein Schlüssel eines Auftrags darf in seinem Objekt einmal stehen, hier {} zweimal</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>a law must be one of {}, got {}</source>
        <translation>ein Gesetz muss eines von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>a law's bounds must be finite numbers, got {} and {}</source>
        <translation>die Grenzen eines Gesetzes müssen endliche Zahlen sein, hier {} und {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>a law's bounds must satisfy low &lt;= high, got {} and {}</source>
        <translation>für die Grenzen eines Gesetzes muss kleinster &lt;= größter Wert gelten, hier {} und {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>a layer</source>
        <translation>eine Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a layer along {} holds {} voxels, but layer {} is asked for {}</source>
        <translation>eine Schicht entlang {} fasst {} Voxel, aber von Schicht {} sind {} verlangt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a layer along {} holds {} voxels, but the area {} mm² of layer {} asks for {}</source>
        <translation>eine Schicht entlang {} fasst {} Voxel, aber die Fläche {} mm² von Schicht {} verlangt {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/layer_outlines.py"/>
        <source>a layer must be an array of two axes, got {}</source>
        <translation>eine Schicht muss ein Feld mit zwei Achsen sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/voxel_shapes.py"/>
        <source>a layer must be one of 0..{}, got {}</source>
        <translation>eine Schicht muss eine von 0..{} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>a layer must be thinner than the least radius of its face's curvature: at {} mm {} of {} triangles fold</source>
        <translation>eine Schicht muss dünner sein als der kleinste Krümmungsradius ihrer Fläche: bei {} mm falten sich {} von {} Dreiecken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>a layer must be thinner than the least radius of its face's curvature: at {} mm {} of {} triangles fold, and smoothing does not help</source>
        <translation>eine Schicht muss dünner sein als der kleinste Krümmungsradius ihrer Fläche: bei {} mm falten sich {} von {} Dreiecken, auch geglättet</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a layer's thickness must be greater than 0, got {}</source>
        <translation>die Dicke einer Schicht muss größer als 0 sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/arguments.py"/>
        <source>a list of objects is needed, got {}</source>
        <translation>nötig ist eine Liste von Objekten, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/arguments.py"/>
        <source>a list of whole numbers is needed, got {}</source>
        <translation>nötig ist eine Liste ganzer Zahlen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>a mask for these targets must have the shape {}, got {}</source>
        <translation>eine Maske muss für diese Zielwerte die Form {} haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masks.py"/>
        <source>a mask must be in one part, got parts of {} and {} cells</source>
        <translation>eine Maske muss aus einem Teil bestehen, hier Teile von {} und {} Zellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masks.py"/>
        <source>a mask must have at least one cell, got {}</source>
        <translation>eine Maske muss mindestens eine Zelle haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>a mask must have at least one cell; {} has in the targets' box, got {}</source>
        <translation>eine Maske muss mindestens eine Zelle haben; {} hat im Quader der Zielwerte, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>a mask must have at least one voxel, got 0</source>
        <translation>eine Maske muss mindestens ein Voxel haben, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_formats.py"/>
        <source>a mesh format must be one of {}, got {}</source>
        <translation>ein Netzformat muss eines von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>a mesh must be closed to be filled with voxels: {}</source>
        <translation>ein Netz muss geschlossen sein, um mit Voxeln gefüllt zu werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_solids.py"/>
        <source>a mesh must be closed to become a solid, got {} holes with {} open edges</source>
        <translation>ein Netz muss geschlossen sein, um Volumenkörper zu werden, hier {} Löcher mit {} offenen Kanten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/slabs.py"/>
        <source>a mesh must have at least one triangle, got 0</source>
        <translation>ein Netz muss mindestens ein Dreieck haben, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/meshes.py"/>
        <source>a mesh must have at least one vertex to have bounds, got 0</source>
        <translation>ein Netz muss für Grenzen mindestens eine Ecke haben, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_solids.py"/>
        <source>a mesh must have at most {} triangles to become a solid, got {}: reduce it (Mesh &gt; Decimation) or give a STEP file</source>
        <translation>ein Netz darf höchstens {} Dreiecke haben, um Volumenkörper zu werden, hier {}: verringern (Mesh &gt; Dezimieren) oder eine STEP-Datei nehmen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_solids.py"/>
        <source>a mesh must have triangles, got 0</source>
        <translation>ein Netz muss Dreiecke haben, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_solids.py"/>
        <source>a mesh must have two triangles at each edge, turned alike, to become a solid; got {} edges of more than two and {} edges of triangles turned unevenly</source>
        <translation>ein Netz muss an jeder Kante zwei gleich gewendete Dreiecke haben, um Volumenkörper zu werden; hier {} Kanten von mehr als zwei und {} Kanten ungleich gewendeter Dreiecke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/voxelise.py"/>
        <source>a mesh to be voxelised must have at least one triangle, got 0</source>
        <translation>ein Netz muss für Voxel mindestens ein Dreieck haben, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preview_worker.py"/>
        <source>a newer preview is wanted</source>
        <translation>eine neuere Vorschau ist gewünscht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/registry.py"/>
        <source>a number must be one of {} that are explained, got {}</source>
        <translation>eine Zahl muss eine von {} erklärten sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/patchwork.py"/>
        <source>a patchwork needs a closed mesh each of whose edges has two triangles</source>
        <translation>ein Flickwerk braucht ein geschlossenes Netz, dessen Kanten je zwei Dreiecke haben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a path's tension must be greater than 0, got {}</source>
        <translation>die Spannung eines Pfads muss größer als 0 sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>a pitch must be three lengths above 0, got {}</source>
        <translation>ein Abstand muss aus drei Längen über 0 bestehen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/edits.py"/>
        <source>a point must be three numbers in mm, got {}</source>
        <translation>ein Punkt muss aus drei Zahlen in mm bestehen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/presets.py"/>
        <source>a preset must be one of {}, got {}</source>
        <translation>eine Vorlage muss eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>a profile to be compared must have slices, {} has none along {}</source>
        <translation>ein Profil muss zum Vergleich Schnitte haben, {} hat keine entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>a quantity must be one of {}, got {}</source>
        <translation>eine Größe muss eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>a range of layers must satisfy low &lt; high, got {}</source>
        <translation>für einen Bereich von Schichten muss unten &lt; oben gelten, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>a range only was sliced</source>
        <translation>nur ein Bereich wurde geschnitten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/report_sections.py"/>
        <source>a report must have something to tell, got nothing in {}: {}</source>
        <translation>ein Bericht muss etwas zu berichten haben, hier nichts in {}: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/spline_solids.py"/>
        <source>a rod must be a valid solid of positive volume, got {} mm3 for rod {}</source>
        <translation>ein Stab muss ein gültiger Volumenkörper mit positivem Volumen sein, hier {} mm3 für Stab {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/rod_solids.py"/>
        <source>a rod must be a valid solid, got one that is not for rod {}</source>
        <translation>ein Stab muss ein gültiger Volumenkörper sein, Stab {} ist es nicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/rod_solids.py"/>
        <source>a rod's solid must have its mesh's volume within {}, got {} and {} mm3 for rod {}</source>
        <translation>der Volumenkörper eines Stabs muss das Volumen seines Netzes auf {} haben, hier {} und {} mm3 für Stab {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>a row must have 0 &lt;= v &lt;= N and voxels &gt;= 0, got {}</source>
        <translation>für eine Zeile muss 0 &lt;= v &lt;= N und Voxel &gt;= 0 gelten, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>a row of {} does not fit into its ranks</source>
        <translation>eine Zeile von {} passt nicht in ihre Ränge</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>a sample must be numbered 0 to {}, got {}</source>
        <translation>eine Probe muss mit 0 bis {} nummeriert sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>a sample must have a mesh or a shape, got {} without one</source>
        <translation>eine Probe muss ein Netz oder eine Form haben, {} hat keines von beiden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/texture_fit.py"/>
        <source>a sample must have a surface to fit a texture to, got one that is empty or full</source>
        <translation>eine Probe muss für eine Textur eine Oberfläche haben, hier ist sie leer oder voll</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>a sample must have at least one triangle, got 0</source>
        <translation>eine Probe muss mindestens ein Dreieck haben, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a sample must have material and voids: of {} cells are solid, got {}</source>
        <translation>eine Probe muss Material und Hohlräume haben: von {} Zellen sind voll, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thresholds.py"/>
        <source>a sample must have material and voids: of {} voxels above {} are solid</source>
        <translation>eine Probe muss Material und Hohlräume haben: von {} Voxeln über {} sind voll</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thresholds.py"/>
        <source>a sample must have material and voids: of {} voxels above {} are solid, got {}</source>
        <translation>eine Probe muss Material und Hohlräume haben: von {} Voxeln über {} sind voll, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thresholds.py"/>
        <source>a sample must have material and voids: of {} voxels are solid</source>
        <translation>eine Probe muss Material und Hohlräume haben: von {} Voxeln sind voll</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thresholds.py"/>
        <source>a sample must have material and voids: of {} voxels are solid, got {}</source>
        <translation>eine Probe muss Material und Hohlräume haben: von {} Voxeln sind voll, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a sample must have material: its sliced areas make, got {}</source>
        <translation>eine Probe muss Material haben: ihre Schnittflächen ergeben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a sample must have voids: of {} cells its sliced areas fill, got {}</source>
        <translation>eine Probe muss Hohlräume haben: von {} Zellen füllen ihre Schnittflächen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>a sample's mesh must be closed, got an open area of {} mm²: mend it first (Mesh &gt; Analyze &gt; Evaluate and repair)</source>
        <translation>das Netz einer Probe muss geschlossen sein, hier eine offene Fläche von {} mm²: es zuerst reparieren (Arbeitsbereich Mesh: Auswerten und reparieren)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>a sample's mesh must not be inside out; its volume is, got {}</source>
        <translation>das Netz einer Probe darf nicht umgestülpt sein; sein Volumen ist, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thresholds.py"/>
        <source>a scan must have more than one grey value to be parted by Otsu's threshold, got {}</source>
        <translation>ein Scan muss für Otsus Schwelle mehr als einen Grauwert haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scripts.py"/>
        <source>a script must have a design, an analysis or voxels to make, got none in {}</source>
        <translation>ein Skript muss einen Entwurf, eine Analyse oder Voxel erzeugen, hier nichts in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a setting must read name=value, got {}</source>
        <translation>eine Einstellung muss Name=Wert lauten, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/files.py"/>
        <source>a shape must have faces to be written into {}, got none</source>
        <translation>eine Form muss Flächen haben, um in {} geschrieben zu werden, hier keine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>a shape that is cut must have at least one solid, got none</source>
        <translation>eine geschnittene Form muss mindestens einen Volumenkörper haben, hier keinen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/workbook.py"/>
        <source>a sheet of a workbook holds at most {} contours, got {} along {}; thicker layers have fewer</source>
        <translation>ein Tabellenblatt fasst höchstens {} Konturen, hier {} entlang {}; dickere Schichten haben weniger</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_sites.py"/>
        <source>a site placed by hand</source>
        <translation>eine von Hand gesetzte Stelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a site's co-ordinate</source>
        <translation>eine Koordinate einer Stelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a site's name must read face.i.j, got {}</source>
        <translation>der Name einer Stelle muss face.i.j lauten, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>a sliced area along {} must not be larger than its layer, got {} of it at {}</source>
        <translation>eine Schnittfläche entlang {} darf nicht größer als ihre Schicht sein, hier {} davon bei {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>a sliced area along {} must not be negative, got {} of it at {}</source>
        <translation>eine Schnittfläche entlang {} darf nicht negativ sein, hier {} davon bei {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_solids.py"/>
        <source>a solid from a mesh must have its volume of {} mm3, got {} mm3</source>
        <translation>ein Volumenkörper aus einem Netz muss dessen Volumen von {} mm3 haben, hier {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/tessellation.py"/>
        <source>a solid must have a volume greater than 0, got {} mm3: it is empty or inside out</source>
        <translation>ein Volumenkörper muss ein Volumen größer als 0 haben, hier {} mm3: er ist leer oder umgestülpt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>a solid must not cross itself; {} pairs of its triangles do, the longest crossing is {} mm at ({}) mm</source>
        <translation>ein Volumenkörper darf sich nicht durchdringen; {} Paare seiner Dreiecke tun es, die längste Durchdringung ist {} mm bei ({}) mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/patch_solids.py"/>
        <source>a solid of patches has no closed voids, got {}</source>
        <translation>ein Volumenkörper aus Flicken hat keine geschlossenen Hohlräume, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>a solid scaffold must have all its channels: the B-Rep engine came to {} of {} rods, then {}; the mesh scaffold stands</source>
        <translation>ein Gerüst als Volumenkörper muss alle Kanäle haben: das B-Rep-Verfahren kam bis {} von {} Stäben, dann {}; das Netzgerüst bleibt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/patch_solids.py"/>
        <source>a solid's faces must be bounded by seams that do not cross, got {} of {} seams of surfaces that nearly touch</source>
        <translation>die Flächen eines Volumenkörpers müssen von Nähten begrenzt sein, die sich nicht kreuzen, hier {} von {} Nähten fast berührender Flächen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/variants.py"/>
        <source>a spread must be that of at least 1 value, got 0</source>
        <translation>eine Streuung braucht mindestens 1 Wert, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_triangles.py"/>
        <source>a surface must be told by {} points at most, got {} x {}</source>
        <translation>eine Oberfläche darf durch höchstens {} Punkte beschrieben sein, hier {} x {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/patchwork.py"/>
        <source>a surface of a patchwork must meet others, got one that is closed in itself</source>
        <translation>eine Fläche eines Flickwerks muss andere treffen, hier ist eine in sich geschlossen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a tangent component of the pore at {}</source>
        <translation>eine Tangentenkomponente der Pore bei {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/tasks.py"/>
        <source>a task must have an object to compute, got none</source>
        <translation>eine Aufgabe muss ein Objekt zu berechnen haben, hier keines</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>a tenth of the void has spheres up to it</source>
        <translation>ein Zehntel des Hohlraums hat Kugeln bis zu diesem Durchmesser</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/thickness.py"/>
        <source>a thickness needs a surface, got voxels that are all on one side of it</source>
        <translation>eine Dicke braucht eine Oberfläche, hier liegen alle Voxel auf einer Seite</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_triangles.py"/>
        <source>a trimmed face must have no kink inside</source>
        <translation>eine beschnittene Fläche darf innen keinen Knick haben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_triangles.py"/>
        <source>a trimmed face with a seam or a pole must be bent both ways</source>
        <translation>eine beschnittene Fläche mit Naht oder Pol muss in beide Richtungen gebogen sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_triangles.py"/>
        <source>a trimmed face with a seam or a pole must not turn away from its middle plane</source>
        <translation>eine beschnittene Fläche mit Naht oder Pol darf sich nicht von ihrer Mittelebene abwenden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/arguments.py"/>
        <source>a value of the type {} is needed, got {}</source>
        <translation>nötig ist ein Wert der Art {}, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>a variant must have rods, got none with seed {}</source>
        <translation>eine Variante muss Stäbe haben, hier keine mit Startwert {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_panel.py"/>
        <source>a voxel design needs a sample, got none: choose an object or a file, or draw it</source>
        <translation>ein Voxelentwurf braucht eine Probe, hier keine: ein Objekt oder eine Datei wählen, oder sie zeichnen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a voxel must have three edges above 0, got {}</source>
        <translation>ein Voxel muss drei Kanten über 0 haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a voxel must not be larger than the sample, {} mm along {}, got {}</source>
        <translation>ein Voxel darf nicht größer als die Probe sein, {} mm entlang {}, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>a voxel's edges must be at least {} mm, got {}</source>
        <translation>die Kanten eines Voxels müssen mindestens {} mm sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>a wavelength must be 0 (fitted) or more, got {}</source>
        <translation>eine Wellenlänge muss 0 (angepasst) oder mehr sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/workbook.py"/>
        <source>a workbook needs openpyxl</source>
        <translation>eine Arbeitsmappe braucht openpyxl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>a {} without one</source>
        <translation>{} ohne einen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/estimates.py"/>
        <source>about {} s</source>
        <translation>etwa {} s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>alignment must be one of {}, got {}</source>
        <translation>die Ausrichtung muss eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>all held</source>
        <translation>alle bestanden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>all images of a stack must have one size, {} pixels, but {} has {}</source>
        <translation>alle Bilder eines Stapels müssen eine Größe haben, {} Pixel, aber {} hat {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <source>all layers must have one thickness, got {} to {} mm in {} layers</source>
        <translation>alle Schichten müssen gleich dick sein, hier {} bis {} mm in {} Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>all layers must have the voxels asked for, but {} have not: {}</source>
        <translation>alle Schichten müssen die verlangten Voxel haben, aber {} haben sie nicht: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>all, processor time</source>
        <translation>alle, Prozessorzeit</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>along</source>
        <translation>entlang</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/path_laws.py"/>
        <source>along the normal</source>
        <translation>entlang der Normalen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>along {} no slice has any area</source>
        <translation>entlang {} hat kein Schnitt eine Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>along {} {}</source>
        <translation>entlang {} {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>along {} {} (the widest gap: {} mm)</source>
        <translation>entlang {} {} (die breiteste Lücke: {} mm)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>along {} {} of at most {} mm2 left out of all counts</source>
        <translation>entlang {} {} mit höchstens {} mm2 bei keiner Zahl mitgezählt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>along {} {} of {} slices are spoilt: layers {}</source>
        <translation>entlang {} sind {} von {} Schnitten fehlerhaft: Schichten {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>alpha and beta must be whole numbers with blanks between, got {}</source>
        <translation>Alpha und Beta müssen ganze Zahlen mit Leerzeichen dazwischen sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>alpha and beta must have the same counts in the layers along Z, got {}</source>
        <translation>alpha und beta müssen dieselben Anzahlen in den Schichten entlang Z haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/propagation_steps.py"/>
        <source>alpha and beta must have the same sum, got {}</source>
        <translation>alpha und beta müssen dieselbe Summe haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>an analysis along X, Y and Z is needed; {} has, got {}</source>
        <translation>eine Analyse entlang X, Y und Z wird gebraucht; {} hat, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>an axis must be x, y, z or a direction of three numbers such as 0.6,0.8,0, got {}</source>
        <translation>eine Achse muss x, y, z oder eine Richtung aus drei Zahlen wie 0.6,0.8,0 sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_triangles.py"/>
        <source>an edge of a curved face must have its parameters on the surface</source>
        <translation>eine Kante einer gekrümmten Fläche muss ihre Parameter auf der Fläche haben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>an edge of the box of middle points</source>
        <translation>eine Kante des Quaders der Mittelpunkte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>an envelope file needs faces with sites, got {}</source>
        <translation>eine Hüllkörperdatei braucht Flächen mit Stellen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/jobs.py"/>
        <source>an envelope must be a box or come from a file to be kept in a job, got {}; export it as STEP and name that file</source>
        <translation>ein Hüllkörper muss ein Quader sein oder aus einer Datei stammen, um in einem Auftrag zu stehen, hier {}; als STEP exportieren und diese Datei nennen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>an envelope must be a closed solid, got an open one of {} faces</source>
        <translation>ein Hüllkörper muss ein geschlossener Volumenkörper sein, hier ein offener mit {} Flächen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>an envelope must be a valid solid; the kernel finds: {}</source>
        <translation>ein Hüllkörper muss ein gültiger Volumenkörper sein; der Kern findet: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>an envelope must be at most {} mm large, got {} mm</source>
        <translation>ein Hüllkörper darf höchstens {} mm groß sein, hier {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>an envelope must be one closed solid, got a {} of {} faces and no solid</source>
        <translation>ein Hüllkörper muss ein geschlossener Volumenkörper sein, hier {} mit {} Flächen und kein Volumenkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>an envelope must be one closed solid, got a {} of {} faces and no solid (closed: make a solid of it first)</source>
        <translation>ein Hüllkörper muss ein geschlossener Volumenkörper sein, hier {} mit {} Flächen und kein Volumenkörper (geschlossen: zuerst einen Volumenkörper daraus machen)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>an envelope must have a shape, got an empty one</source>
        <translation>ein Hüllkörper muss eine Form haben, hier eine leere</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/envelope.py"/>
        <source>an envelope must have a shape, got nothing</source>
        <translation>ein Hüllkörper muss eine Form haben, hier nichts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/envelope.py"/>
        <source>an envelope must have a shape, got {} without one</source>
        <translation>ein Hüllkörper muss eine Form haben, hier {} ohne eine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>an envelope must have a volume greater than 0 mm3, got {} mm3</source>
        <translation>ein Hüllkörper muss ein Volumen größer als 0 mm3 haben, hier {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>an equation must have n &gt;= 0 and k &gt;= 1, got {}</source>
        <translation>eine Gleichung muss n &gt;= 0 und k &gt;= 1 haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>an estimate can be made for the mesh or the field engine, got {}</source>
        <translation>geschätzt werden kann für das Netz- oder das Feldverfahren, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/examples.py"/>
        <source>an example must be one of {}, got {}</source>
        <translation>ein Beispiel muss eines von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>an expression holds numbers only, got {} in {}</source>
        <translation>eine Formel enthält nur Zahlen, hier {} in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>an expression must have 1 to {} characters, got {}</source>
        <translation>eine Formel muss 1 bis {} Zeichen haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/arguments.py"/>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>an object of a document is needed, got {}</source>
        <translation>nötig ist ein Objekt eines Dokuments, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>analyses to be compared must have an axis in common, got {}</source>
        <translation>Analysen müssen zum Vergleich eine Achse gemeinsam haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>analyses to be compared must share at least one layer of {} mm along {}, got {}</source>
        <translation>Analysen müssen zum Vergleich mindestens eine Schicht von {} mm entlang {} gemeinsam haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>another program's slices in the tests; of solids the kernel's own sections (make.exact_slices)</source>
        <translation>Schnitte eines anderen Programms in den Tests; bei Volumenkörpern die Schnitte des Kerns (make.exact_slices)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>another seed, counts that differ less between layers or a strategy that fills tables may do</source>
        <translation>ein anderer Startwert, Anzahlen, die sich von Schicht zu Schicht weniger unterscheiden, oder eine Strategie, die Tabellen füllt, könnten helfen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>area and volume of the triangles, BS/BV</source>
        <translation>Fläche und Volumen der Dreiecke, BS/BV</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>area of an outer contour less those of its holes</source>
        <translation>Fläche einer äußeren Kontur ohne die ihrer Löcher</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>area of the triangles, those in the box's faces (cuts) left out</source>
        <translation>Fläche der Dreiecke, ohne die in den Quaderflächen (Anschnitte)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>areas must be given along X, Y and Z, got {}</source>
        <translation>Flächen müssen entlang X, Y und Z gegeben sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>areas must be one of {}, got {}</source>
        <translation>Flächen müssen eines von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rod_colours.py"/>
        <source>as drawn</source>
        <translation>wie gezogen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>asked for</source>
        <translation>verlangt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>at</source>
        <translation>bei</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>at given heights</source>
        <translation>auf gegebenen Höhen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>at most</source>
        <translation>höchstens</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>at most 0.2 % apart</source>
        <translation>höchstens 0,2 % auseinander</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>at most {} of the envelope apart; with the field engine {}</source>
        <translation>höchstens {} des Hüllkörpers auseinander; mit dem Feldverfahren {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>at most {} standard errors of the rays apart</source>
        <translation>höchstens {} Standardfehler der Strahlen auseinander</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>at the layers' bottoms</source>
        <translation>an der Unterseite der Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>at the layers' middles</source>
        <translation>in der Mitte der Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>at, mm</source>
        <translation>bei, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>available less left is the number of rods</source>
        <translation>verfügbare minus übrige Stellen ist die Zahl der Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>available sites that the coupling did not use</source>
        <translation>verfügbare Stellen, die die Kopplung nicht nutzte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/texture.py"/>
        <source>axes of a texture must be three unit vectors at right angles, got {}</source>
        <translation>Achsen einer Textur müssen drei Einheitsvektoren im rechten Winkel sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>b_u, mm</source>
        <translation>b_u, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>b_v, mm</source>
        <translation>b_v, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/on_demand.py"/>
        <source>being computed</source>
        <translation>wird berechnet</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/best_layer.py"/>
        <source>best layers</source>
        <translation>beste Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>blocks of 2 x 2 x 2 voxels with two opposite corners alone of their kind, solid or void</source>
        <translation>Blöcke von 2 x 2 x 2 Voxeln, in denen zwei gegenüberliegende Ecken allein von ihrer Art sind, voll oder leer</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <source>bodies must be of {}, got {}</source>
        <translation>Körper müssen von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>bone fraction</source>
        <translation>Knochenanteil</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>bone fraction BV/TV</source>
        <translation>Knochenanteil BV/TV</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>bone surface</source>
        <translation>Knochenoberfläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>bone volume</source>
        <translation>Knochenvolumen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>bone volume fraction</source>
        <translation>Knochenvolumenanteil</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>bone volume fraction, by voxels</source>
        <translation>Knochenvolumenanteil aus Voxeln</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>border a_x, a_y, a_z, mm</source>
        <translation>Rand a_x, a_y, a_z, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>both routes</source>
        <translation>beide Wege</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>bounds and sum must not be negative, got {}</source>
        <translation>Grenzen und Summe dürfen nicht negativ sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/branches.py"/>
        <source>branches</source>
        <translation>Äste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>branches a mm</source>
        <translation>Äste je mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>branches per mm</source>
        <translation>Äste je mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>branches: chains of trabeculae that go on without an event</source>
        <translation>Äste: Ketten von Trabekeln, die ohne Ereignis weitergehen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <source>building the {}</source>
        <translation>{} wird erzeugt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>by another</source>
        <translation>auf dem anderen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>by one route</source>
        <translation>auf einem Weg</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>c_u, mm</source>
        <translation>c_u, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>c_v, mm</source>
        <translation>c_v, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/marching.py"/>
        <source>case {}: no triangulation without chords in faces</source>
        <translation>Fall {}: keine Triangulierung ohne Sehnen in Flächen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <source>casting rays</source>
        <translation>Strahlen werden verfolgt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>cavities found from the shells of the scaffold and from those of the channels</source>
        <translation>Hohlräume, gefunden aus den Hüllen des Gerüsts und aus denen der Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>cavities seen from inside and from outside</source>
        <translation>Hohlräume von innen und von außen gesehen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>cell ({}, {}) is {}, beyond its bound {}</source>
        <translation>Zelle ({}, {}) ist {}, über ihrer Grenze {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>cells of {} mm</source>
        <translation>Zellen von {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>chains of trabeculae that go on from slice to slice, each overlapping one of the next and no other, over the distance from the first slice to the last</source>
        <translation>Ketten von Trabekeln, die von Schnitt zu Schnitt weitergehen, jedes überlappt genau eines des nächsten, durch den Abstand vom ersten zum letzten Schnitt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>changes by hand</source>
        <translation>Änderungen von Hand</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>channels by triangles and by rays, mm3</source>
        <translation>Kanäle aus Dreiecken und aus Strahlen, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>channels can be shown once a scaffold is built, got none: build the scaffold first</source>
        <translation>Kanäle können gezeigt werden, sobald ein Gerüst gebaut ist, hier keines: zuerst das Gerüst bauen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>checks</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>checks that failed</source>
        <translation>misslungene Prüfungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>choice</source>
        <translation>Wahl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>choice of the convergence point</source>
        <translation>die Wahl des Konvergenzpunkts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>clock time of cutting the channels</source>
        <translation>Uhrzeit für das Schneiden der Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>clock time of targets, design and mesh</source>
        <translation>Uhrzeit für Zielwerte, Entwurf und Netz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>closed cavities</source>
        <translation>geschlossene Hohlräume</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>closed contour</source>
        <translation>geschlossene Kontur</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>closed layers need a Boolean, which takes them out of the rods, and that needs manifold3d: {}; or choose layers that are not closed</source>
        <translation>geschlossene Schichten brauchen eine boolesche Operation, die sie aus den Stäben nimmt, und dafür manifold3d: {}; oder nicht geschlossene Schichten wählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>closed shells of its triangles, the voids inside one counted with it</source>
        <translation>geschlossene Hüllen seiner Dreiecke, innere Hohlräume mit ihnen gezählt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>closed shells of their triangles, the holes inside one counted with it</source>
        <translation>geschlossene Hüllen ihrer Dreiecke, innere Löcher mit ihnen gezählt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>closed voids</source>
        <translation>geschlossene Hohlräume</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>closed voids are {} of the envelope: many channels have no way out</source>
        <translation>geschlossene Hohlräume sind {} des Hüllkörpers: viele Kanäle haben keinen Ausgang</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>co-ordinate along the axis, mm</source>
        <translation>Koordinate entlang der Achse, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/meshes.py"/>
        <source>co-ordinates must be finite and below 3.4e38 mm for a file, got {}</source>
        <translation>Koordinaten müssen für eine Datei endlich und unter 3.4e38 mm sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <source>co-ordinates of rods must be finite, got nan or infinite mm</source>
        <translation>Koordinaten von Stäben müssen endlich sein, hier nan oder unendlich mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rays.py"/>
        <source>co-ordinates of triangles must be finite, got nan or infinite mm</source>
        <translation>Koordinaten von Dreiecken müssen endlich sein, hier nan oder unendlich mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>common total less the sum of an axis' rounded counts</source>
        <translation>gemeinsame Summe minus die Summe der gerundeten Anzahlen einer Achse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>compact layer</source>
        <translation>kompakte Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>components (6-neighbours)</source>
        <translation>Teile (6 Nachbarn)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>connected channels</source>
        <translation>zusammenhängende Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>connected parts</source>
        <translation>zusammenhängende Teile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>connected pieces of the channels that touch no face of the envelope</source>
        <translation>zusammenhängende Teile der Kanäle, die keine Fläche des Hüllkörpers berühren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>connected pieces of the scaffold</source>
        <translation>zusammenhängende Teile des Gerüsts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>connected pieces of the scaffold that channels cut off all round; they are taken away unless they are to be kept</source>
        <translation>zusammenhängende Teile des Gerüsts, die Kanäle ringsum abtrennen; sie werden entfernt, wenn sie nicht behalten werden sollen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>connectivity</source>
        <translation>Konnektivität</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>connectivity density</source>
        <translation>Konnektivitätsdichte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/contacts.py"/>
        <source>contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>contacts by a corner alone</source>
        <translation>Kontakte nur über eine Ecke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>contacts by an edge alone</source>
        <translation>Kontakte nur über eine Kante</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>contour filter, closed, mm</source>
        <translation>Konturfilter, geschlossen, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>contour filter, open, mm</source>
        <translation>Konturfilter, offen, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>contours a slice</source>
        <translation>Konturen je Schnitt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>contours counted above, mm2</source>
        <translation>Konturen gezählt ab mehr als, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/contours.py"/>
        <source>contours must have one start more than planes, and as many points as the last start says, got {} starts, {} planes, {} marks, points {}</source>
        <translation>Konturen brauchen einen Anfang mehr als Ebenen und so viele Punkte, wie der letzte Anfang sagt, hier {} Anfänge, {} Ebenen, {} Marken, Punkte {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/contours.py"/>
        <source>contours must lie in the order of their planes, 0..{}</source>
        <translation>Konturen müssen in der Reihenfolge ihrer Ebenen liegen, 0..{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>contours of more area than the least</source>
        <translation>Konturen mit mehr als der Mindestfläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>contours of more area than the least on a slice, holes among them: the thesis' number of trabeculae</source>
        <translation>Konturen eines Schnitts mit mehr als der Mindestfläche, auch Löcher: die Trabekelzahl der Dissertation</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>contours that are no holes</source>
        <translation>Konturen, die keine Löcher sind</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>contours that are no rods, voids among them (their area is negative)</source>
        <translation>Konturen, die keine Stäbe sind, auch Hohlräume (ihre Fläche ist negativ)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>contours were filtered</source>
        <translation>Konturen wurden gefiltert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>contours were offset</source>
        <translation>Konturen wurden versetzt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>contours were smoothed</source>
        <translation>Konturen wurden geglättet</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>contours whose area is at least 0.6 of their box</source>
        <translation>Konturen, deren Fläche mindestens 0,6 ihres Rechtecks ist</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>count of the pairs that were coupled</source>
        <translation>Anzahl der gekoppelten Paare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>count of the solid voxels</source>
        <translation>Anzahl der vollen Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>count of the solid voxels of the layer</source>
        <translation>Anzahl der vollen Voxel der Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/entropy_counts.py"/>
        <source>counting by entropy</source>
        <translation>Zählung durch Entropie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>counting it anew</source>
        <translation>erneutes Zählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sampled_layers.py"/>
        <source>counting layers</source>
        <translation>Schichten werden gezählt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sampled_tables.py"/>
        <source>counting tables</source>
        <translation>Tabellen werden gezählt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>counts as often as it overlaps</source>
        <translation>zählt so oft, wie es sich überlappt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>counts once</source>
        <translation>zählt einmal</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/assembly.py"/>
        <source>couplings</source>
        <translation>Kopplungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/slices.py"/>
        <source>cutting triangles</source>
        <translation>Dreiecke werden geschnitten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_sites.py"/>
        <source>d1 and d2 must differ by at least 1 degree on the face, got {} degrees</source>
        <translation>d1 und d2 müssen sich auf der Fläche um mindestens 1 Grad unterscheiden, hier {} Grad</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>definition</source>
        <translation>Definition</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>degree of anisotropy</source>
        <translation>Anisotropiegrad</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>degree of anisotropy, by triangles</source>
        <translation>Anisotropiegrad aus Dreiecken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>delta</source>
        <translation>Delta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masks.py"/>
        <source>densities must be 0 to 1, got {} in layer {} along {}</source>
        <translation>Dichten müssen 0 bis 1 sein, hier {} in Schicht {} entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>design</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>designs are counted in boxes, not in, got {}</source>
        <translation>Entwürfe werden in Quadern gezählt, nicht in, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_search.py"/>
        <source>designs are searched for exhaustively up to {} cells, got {}</source>
        <translation>Entwürfe werden bis {} Zellen vollständig durchsucht, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/variants.py"/>
        <source>designs must have one shape and solid voxels, got shapes {}</source>
        <translation>Entwürfe müssen eine Form und volle Voxel haben, hier die Formen {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>designs with these counts</source>
        <translation>Entwürfe mit diesen Anzahlen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>designs with this design's tables</source>
        <translation>Entwürfe mit den Tabellen dieses Entwurfs</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>diameter of the circle, or side of the square through the corners, as drawn from the law of the pores</source>
        <translation>Durchmesser des Kreises oder Seite des Quadrats durch die Ecken, gezogen nach dem Gesetz der Poren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>diameter of the largest sphere in the solid</source>
        <translation>Durchmesser der größten Kugel im Material</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>diameter of the largest sphere in the void</source>
        <translation>Durchmesser der größten Kugel im Hohlraum</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>difference half way along the shared stretch, linear between the layers' middles</source>
        <translation>Differenz auf halbem Weg der gemeinsamen Strecke, linear zwischen den Mitten der Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>difference in the middle</source>
        <translation>Differenz in der Mitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>difference of the largest size over the shared layers, with its sign; at: the middle of its layer</source>
        <translation>betragsmäßig größte Differenz über die gemeinsamen Schichten, mit Vorzeichen; bei: die Mitte ihrer Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/thickness.py"/>
        <source>distances</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>divergence theorem over its triangles</source>
        <translation>Divergenzsatz über seine Dreiecke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>divergence theorem over its triangles in double precision</source>
        <translation>Divergenzsatz über seine Dreiecke in doppelter Genauigkeit</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>divergence theorem over the triangles of union of the rods and envelope</source>
        <translation>Divergenzsatz über die Dreiecke aus Vereinigung der Stäbe und Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>divergence theorem over their triangles</source>
        <translation>Divergenzsatz über ihre Dreiecke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>dmean area</source>
        <translation>dmean area</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/svg_layers.py"/>
        <source>drawing layers</source>
        <translation>Schichten werden gezeichnet</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_files.py"/>
        <source>drawing {}</source>
        <translation>{} wird gezeichnet</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/profiles.py"/>
        <source>each contour must have one row of measures, got {} and {}</source>
        <translation>jede Kontur muss eine Zeile Maße haben, hier {} und {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>each face must have at least three corners, got {}</source>
        <translation>jede Fläche muss mindestens drei Ecken haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/plane_triangles.py"/>
        <source>each point of a face must be used by its triangles; a border crosses itself</source>
        <translation>jeder Punkt einer Fläche muss von ihren Dreiecken benutzt werden; ein Rand kreuzt sich</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>each variable must have two bounds, got {}</source>
        <translation>jede Variable muss zwei Grenzen haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>each vertex must have three co-ordinates</source>
        <translation>jede Ecke muss drei Koordinaten haben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>edges at which two solid voxels meet across, the other two being void</source>
        <translation>Kanten, an denen sich zwei volle Voxel schräg gegenüberliegen und die anderen zwei leer sind</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>end sections by size</source>
        <translation>Endquerschnitte nach Größe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>engine</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/features/designs.py"/>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>envelope</source>
        <translation>Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>envelope less rods</source>
        <translation>Hüllkörper minus Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>equal layers</source>
        <translation>gleiche Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>equal layers, and pairs of neighbours between which the curves cross</source>
        <translation>gleiche Schichten und Nachbarpaare, zwischen denen sich die Kurven kreuzen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>equal numbers</source>
        <translation>gleiche Zahlen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>equal numbers on every layer of the three axes, or the design is refused</source>
        <translation>gleiche Zahlen auf jeder Schicht der drei Achsen, sonst wird der Entwurf abgelehnt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>equal numbers, or the scaffold is refused</source>
        <translation>gleiche Zahlen, sonst wird das Gerüst abgelehnt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>error: the computation broke off; the report view says where</source>
        <translation>Fehler: die Berechnung brach ab; die Ausgabeansicht sagt, wo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>error: {}</source>
        <translation>Fehler: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/variants.py"/>
        <source>estimate by rays</source>
        <translation>Schätzung mit Strahlen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>estimated area of the end sections</source>
        <translation>geschätzte Fläche der Endquerschnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>estimated area s^2, mm2</source>
        <translation>geschätzte Fläche s^2, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>estimated porosity</source>
        <translation>geschätzte Porosität</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>every axis may be named once, got {}</source>
        <translation>jede Achse darf nur einmal genannt sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/pieces.py"/>
        <source>every cavity must lie in a body, but {} of {} lie in none: the mesh is inside out or crosses itself</source>
        <translation>jeder Hohlraum muss in einem Körper liegen, aber {} von {} liegen in keinem: das Netz ist umgestülpt oder kreuzt sich</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>every face must be named once, got {}</source>
        <translation>jede Fläche darf nur einmal genannt sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>every face must be named once, got {} again in {}</source>
        <translation>jede Fläche darf nur einmal genannt sein, hier {} noch einmal in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>every layer must have its count in a design with {}; none was found</source>
        <translation>jede Schicht muss ihre Anzahl haben, in einem Entwurf mit: {}; keiner wurde gefunden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_moves.py"/>
        <source>every layer must have its count in one part without closed cavities; after {} flips {} layers are off by {} voxels together, layer {} along {} by {}; another seed, fewer restrictions or smaller voxels may do</source>
        <translation>jede Schicht muss ihre Anzahl in einem Teil ohne geschlossene Hohlräume haben; nach {} Tauschschritten fehlen {} Schichten zusammen {} Voxel, Schicht {} entlang {} davon {}; ein anderer Startwert, weniger Einschränkungen oder kleinere Voxel können helfen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/verification.py"/>
        <source>every layer must have its count of voxels; {} layers differ: {}</source>
        <translation>jede Schicht muss ihre Voxelzahl haben; {} Schichten weichen ab: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_moves.py"/>
        <source>exact moves</source>
        <translation>genaue Tauschschritte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>exact slices</source>
        <translation>genaue Schnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_makers.py"/>
        <source>exact slices are those of a solid, got a file</source>
        <translation>genaue Schnitte sind die eines Volumenkörpers, hier eine Datei</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_makers.py"/>
        <source>exact slices are those of a solid, got {}</source>
        <translation>genaue Schnitte sind die eines Volumenkörpers, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>face 1</source>
        <translation>Fläche 1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>face 2</source>
        <translation>Fläche 2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>face sites</source>
        <translation>Stellen der Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>facets</source>
        <translation>Facetten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>facets that are there twice</source>
        <translation>doppelt vorhandene Facetten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>facets that run through others</source>
        <translation>Facetten, die durch andere gehen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>facets turned against their neighbours</source>
        <translation>gegen ihre Nachbarn gedrehte Facetten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>facets without area</source>
        <translation>Facetten ohne Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>failed and left out</source>
        <translation>misslungen und weggelassen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rod_colours.py"/>
        <source>failed, left out</source>
        <translation>misslungen, weggelassen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/assembly.py"/>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>faults</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/texture.py"/>
        <source>field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>fill rule</source>
        <translation>Füllregel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>final sites 1</source>
        <translation>Stellen 1 am Ende</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>final sites 2</source>
        <translation>Stellen 2 am Ende</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/soundness.py"/>
        <source>finding doubles</source>
        <translation>Doppelte werden gesucht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/soundness.py"/>
        <source>finding parts</source>
        <translation>Teile werden gesucht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>floating voxels</source>
        <translation>schwebende Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>formula</source>
        <translation>Formel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>gap fill, iterations</source>
        <translation>Lücken schließen, Durchgänge</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>gap fill, maximum, mm</source>
        <translation>Lücken schließen, höchstens, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>given tables are needed, got none</source>
        <translation>nötig sind gegebene Tabellen, hier keine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>given tables need a strategy that fills layers from them ({}), got {}</source>
        <translation>gegebene Tabellen brauchen eine Strategie, die Schichten aus ihnen füllt ({}), hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>greatest</source>
        <translation>größter</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>half a layer (a whole one with planes at bottoms) times the total variation of the sliced area: Niederreiter 1992, DOI 10.1137/1.9781611970081</source>
        <translation>eine halbe Schicht (eine ganze mit Ebenen an der Unterseite) mal die Gesamtvariation der Schnittfläche: Niederreiter 1992, DOI 10.1137/1.9781611970081</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>half a layer's variation</source>
        <translation>Variation einer halben Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>half of the void has spheres up to it</source>
        <translation>die Hälfte des Hohlraums hat Kugeln bis zu diesem Durchmesser</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>heights must be finite, got {}</source>
        <translation>Höhen müssen endlich sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>heights must be given with at='heights', and only then, got {}</source>
        <translation>Höhen gehören zu at='heights', und nur dazu, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>heights must be numbers between blanks, mm, got {}</source>
        <translation>Höhen müssen Zahlen zwischen Leerzeichen sein, mm, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>heights must rise, got {}</source>
        <translation>Höhen müssen aufsteigen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/slices.py"/>
        <source>heights of planes must be finite and rise</source>
        <translation>Höhen von Ebenen müssen endlich sein und aufsteigen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>how often a faulty rod was drawn anew until it was sound</source>
        <translation>wie oft ein fehlerhafter Stab neu gezogen wurde, bis er fehlerfrei war</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>images must be of the kind {}, got {}</source>
        <translation>Bilder müssen von der Art {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>images of this kind need Pillow</source>
        <translation>Bilder dieser Art brauchen Pillow</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>in the envelope</source>
        <translation>im Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>in the middle</source>
        <translation>in der Mitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>initial sites 1</source>
        <translation>Stellen 1 am Anfang</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>initial sites 2</source>
        <translation>Stellen 2 am Anfang</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>intercepts of lines through the voxels, BS/BV.vox</source>
        <translation>Durchstoßungen von Linien durch die Voxel, BS/BV.vox</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/joining.py"/>
        <source>islands</source>
        <translation>Inseln</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>it must name a site of face {}, which has {} sites</source>
        <translation>sie muss eine Stelle der Fläche {} nennen, die {} Stellen hat</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>it must name a site of one of the faces {}</source>
        <translation>sie muss eine Stelle einer der Flächen {} nennen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>items must show objects of the model, at most {} deep, got {}</source>
        <translation>Bauteile müssen Objekte des Modells zeigen, höchstens {} tief, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>its face, {} so far, is now Face{} of {}</source>
        <translation>seine Fläche, bisher {}, ist jetzt Face{} von {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>its own end</source>
        <translation>sein eigenes Ende</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>its standard deviation</source>
        <translation>ihre Standardabweichung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>its volume against the voxels'</source>
        <translation>sein Volumen gegen das der Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/repair.py"/>
        <source>joining open contours</source>
        <translation>offene Konturen werden verbunden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <source>joining the slabs</source>
        <translation>Scheiben werden verbunden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/neighbours.py"/>
        <source>joining the triangles</source>
        <translation>Dreiecke werden verbunden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/path_laws.py"/>
        <source>joins the sites</source>
        <translation>verbindet die Stellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>junctions a mm</source>
        <translation>Verzweigungen je mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>junctions per mm</source>
        <translation>Verzweigungen je mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>junctions: splits and joins</source>
        <translation>Verzweigungen: Teilungen und Verbindungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>largest</source>
        <translation>größte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>largest alpha, beta</source>
        <translation>größtes alpha, beta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/thickness.py"/>
        <source>largest balls</source>
        <translation>größte Kugeln</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>largest difference</source>
        <translation>größte Differenz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>largest of the tables alpha and beta</source>
        <translation>größter Wert der Tabellen alpha und beta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>largest trabecular area</source>
        <translation>größte Trabekelfläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>largest trabecular separation</source>
        <translation>größter Trabekelabstand</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>largest trabecular thickness</source>
        <translation>größte Trabekeldicke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>largest value of b less largest of a over the shared layers</source>
        <translation>größter Wert von b minus größter von a über die gemeinsamen Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>layer thickness, mm</source>
        <translation>Schichtdicke, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/feasibility.py"/>
        <source>layer {} along {}</source>
        <translation>Schicht {} entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>layer {} along {} is empty between others: no design is one piece</source>
        <translation>Schicht {} entlang {} ist zwischen anderen leer: kein Entwurf hängt zusammen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/verification.py"/>
        <source>layer {} along {}: {} for {}</source>
        <translation>Schicht {} entlang {}: {} statt {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/voxel_shapes.py"/>
        <source>layer {} as solids must hold the {} mm3 of its voxels, the kernel gives {} mm3</source>
        <translation>Schicht {} muss als Volumenkörper die {} mm3 ihrer Voxel enthalten, der Kern gibt {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/layer_fill.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>layers</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>layers N x M x P</source>
        <translation>Schichten N x M x P</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>layers added to it</source>
        <translation>angefügte Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/voxel_shapes.py"/>
        <source>layers as solids</source>
        <translation>Schichten als Volumenkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>layers follow smoothed normals at {} points where a face bends more sharply than {} mm</source>
        <translation>Schichten folgen geglätteten Normalen an {} Punkten, wo eine Fläche schärfer als {} mm gebogen ist</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>layers inwards must leave a part of the envelope, but {} mm take all of it</source>
        <translation>Schichten nach innen müssen einen Teil des Hüllkörpers lassen, {} mm nehmen ihn ganz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>layers inwards that the channels go through are the envelope itself: nothing changes</source>
        <translation>Schichten nach innen, durch die Kanäle gehen, sind der Hüllkörper selbst: nichts ändert sich</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>layers on faces that bend sharply need the package scipy</source>
        <translation>Schichten auf scharf gebogenen Flächen brauchen das Paket scipy</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>layers whose middles (or bottoms) lie in the body</source>
        <translation>Schichten, deren Mitten (oder Unterseiten) im Körper liegen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/feasibility.py"/>
        <source>layers {} along {}</source>
        <translation>Schichten {} entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>least</source>
        <translation>kleinster</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>least and greatest of the variants</source>
        <translation>kleinster und größter Wert der Varianten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>least and greatest of the variants' porosities</source>
        <translation>kleinste und größte Porosität der Varianten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>least cap on alpha and beta with which a table has the layers' sums</source>
        <translation>kleinste Grenzen für alpha und beta, mit denen eine Tabelle die Summen der Schichten hat</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>leave the envelope</source>
        <translation>verlassen den Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rod_colours.py"/>
        <source>leaves the envelope</source>
        <translation>verlässt den Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>left out by smoothing</source>
        <translation>beim Glätten weggelassen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>left out by the filter</source>
        <translation>vom Filter weggelassen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>length of the sample along X, Y, Z over the voxel's edge, rounded</source>
        <translation>Länge der Probe entlang X, Y, Z durch die Kante des Voxels, gerundet</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/estimates.py"/>
        <source>less than 1 s</source>
        <translation>weniger als 1 s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>levelling tables</source>
        <translation>Tabellen werden ausgeglichen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>lines through the voxels, DA</source>
        <translation>Linien durch die Voxel, DA</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>longest half axis of the fabric ellipsoid, by voxels</source>
        <translation>längste Halbachse des Fabric-Ellipsoids aus Voxeln</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>longest mean intercept length</source>
        <translation>längste mittlere Sehnenlänge</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/crossings.py"/>
        <source>looking for triangles that cross</source>
        <translation>Suche nach sich kreuzenden Dreiecken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>loops</source>
        <translation>Schleifen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>loops: ways that part and meet again</source>
        <translation>Schleifen: Wege, die sich trennen und wieder treffen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>loose</source>
        <translation>lose Teile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>loose pieces</source>
        <translation>lose Teile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>loose pieces are {} of the envelope: the channels cut the scaffold apart</source>
        <translation>lose Teile sind {} des Hüllkörpers: die Kanäle zerschneiden das Gerüst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>loose pieces taken away</source>
        <translation>entfernte lose Teile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>m (guessed: the body would be {} mm large)</source>
        <translation>m (geschätzt: der Körper wäre {} mm groß)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>manual design a rod, s (thesis 2.3.3)</source>
        <translation>Entwurf eines Stabs von Hand, s (Dissertation 2.3.3)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>mean bone fraction</source>
        <translation>mittlerer Knochenanteil</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>mean bone fraction, %</source>
        <translation>mittlerer Knochenanteil, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>mean bone fraction, along {} against {}</source>
        <translation>mittlerer Knochenanteil, entlang {} gegen {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>mean deviation</source>
        <translation>mittlere Abweichung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>mean deviation of the trabeculae</source>
        <translation>mittlere Abweichung der Trabekel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>mean difference</source>
        <translation>mittlere Differenz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/anisotropy.py"/>
        <source>mean intercept length</source>
        <translation>mittlere Sehnenlänge (MIL)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>mean of b less mean of a over the shared layers</source>
        <translation>Mittel von b minus Mittel von a über die gemeinsamen Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>mean over the shared layers of sample less first sample</source>
        <translation>Mittel über die gemeinsamen Schichten von Probe minus erster Probe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>mean over the solid of the largest inscribed sphere's diameter</source>
        <translation>Mittel über das Material des Durchmessers der größten einbeschriebenen Kugel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>mean over the void inside the box of the largest inscribed sphere's diameter: mean pore size</source>
        <translation>Mittel über den Hohlraum im Quader des Durchmessers der größten einbeschriebenen Kugel: mittlere Porengröße</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>mean overlap, %</source>
        <translation>mittlere Überlappung, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>mean porosity of the variants</source>
        <translation>mittlere Porosität der Varianten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>mean sliced area</source>
        <translation>mittlere Schnittfläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>mean sliced area, mm2</source>
        <translation>mittlere Schnittfläche, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>mean thickness of the sample</source>
        <translation>mittlere Dicke der Probe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>mean thickness of the sample (2 BV/BS), voxels</source>
        <translation>mittlere Dicke der Probe (2 BV/BS), Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>mean trabecular area of b less that of a</source>
        <translation>mittlere Trabekelfläche von b minus die von a</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/contours.py"/>
        <source>measuring contours</source>
        <translation>Konturen werden vermessen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/soundness.py"/>
        <source>measuring triangles</source>
        <translation>Dreiecke werden vermessen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>meetings</source>
        <translation>Treffpunkte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>mended by</source>
        <translation>behoben durch</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/recovery.py"/>
        <source>mending: {}, {}</source>
        <translation>Reparatur: {}, {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>mesh Booleans need the package manifold3d</source>
        <translation>boolesche Operationen mit Netzen brauchen das Paket manifold3d</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>mesh {}{} of the {}</source>
        <translation>Netz {}{} von {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/texture.py"/>
        <source>mix of sheets and rods must be 0 to 4, got {}</source>
        <translation>die Mischung von Lamellen und Stäben muss 0 bis 4 sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>mm (guessed: the body would be {} mm large)</source>
        <translation>mm (geschätzt: der Körper wäre {} mm groß)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>more than 2 % is noted: the mesh overlaps itself</source>
        <translation>mehr als 2 % wird gemeldet: das Netz überlappt sich selbst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>most solid voxels in a line (x, z) and (y, z)</source>
        <translation>meiste volle Voxel in einer Linie (x, z) und (y, z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>must be a finite number</source>
        <translation>muss eine endliche Zahl sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>must be at least {}</source>
        <translation>muss mindestens {} sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>must be finite</source>
        <translation>müssen endlich sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>must be whole numbers</source>
        <translation>müssen ganze Zahlen sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>must lie in {}..{}</source>
        <translation>muss in {}..{} liegen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>must not be larger than its layer</source>
        <translation>darf nicht größer als ihre Schicht sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>must not be negative</source>
        <translation>dürfen nicht negativ sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>nine tenths of the void have spheres up to it</source>
        <translation>neun Zehntel des Hohlraums haben Kugeln bis zu diesem Durchmesser</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_rules.py"/>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>no closed cavity</source>
        <translation>kein geschlossener Hohlraum</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>no contact{} alone</source>
        <translation>kein Kontakt nur{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_search.py"/>
        <source>no design has these counts: no set of layers contradicts another by itself, but a search of all designs found none</source>
        <translation>kein Entwurf hat diese Anzahlen: keine Schichtengruppe widerspricht für sich einer anderen, aber die Suche aller Entwürfe fand keinen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>no design with these counts exists that has {}</source>
        <translation>kein Entwurf mit diesen Anzahlen hat zugleich: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>no design with these counts exists{}</source>
        <translation>kein Entwurf hat diese Anzahlen{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>no error</source>
        <translation>kein Fehler</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/trabecular.py"/>
        <source>no field was tried</source>
        <translation>kein Feld wurde versucht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/best_layer.py"/>
        <source>no layer has these {} voxels in columns and {} in rows</source>
        <translation>keine Schicht hat diese {} Voxel in Spalten und {} in Zeilen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>no pair of tables was found in {} tries that alpha &lt;= {} and beta &lt;= {} allow: larger caps leave more room</source>
        <translation>in {} Versuchen fand sich kein Tabellenpaar, das alpha &lt;= {} und beta &lt;= {} zulassen: größere Grenzen lassen mehr Raum</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masked_tables.py"/>
        <source>no pair of tables was found within the mask in {} tries{}; strategy trabecular, which needs no tables, may find a design</source>
        <translation>in der Maske wurde in {} Versuchen kein Tabellenpaar gefunden{}; die Strategie trabekulär, die keine Tabellen braucht, findet vielleicht einen Entwurf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/joining.py"/>
        <source>no part with {} voxels was found in the field</source>
        <translation>im Feld wurde kein Teil mit {} Voxeln gefunden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/surfaces.py"/>
        <source>no point of the face's surface lies near ({}) mm</source>
        <translation>kein Punkt der Fläche liegt nahe ({}) mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>no rod may be left out</source>
        <translation>kein Stab darf weggelassen sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>no sample came to its end</source>
        <translation>keine Ziehung kam zu Ende</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>no shape</source>
        <translation>keine Form</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>no solid of patches: {} mm3 against {} of the mesh; then </source>
        <translation>kein Volumenkörper aus Flicken: {} mm3 gegen {} des Netzes; dann </translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>no solid of patches: {}; then </source>
        <translation>kein Volumenkörper aus Flicken: {}; dann </translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masked_tables.py"/>
        <source>no table has these sums: columns {} ask for {}, and the rows can give them {}{}</source>
        <translation>keine Tabelle hat diese Summen: Spalten {} verlangen {}, und die Zeilen können ihnen {}{} geben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>no tolerance: another rule</source>
        <translation>keine Toleranz: eine andere Regel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>no tolerance: it says how far variants are from chance</source>
        <translation>keine Toleranz: es sagt, wie weit Varianten vom Zufall entfernt sind</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>no tolerance: the estimate is the thesis'</source>
        <translation>keine Toleranz: die Schätzung ist die der Dissertation</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>no tolerance: voxels round the surface</source>
        <translation>keine Toleranz: Voxel rund um die Oberfläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/local_scale.py"/>
        <source>no wavelengths were found that bring the numbers of trabeculae near to those asked for</source>
        <translation>keine Wellenlängen wurden gefunden, die die Zahlen der Trabekel den verlangten nahe bringen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>none of {} pairs of tables was compatible; pairing 'constraint' finds them by construction, and lower caps make them likelier</source>
        <translation>keines von {} Tabellenpaaren war verträglich; die Paarung 'constraint' findet sie durch Konstruktion, und kleinere Grenzen machen sie wahrscheinlicher</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/surfaces.py"/>
        <source>none of {} points tried lies inside the face of {} mm2</source>
        <translation>keiner von {} versuchten Punkten liegt in der Fläche von {} mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>normals of the triangles, DA.mesh</source>
        <translation>Normalen der Dreiecke, DA.mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>not all held</source>
        <translation>nicht alle bestanden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>not looked for</source>
        <translation>nicht gesucht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>nothing is left of the envelope: the rods fill it</source>
        <translation>vom Hüllkörper bleibt nichts: die Stäbe füllen ihn</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>number of</source>
        <translation>Anzahl der</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>number of parts</source>
        <translation>Anzahl der Teile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>numbers by two routes</source>
        <translation>Zahlen auf zwei Wegen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/trabeculae.py"/>
        <source>numbers of trabeculae along {} need a sample, or targets that hold them; got neither</source>
        <translation>Trabekelzahlen entlang {} brauchen eine Probe oder Zielwerte, die sie enthalten; hier keines</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>of</source>
        <translation>von</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/plane_offsets.py"/>
        <source>offsets</source>
        <translation>Versätze</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/fill.py"/>
        <source>offsetting contours</source>
        <translation>Konturen werden versetzt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>ok</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_rules.py"/>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>one part</source>
        <translation>ein Teil</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/trabecular.py"/>
        <source>one part needs voxels in every layer between its first and last; along {} layers {} and {} are asked for {} and {} voxels, and {} between them for none</source>
        <translation>ein Teil braucht Voxel in jeder Schicht zwischen erster und letzter; entlang {} sind von Schicht {} und {} {} und {} Voxel verlangt, dazwischen von {} keines</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>one solid of {} must be chosen as the envelope: {}; a compound is taken apart by Part &gt; Compound &gt; Explode compound</source>
        <translation>ein Volumenkörper von {} muss als Hüllkörper gewählt werden: {}; ein Verbund wird im Arbeitsbereich Part zerlegt (Verbund auflösen)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>only a cut that was made can be undone, got 0 cuts</source>
        <translation>nur ein gemachter Schnitt kann zurückgenommen werden, hier 0 Schnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>only a strategy that fills tables, in several parts or with cavities, can have these counts</source>
        <translation>nur eine Strategie, die Tabellen füllt, in mehreren Teilen oder mit Hohlräumen, kann diese Anzahlen haben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>only {} can be called in {}</source>
        <translation>nur {} kann in {} aufgerufen werden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>open contour</source>
        <translation>offene Kontur</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>open edge</source>
        <translation>offene Kante</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>open edges</source>
        <translation>offene Kanten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>operator {} is not allowed in {}</source>
        <translation>der Operator {} ist in {} nicht erlaubt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/on_demand.py"/>
        <source>out of date: update it</source>
        <translation>veraltet: aktualisieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>outer contours</source>
        <translation>äußere Konturen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>outer contours a slice</source>
        <translation>äußere Konturen je Schnitt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>outer contours that are no rods</source>
        <translation>äußere Konturen, die keine Stäbe sind</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>outer contours whose area is at least 0.6 of their box</source>
        <translation>äußere Konturen, deren Fläche mindestens 0,6 ihres Rechtecks ist</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/voxel_shapes.py"/>
        <source>outlines of layers</source>
        <translation>Umrisse der Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>output</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>over the solid</source>
        <translation>über das Material</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>over the void</source>
        <translation>über den Hohlraum</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>overlap of two variants</source>
        <translation>Überlappung zweier Varianten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>overlap to expect of unrelated designs with the same layers</source>
        <translation>zu erwartende Überlappung unabhängiger Entwürfe mit den gleichen Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/variants.py"/>
        <source>overlap with seed {}</source>
        <translation>Überlappung mit Startwert {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>overlaps</source>
        <translation>Überlappungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>overlaps less trabeculae plus parts of the graph: ways that part and meet again</source>
        <translation>Überlappungen minus Trabekel plus Teile des Graphen: Wege, die sich trennen und wieder treffen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>own definition</source>
        <translation>eigene Definition</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>own definition (docs/method.md, section 1)</source>
        <translation>eigene Definition (docs/method.md, Abschnitt 1)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/thickness.py"/>
        <source>painting balls</source>
        <translation>Kugeln werden eingetragen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masked_tables.py"/>
        <source>pairing 'repeat' fills boxes only; pairing 'constraint' works within a mask</source>
        <translation>die Paarung 'repeat' füllt nur Quader; 'constraint' arbeitet in einer Maske</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>pairs of the couplings that are on, less the rods that nothing mended</source>
        <translation>Paare der eingeschalteten Kopplungen minus die Stäbe, die nichts behob</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>part of the balance of all volumes</source>
        <translation>Teil der Bilanz aller Volumen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>parts less handles plus cavities by another program in the tests (scikit-image)</source>
        <translation>Teile minus Henkel plus Hohlräume eines anderen Programms in den Tests (scikit-image)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>parts less handles plus cavities, of the voxels as a closed body</source>
        <translation>Teile minus Henkel plus Hohlräume der Voxel als geschlossener Körper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/designs.py"/>
        <source>parts of a design are {}, got {}</source>
        <translation>Teile eines Entwurfs sind {}, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>parts of a layer's solid voxels, neighbours by an edge of their squares</source>
        <translation>Teile der vollen Voxel einer Schicht, Nachbarn über eine Kante ihrer Quadrate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>parts of solid voxels, neighbours by a face</source>
        <translation>Teile voller Voxel, Nachbarn über eine Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>parts of void voxels, neighbours by a face, that touch no border</source>
        <translation>Teile leerer Voxel, Nachbarn über eine Fläche, die keinen Rand berühren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/labelling.py"/>
        <source>parts of voxels and distances between them need scipy</source>
        <translation>Teile aus Voxeln und Abstände zwischen ihnen brauchen scipy</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>parts that hang together from slice to slice</source>
        <translation>Teile, die von Schnitt zu Schnitt zusammenhängen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>pasted: recompute the document</source>
        <translation>eingefügt: das Dokument neu berechnen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>path</source>
        <translation>Pfad</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>picture of seed {}</source>
        <translation>Bild zu Startwert {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>pieces</source>
        <translation>Teile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>pieces of solid voxels, 26 neighbours</source>
        <translation>Teile voller Voxel, 26 Nachbarn</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>pieces of void voxels, 6 neighbours, that touch no face of the box</source>
        <translation>Teile leerer Voxel, 6 Nachbarn, die keine Quaderfläche berühren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>pieces: {}</source>
        <translation>Teile: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>plain sum of the rods</source>
        <translation>einfache Summe der Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>plain sum of the rods, %</source>
        <translation>einfache Summe der Stäbe, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/slabs.py"/>
        <source>planes must rise, got {}</source>
        <translation>Ebenen müssen aufsteigen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>plates</source>
        <translation>Platten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>plates of all contours</source>
        <translation>Platten aller Konturen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>plates, by that rule</source>
        <translation>Platten, nach dieser Regel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>plates, voids among them</source>
        <translation>Platten, auch Hohlräume</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_files.py"/>
        <source>plots must be one of {}, none, got {}</source>
        <translation>Diagramme müssen eines von {}, none sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/plots.py"/>
        <source>plots need matplotlib</source>
        <translation>Diagramme brauchen matplotlib</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>points along {} must lie apart by at least {}, got {}</source>
        <translation>Punkte entlang {} müssen mindestens {} auseinander liegen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>points of Eq. 2.1 on a prism; points of the co-ordinate lines on other faces</source>
        <translation>Punkte nach Gl. 2.1 auf einem Prisma; Punkte der Koordinatenlinien auf anderen Flächen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>pore diameter, 10 % of the void</source>
        <translation>Porendurchmesser, 10 % des Hohlraums</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>pore diameter, 50 % of the void</source>
        <translation>Porendurchmesser, 50 % des Hohlraums</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>pore diameter, 90 % of the void</source>
        <translation>Porendurchmesser, 90 % des Hohlraums</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>pore layout</source>
        <translation>die Porenform</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>pore sizes must be at least {} mm, got {}</source>
        <translation>Porengrößen müssen mindestens {} mm sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>pores</source>
        <translation>Poren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/assembly.py"/>
        <source>pores and paths</source>
        <translation>Poren und Pfade</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>porosities must be found by one of {}, {}, got {}</source>
        <translation>Porositäten werden durch eines von {}, {} gefunden, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>porosity</source>
        <translation>Porosität</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/colouring.py"/>
        <source>porosity along {}</source>
        <translation>Porosität entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>porosity of a slice</source>
        <translation>Porosität eines Schnitts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>porosity of the STEP scaffold</source>
        <translation>Porosität des STEP-Gerüsts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>porosity of the scaffold</source>
        <translation>Porosität des Gerüsts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>porosity range, %</source>
        <translation>Porosität, Bereich, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>porosity {} % by the {} engine</source>
        <translation>Porosität {} %, Verfahren {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>porosity {} %, {} rods cut; solid and mesh differ by {} %</source>
        <translation>Porosität {} %, {} Stäbe ausgeschnitten; Volumenkörper und Netz unterscheiden sich um {} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>porosity, %</source>
        <translation>Porosität, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>porosity, % (Eq. 2.2)</source>
        <translation>Porosität, % (Gl. 2.2)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>prism l x w x h, mm</source>
        <translation>Prisma l x b x h, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/layer_fill.py"/>
        <location filename="../../freecad_trabecula/core/voxels/strategies/random_layers.py"/>
        <source>random layers</source>
        <translation>zufällige Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/random_layers.py"/>
        <source>random tables; each layer drawn nearly uniformly from all that have these row and column sums</source>
        <translation>zufällige Tabellen; jede Schicht fast gleichverteilt aus allen mit diesen Zeilen- und Spaltensummen gezogen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/sequential.py"/>
        <source>random tables; in each layer line after line, into the lines that need most (thesis case 2)</source>
        <translation>zufällige Tabellen; in jeder Schicht Linie nach Linie, in die Linien, die am meisten brauchen (Dissertation Fall 2)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/minimum_zeros.py"/>
        <source>random tables; in each layer the shortest line first, into the lines that need most (thesis case 1)</source>
        <translation>zufällige Tabellen; in jeder Schicht die kürzeste Linie zuerst, in die Linien, die am meisten brauchen (Dissertation Fall 1)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/best_tables.py"/>
        <source>random tables; of all layers that they allow the one that is highest on the chosen field (linear program)</source>
        <translation>zufällige Tabellen; von allen Schichten, die sie erlauben, die im gewählten Feld höchste (lineares Programm)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>range, mm</source>
        <translation>Bereich, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>rates of compatible tables</source>
        <translation>Anteile verträglicher Tabellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/porosity_estimate.py"/>
        <source>rays</source>
        <translation>Strahlen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rays.py"/>
        <source>rays need closed meshes: each ray must leave as often as it enters; {} rays do not</source>
        <translation>Strahlen brauchen geschlossene Netze: jeder muss so oft austreten wie eintreten; {} tun es nicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rays.py"/>
        <source>rays per direction must be &gt;= 1, got {}</source>
        <translation>Strahlen je Richtung müssen &gt;= 1 sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>rays through the rods' own triangles</source>
        <translation>Strahlen durch die Dreiecke der Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>reading layers</source>
        <translation>Schichten werden gelesen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>redraws must lie in 0..100, got {}</source>
        <translation>Neuziehungen müssen in 0..100 liegen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>relative L1 distance of the profiles: sum |b - a| / sum |a| over the shared layers; 0 = equal</source>
        <translation>relativer L1-Abstand der Profile: Summe |b - a| / Summe |a| über die gemeinsamen Schichten; 0 = gleich</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>relative L2 distance of the profiles: sqrt(sum (b - a)^2 / sum a^2) over the shared layers; 0 = equal</source>
        <translation>relativer L2-Abstand der Profile: Wurzel(Summe (b - a)^2 / Summe a^2) über die gemeinsamen Schichten; 0 = gleich</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/packing.py"/>
        <source>results must be numbers, texts, arrays or records of them, got {}</source>
        <translation>Ergebnisse müssen Zahlen, Texte, Felder oder Datensätze davon sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/packing.py"/>
        <source>results must be of classes of {}, got {}</source>
        <translation>Ergebnisse müssen von Klassen aus {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>rod</source>
        <translation>Stab</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>rod if area / box is at least</source>
        <translation>Stab, wenn Fläche / Rechteck mindestens</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>rod {}{} of {}</source>
        <translation>Stab {}{} von {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <location filename="../../freecad_trabecula/core/porosity_estimate.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>rods</source>
        <translation>Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>rods and plates by a rule that turning the part does not change (report)</source>
        <translation>Stäbe und Platten nach einer Regel, die Drehen des Teils nicht ändert (Bericht)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rod_colours.py"/>
        <source>rods are coloured by one of {}, got {}</source>
        <translation>Stäbe werden nach einem von {} gefärbt, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>rods are designed in a solid or a closed mesh, got {}, which has neither: select a body, or nothing for a new prism</source>
        <translation>Stäbe werden in einem Volumenkörper oder einem geschlossenen Netz entworfen, hier {}, das keines von beiden hat: einen Körper auswählen, oder nichts für ein neues Prisma</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>rods begin on faces with sites, got none: press Pick faces and click them in the view</source>
        <translation>Stäbe beginnen auf Flächen mit Stellen, hier keine: Flächen wählen drücken und sie in der Ansicht anklicken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>rods cut from the STEP scaffold</source>
        <translation>aus dem STEP-Gerüst geschnittene Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>rods join a pair of faces, got no pair: add one in the section Couplings</source>
        <translation>Stäbe verbinden ein Paar von Flächen, hier kein Paar: eines im Abschnitt Kopplungen hinzufügen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>rods left out</source>
        <translation>weggelassene Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/second_routes.py"/>
        <source>rods made, of those that were coupled</source>
        <translation>erzeugte Stäbe von den gekoppelten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>rods mended</source>
        <translation>reparierte Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/nodes.py"/>
        <source>rods must be closed meshes: each ray must leave as often as it enters, {} do not</source>
        <translation>Stäbe müssen geschlossene Netze sein: jeder Strahl muss so oft austreten wie eintreten, {} tun es nicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>rods of all contours</source>
        <translation>Stäbe aller Konturen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>rods of the wireframe</source>
        <translation>Stäbe des Drahtmodells</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>rods whose channels the B-Rep engine cut, of all</source>
        <translation>Stäbe, deren Kanäle das B-Rep-Verfahren schnitt, von allen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>rods, by the rule that turning does not change</source>
        <translation>Stäbe, nach der Regel, die Drehen nicht ändert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>rounds of gap fill must be at least 0, got {}</source>
        <translation>die Durchgänge zum Schließen von Lücken müssen mindestens 0 sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>row sums and column sums must agree, got {} and {}</source>
        <translation>Zeilen- und Spaltensummen müssen übereinstimmen, hier {} und {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>sample</source>
        <translation>Probe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>sample size, bounding box, mm</source>
        <translation>Größe der Probe, Quader, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>scaffold</source>
        <translation>Gerüst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>scaffold + channels</source>
        <translation>Gerüst + Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>scaffold + channels + loose pieces = envelope</source>
        <translation>Gerüst + Kanäle + lose Teile = Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>scaffold + channels + loose pieces = envelope, mm3</source>
        <translation>Gerüst + Kanäle + lose Teile = Hüllkörper, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>scaffold + channels + loose pieces, each by its own triangles, against the envelope</source>
        <translation>Gerüst + Kanäle + lose Teile, jedes mit seinen Dreiecken, gegen den Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>scaffold + channels = envelope</source>
        <translation>Gerüst + Kanäle = Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>scaffold + channels = envelope, mm3</source>
        <translation>Gerüst + Kanäle = Hüllkörper, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>scaffold in double and in single precision, mm3</source>
        <translation>Gerüst in doppelter und einfacher Genauigkeit, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>scatter of the corners</source>
        <translation>Streuung der Ecken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>score</source>
        <translation>Wert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>score {}</source>
        <translation>Wert {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>sd</source>
        <translation>s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/seam_settling.py"/>
        <location filename="../../freecad_trabecula/geometry/patch_solids.py"/>
        <source>seams of channels</source>
        <translation>Nähte der Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>second</source>
        <translation>zweite</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>second route</source>
        <translation>zweiter Weg</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>sections</source>
        <translation>Querschnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>sections a rod</source>
        <translation>Querschnitte je Stab</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>sections per rod must be 1 or 2, got {}</source>
        <translation>Querschnitte je Stab müssen 1 oder 2 sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/variants.py"/>
        <source>seeds must lie in 0..{}, got {} to {}</source>
        <translation>Startwerte müssen in 0..{} liegen, hier {} bis {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>shapes of layers must take at most {} of memory; fewer layers take less, got {}</source>
        <translation>Formen von Schichten dürfen höchstens {} Speicher brauchen; weniger Schichten brauchen weniger, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>share of contours that are rods (thesis' rule), b less a</source>
        <translation>Anteil der Konturen, die Stäbe sind (Regel der Dissertation), b minus a</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>share of solid voxels, BV/TV.vox</source>
        <translation>Anteil voller Voxel, BV/TV.vox</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>share of solid voxels: the second route</source>
        <translation>Anteil voller Voxel: der zweite Weg</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>share of the largest</source>
        <translation>Anteil des größten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>share of the largest part</source>
        <translation>Anteil des größten Teils</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>shared layers on which both values are the same number</source>
        <translation>gemeinsame Schichten, auf denen beide Werte gleich sind</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>shortest half axis of the fabric ellipsoid, by voxels</source>
        <translation>kürzeste Halbachse des Fabric-Ellipsoids aus Voxeln</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>shortest mean intercept length</source>
        <translation>kürzeste mittlere Sehnenlänge</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_sites.py"/>
        <source>site ({}, {}) came to lie outside its face, a line of which crossed the border unnoticed</source>
        <translation>Stelle ({}, {}) geriet außerhalb ihrer Fläche, deren Linie unbemerkt den Rand kreuzte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>sites</source>
        <translation>Stellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>sites along {} must be at least 2 (Eq. 2.1 divides by n - 1), got {}</source>
        <translation>Stellen entlang {} müssen mindestens 2 sein (Gl. 2.1 teilt durch n - 1), hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sites available</source>
        <translation>verfügbare Stellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sites left</source>
        <translation>übrige Stellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>sites n_x, n_y, n_z</source>
        <translation>Stellen n_x, n_y, n_z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sites of both faces that are on and that no earlier coupling used</source>
        <translation>eingeschaltete Stellen beider Flächen, die keine frühere Kopplung nutzte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/designs.py"/>
        <location filename="../../freecad_trabecula/features/tasks.py"/>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <location filename="../../freecad_trabecula/geometry/face_sites.py"/>
        <source>sites on {}</source>
        <translation>Stellen auf {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>size of the end sections</source>
        <translation>Größe der Endquerschnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>size, mm</source>
        <translation>Größe, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>slice analysis</source>
        <translation>Schnittanalyse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>slice comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>slice passport</source>
        <translation>Pass</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>sliced area</source>
        <translation>Schnittfläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>sliced area, mm2</source>
        <translation>Schnittfläche, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>sliced area, mm²</source>
        <translation>Schnittfläche, mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>sliced areas</source>
        <translation>Schnittflächen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>sliced areas {}, got {} mm² in layer {} along {}</source>
        <translation>Schnittflächen {}, hier {} mm² in Schicht {} entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>slices</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>slices through an open, turned or doubled place of the mesh</source>
        <translation>Schnitte durch eine offene, gedrehte oder doppelte Stelle des Netzes</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/slices.py"/>
        <source>slicing along {}</source>
        <translation>Schnitte entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/annealing.py"/>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>small box</source>
        <translation>kleiner Quader</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>smallest possible caps</source>
        <translation>kleinstmögliche Grenzen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>smallest possible caps on alpha, beta</source>
        <translation>kleinstmögliche Grenzen für alpha, beta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>smallest value of b less smallest of a over the shared layers</source>
        <translation>kleinster Wert von b minus kleinster von a über die gemeinsamen Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/voxels/smooth_surface.py"/>
        <source>smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>solid and mesh of a rod must agree within {} % of its volume, got {} and {} mm^3 for rod {} and {} such rods in all</source>
        <translation>Volumenkörper und Netz eines Stabs müssen auf {} % seines Volumens übereinstimmen, hier {} und {} mm^3 für Stab {} und insgesamt {} solche Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>solid and mesh of the scaffold must agree within {}, got {} and {} mm3</source>
        <translation>Volumenkörper und Netz des Gerüsts müssen auf {} übereinstimmen, hier {} und {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thinnest.py"/>
        <source>solid must be at least {} and void {} voxels thick; of {} solid ones {} and of the void {} stayed thinner; longer waves or smaller voxels may do</source>
        <translation>Material muss mindestens {} und Hohlraum {} Voxel dick sein; von {} vollen blieben {} und vom Hohlraum {} dünner; längere Wellen oder kleinere Voxel können helfen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/patch_solids.py"/>
        <source>solid of patches</source>
        <translation>Volumenkörper aus Flicken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>solid voxels</source>
        <translation>volle Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>solid voxels outside of the largest part</source>
        <translation>volle Voxel außerhalb des größten Teils</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>solid voxels x dx dy dz</source>
        <translation>volle Voxel x dx dy dz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>solid: rod {}{} of {}</source>
        <translation>Volumenkörper: Stab {}{} von {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/rod_solids.py"/>
        <source>solids of rods</source>
        <translation>Volumenkörper der Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>spacing={} unit=mm</source>
        <translation>spacing={} unit=mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>specific bone surface</source>
        <translation>spezifische Knochenoberfläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>specific bone surface, by voxels</source>
        <translation>spezifische Knochenoberfläche aus Voxeln</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>spoilt slices</source>
        <translation>fehlerhafte Schnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sqrt(sum (P - mean)^2 / (n - 1)); of a sample, as the thesis' repeats are</source>
        <translation>sqrt(Summe (P - Mittel)^2 / (n - 1)); einer Stichprobe, wie bei den Wiederholungen der Dissertation</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>standard deviation of the variants</source>
        <translation>Standardabweichung der Varianten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>standard error</source>
        <translation>Standardfehler</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>standard error, %</source>
        <translation>Standardfehler, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>sum (x_i y_i+1 - x_i+1 y_i) / 2 over the corners of a contour, voids negative; least and greatest of the contours of more area than the least</source>
        <translation>Summe (x_i y_i+1 - x_i+1 y_i) / 2 über die Ecken einer Kontur, Hohlräume negativ; kleinste und größte der Konturen mit mehr als der Mindestfläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>sum of area x thickness, mm3</source>
        <translation>Summe aus Fläche x Dicke, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>sum of both axes' tolerances of the volume</source>
        <translation>Summe der Volumentoleranzen beider Achsen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>sum of sliced area x thickness</source>
        <translation>Summe aus Schnittfläche x Dicke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>sum of sliced areas over the number of slices</source>
        <translation>Summe der Schnittflächen durch die Zahl der Schnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>sum of the areas of all contours of a slice</source>
        <translation>Summe der Flächen aller Konturen eines Schnitts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>sum of the layers along each of the three axes</source>
        <translation>Summe der Schichten entlang jeder der drei Achsen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sum of the rods</source>
        <translation>Summe der Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sum of the rods' solids by the kernel, where the network is built</source>
        <translation>Summe der Volumenkörper der Stäbe vom Kern, wo das Netzwerk erzeugt ist</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sum of the variants' porosities over their number</source>
        <translation>Summe der Porositäten der Varianten durch ihre Anzahl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sum of the volumes of the rods' solids by the kernel, crossings counted as often as they come</source>
        <translation>Summe der Volumen der Stäbe als Volumenkörper vom Kern, Kreuzungen so oft gezählt, wie sie vorkommen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sum over the rods of 30 to 75 s, by curvature of the path and number of sections</source>
        <translation>Summe über die Stäbe von 30 bis 75 s, je nach Krümmung des Pfads und Zahl der Querschnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>sums of the targets along X, Y and Z</source>
        <translation>Summen der Zielwerte entlang X, Y und Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/smooth_surface.py"/>
        <source>surface of the voxels</source>
        <translation>Oberfläche der Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>surface, mm2</source>
        <translation>Oberfläche, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>symbol</source>
        <translation>Zeichen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>table {} must have {} lines and {} layers along Z, got {} and {}</source>
        <translation>Tabelle {} muss {} Zeilen und {} Schichten entlang Z haben, hier {} und {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_inputs.py"/>
        <source>table {} must have {} x {} cells for these targets, got {}: its tables were given for another sample or voxel size</source>
        <translation>Tabelle {} muss für diese Zielwerte {} x {} Zellen haben, hier {}: ihre Tabellen wurden für eine andere Probe oder Voxelgröße gegeben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>table {}: {}</source>
        <translation>Tabelle {}: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masked_tables.py"/>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>tables</source>
        <translation>Tabellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>tables alpha</source>
        <translation>Tabellen alpha</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>tables beta</source>
        <translation>Tabellen beta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_inputs.py"/>
        <source>tables must be alpha and beta, of whole numbers, got {}</source>
        <translation>Tabellen müssen Alpha und Beta sein, aus ganzen Zahlen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/flows.py"/>
        <source>tables within a mask need scipy 1.6 or later</source>
        <translation>Tabellen in einer Maske brauchen scipy 1.6 oder neuer</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>taken away</source>
        <translation>weggenommen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>tangent component</source>
        <translation>Tangentenkomponente</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>tangent pull</source>
        <translation>Zug der Tangente</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>targets are read from {}, .csv, .json, the folder of an analysis or a folder of images, got {}</source>
        <translation>Zielwerte werden aus {}, .csv, .json, dem Ordner einer Analyse oder einem Ordner mit Bildern gelesen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/plane_offsets.py"/>
        <source>targets of {} layers do not fit a field of {}</source>
        <translation>Zielwerte von {} Schichten passen nicht zu einem Feld von {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>the B-Rep engine makes no compact layers, got {} faces with a layer: use the mesh engine</source>
        <translation>das B-Rep-Verfahren macht keine kompakten Schichten, hier {} Flächen mit Schicht: das Netzverfahren nehmen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_formats.py"/>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>the PLY file ends too early</source>
        <translation>die PLY-Datei endet zu früh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_formats.py"/>
        <source>the PLY file must be binary, little-endian</source>
        <translation>die PLY-Datei muss binär, little-endian sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_formats.py"/>
        <source>the PLY file must hold vertices and faces, got {}</source>
        <translation>die PLY-Datei muss Ecken und Flächen enthalten, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <location filename="../../freecad_trabecula/features/analysis_makers.py"/>
        <source>the axis must be one of {}, got {}</source>
        <translation>die Achse muss eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rays.py"/>
        <source>the axis of rays must be 0, 1 or 2, got {}</source>
        <translation>die Achse der Strahlen muss 0, 1 oder 2 sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/best_layer.py"/>
        <source>the best layer of given tables needs scipy 1.6 or later</source>
        <translation>die beste Schicht zu gegebenen Tabellen braucht scipy 1.6 oder neuer</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>the body could not be measured as a whole: {}</source>
        <translation>der Körper konnte als Ganzes nicht vermessen werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the border distance along {} must satisfy 0 &lt;= a &lt; edge / 2 = {} mm, got {}</source>
        <translation>für den Randabstand entlang {} muss 0 &lt;= a &lt; Kante / 2 = {} mm gelten, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the border distance {}</source>
        <translation>der Randabstand {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/plane_triangles.py"/>
        <source>the border of a face must not cross itself, nor run through a point of its own</source>
        <translation>der Rand einer Fläche darf sich nicht kreuzen und durch keinen eigenen Punkt laufen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>the box of drawn curves must have three edges, got {}</source>
        <translation>der Quader gezeichneter Kurven muss drei Kanten haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/feasibility.py"/>
        <source>the cap on {} must be at least {}, got {}: {} ask for {} voxels, and the layers along Z can give them {}</source>
        <translation>die Grenze für {} muss mindestens {} sein, hier {}: {} verlangen {} Voxel, und die Schichten entlang Z können ihnen {} geben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the cell must be greater than 0, got {}</source>
        <translation>die Zelle muss größer als 0 sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <source>the cell size must be above 0 mm, got {}</source>
        <translation>die Zellgröße muss über 0 mm liegen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>the cells of the field engine are too coarse for these rods: make them smaller, or take the mesh engine</source>
        <translation>die Zellen des Feldverfahrens sind für diese Stäbe zu grob: kleiner machen oder das Netzverfahren nehmen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the change of a site</source>
        <translation>die Änderung einer Stelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>the channels</source>
        <translation>die Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/pieces.py"/>
        <source>the channels must leave some material, got 0 mm3 of scaffold: the rods fill the whole envelope</source>
        <translation>die Kanäle müssen Material übrig lassen, hier 0 mm3 Gerüst: die Stäbe füllen den ganzen Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>the compensation must be finite, got {}</source>
        <translation>die Korrektur muss endlich sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>the correction must be one of {}, got {}</source>
        <translation>der Ausgleich muss einer von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>the counts along {} must be a list, got {}</source>
        <translation>die Anzahlen entlang {} müssen eine Liste sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>the counts along {} must be numbers, got {}</source>
        <translation>die Anzahlen entlang {} müssen Zahlen sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the deflection</source>
        <translation>die Abweichung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/tessellation.py"/>
        <source>the deflection must be 0 mm or more, got {} mm</source>
        <translation>die Abweichung muss 0 mm oder mehr sein, hier {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/envelope_sources.py"/>
        <source>the density of an envelope must lie between 0 and 1, got {}</source>
        <translation>die Dichte eines Hüllkörpers muss zwischen 0 und 1 liegen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>the design</source>
        <translation>der Entwurf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>the design {} must be open to be made again, got none: it was closed</source>
        <translation>der Entwurf {} muss offen sein, um noch einmal gemacht zu werden, hier keiner: er wurde geschlossen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/layer_fill.py"/>
        <location filename="../../freecad_trabecula/core/voxels/propagation_steps.py"/>
        <source>the direction must be one of {}, got {}</source>
        <translation>die Richtung muss eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>the direction of a law must be three finite numbers, got {}</source>
        <translation>die Richtung eines Gesetzes muss aus drei endlichen Zahlen bestehen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>the direction of a linear law must not be zero, got {}</source>
        <translation>die Richtung eines linearen Gesetzes darf nicht null sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the direction {} must not be zero, got {}</source>
        <translation>die Richtung {} darf nicht null sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scripts.py"/>
        <source>the document must have the body {}, got none in {}: open the document with it first, or give one of yours this name</source>
        <translation>das Dokument muss den Körper {} enthalten, hier keiner in {}: zuerst das Dokument mit ihm öffnen oder einem eigenen diesen Namen geben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/document_work.py"/>
        <source>the document was closed</source>
        <translation>das Dokument wurde geschlossen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>the edges of a drawn box must be above 0, got {}</source>
        <translation>die Kanten eines gezeichneten Quaders müssen über 0 liegen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the engine</source>
        <translation>das Verfahren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>the envelope</source>
        <translation>der Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the envelope is only {} mm large: was its file in metres or inches, not mm?</source>
        <translation>der Hüllkörper ist nur {} mm groß: war seine Datei in Metern oder Zoll, nicht mm?</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the envelope is {} mm large: was its file in micrometres, not mm?</source>
        <translation>der Hüllkörper ist {} mm groß: war seine Datei in Mikrometern, nicht mm?</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/nodes.py"/>
        <source>the envelope must be at least two cells thick; it measures {} mm, a cell {} mm</source>
        <translation>der Hüllkörper muss mindestens zwei Zellen dick sein; er misst {} mm, eine Zelle {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_envelope.py"/>
        <source>the envelope must be checked before rods are built: wait a moment</source>
        <translation>der Hüllkörper muss geprüft sein, bevor Stäbe gebaut werden: einen Augenblick warten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>the envelope must enclose a volume above 0, got {} mm3: it is inside out</source>
        <translation>der Hüllkörper muss ein Volumen über 0 umschließen, hier {} mm3: sein Inneres ist außen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/tessellation.py"/>
        <source>the envelope's triangles are the kernel's and may differ between versions of FreeCAD: {}</source>
        <translation>die Dreiecke des Hüllkörpers stammen vom Kern und können sich zwischen FreeCAD-Versionen unterscheiden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <source>the envelope's triangles must turn counter-clockwise seen from outside; its volume is {} mm³</source>
        <translation>die Dreiecke des Hüllkörpers müssen von außen gesehen gegen den Uhrzeigersinn laufen; sein Volumen ist {} mm³</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>the expression {} cannot be computed: {}</source>
        <translation>die Formel {} kann nicht berechnet werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>the expression {} cannot be read: {}</source>
        <translation>die Formel {} kann nicht gelesen werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>the expression {} must give finite numbers, got {} at ({}) mm</source>
        <translation>die Formel {} muss endliche Zahlen ergeben, hier {} bei ({}) mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/surfaces.py"/>
        <source>the face has no normal at ({}) mm</source>
        <translation>die Fläche hat bei ({}) mm keine Normale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>the face's own</source>
        <translation>die der Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the faces of an IGES file must bound a closed body; these {} do not, with gaps up to {} mm closed (a STEP file keeps solids)</source>
        <translation>die Flächen einer IGES-Datei müssen einen geschlossenen Körper begrenzen; diese {} tun es nicht, Lücken bis {} mm geschlossen (eine STEP-Datei behält Volumenkörper)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_formats.py"/>
        <source>the faces of the PLY file must be triangles</source>
        <translation>die Flächen der PLY-Datei müssen Dreiecke sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/chosen_fields.py"/>
        <source>the field must be one of {}, got {}</source>
        <translation>das Feld muss eines von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the file of an envelope must be readable, got {}</source>
        <translation>die Datei eines Hüllkörpers muss lesbar sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the file of an envelope must end in one of {}, got {}</source>
        <translation>die Datei eines Hüllkörpers muss auf eines von {} enden, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the file of an envelope must hold a mesh, but {} cannot be read as one</source>
        <translation>die Datei eines Hüllkörpers muss ein Netz enthalten, aber {} ist nicht als solches lesbar</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the file of an envelope must hold a shape, but {} cannot be read as one</source>
        <translation>die Datei eines Hüllkörpers muss eine Form enthalten, aber {} ist nicht als solche lesbar</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the file of an envelope must hold a shape, got none in {}</source>
        <translation>die Datei eines Hüllkörpers muss eine Form enthalten, hier keine in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_source.py"/>
        <source>the file {} could not be read: {}</source>
        <translation>die Datei {} konnte nicht gelesen werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/files.py"/>
        <source>the file's extension must be one of {}, got {}</source>
        <translation>die Endung der Datei muss eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_files.py"/>
        <source>the folder {} could not be made: {}</source>
        <translation>der Ordner {} konnte nicht angelegt werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/results.py"/>
        <source>the folder {} must hold results that were written to the end: {}</source>
        <translation>der Ordner {} muss vollständig geschriebene Ergebnisse enthalten: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>the format of a PLY file must be ascii or binary, got {}</source>
        <translation>das Format einer PLY-Datei muss ascii oder binary sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the greatest number of rods of a coupling must be 0 (all) or more, got {}</source>
        <translation>die größte Stabzahl einer Kopplung muss 0 (alle) oder mehr sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_export.py"/>
        <source>the images need a new folder, but {} is there already</source>
        <translation>die Bilder brauchen einen neuen Ordner, aber {} ist schon da</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>the images of {} must be of one kind, got {}</source>
        <translation>die Bilder von {} müssen von einer Art sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>the job file {} cannot be read: {}</source>
        <translation>die Auftragsdatei {} kann nicht gelesen werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>the job file {} must be a text in UTF-8: {}</source>
        <translation>die Auftragsdatei {} muss Text in UTF-8 sein: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>the job's schema must be {}, got {}</source>
        <translation>das Schema des Auftrags muss {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/brep_text.py"/>
        <source>the kernel could not read a shape of {} characters</source>
        <translation>der Kern konnte eine Form von {} Zeichen nicht lesen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/brep_text.py"/>
        <source>the kernel could not read a shape of {} characters: {}</source>
        <translation>der Kern konnte eine Form von {} Zeichen nicht lesen: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>the kernel cuts rod {} wrongly in every way tried</source>
        <translation>der Kern schneidet Stab {} auf jede versuchte Weise falsch</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_solids.py"/>
        <source>the kernel made no solid of {} triangles: {}</source>
        <translation>der Kern machte keinen Volumenkörper aus {} Dreiecken: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/cutting.py"/>
        <source>the kernel made no triangles of a face at a deflection of {} mm</source>
        <translation>der Kern erzeugte keine Dreiecke einer Fläche bei einer Abweichung von {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/tessellation.py"/>
        <source>the kernel made no triangles of a solid at a deflection of {} mm</source>
        <translation>der Kern erzeugte keine Dreiecke eines Volumenkörpers bei einer Abweichung von {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>the kernel refused it</source>
        <translation>der Kern hat es abgelehnt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/file_sizes.py"/>
        <source>the kind must be one of npy, nrrd, vti, png, bmp, tiff, got {}</source>
        <translation>die Art muss eine von npy, nrrd, vti, png, bmp, tiff sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the largest size of an envelope must be at most {} times its least, got {} and {} mm</source>
        <translation>die größte Abmessung eines Hüllkörpers darf höchstens das {}-fache der kleinsten sein, hier {} und {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>the last layer must not lie below the first, got {} to {}</source>
        <translation>die letzte Schicht darf nicht unter der ersten liegen, hier {} bis {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>the layers along X, Y and Z must ask for the same total, got {}, {} and {} voxels: X - Z = {}, Y - Z = {}</source>
        <translation>die Schichten entlang X, Y und Z müssen dieselbe Summe verlangen, hier {}, {} und {} Voxel: X - Z = {}, Y - Z = {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_search.py"/>
        <source>the layers contradict each other; count {}</source>
        <translation>die Schichten widersprechen einander; zu zählen ist {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>the layers were not to be made</source>
        <translation>die Schichten sollten nicht gemacht werden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the lean</source>
        <translation>die Neigung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>the low ends of their boxes</source>
        <translation>den unteren Enden ihrer Quader</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>the mask must have the shape {}, got {}</source>
        <translation>die Maske muss die Form {} haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masks.py"/>
        <source>the mask's layers along {} have {} cells, but the common total is {}</source>
        <translation>die Schichten der Maske entlang {} haben {} Zellen, die gemeinsame Summe ist {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the memory budget</source>
        <translation>die Speichergrenze</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>the memory budget of {} GB is used up ({} GB)</source>
        <translation>die Speichergrenze von {} GB ist aufgebraucht ({} GB)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>the mesh does not enclose a volume</source>
        <translation>das Netz umschließt kein Volumen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>the mesh is inside out, or flat: its volume is {} mm3</source>
        <translation>das Netz ist umgestülpt oder flach: sein Volumen ist {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_objects.py"/>
        <source>the mesh kernel must hold a closed mesh, got an open one of {} triangles</source>
        <translation>der Netzkern muss ein geschlossenes Netz enthalten, hier ein offenes mit {} Dreiecken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_objects.py"/>
        <source>the mesh kernel must hold {} vertices and {} triangles, got {} and {}</source>
        <translation>der Netzkern muss {} Ecken und {} Dreiecke enthalten, hier {} und {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>the mesh must be closed and hold the {} mm3 of its voxels, got {} mm3</source>
        <translation>das Netz muss geschlossen sein und die {} mm3 seiner Voxel enthalten, hier {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_solids.py"/>
        <source>the mesh was inside out; its triangles have been turned round</source>
        <translation>das Netz war umgestülpt; seine Dreiecke wurden gewendet</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>the middles of their boxes</source>
        <translation>den Mitten ihrer Quader</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>the model of a 3MF file may have at most {} bytes</source>
        <translation>das Modell einer 3MF-Datei darf höchstens {} Bytes haben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>the model of a 3MF file must be proper XML: {}</source>
        <translation>das Modell einer 3MF-Datei muss richtiges XML sein: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>the model of a 3MF file must have an item to build</source>
        <translation>das Modell einer 3MF-Datei muss ein Bauteil enthalten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>the nearest one found has {} contacts</source>
        <translation>der nächste gefundene hat {} Kontakte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>the nearest one found has {} contacts, one of them in layer {} along Z</source>
        <translation>der nächste gefundene hat {} Kontakte, einen davon in Schicht {} entlang Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>the nearest one found has {} voxels instead of {} in layer {} along {}</source>
        <translation>der nächste gefundene hat {} Voxel statt {} in Schicht {} entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the number of corners of a pore must lie in 3..12, got {}</source>
        <translation>die Zahl der Ecken einer Pore muss in 3..12 liegen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/arguments.py"/>
        <source>the object must be in the document {}, got {} of {}</source>
        <translation>das Objekt muss im Dokument {} sein, hier {} von {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/arguments.py"/>
        <source>the object must be of the kind {}, got {} ({})</source>
        <translation>das Objekt muss von der Art {} sein, hier {} ({})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/layer_fill.py"/>
        <location filename="../../freecad_trabecula/core/voxels/propagation_steps.py"/>
        <source>the order must be one of {}, got {}</source>
        <translation>die Reihenfolge muss eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_sites.py"/>
        <source>the origin on face {}</source>
        <translation>der Ursprung auf Fläche {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>the pixels of {} must have a pitch: none stands in the images, and none was given</source>
        <translation>die Pixel von {} brauchen einen Abstand: in den Bildern steht keiner, und keiner ist gegeben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>the plane at {} mm along {} could not be cut: {}</source>
        <translation>die Ebene bei {} mm entlang {} konnte nicht geschnitten werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>the planes are not those of layers</source>
        <translation>die Ebenen sind nicht die von Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/edits.py"/>
        <source>the pore at {} must get a size or tangent components, got neither</source>
        <translation>die Pore an {} muss eine Größe oder Tangentenkomponenten bekommen, hier nichts davon</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/pores.py"/>
        <source>the pore at {} takes {} tangent components, got {}</source>
        <translation>die Pore bei {} braucht {} Tangentenkomponenten, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/colouring.py"/>
        <source>the porosity of slices along {} is that of an analysis of {}, got none: analyse it first</source>
        <translation>die Porosität der Schnitte entlang {} ist die einer Analyse von {}, hier keine: zuerst analysieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/jobs.py"/>
        <source>the prism of a job has a corner at the origin and its edges along X, Y, Z: the box's placement must be the identity, got {} of {}</source>
        <translation>das Prisma eines Auftrags hat eine Ecke im Ursprung und Kanten entlang X, Y, Z: die Platzierung des Quaders muss die Identität sein, hier {} von {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the prism's edge along {}</source>
        <translation>die Kante des Prismas entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>the range of layers must meet the body, {}..{} mm, got {}</source>
        <translation>der Bereich der Schichten muss den Körper treffen, {}..{} mm, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>the ratio from which a contour is a rod must lie in 0..1, got {}</source>
        <translation>das Verhältnis, ab dem eine Kontur ein Stab ist, muss in 0..1 liegen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>the rectangle of the bounding box</source>
        <translation>das Rechteck des umschließenden Quaders</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/smooth_surface.py"/>
        <source>the rounds of smoothing must be 0 or more, got {}</source>
        <translation>die Glättungsdurchgänge müssen 0 oder mehr sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>the same along another axis</source>
        <translation>das gleiche entlang einer anderen Achse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>the same cut by the mesh engine</source>
        <translation>das gleiche, mit dem Netzverfahren geschnitten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>the same in single precision, as it is in the file; and the balance of all volumes</source>
        <translation>das gleiche in einfacher Genauigkeit, wie es in der Datei steht; und die Bilanz aller Volumen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>the same, net of holes, mm2</source>
        <translation>dasselbe ohne Löcher, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>the sample's mean thickness is {} voxels; below {} its trabeculae are not resolved ({} % of it lie outside any block of 2 x 2 x 2 voxels): voxels of {} mm would resolve them</source>
        <translation>die mittlere Dicke der Probe ist {} Voxel; unter {} sind ihre Trabekel nicht aufgelöst ({} % davon liegen außerhalb jedes Blocks von 2 x 2 x 2 Voxeln): Voxel von {} mm würden sie auflösen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>the sample's mean thickness is {} voxels; below {} its trabeculae are not resolved: voxels of {} mm would resolve them</source>
        <translation>die mittlere Dicke der Probe ist {} Voxel; unter {} sind ihre Trabekel nicht aufgelöst: Voxel von {} mm würden sie auflösen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>the sample's voxels must have the shape {}, got {}</source>
        <translation>die Voxel der Probe müssen die Form {} haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>the scaffold</source>
        <translation>das Gerüst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>the scaffold, once it is built</source>
        <translation>das Gerüst, sobald es erzeugt ist</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_search.py"/>
        <source>the search for a design gave up after {} s</source>
        <translation>die Suche nach einem Entwurf gab nach {} s auf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_search.py"/>
        <source>the search for a design needs scipy 1.9 or later</source>
        <translation>die Suche nach einem Entwurf braucht scipy 1.9 oder neuer</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the seed must lie in 0..{}, got {}</source>
        <translation>der Startwert muss in 0..{} liegen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the short name of a face must hold no dot, got {}</source>
        <translation>der Kurzname einer Fläche darf keinen Punkt enthalten, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the side of a layer</source>
        <translation>die Seite einer Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/slices.py"/>
        <source>the side of a plane must be one of {}, got {}</source>
        <translation>die Seite einer Ebene muss eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>the sites {} lost their face {}: {} has Face1..Face{}; choose another face</source>
        <translation>die Stellen {} haben ihre Fläche {} verloren: {} hat Face1..Face{}; eine andere Fläche wählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>the sites {} must be on faces of {}, got none</source>
        <translation>die Stellen {} müssen auf Flächen von {} liegen, hier keine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>the sites {} must be on faces of {}, got {}</source>
        <translation>die Stellen {} müssen auf Flächen von {} liegen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the size of the pore at {}</source>
        <translation>die Größe der Pore bei {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/voxelise.py"/>
        <source>the size of voxels must be &gt; 0, got {} mm</source>
        <translation>die Voxelgröße muss &gt; 0 sein, hier {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>the slices' volume was not held against the mesh's: {}</source>
        <translation>das Volumen der Schnitte wurde nicht gegen das des Netzes geprüft: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the solid must be one of Solid1..Solid{}, got {}</source>
        <translation>der Volumenkörper muss einer von Solid1..Solid{} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the solid was inside out (volume {} mm3) and has been turned</source>
        <translation>der Volumenkörper war umgestülpt (Volumen {} mm3) und ist gewendet</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the solid was invalid ({}) and has been mended</source>
        <translation>der Volumenkörper war ungültig ({}) und ist repariert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>the solver must be one of {}, got {}</source>
        <translation>das Lösungsverfahren muss eines von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/branches.py"/>
        <source>the spacing of rows must be &gt; 0, got {} mm</source>
        <translation>der Abstand der Reihen muss &gt; 0 sein, hier {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the spacing {} must be greater than 0, got {}</source>
        <translation>der Abstand {} muss größer als 0 sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the stations of a rod must lie in 3..33, got {}</source>
        <translation>die Stationen eines Stabs müssen in 3..33 liegen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/registry.py"/>
        <source>the strategy must be one of {}, got {}</source>
        <translation>die Strategie muss eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>the surface must be one of {}, got {}</source>
        <translation>die Oberfläche muss eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>the table must have {} rows and {} columns, got {}</source>
        <translation>die Tabelle muss {} Zeilen und {} Spalten haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>the tables are not compatible in layer {} along Z, and {} layers in all: no voxels have these sums in columns and rows</source>
        <translation>die Tabellen sind in Schicht {} entlang Z und in insgesamt {} Schichten nicht verträglich: keine Voxel haben diese Summen in Spalten und Zeilen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>the tables are not compatible in layer {} along Z, and {} layers in all: no voxels within the mask have these sums in columns and rows</source>
        <translation>die Tabellen sind in Schicht {} entlang Z und in insgesamt {} Schichten nicht verträglich: keine Voxel in der Maske haben diese Summen in Spalten und Zeilen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/layer_fill.py"/>
        <source>the tables are not compatible: no layer {} along Z has these {} voxels in columns and {} in rows; {} of {} layers fail</source>
        <translation>die Tabellen sind nicht verträglich: keine Schicht {} entlang Z hat diese {} Voxel in Spalten und {} in Zeilen; {} von {} Schichten scheitern</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/tasks.py"/>
        <source>the task could not be written into {}: {}</source>
        <translation>die Aufgabe konnte nicht in {} geschrieben werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/cli_layers.py"/>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <source>the thickness of a layer must be above 0 mm, got {}</source>
        <translation>die Dicke einer Schicht muss über 0 mm liegen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>the thickness of a layer must be greater than 0, got {}</source>
        <translation>die Dicke einer Schicht muss größer als 0 sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>the thickness of common layers must be &gt; 0, got {} mm</source>
        <translation>die Dicke gemeinsamer Schichten muss &gt; 0 sein, hier {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the time budget</source>
        <translation>die Zeitgrenze</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>the time budget of {} s is used up</source>
        <translation>die Zeitgrenze von {} s ist aufgebraucht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>the total must be one of {}, got {}</source>
        <translation>die Summe muss eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>the triangles of a face must run along each edge at most once each way</source>
        <translation>die Dreiecke einer Fläche dürfen jede Kante je Richtung höchstens einmal durchlaufen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/tessellation.py"/>
        <source>the triangles of a solid</source>
        <translation>die Dreiecke eines Volumenkörpers</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/tessellation.py"/>
        <source>the triangles' volume must be the solid's to {} mm3 (deflection times area), got {} against {} mm3</source>
        <translation>das Volumen der Dreiecke muss das des Volumenkörpers auf {} mm3 sein (Abweichung mal Fläche), hier {} gegen {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>the union of rods</source>
        <translation>die Vereinigung der Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>the unit is {}; name it if this is wrong</source>
        <translation>die Einheit ist {}; angeben, wenn das falsch ist</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>the unit must be auto or one of {}, got {}</source>
        <translation>die Einheit muss auto oder eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <source>the unit must be one of auto, {}, got {}</source>
        <translation>die Einheit muss auto oder eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <source>the unit must be one of {}, got {}</source>
        <translation>die Einheit muss eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>the unit of a 3MF file must be one of {}, got {}</source>
        <translation>die Einheit einer 3MF-Datei muss eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_makers.py"/>
        <source>the unit of a file must be one of auto, {}, got {}</source>
        <translation>die Einheit einer Datei muss auto oder eine von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>the voxel size</source>
        <translation>die Voxelgröße</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>the wavelength</source>
        <translation>die Wellenlänge</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/on_demand.py"/>
        <source>the window must not wait</source>
        <translation>das Fenster darf nicht warten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/child_work.py"/>
        <source>the work could not be handed over in {}: {}</source>
        <translation>die Arbeit konnte in {} nicht übergeben werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the {} of a box must be greater than 0 mm, got {} mm</source>
        <translation>{} eines Quaders muss größer als 0 mm sein, hier {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>the {} of {} and {} must leave some volume, got 0 mm3</source>
        <translation>{} von {} und {} muss ein Volumen lassen, hier 0 mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>the {}{} fullest columns ask for {}, and the rows can give them {}</source>
        <translation>die {}{} vollsten Spalten verlangen {}, und die Zeilen können ihnen {} geben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>their own zeros</source>
        <translation>ihren eigenen Nullpunkten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>there is no mesh</source>
        <translation>es gibt kein Netz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>there may be at most {} heights, got {}</source>
        <translation>es darf höchstens {} Höhen geben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>there may be at most {} planes along an axis; {} mm in layers of {} mm are {} planes, which would take about {} times the minute and 15 GB that {} take; layers of at least {} mm are possible</source>
        <translation>es darf höchstens {} Ebenen je Achse geben; {} mm in Schichten von {} mm sind {} Ebenen, das dauert etwa {}-mal die Minute und die 15 GB von {}; Schichten ab {} mm sind möglich</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/voxelise.py"/>
        <source>there may be at most {} voxels, a size of {} mm makes {}</source>
        <translation>es darf höchstens {} Voxel geben, eine Größe von {} mm ergibt {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>there must be a file or folder of that name, got {}</source>
        <translation>es muss eine Datei oder einen Ordner dieses Namens geben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>there must be at least one axis to slice along, got {}</source>
        <translation>mindestens eine Achse muss geschnitten werden, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/contacts.py"/>
        <source>there must be no contacts by an edge alone, but of {} contacts {}{} could not be removed without splitting the solid or closing a cavity; another seed or smaller voxels may do</source>
        <translation>es darf keine Kontakte nur über eine Kante geben, aber von {} Kontakten waren {}{} nicht zu beseitigen, ohne das Material zu teilen oder einen Hohlraum zu schließen; ein anderer Startwert oder kleinere Voxel können helfen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/contacts.py"/>
        <source>there must be no contacts by an edge or a corner alone, but of {} contacts {}{} could not be removed without splitting the solid or closing a cavity; another seed or smaller voxels may do</source>
        <translation>es darf keine Kontakte nur über Kante oder Ecke geben, aber von {} Kontakten waren {}{} nicht zu beseitigen, ohne das Material zu teilen oder einen Hohlraum zu schließen; ein anderer Startwert oder kleinere Voxel können helfen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/branches.py"/>
        <source>there must be one row of measures for each contour, got {}, {}</source>
        <translation>zu jeder Kontur gehört eine Zeile Maße, hier {}, {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/triples.py"/>
        <source>there must be three values, one along X, Y and Z each, got {}</source>
        <translation>es müssen drei Werte sein, je einer längs X, Y und Z, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>thesis</source>
        <translation>Dissertation</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis Eq. 2.1, section 4.2.2</source>
        <translation>Dissertation Gl. 2.1, Abschnitt 4.2.2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis Eq. 2.2</source>
        <translation>Dissertation Gl. 2.2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis Eq. 2.2, of a slice</source>
        <translation>Dissertation Gl. 2.2, eines Schnitts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis Eq. 5.1</source>
        <translation>Dissertation Gl. 5.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis Eq. 6.1</source>
        <translation>Dissertation Gl. 6.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis Eq. 6.2 and Eq. 6.6</source>
        <translation>Dissertation Gl. 6.2 und Gl. 6.6</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>thesis ch. 9 (interconnectivity of trabeculae); graph of the slices</source>
        <translation>Dissertation Kap. 9 (Verbundenheit der Trabekel); Graph der Schnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis chapter 9</source>
        <translation>Dissertation Kapitel 9</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis section 2.3.3</source>
        <translation>Dissertation Abschnitt 2.3.3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis section 2.4.1</source>
        <translation>Dissertation Abschnitt 2.4.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis section 2.4.5, tables 4.2 and 4.5</source>
        <translation>Dissertation Abschnitt 2.4.5, Tabellen 4.2 und 4.5</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis section 2.4.7</source>
        <translation>Dissertation Abschnitt 2.4.7</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis section 4.3.1</source>
        <translation>Dissertation Abschnitt 4.3.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis section 5.2.3</source>
        <translation>Dissertation Abschnitt 5.2.3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis section 5.2.3.1</source>
        <translation>Dissertation Abschnitt 5.2.3.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis section 5.2.3.3</source>
        <translation>Dissertation Abschnitt 5.2.3.3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis section 5.4</source>
        <translation>Dissertation Abschnitt 5.4</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis section 5.4.2</source>
        <translation>Dissertation Abschnitt 5.4.2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis section 6.2.1</source>
        <translation>Dissertation Abschnitt 6.2.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis section 6.2.1, after Eq. 6.1</source>
        <translation>Dissertation Abschnitt 6.2.1, nach Gl. 6.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis section 6.2.4, by Gale 1957, DOI 10.2140/pjm.1957.7.1073</source>
        <translation>Dissertation Abschnitt 6.2.4, nach Gale 1957, DOI 10.2140/pjm.1957.7.1073</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis section 6.3.1</source>
        <translation>Dissertation Abschnitt 6.3.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis section 6.4</source>
        <translation>Dissertation Abschnitt 6.4</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis sections 3.3.5 and 4.2.4</source>
        <translation>Dissertation Abschnitte 3.3.5 und 4.2.4</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis tables 4.2 and 4.5</source>
        <translation>Dissertation Tabellen 4.2 und 4.5</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis tables 5.11, 5.12 and 5.13</source>
        <translation>Dissertation Tabellen 5.11, 5.12 und 5.13</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thinnest.py"/>
        <source>thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/path_laws.py"/>
        <source>through a random point of a box about it (Eq. 3.1)</source>
        <translation>durch einen zufälligen Punkt eines Quaders um ihn (Gl. 3.1)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>time by hand</source>
        <translation>Zeit von Hand</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>time for a rod</source>
        <translation>Zeit je Stab</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>time of all, s</source>
        <translation>Zeit insgesamt, s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>time of the network a rod, s</source>
        <translation>Zeit des Netzwerks je Stab, s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>time of the network, s</source>
        <translation>Zeit des Netzwerks, s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>time of the slices, processor s</source>
        <translation>Zeit der Schnitte, Prozessor-s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>time over the number of rods</source>
        <translation>Zeit durch die Zahl der Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>to {} site {} a point is needed, got {}</source>
        <translation>für {} der Stelle {} wird ein Punkt gebraucht, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>tool compensation, mm</source>
        <translation>Werkzeugkorrektur, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>total number of plates</source>
        <translation>Gesamtzahl der Platten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>total number of rods</source>
        <translation>Gesamtzahl der Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>total volume</source>
        <translation>Gesamtvolumen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/trabeculae.py"/>
        <source>trabeculae</source>
        <translation>Trabekel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>trabeculae (mean)</source>
        <translation>Trabekel (Mittel)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>trabeculae a layer along {}</source>
        <translation>Trabekel je Schicht entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/colouring.py"/>
        <source>trabeculae along {}</source>
        <translation>Trabekel entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>trabeculae of a layer</source>
        <translation>Trabekel einer Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>trabeculae that appear</source>
        <translation>Trabekel, die beginnen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>trabeculae that end</source>
        <translation>Trabekel, die enden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>trabeculae that join</source>
        <translation>Trabekel, die sich verbinden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>trabeculae that overlap several of the next slice (splits) or of the one before (joins), over that distance</source>
        <translation>Trabekel, die mehrere des nächsten Schnitts überlappen (Teilungen) oder des vorigen (Verbindungen), durch diesen Abstand</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>trabeculae that split</source>
        <translation>Trabekel, die sich teilen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>trabeculae too small to be followed</source>
        <translation>Trabekel, die zu klein zum Verfolgen sind</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>trabecular area</source>
        <translation>Trabekelfläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>trabecular area range, mm2</source>
        <translation>Trabekelfläche, Bereich, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>trabecular area, net of holes</source>
        <translation>Trabekelfläche ohne Löcher</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>trabecular number</source>
        <translation>Trabekelzahl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>trabecular separation</source>
        <translation>Trabekelabstand</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>trabecular thickness</source>
        <translation>Trabekeldicke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_source.py"/>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/plane_triangles.py"/>
        <source>triangles between trimmed borders need the Python package scipy</source>
        <translation>Dreiecke zwischen beschnittenen Rändern brauchen das Python-Paket scipy</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>triangles must have the shape (count, 3, 3), got {}</source>
        <translation>Dreiecke müssen die Form (Anzahl, 3, 3) haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_triangles.py"/>
        <source>triangles must lie within {} mm of a face, got {} mm</source>
        <translation>Dreiecke müssen innerhalb {} mm einer Fläche liegen, hier {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>triangles must name vertices 0..{} of their object</source>
        <translation>Dreiecke müssen Ecken 0..{} ihres Objekts nennen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_triangles.py"/>
        <source>triangles of a face must not fold over</source>
        <translation>Dreiecke einer Fläche dürfen sich nicht falten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>triangles of solids</source>
        <translation>Dreiecke der Volumenkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>triangles of the body</source>
        <translation>Dreiecke des Körpers</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>triangles of the mesh</source>
        <translation>Dreiecke des Netzes</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>true area of the curve: it is 1.46 s^2 in the mean</source>
        <translation>wahre Fläche der Kurve: sie ist im Mittel 1,46 s^2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>true area of the end sections</source>
        <translation>wahre Fläche der Endquerschnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>true area, mm2</source>
        <translation>wahre Fläche, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>true or false</source>
        <translation>wahr oder falsch</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>twice the surfaces crossed per length by parallel lines in all directions, over BV/TV.vox: the second route</source>
        <translation>doppelte Zahl der Durchstoßungen je Länge paralleler Linien aller Richtungen, durch BV/TV.vox: der zweite Weg</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>two independent routes must agree, but they do not: {}</source>
        <translation>zwei unabhängige Wege müssen übereinstimmen, tun es aber nicht: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>um (guessed: the body would be {} mm large)</source>
        <translation>um (geschätzt: der Körper wäre {} mm groß)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/fill.py"/>
        <source>union and compensation need the package manifold3d</source>
        <translation>Vereinigung und Korrektur brauchen das Paket manifold3d</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>union by parallel rays through the rods' own triangles: no Boolean</source>
        <translation>Vereinigung mit parallelen Strahlen durch die Dreiecke der Stäbe: ohne boolesche Operation</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>union of rods</source>
        <translation>Vereinigung der Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>union of the rods in the envelope</source>
        <translation>Vereinigung der Stäbe im Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>union of the rods, %</source>
        <translation>Vereinigung der Stäbe, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>unit of the file</source>
        <translation>Einheit der Datei</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/fill.py"/>
        <source>uniting contours</source>
        <translation>Konturen werden vereinigt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>unknown name {} in {}; known are {}</source>
        <translation>unbekannter Name {} in {}; bekannt sind {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>up to 10 % low</source>
        <translation>bis 10 % zu klein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>up to date</source>
        <translation>aktuell</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>value of b over value of a, less 1; 0 = equal</source>
        <translation>Wert von b durch Wert von a, minus 1; 0 = gleich</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>variable</source>
        <translation>Größe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/variants.py"/>
        <source>variants must be 1 to {}, got {}</source>
        <translation>Varianten müssen 1 bis {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>variants must be those of a wireframe or of a voxel design, got {}</source>
        <translation>Varianten müssen die eines Drahtmodells oder Voxelentwurfs sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>verification</source>
        <translation>Nachprüfung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>vertices of rods must have the shape (rods, vertices, 3), got {}</source>
        <translation>Ecken von Stäben müssen die Form (Stäbe, Ecken, 3) haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>voids that no opening reaches</source>
        <translation>Hohlräume ohne Öffnung nach außen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>voids without an opening</source>
        <translation>Hohlräume ohne Öffnung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>volume along</source>
        <translation>Volumen entlang</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>volume along {}, sum of area x thickness against the mesh, mm3</source>
        <translation>Volumen entlang {}, Summe aus Fläche x Dicke gegen das Netz, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>volume by slices</source>
        <translation>Volumen aus Schnitten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>volume by the triangles, BV/TV</source>
        <translation>Volumen aus den Dreiecken, BV/TV</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>volume by the triangles; what overlaps counts twice</source>
        <translation>Volumen aus den Dreiecken; was sich überlappt, zählt doppelt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>volume of layers outside of the envelope</source>
        <translation>Volumen der Schichten außerhalb des Hüllkörpers</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>volume of the STEP scaffold</source>
        <translation>Volumen des STEP-Gerüsts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>volume of the body's box</source>
        <translation>Volumen des Quaders um den Körper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>volume of the channels</source>
        <translation>Volumen der Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>volume of the envelope</source>
        <translation>Volumen des Hüllkörpers</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <location filename="../../freecad_trabecula/features/second_routes.py"/>
        <source>volume of the mesh and of the voxels, mm3</source>
        <translation>Volumen des Netzes und der Voxel, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>volume of the mesh by the divergence theorem</source>
        <translation>Volumen des Netzes nach dem Divergenzsatz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>volume of the mesh of the same rods</source>
        <translation>Volumen des Netzes der gleichen Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>volume of the mesh over the body's length</source>
        <translation>Volumen des Netzes durch die Länge des Körpers</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/second_routes.py"/>
        <source>volume of the rods, solids against meshes, mm3</source>
        <translation>Volumen der Stäbe, Volumenkörper gegen Netze, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>volume of the scaffold</source>
        <translation>Volumen des Gerüsts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/second_routes.py"/>
        <source>volume of the scaffold, solid against mesh, mm3</source>
        <translation>Volumen des Gerüsts, Volumenkörper gegen Netz, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>volume of the solid by the kernel</source>
        <translation>Volumen des Volumenkörpers vom Kern</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>volume of the triangles by the divergence theorem</source>
        <translation>Volumen der Dreiecke nach dem Divergenzsatz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>volume of the voxels</source>
        <translation>Volumen der Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>volume of {}, mm3</source>
        <translation>Volumen ({}), mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>volume, mm3</source>
        <translation>Volumen, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>volume, mm³</source>
        <translation>Volumen, mm³</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>volumes by rays</source>
        <translation>Volumen aus Strahlen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>voxel counts {}, got {} in layer {} along {}</source>
        <translation>Voxelzahlen {}, hier {} in Schicht {} entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report.py"/>
        <source>voxel design</source>
        <translation>Voxelentwurf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>voxel, mm</source>
        <translation>Voxel, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/voxelise.py"/>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>voxels asked for in a layer</source>
        <translation>verlangte Voxel einer Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>voxels asked for, counted by a routine of its own (core/voxels/verification.py)</source>
        <translation>verlangte Voxel, von einer eigenen Routine gezählt (core/voxels/verification.py)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>voxels made in a layer</source>
        <translation>erzeugte Voxel einer Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/voxelise.py"/>
        <source>voxels must be a bool array [z, y, x], got {} of {}</source>
        <translation>Voxel müssen ein bool-Feld [z, y, x] sein, hier {} aus {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>voxels must be as large as the layers of the sample, {} mm along {}, got {} mm, which makes {} layers of the sample's {}: slice it again with layers of {} mm</source>
        <translation>Voxel müssen so groß sein wie die Schichten der Probe, {} mm entlang {}, hier {} mm, das ergibt {} Schichten der {} der Probe: sie neu in Schichten von {} mm schneiden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/by_field.py"/>
        <source>voxels where the chosen field is highest, as nearly as the counts of the layers allow</source>
        <translation>Voxel, wo das gewählte Feld am höchsten ist, so gut es die Anzahlen der Schichten erlauben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>watertight</source>
        <translation>dicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>watertight {}: faulty edges</source>
        <translation>{} dicht: fehlerhafte Kanten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/local_scale.py"/>
        <source>wavelengths</source>
        <translation>Wellenlängen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/texture.py"/>
        <source>wavelengths must be three lengths above 2 voxels, got {}</source>
        <translation>Wellenlängen müssen drei Längen über 2 Voxeln sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>what</source>
        <translation>was</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/packing.py"/>
        <source>what a document holds must be a value of this version: {}</source>
        <translation>was ein Dokument enthält, muss ein Wert dieser Version sein: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_source.py"/>
        <source>what is sliced must be a mesh or have a solid, got {} without</source>
        <translation>was geschnitten wird, muss ein Netz sein oder einen Volumenkörper haben, hier {} ohne</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_source.py"/>
        <source>what is sliced must have triangles, got none in {}</source>
        <translation>was geschnitten wird, muss Dreiecke haben, hier keine in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/guides.py"/>
        <location filename="../../freecad_trabecula/geometry/patch_solids.py"/>
        <source>what meets what</source>
        <translation>was sich mit was trifft</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>what overlaps was united</source>
        <translation>was sich überlappt, wurde vereinigt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>whether a design exists</source>
        <translation>ob ein Entwurf existiert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>which is up to 10 % low</source>
        <translation>das bis 10 % zu klein ist</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>whole</source>
        <translation>gesamt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>wider than {} mm bridged</source>
        <translation>breiter als {} mm überbrückt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/texture.py"/>
        <source>width of a texture must be 0.02 to 1, got {}</source>
        <translation>die Breite einer Textur muss 0.02 bis 1 sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/assembly.py"/>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>wireframe</source>
        <translation>Drahtmodell</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>with contacts 'any' there is one</source>
        <translation>mit Kontakten „any“ gibt es einen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>with contacts '{}' there is one</source>
        <translation>mit Kontakten „{}“ gibt es einen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/feasibility.py"/>
        <source>within the mask layer {} along {} holds {} voxels, but is asked for {}</source>
        <translation>in der Maske fasst Schicht {} entlang {} {} Voxel, verlangt sind {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masked_tables.py"/>
        <source>within the mask{}</source>
        <translation>in der Maske{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/cli_layers.py"/>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>writing layers</source>
        <translation>Schichten werden geschrieben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/report_sections.py"/>
        <source>writing the report</source>
        <translation>der Bericht wird geschrieben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>writing the tables of {}</source>
        <translation>die Tabellen von {} werden geschrieben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/workbook.py"/>
        <source>writing the workbook's sheet {}</source>
        <translation>das Tabellenblatt {} wird geschrieben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>{} (the file's)</source>
        <translation>{} (der Datei)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>{} (the zero vector)</source>
        <translation>{} (der Nullvektor)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{} about {} mm</source>
        <translation>{} um {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>{} against {}</source>
        <translation>{} gegen {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>{} against {}, {} apart</source>
        <translation>{} gegen {}, {} auseinander</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>{} against {}, {} of it apart</source>
        <translation>{} gegen {}, {} davon auseinander</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>{} along {}</source>
        <translation>{} entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>{} and {}</source>
        <translation>{} und {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>{} and {} layers of {} and {} voxels</source>
        <translation>{} und {} Schichten von {} und {} Voxeln</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>{} and {} more stretches</source>
        <translation>{} und {} weitere Abschnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>{} apart</source>
        <translation>{} auseinander</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>{} apart (at most {})</source>
        <translation>{} auseinander (höchstens {})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/feasibility.py"/>
        <source>{} ask for {} voxels together, but the layers along {} leave them at most {}</source>
        <translation>{} verlangen zusammen {} Voxel, aber die Schichten entlang {} lassen ihnen höchstens {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/feasibility.py"/>
        <source>{} ask for {} voxels together, each voxel counted in every such layer it lies in; {} voxels give them at most {}</source>
        <translation>{} verlangen zusammen {} Voxel, jedes in jeder seiner Schichten gezählt; {} Voxel geben ihnen höchstens {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>{} below {} mm3 left out</source>
        <translation>{} unter {} mm3 weggelassen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/colouring.py"/>
        <source>{} can be coloured by one of {}, got {}</source>
        <translation>{} kann nach einem von {} gefärbt werden, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>{} changes by hand do not</source>
        <translation>{} Änderungen von Hand tun es nicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>{} changes by hand do not fit the design: {}</source>
        <translation>{} Änderungen von Hand passen nicht zum Entwurf: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>{} could not be computed: {}</source>
        <translation>{} konnte nicht berechnet werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>{} could not be read as CSV: {}</source>
        <translation>{} konnte nicht als CSV gelesen werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{} could not be read as JSON: {}</source>
        <translation>{} konnte nicht als JSON gelesen werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>{} could not be read as XLSX: {}</source>
        <translation>{} konnte nicht als XLSX gelesen werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>{} could not be read: there is no such file or folder</source>
        <translation>{} konnte nicht gelesen werden: es gibt keine solche Datei und keinen solchen Ordner</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <location filename="../../freecad_trabecula/core/analysis/tables.py"/>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{} could not be read: {}</source>
        <translation>{} konnte nicht gelesen werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_source.py"/>
        <source>{} could not be written into {}: {}</source>
        <translation>{} konnte nicht in {} geschrieben werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/files.py"/>
        <source>{} could not be written whole: is the disk full?</source>
        <translation>{} konnte nicht vollständig geschrieben werden: ist der Datenträger voll?</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <location filename="../../freecad_trabecula/geometry/files.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_export.py"/>
        <source>{} could not be written: {}</source>
        <translation>{} konnte nicht geschrieben werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{} end sections; their true area is {} of the estimated.</source>
        <translation>{} Endquerschnitte; ihre wahre Fläche ist das {}-Fache der geschätzten.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>{} engine, {} rods, {} triangles, cells of {} mm: about {} s and {} GB</source>
        <translation>Verfahren {}, {} Stäbe, {} Dreiecke, Zellen von {} mm: etwa {} s und {} GB</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>{} engine, {} rods, {} triangles, {} pairs that come near: about {} s and {} GB</source>
        <translation>Verfahren {}, {} Stäbe, {} Dreiecke, {} Paare, die sich nahe kommen: etwa {} s und {} GB</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>{} faces were sewn to a solid, gaps up to {} mm</source>
        <translation>{} Flächen wurden zu einem Volumenkörper vernäht, Lücken bis {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>{} has no key {}; known are {}</source>
        <translation>{} hat keinen Schlüssel {}; bekannt sind {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/flows.py"/>
        <source>{} have {} cells for them, and </source>
        <translation>{} haben {} Zellen dafür, und </translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/tasks.py"/>
        <source>{} holds no task that can be read: {}</source>
        <translation>{} enthält keine lesbare Aufgabe: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/json_values.py"/>
        <source>{} is incomplete: {}</source>
        <translation>{} ist unvollständig: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{} is no folder of an analysis: {} {}</source>
        <translation>{} ist kein Ordner einer Analyse: {} {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>{} is no proper {} file: {}</source>
        <translation>{} ist keine richtige {}-Datei: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{} is not a whole analysis: {}</source>
        <translation>{} ist keine vollständige Analyse: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>{} is not allowed in {}</source>
        <translation>{} ist in {} nicht erlaubt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>{} layers of {} voxels cannot hold {}</source>
        <translation>{} Schichten von {} Voxeln können {} nicht fassen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{} mm {} on {}</source>
        <translation>{} mm {} an {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>{} mm, {} mm3</source>
        <translation>{} mm, {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>{} mm3 together</source>
        <translation>{} mm3 zusammen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{} must be JSON: {}</source>
        <translation>{} muss JSON sein: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/tables.py"/>
        <source>{} must be UTF-8 text: {}</source>
        <translation>{} muss UTF-8-Text sein: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>{} must be a closed mesh of finite co-ordinates, got {}</source>
        <translation>{} muss ein geschlossenes Netz mit endlichen Koordinaten sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/meshes.py"/>
        <source>{} must be a closed mesh, each edge in two triangles that run along it opposite ways; it has {} triangles, {} open edges, {} edges of more than two triangles, {} edges run unevenly, {} triangles with a vertex named twice</source>
        <translation>{} muss ein geschlossenes Netz sein, jede Kante in zwei Dreiecken, die sie gegenläufig durchlaufen; es hat {} Dreiecke, {} offene Kanten, {} Kanten von mehr als zwei Dreiecken, {} ungleich durchlaufene Kanten, {} Dreiecke mit doppelter Ecke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>{} must be a finite number, got {}</source>
        <translation>{} muss eine endliche Zahl sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>{} must be a flat image, got {}</source>
        <translation>{} muss ein flaches Bild sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/json_values.py"/>
        <source>{} must be a list of numbers, got {}</source>
        <translation>{} muss eine Liste von Zahlen sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/json_values.py"/>
        <source>{} must be a list of numbers: {}</source>
        <translation>{} muss eine Liste von Zahlen sein: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/json_values.py"/>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>{} must be a list, got {}</source>
        <translation>{} muss eine Liste sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>{} must be a number a computer can hold, got {}</source>
        <translation>{} muss eine Zahl sein, die ein Rechner fasst, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{} must be a whole NPY file of numbers: {}</source>
        <translation>{} muss eine vollständige NPY-Datei mit Zahlen sein: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>{} must be an image that can be read: {}</source>
        <translation>{} muss ein lesbares Bild sein: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/json_values.py"/>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>{} must be an object with keys, got {}</source>
        <translation>{} muss ein Objekt mit Schlüsseln sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>{} must be at least 0, got {}</source>
        <translation>{} muss mindestens 0 sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>{} must be at least {}, got {}</source>
        <translation>{} muss mindestens {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>{} must be computed anew: {}</source>
        <translation>{} muss neu berechnet werden: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/colouring.py"/>
        <source>{} must be computed before its rods are coloured, got: {}</source>
        <translation>{} muss berechnet sein, bevor seine Stäbe gefärbt werden, Zustand: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>{} must be finite, got {}</source>
        <translation>{} muss endlich sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>{} must be finite, or nan for the body's own, got {}</source>
        <translation>{} muss endlich sein, oder nan für den Wert des Körpers, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>{} must be linked to 1 face, got {}</source>
        <translation>{} muss mit 1 Fläche verknüpft sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/prism_sites.py"/>
        <source>{} must be linked to a box, got nothing</source>
        <translation>{} muss mit einem Quader verknüpft sein, hier nichts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/prism_sites.py"/>
        <source>{} must be linked to a box, got {}</source>
        <translation>{} muss mit einem Quader verknüpft sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>{} must be linked to a scaffold, got {}</source>
        <translation>{} muss mit einem Gerüst verknüpft sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>{} must be linked to a wireframe, got {}</source>
        <translation>{} muss mit einem Drahtmodell verknüpft sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>{} must be made of curves to get others, it follows another sample</source>
        <translation>{} muss aus Kurven gemacht sein, um andere zu bekommen, folgt aber einer anderen Probe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>{} must be one number or three, got {}</source>
        <translation>{} muss aus einer Zahl oder dreien bestehen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>{} must be one of {}, got {}</source>
        <translation>{} muss eines von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{} must be the report of a {}</source>
        <translation>{} muss der Bericht einer {} sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>{} must be up to date for its contours, got: {}</source>
        <translation>{} muss für seine Konturen aktuell sein, Zustand: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_files.py"/>
        <source>{} must be up to date to be saved, got: {}</source>
        <translation>{} muss zum Speichern aktuell sein, Zustand: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/exports.py"/>
        <source>{} must be up to date to be written: update it first</source>
        <translation>{} muss zum Schreiben aktuell sein: zuerst aktualisieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scripts.py"/>
        <source>{} must be without error to be written as a script, got: {}</source>
        <translation>{} muss ohne Fehler sein, um als Skript geschrieben zu werden, Zustand: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/exports.py"/>
        <source>{} must be without error to be written, got {}</source>
        <translation>{} muss zum Schreiben ohne Fehler sein, Zustand: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/json_values.py"/>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>{} must be {}, got {}</source>
        <translation>{} muss {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{} must begin with NRRD000, got {}</source>
        <translation>{} muss mit NRRD000 beginnen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{} must give the sizes of its voxels (spacings or space directions)</source>
        <translation>{} muss die Größen seiner Voxel nennen (spacings oder space directions)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{} must have a column {}; it has, got {}</source>
        <translation>{} muss eine Spalte {} haben; sie hat, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{} must have a line of names and one for each layer, got {}</source>
        <translation>{} muss eine Zeile mit Namen und eine je Schicht haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/exports.py"/>
        <source>{} must have a mesh or a shape to be written, got neither</source>
        <translation>{} muss zum Schreiben ein Netz oder eine Form haben, hier keines</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_inputs.py"/>
        <source>{} must have a sample, a source, a file or drawn curves, got none</source>
        <translation>{} muss eine Probe, einen Körper, eine Datei oder gezeichnete Kurven haben, hier keines</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>{} must have a source or a file to be sliced, got neither</source>
        <translation>{} muss einen Körper oder eine Datei zum Schneiden haben, hier keines</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>{} must have at least one rod, got 0</source>
        <translation>{} muss mindestens einen Stab haben, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>{} must have at least one solid, got a {} without one</source>
        <translation>{} muss mindestens einen Volumenkörper haben, hier {} ohne einen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>{} must have at least one solid, got no shape</source>
        <translation>{} muss mindestens einen Volumenkörper haben, hier keine Form</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>{} must have at least one triangle, got 0</source>
        <translation>{} muss mindestens ein Dreieck haben, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>{} must have been computed, got: {}</source>
        <translation>{} muss berechnet sein, Zustand: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{} must have the layers 0, 1, ... along {}, got {}</source>
        <translation>{} muss die Schichten 0, 1, ... entlang {} haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{} must have the schema {}, got {}</source>
        <translation>{} muss das Schema {} haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>{} must have the sheets alpha and beta; it has, got {}</source>
        <translation>{} muss die Blätter alpha und beta haben; sie hat, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>{} must have triangles counter-clockwise seen from outside, got a volume of {} mm3</source>
        <translation>{} muss Dreiecke haben, die von außen gesehen gegen den Uhrzeigersinn laufen, hier ein Volumen von {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/exports.py"/>
        <source>{} must have triangles to be written, got 0</source>
        <translation>{} muss zum Schreiben Dreiecke haben, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>{} must have {} values, got {}</source>
        <translation>{} muss {} Werte haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{} must hold an array of three axes, got {}</source>
        <translation>{} muss ein Feld mit drei Achsen enthalten, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/layer_analysis.py"/>
        <source>{} must hold at least one layer, got 0</source>
        <translation>{} muss mindestens eine Schicht enthalten, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>{} must hold at least one triangle, got 0</source>
        <translation>{} muss mindestens ein Dreieck enthalten, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{} must hold finite numbers, got {} that are not</source>
        <translation>{} muss endliche Zahlen enthalten, hier {}, die es nicht sind</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>{} must hold images ({}), got {}</source>
        <translation>{} muss Bilder enthalten ({}), hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{} must hold numbers, got {}</source>
        <translation>{} muss Zahlen enthalten, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{} must hold {}</source>
        <translation>{} muss {} enthalten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{} must hold, got {}</source>
        <translation>{} muss enthalten, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/propagation_steps.py"/>
        <source>{} must lie in 0..{}, got {}</source>
        <translation>{} muss in 0..{} liegen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>{} must lie in {}..{}, got {}</source>
        <translation>{} muss in {}..{} liegen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_sites.py"/>
        <source>{} must lie on it to {} mm, got a distance of {} mm</source>
        <translation>{} muss auf {} mm darauf liegen, hier ein Abstand von {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>{} must name a field of the job; known here are {}, got {}</source>
        <translation>{} muss ein Feld des Auftrags nennen; bekannt sind hier {}, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>{} must number one of {} entries, got {}</source>
        <translation>{} muss eine von {} Zeilen nummerieren, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/colouring.py"/>
        <source>{} must show the rods of {}, got {}: update it</source>
        <translation>{} muss die Stäbe von {} zeigen, hier {}: aktualisieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>{} needs brackets</source>
        <translation>{} braucht Klammern</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/meshes.py"/>
        <source>{} of a mesh must have the shape (count, 3), got {}</source>
        <translation>{} eines Netzes müssen die Form (Anzahl, 3) haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>{} of it apart</source>
        <translation>{} davon auseinander</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>{} of the body and the voxels</source>
        <translation>{} des Körpers und der Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>{} of the envelope</source>
        <translation>{} des Hüllkörpers</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/estimates.py"/>
        <source>{} of {}</source>
        <translation>{} {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>{} of {} and {}</source>
        <translation>{} von {} und {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{} of {} rods were faulty when they were drawn.</source>
        <translation>{} von {} Stäben waren fehlerhaft, als sie gezogen wurden.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>{} pairs of pores overlap on face {}: pores must be smaller than their spacing</source>
        <translation>{} Porenpaare überlappen sich auf Fläche {}: Poren müssen kleiner als ihr Abstand sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>{} pairs that come near</source>
        <translation>{} Paare, die sich nahe kommen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>{} parts</source>
        <translation>{} Teile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>{} pores reach over the border of face {}: half their size must not exceed the distance from it</source>
        <translation>{} Poren reichen über den Rand von Fläche {}: ihre halbe Größe darf den Abstand davon nicht überschreiten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>{} rods</source>
        <translation>{} Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>{} rods, {} mm^3 with overlaps</source>
        <translation>{} Stäbe, {} mm^3 mit Überlappungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>{} sites</source>
        <translation>{} Stellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>{} slices, bone fraction {} %</source>
        <translation>{} Schnitte, Knochenanteil {} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>{} slices, {} of them spoilt, bone fraction {} %</source>
        <translation>{} Schnitte, {} davon fehlerhaft, Knochenanteil {} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>{} standard errors, loose pieces and voids left aside</source>
        <translation>{} Standardfehler, lose Teile und Hohlräume nicht beachtet</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>{} that no opening reaches, {} mm3 together: {}</source>
        <translation>{} ohne Öffnung, zusammen {} mm3: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>{} through others: what overlaps {} (fill rule '{}')</source>
        <translation>{} durch andere: was sich überlappt, {} (Füllregel '{}')</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>{} to {}</source>
        <translation>{} bis {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{} to {} ({})</source>
        <translation>{} bis {} ({})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/meshes.py"/>
        <source>{} vertices still share their point in single precision after {} nudges</source>
        <translation>{} Ecken teilen nach {} Verschiebungen in einfacher Genauigkeit noch ihren Punkt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>{} voxels in one part, exact along X, Y and Z, bone fraction {} %</source>
        <translation>{} Voxel in einem Teil, genau entlang X, Y und Z, Knochenanteil {} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>{} voxels in {} parts, exact along X, Y and Z, bone fraction {} %</source>
        <translation>{} Voxel in {} Teilen, genau entlang X, Y und Z, Knochenanteil {} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/migrations.py"/>
        <source>{} was made by a later version of Trabecula: its schema must be at most {}, got {}; update Trabecula</source>
        <translation>{} stammt von einer späteren Version von Trabecula: sein Schema darf höchstens {} sein, hier {}; Trabecula aktualisieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>{} without area: no slice is spoilt by that</source>
        <translation>{} ohne Fläche: kein Schnitt ist dadurch fehlerhaft</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>{} x {} x {} layers, {} cells: about {} GB of memory and {} s</source>
        <translation>{} x {} x {} Schichten, {} Zellen: etwa {} GB Speicher und {} s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/flows.py"/>
        <source>{} {} ask for {} voxels together, but </source>
        <translation>{} {} verlangen zusammen {} Voxel, aber </translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/flows.py"/>
        <source>{} {} ask for {} voxels together, but the other layers along {} are asked for {} in all</source>
        <translation>{} {} verlangen zusammen {} Voxel, aber von den anderen Schichten entlang {} sind insgesamt {} verlangt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>{} {} must be one JSON object, got {}: {}</source>
        <translation>{} {} muss ein JSON-Objekt sein, hier {}: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>{} {} sums to {}, asked for {}</source>
        <translation>{} {} ergibt {}, verlangt {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_search.py"/>
        <source>{} {} times</source>
        <translation>{} {}-mal</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{}, box of {} mm</source>
        <translation>{}, Quader {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{}, box of {} mm about {} mm</source>
        <translation>{}, Quader {} mm um {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>{}, cut off all round, {} mm3 together, the largest {} mm3: {}</source>
        <translation>{}, ringsum abgetrennt, zusammen {} mm3, das größte {} mm3: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>{}, got {}</source>
        <translation>{}, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>{}, got {} {}</source>
        <translation>{}, hier {} {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/tables.py"/>
        <source>{}, line 1: the columns must be {}, got {}</source>
        <translation>{}, Zeile 1: die Spalten müssen {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{}, line {}</source>
        <translation>{}, Zeile {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{}, line {}: a layer must stand there once, got {}</source>
        <translation>{}, Zeile {}: eine Schicht muss dort einmal stehen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/tables.py"/>
        <source>{}, line {}: it must hold {} numbers, got {}</source>
        <translation>{}, Zeile {}: sie muss {} Zahlen enthalten, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{}, line {}: the axis must be x, y or z, got {}</source>
        <translation>{}, Zeile {}: die Achse muss x, y oder z sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>{}, seen from a corner</source>
        <translation>{}, von einer Ecke gesehen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{}, size {} mm</source>
        <translation>{}, Größe {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: a binary STL file has at least {}{} bytes, got {}</source>
        <translation>{}: eine binäre STL-Datei hat mindestens {}{} Bytes, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>{}: a mesh file must end in .stl, .obj, .ply or .3mf, got {}</source>
        <translation>{}: eine Netzdatei muss auf .stl, .obj, .ply oder .3mf enden, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <source>{}: a polyline must end with C or O; that of line {}{} is cut off</source>
        <translation>{}: ein Linienzug muss mit C oder O enden; der von Zeile {}{} ist abgeschnitten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>{}: a table must have sums and cells, got rows, got {}</source>
        <translation>{}: eine Tabelle muss Summen und Zellen haben, hier Zeilen, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: a voxel must have three edges above 0, got {}</source>
        <translation>{}: ein Voxel muss drei Kanten über 0 haben, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>{}: all rows must have the same length, got {}</source>
        <translation>{}: alle Zeilen müssen gleich lang sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: an ASCII STL file must end with 'endsolid'; this one is cut off</source>
        <translation>{}: eine ASCII-STL-Datei muss mit 'endsolid' enden; diese ist abgeschnitten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <source>{}: an SSL file must begin with 'Slice V0' and 'SLICES()'; this one holds neither</source>
        <translation>{}: eine SSL-Datei muss mit 'Slice V0' und 'SLICES()' beginnen; diese enthält keines</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: an STL file must hold at least one triangle, got 0</source>
        <translation>{}: eine STL-Datei muss mindestens ein Dreieck enthalten, hier 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{}: axes.{} does not fit its profile of {} slices: {}</source>
        <translation>{}: axes.{} passt nicht zu seinem Profil von {} Schnitten: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>{}: co-ordinates must be finite</source>
        <translation>{}: Koordinaten müssen endlich sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>{}: co-ordinates must be finite and at most {} mm, got {}..{} mm</source>
        <translation>{}: Koordinaten müssen endlich und höchstens {} mm sein, hier {}..{} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: co-ordinates must be finite; triangle {}{} of {} has {}</source>
        <translation>{}: Koordinaten müssen endlich sein; Dreieck {}{} von {} hat {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: co-ordinates must be numbers: {}</source>
        <translation>{}: Koordinaten müssen Zahlen sein: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>{}: direction in which a linear law grows</source>
        <translation>{}: Richtung, in der ein lineares Gesetz wächst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: each facet must have three vertices, got {} vertices in {} facets</source>
        <translation>{}: jede Facette muss drei Ecken haben, hier {} Ecken in {} Facetten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>{}: every sum and cell must be a whole number, got {}</source>
        <translation>{}: jede Summe und Zelle muss eine ganze Zahl sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>{}: formula of x, y, z (mm) and a random u in 0..1</source>
        <translation>{}: Formel mit x, y, z (mm) und einer Zufallszahl u in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>{}: how it varies over the design</source>
        <translation>{}: wie es sich über den Entwurf ändert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{}: it must be a number, got {}</source>
        <translation>{}: es muss eine Zahl sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{}: its values must be lists of numbers: {}</source>
        <translation>{}: seine Werte müssen Listen von Zahlen sein: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{}: layers must be those of the profile</source>
        <translation>{}: die Schichten müssen die des Profils sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{}: mesh</source>
        <translation>{}: Netz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{}: morphometry</source>
        <translation>{}: Morphometrie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{}: parameters</source>
        <translation>{}: Parameter</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: sizes must be three numbers above 0, got {}</source>
        <translation>{}: Größen müssen drei Zahlen über 0 sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: sizes must be whole numbers, got {}</source>
        <translation>{}: Größen müssen ganze Zahlen sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: spacings, directions and origin must be numbers: {}</source>
        <translation>{}: spacings, directions und origin müssen Zahlen sein: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/tables.py"/>
        <source>{}: the column {} must hold whole numbers</source>
        <translation>{}: die Spalte {} muss ganze Zahlen enthalten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>{}: the constant value, or the least; linear, radial: at the start</source>
        <translation>{}: der feste Wert oder der kleinste; linear, radial: am Anfang</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_search.py"/>
        <source>{}: the counts weigh {}, no design above {}</source>
        <translation>{}: die Anzahlen wiegen {}, kein Entwurf über {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: the data must stand in the file itself, not in a data file of their own</source>
        <translation>{}: die Daten müssen in der Datei selbst stehen, nicht in einer eigenen Datendatei</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: the encoding must be raw or gzip, got {}</source>
        <translation>{}: die Kodierung muss raw oder gzip sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: the file became shorter while it was read, at triangle {}{}</source>
        <translation>{}: die Datei wurde beim Lesen kürzer, bei Dreieck {}{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>{}: the greatest value; linear, radial: at the end</source>
        <translation>{}: der größte Wert; linear, radial: am Ende</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: the header must end with an empty line; the file is cut off</source>
        <translation>{}: der Kopf muss mit einer leeren Zeile enden; die Datei ist abgeschnitten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/tables.py"/>
        <source>{}: the layers must be counted 0, 1, 2, ...</source>
        <translation>{}: die Schichten müssen 0, 1, 2, ... gezählt sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: the packed data are damaged or cut off: {}</source>
        <translation>{}: die gepackten Daten sind beschädigt oder abgeschnitten: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: the size of a binary STL file must be 84 + 50 bytes for each triangle; its header says {} triangles, {} bytes hold {} and {} bytes more</source>
        <translation>{}: eine binäre STL-Datei muss 84 + 50 Bytes je Dreieck haben; ihr Kopf sagt {} Dreiecke, {} Bytes fassen {} und {} Bytes mehr</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: the type must be one of {}, got {}</source>
        <translation>{}: der Typ muss einer von {} sein, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>{}: triangles must name vertices 0..{}, got {}..{}</source>
        <translation>{}: Dreiecke müssen Ecken 0..{} nennen, hier {}..{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>{}: {} against {}, {} apart (at most {})</source>
        <translation>{}: {} gegen {}, {} auseinander (höchstens {})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>{}: {} is resampled by area from layers of {} mm.</source>
        <translation>{}: {} wird flächentreu aus Schichten von {} mm umgerechnet.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>{}: {} layers of {} mm, {} to {} mm.</source>
        <translation>{}: {} Schichten von {} mm, {} bis {} mm.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>{}: {} reaches {} mm below and {} mm above.</source>
        <translation>{}: {} reicht {} mm tiefer und {} mm höher.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>{}: {} to {} mm</source>
        <translation>{}: {} bis {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: {} x {} x {} values of {} are {} bytes, got {}</source>
        <translation>{}: {} x {} x {} Werte von {} sind {} Bytes, hier {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>{}; closed layers need a Boolean</source>
        <translation>{}; geschlossene Schichten brauchen eine boolesche Operation</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>{}; exact</source>
        <translation>{}; genau</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/optional_packages.py"/>
        <source>{}; install it with: {}</source>
        <translation>{}; so wird es installiert: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>{}; the exact mesh engine needs manifold3d: {}</source>
        <translation>{}; das genaue Netzverfahren braucht manifold3d: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>{}; the exact mesh engine would take about {} s</source>
        <translation>{}; das genaue Netzverfahren bräuchte etwa {} s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>{}; {} sums or cells are wrong</source>
        <translation>{}; {} Summen oder Zellen sind falsch</translation>
    </message>
</context>
<context>
    <name>Labels</name>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Analysis {}</source>
        <translation>Analyse {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Envelope</source>
        <translation>Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Example_measure</source>
        <translation>Beispiel_Messung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Example_rods</source>
        <translation>Beispiel_Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Example_voxels</source>
        <translation>Beispiel_Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Layers of {}</source>
        <translation>Schichten von {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Loose</source>
        <translation>Lose Teile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Network</source>
        <translation>Netzwerk</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Scaffold</source>
        <translation>Gerüst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Sites</source>
        <translation>Stellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Sites {}</source>
        <translation>Stellen {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>SolidScaffold</source>
        <translation>Gerüst (Volumenkörper)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Specimen {}</source>
        <translation>Präparat {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Voids</source>
        <translation>Hohlräume</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Voxels of drawn curves</source>
        <translation>Voxel gezeichneter Kurven</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Voxels {}</source>
        <translation>Voxel {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Wireframe</source>
        <translation>Drahtmodell</translation>
    </message>
</context>
<context>
    <name>Trabecula</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>  area</source>
        <translation>  Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>  at</source>
        <translation>  bei</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>  size</source>
        <translation>  Größe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>, layers on {} faces</source>
        <translation>, Schichten auf {} Flächen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>, porosity {:.2f} %</source>
        <translation>, Porosität {:.2f} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>, {} left</source>
        <translation>, noch {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <source>1 section</source>
        <translation>1 Querschnitt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <source>2 sections</source>
        <translation>2 Querschnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>30 to 75 s a rod, by curvature and sections (thesis 2.3.3)</source>
        <translation>30 bis 75 s je Stab, nach Krümmung und Querschnitten (Dissertation 2.3.3)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>A click brings in a mesh or a solid from a file; one of the document will do as well.</source>
        <translation>Ein Klick holt ein Netz oder einen Volumenkörper aus einer Datei; eines aus dem Dokument genügt ebenso.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>A further direction: as if the part were turned</source>
        <translation>Eine weitere Richtung: als wäre das Teil gedreht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>A mesh, an analysis' CSV, targets or voxels from a file</source>
        <translation>Netz, CSV einer Analyse, Zielwerte oder Voxel aus einer Datei</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/install.py"/>
        <source>A package is missing</source>
        <translation>Ein Paket fehlt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>Across the direction in which you look now</source>
        <translation>Quer zur jetzigen Blickrichtung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Add a convergence point</source>
        <translation>Einen Konvergenzpunkt hinzufügen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Add a coupling</source>
        <translation>Eine Kopplung hinzufügen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>All sums are right and every layer can be filled</source>
        <translation>Alle Summen stimmen, und jede Schicht kann gefüllt werden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>All ways to work</source>
        <translation>Alle Arbeitswege</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysing.py"/>
        <location filename="../../freecad_trabecula/gui/analysis_panel.py"/>
        <source>Analyse</source>
        <translation>Analysieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>Analyse a mesh, a solid or a design to see its slices</source>
        <translation>Netz, Volumenkörper oder Entwurf analysieren, um die Schnitte zu sehen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Analyse it</source>
        <translation>Analysieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Analyse the scaffold</source>
        <translation>Das Gerüst analysieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Analyse the voxels</source>
        <translation>Die Voxel analysieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Another bone, or a design: a click brings it in, the next one measures it.</source>
        <translation>Ein weiterer Knochen oder ein Entwurf: ein Klick holt ihn herein, der nächste vermisst ihn.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>Areas</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>As</source>
        <translation>Als</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>As many voxels in every layer along X, Y and Z as the targets ask, in one piece.</source>
        <translation>So viele Voxel in jeder Schicht entlang X, Y und Z, wie die Zielwerte verlangen, zusammenhängend.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>As seen</source>
        <translation>Wie gesehen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>As they were</source>
        <translation>Wie zuvor</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Available</source>
        <translation>Verfügbar</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>Begin with</source>
        <translation>Beginnen mit</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Being computed …</source>
        <translation>Wird berechnet …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Blocks keep volume and areas exactly; smooth keeps the volume</source>
        <translation>Blöcke halten Volumen und Flächen genau ein; glatt hält das Volumen ein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <location filename="../../freecad_trabecula/gui/export_dialog.py"/>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Body to be sliced</source>
        <translation>Körper, der geschnitten wird</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Body within which voxels may lie</source>
        <translation>Körper, in dem Voxel liegen dürfen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Bone fraction</source>
        <translation>Knochenanteil</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/prism_section.py"/>
        <source>Border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Border u, v</source>
        <translation>Rand u, v</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Both on shared axes, with their differences and a passport of how near they are.</source>
        <translation>Beide auf gemeinsamen Achsen, mit ihren Differenzen und einem Pass, wie nahe sie sich sind.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/why.py"/>
        <source>Both routes</source>
        <translation>Beide Wege</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/renewing.py"/>
        <source>Bring up to date</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/build_bar.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_panel.py"/>
        <source>Build</source>
        <translation>Erzeugen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Build the scaffold</source>
        <translation>Das Gerüst erzeugen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/build_bar.py"/>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <location filename="../../freecad_trabecula/gui/recomputing.py"/>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Cell</source>
        <translation>Zelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Cells at its border</source>
        <translation>Zellen am Rand</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Change a value and build again: analysis and comparison follow in the plots.</source>
        <translation>Einen Wert ändern und neu erzeugen: Analyse und Vergleich folgen in den Diagrammen.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Change the design</source>
        <translation>Den Entwurf ändern</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/edits_list.py"/>
        <source>Changes by hand</source>
        <translation>Änderungen von Hand</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_panel.py"/>
        <source>Checking the envelope …</source>
        <translation>Der Hüllkörper wird geprüft …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Checks</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Choice</source>
        <translation>Wahl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_panel.py"/>
        <source>Choose a body or a file</source>
        <translation>Körper oder Datei wählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>Click a rod in the 3D view</source>
        <translation>Einen Stab in der 3D-Ansicht anklicken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Click faces in the 3D view; a second click takes one away</source>
        <translation>Flächen in der 3D-Ansicht anklicken; ein zweiter Klick nimmt eine weg</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_view.py"/>
        <source>Click for a new point, drag points, right click takes one away</source>
        <translation>Klicken für einen neuen Punkt, Punkte ziehen, Rechtsklick nimmt einen weg</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/task_panels.py"/>
        <source>Close the open task panel first</source>
        <translation>Zuerst das offene Aufgabenfenster schließen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/build_bar.py"/>
        <source>Close the panel; the status bar shows how far it is and can end it</source>
        <translation>Das Panel schließen; die Statusleiste zeigt, wie weit es ist, und kann es beenden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Closed cavities</source>
        <translation>Geschlossene Hohlräume</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Closes channels</source>
        <translation>Verschließt Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Co-ordinates of the planes, mm, for planes at heights</source>
        <translation>Koordinaten der Ebenen in mm, für Ebenen auf Höhen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Colour by</source>
        <translation>Farbe nach</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Compact layers</source>
        <translation>Kompakte Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Compensation</source>
        <translation>Korrektur</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Component of the unit tangent, 0 to 1</source>
        <translation>Komponente der Einheitstangente, 0 bis 1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Connected channels</source>
        <translation>Zusammenhängende Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Connected parts</source>
        <translation>Zusammenhängende Teile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Connected pieces of the scaffold</source>
        <translation>Zusammenhängende Gerüstteile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>Constant value, or least; at the start</source>
        <translation>Fester Wert oder kleinster Wert; am Anfang</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Contacts avoided</source>
        <translation>Kontakte meiden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Contacts by a corner alone</source>
        <translation>Kontakte nur über eine Ecke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Contacts by an edge alone</source>
        <translation>Kontakte nur über eine Kante</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Convergence point</source>
        <translation>Konvergenzpunkt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Convergence points: {}</source>
        <translation>Konvergenzpunkte: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Convergence: centre of the envelope</source>
        <translation>Konvergenz: Mitte des Hüllkörpers</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Couple the opposite faces of the prism</source>
        <translation>Die gegenüberliegenden Flächen des Prismas koppeln</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Couplings</source>
        <translation>Kopplungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>Cut</source>
        <translation>Anschnitt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Deflection</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Design a scaffold in this body</source>
        <translation>Ein Gerüst in diesem Körper entwerfen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/building.py"/>
        <location filename="../../freecad_trabecula/gui/design_panel.py"/>
        <source>Design rods</source>
        <translation>Stäbe entwerfen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Design the rods</source>
        <translation>Die Stäbe entwerfen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Design the voxels</source>
        <translation>Die Voxel entwerfen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_panel.py"/>
        <source>Design voxels</source>
        <translation>Voxel entwerfen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>Design voxels of a body or an analysis to see their layers</source>
        <translation>Voxel aus einem Körper oder einer Analyse entwerfen, um ihre Schichten zu sehen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Design voxels that match a bone</source>
        <translation>Voxel entwerfen, die zu einem Knochen passen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Design with these</source>
        <translation>Damit entwerfen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>Direction in which the value grows</source>
        <translation>Richtung, in der der Wert wächst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Direction u</source>
        <translation>Richtung u</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Direction v</source>
        <translation>Richtung v</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>Draw sliced areas</source>
        <translation>Schnittflächen zeichnen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Draw the sliced areas along X, Y and Z, anew or from those of an analysis</source>
        <translation>Die Schnittflächen entlang X, Y und Z zeichnen, neu oder nach denen einer Analyse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Earlier: its faces' sites are taken first</source>
        <translation>Früher: die Stellen ihrer Flächen werden zuerst vergeben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/prism_section.py"/>
        <source>Edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>Edges X, Y, Z</source>
        <translation>Kanten X, Y, Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Edit site and pore</source>
        <translation>Stelle und Pore bearbeiten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Engine</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Envelope</source>
        <translation>Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Envelope and surface</source>
        <translation>Hüllkörper und Oberfläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Estimate by rays (quick)</source>
        <translation>Schätzung mit Strahlen (schnell)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Every slice along X, Y and Z is measured: areas, porosity, contours.</source>
        <translation>Jeder Schnitt entlang X, Y und Z wird vermessen: Flächen, Porosität, Konturen.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Exact on every layer of the three axes</source>
        <translation>Genau in jeder Schicht der drei Achsen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Example</source>
        <translation>Beispiel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/example_projects.py"/>
        <source>Example project</source>
        <translation>Beispielprojekt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <location filename="../../freecad_trabecula/gui/export_dialog.py"/>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Export …</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Face at which the rods start</source>
        <translation>Fläche, an der die Stäbe beginnen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Face at which they end</source>
        <translation>Fläche, an der sie enden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Figures</source>
        <translation>Kennzahlen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Filter open, closed</source>
        <translation>Filter offen, geschl.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>First layer along Z</source>
        <translation>Erste Schicht entlang Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>First site</source>
        <translation>Erste Stelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>First tension</source>
        <translation>Spannung 1. Ende</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_saving.py"/>
        <source>Folder for tables, report and plots</source>
        <translation>Ordner für Tabellen, Bericht und Diagramme</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_export.py"/>
        <source>Folder for the images' folder</source>
        <translation>Ordner für den Bilderordner</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/export_dialog.py"/>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/why.py"/>
        <source>Formula</source>
        <translation>Formel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>Formula of x, y, z (mm) and a random u in 0..1</source>
        <translation>Formel mit x, y, z (mm) und einer Zufallszahl u in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Gap fill</source>
        <translation>Lücken schließen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Give all faces the spacings and borders of the chosen one</source>
        <translation>Allen Flächen die Abstände und Ränder der gewählten geben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Give colours a meaning; a legend says which. Select objects, or nothing for all that are seen</source>
        <translation>Farben eine Bedeutung geben; eine Legende sagt, welche. Objekte auswählen, oder nichts für alle sichtbaren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Glass envelope</source>
        <translation>Gläserner Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Glossary</source>
        <translation>Glossar</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/qt.py"/>
        <source>Glossary: what the words mean</source>
        <translation>Glossar: was die Wörter bedeuten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>Greatest value; at the end</source>
        <translation>Größter Wert; am Ende</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Guide</source>
        <translation>Leitfaden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Heat map</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/qt.py"/>
        <source>Help: what can be done here</source>
        <translation>Hilfe: was hier getan werden kann</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>How sites are set</source>
        <translation>Wie Stellen gesetzt werden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>How the cut is filled</source>
        <translation>Wie der Anschnitt gefüllt wird</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/build_bar.py"/>
        <source>In the background</source>
        <translation>Im Hintergrund</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/install.py"/>
        <source>Install {}</source>
        <translation>{} installieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>It could not be computed: its Status says why.</source>
        <translation>Es konnte nicht berechnet werden: sein Status sagt, warum.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Keep loose pieces</source>
        <translation>Lose Teile behalten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>Last layer</source>
        <translation>Letzte Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>Layer along Z</source>
        <translation>Schicht entlang Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>Layer shapes</source>
        <translation>Schichtkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>Layers</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Layers along X, Y, Z</source>
        <translation>Schichten entlang X, Y, Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <source>Layout</source>
        <translation>Form</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Lean</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Least thickness</source>
        <translation>Mindestdicke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Least void</source>
        <translation>Mindesthohlraum</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Left</source>
        <translation>Übrig</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Lines solved</source>
        <translation>Gelöste Linien</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Look at the layers</source>
        <translation>Die Schichten ansehen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Look at the plots</source>
        <translation>Die Diagramme ansehen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Look through</source>
        <translation>Durchsehen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Look through bodies and envelope. Select a design, or nothing for all</source>
        <translation>Durch Körper und Hüllkörper sehen. Einen Entwurf auswählen, oder nichts für alle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Loose pieces</source>
        <translation>Lose Teile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Mean bone fraction, %</source>
        <translation>Mittlerer Knochenanteil, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Mean deviation of the trabeculae, %</source>
        <translation>Mittlere Abweichung der Trabekel, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Measure a bone</source>
        <translation>Einen Knochen vermessen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Measure a bone or a design</source>
        <translation>Einen Knochen oder Entwurf vermessen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Measure another</source>
        <translation>Noch einen vermessen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Measure the targets</source>
        <translation>Die Zielwerte messen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Measures</source>
        <translation>Maße</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Memory budget</source>
        <translation>Speichergrenze</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>Mended</source>
        <translation>Repariert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Mending</source>
        <translation>Reparatur</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Meshes</source>
        <translation>Netze</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Most in a line (x, z)</source>
        <translation>Höchstens je Linie (x, z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Most in a line (y, z)</source>
        <translation>Höchstens je Linie (y, z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Most rods</source>
        <translation>Höchstens Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Move site</source>
        <translation>Stelle verschieben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>No preview</source>
        <translation>Keine Vorschau</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>No rod is left out</source>
        <translation>Kein Stab fehlt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>No rod leaves the envelope</source>
        <translation>Kein Stab verlässt den Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>No voxels fill layer {} along Z; {} layers do not go</source>
        <translation>Keine Voxel füllen Schicht {} entlang Z; {} Schichten gehen nicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Not now: the steps before it come first</source>
        <translation>Jetzt nicht: die Schritte davor kommen zuerst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/command.py"/>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Not now: {}</source>
        <translation>Jetzt nicht: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Nothing was found.</source>
        <translation>Nichts gefunden.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/why.py"/>
        <source>Number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>Off: share of the layer in %</source>
        <translation>Aus: Anteil der Schicht in %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Off: three edges along X, Y, Z</source>
        <translation>Aus: drei Kanten entlang X, Y, Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_export.py"/>
        <source>One image a layer along Z, in a new folder</source>
        <translation>Ein Bild je Schicht entlang Z, in einem neuen Ordner</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>One number reproduces all draws</source>
        <translation>Eine Zahl, die alle Zufallsziehungen wiederholbar macht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>One step back</source>
        <translation>Einen Schritt zurück</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>One step on</source>
        <translation>Einen Schritt vor</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>One total</source>
        <translation>Eine Summe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Only from, to</source>
        <translation>Nur von, bis</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Open a small project of this kind, in a new document</source>
        <translation>Ein kleines Projekt dieser Art in einem neuen Dokument öffnen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_envelope.py"/>
        <source>Open envelope</source>
        <translation>Hüllkörper öffnen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Open job</source>
        <translation>Auftrag öffnen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Opposite faces</source>
        <translation>Gegenüberliegende Flächen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Other seeds: {}</source>
        <translation>Andere Startwerte: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>Other side</source>
        <translation>Andere Seite</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Out of date: click to bring everything up to date.</source>
        <translation>Veraltet: klicken, um alles zu aktualisieren.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Outer contours</source>
        <translation>Äußere Konturen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>Outside</source>
        <translation>Außerhalb</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Overlaps</source>
        <translation>Überlappungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Pairs of tables</source>
        <translation>Tabellenpaare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>Passport</source>
        <translation>Pass</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Path</source>
        <translation>Pfad</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Path: {}</source>
        <translation>Pfad: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>Paths</source>
        <translation>Pfade</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Paths from {} to {}</source>
        <translation>Pfade von {} nach {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Paths of its own</source>
        <translation>Eigene Pfade</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Paths of this coupling alone</source>
        <translation>Pfade nur dieser Kopplung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Pick a body</source>
        <translation>Einen Körper wählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/picking.py"/>
        <source>Pick a face of {}</source>
        <translation>Eine Fläche von {} anklicken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Pick a site</source>
        <translation>Eine Stelle anklicken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Pick faces</source>
        <translation>Flächen wählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Pick the origin on the chosen face</source>
        <translation>Ursprung auf der gewählten Fläche anklicken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Place of the site</source>
        <translation>Ort der Stelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Plain colours</source>
        <translation>Einfache Farben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Plain sum of the rods</source>
        <translation>Einfache Summe der Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Plates</source>
        <translation>Platten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Point at a diagram: the slice there is drawn beside it and shown in the 3D view.</source>
        <translation>Auf ein Diagramm zeigen: der Schnitt dort wird daneben gezeichnet und in der 3D-Ansicht gezeigt.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Pore sizes</source>
        <translation>Porengrößen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preferences.py"/>
        <source>PoreSmallest and PoreLargest: {}; {:g} and {:g} mm are taken</source>
        <translation>PoreSmallest und PoreLargest: {}; {:g} und {:g} mm werden genommen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>Pores</source>
        <translation>Poren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Porosity</source>
        <translation>Porosität</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Porosity in</source>
        <translation>Porosität in</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Porosity of slices along X</source>
        <translation>Porosität der Schnitte entlang X</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Porosity of slices along Y</source>
        <translation>Porosität der Schnitte entlang Y</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Porosity of slices along Z</source>
        <translation>Porosität der Schnitte entlang Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Porosity of the scaffold (Eq. 2.2)</source>
        <translation>Porosität des Gerüsts (Gl. 2.2)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Porosity, %</source>
        <translation>Porosität, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>Preset</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>Preview …</source>
        <translation>Vorschau …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>Profiles have no picture</source>
        <translation>Profile haben kein Bild</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <source>Pull</source>
        <translation>Zug</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>Raise or lower the curves until all ask for the mean volume</source>
        <translation>Die Kurven heben oder senken, bis alle das mittlere Volumen verlangen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Range and heights</source>
        <translation>Bereich und Höhen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Read tables</source>
        <translation>Tabellen lesen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Read …</source>
        <translation>Lesen …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_panel.py"/>
        <source>Reading the envelope …</source>
        <translation>Der Hüllkörper wird gelesen …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Recoveries</source>
        <translation>Behebungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Redraws</source>
        <translation>Neuziehungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Remedy</source>
        <translation>Abhilfe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Remove the chosen coupling</source>
        <translation>Die gewählte Kopplung entfernen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Remove this point</source>
        <translation>Diesen Punkt entfernen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Reuse sites</source>
        <translation>Stellen wieder nutzen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>Rod</source>
        <translation>Stab</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <location filename="../../freecad_trabecula/gui/design_panel.py"/>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Rods</source>
        <translation>Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Rods as solids and as meshes, mm³</source>
        <translation>Stäbe als Volumenkörper und als Netze, mm³</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Rods by coupling</source>
        <translation>Stäbe nach Kopplung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Rods by hand (thesis' estimate)</source>
        <translation>Stäbe von Hand (Dissertation)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Rods by recovery</source>
        <translation>Stäbe nach Behebung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Rods by size</source>
        <translation>Stäbe nach Größe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Rods from</source>
        <translation>Stäbe ab</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Rods or channels</source>
        <translation>Stäbe oder Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Rods through a box, an implant or any solid; channels, porosity, files for a printer.</source>
        <translation>Stäbe durch einen Quader, ein Implantat oder irgendeinen Volumenkörper; Kanäle, Porosität, Dateien für einen Drucker.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Rounds</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Rows of tables</source>
        <translation>Zeilen der Tabellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>Run on, or stop</source>
        <translation>Weiterlaufen oder anhalten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_panel.py"/>
        <source>STEP scaffold</source>
        <translation>STEP-Gerüst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>STEP scaffold: porosity</source>
        <translation>STEP-Gerüst: Porosität</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>STEP scaffold: rods cut</source>
        <translation>STEP-Gerüst: ausgeschnittene Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>STEP scaffold: time</source>
        <translation>STEP-Gerüst: Zeit</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>STEP scaffold: volume</source>
        <translation>STEP-Gerüst: Volumen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Sample</source>
        <translation>Probe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Sample and design side by side, layer by layer, with the counts of both.</source>
        <translation>Probe und Entwurf nebeneinander, Schicht für Schicht, mit den Anzahlen beider.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Sample of a voxel design</source>
        <translation>Probe eines Voxelentwurfs</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Samples</source>
        <translation>Proben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Save CSV …</source>
        <translation>CSV speichern …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Save job</source>
        <translation>Auftrag speichern</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Save variants</source>
        <translation>Varianten speichern</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>Save …</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <location filename="../../freecad_trabecula/gui/design_panel.py"/>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Scaffold</source>
        <translation>Gerüst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Scaffold as solid and as mesh, mm³</source>
        <translation>Gerüst als Volumenkörper und als Netz, mm³</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Scaffold of each (exact)</source>
        <translation>Gerüst von jedem (genau)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/build_bar.py"/>
        <source>Scaffold: {} engine, about {}, {}</source>
        <translation>Gerüst: Verfahren {}, etwa {}, {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <source>Scatter</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Search all pages</source>
        <translation>Alle Seiten durchsuchen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Search: {}</source>
        <translation>Suche: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/why.py"/>
        <source>Second route</source>
        <translation>Zweiter Weg</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>Second site</source>
        <translation>Zweite Stelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Second tension</source>
        <translation>Spannung 2. Ende</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>Section</source>
        <translation>Schnittebene</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>Section plane</source>
        <translation>Schnittebene</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <source>Sections</source>
        <translation>Querschnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/notice.py"/>
        <source>Seen</source>
        <translation>Gesehen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Select a wireframe or its sites first</source>
        <translation>Zuerst ein Drahtmodell oder seine Stellen auswählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Select the solid or the closed mesh to be filled. A click here brings one in from a file; without one a box is filled.</source>
        <translation>Den Volumenkörper oder das geschlossene Netz auswählen, das gefüllt wird. Ein Klick hier holt eines aus einer Datei; ohne wird ein Quader gefüllt.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Set pore</source>
        <translation>Pore setzen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Share of the largest part</source>
        <translation>Anteil des größten Teils</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Sheets 0 … rods 1</source>
        <translation>Lamelle 0, Stab 1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/notice.py"/>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Show bodies in a clear envelope. Select a design, or nothing for all</source>
        <translation>Körper in durchsichtigem Hüllkörper zeigen. Einen Entwurf auswählen, oder nichts für alle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Show bodies solid, no envelope. Select a design, or nothing for all</source>
        <translation>Körper undurchsichtig zeigen, ohne Hüllkörper. Einen Entwurf auswählen, oder nichts für alle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Show when Trabecula is chosen</source>
        <translation>Zeigen, wenn Trabecula gewählt wird</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Site</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Site; or click one in the 3D view</source>
        <translation>Stelle; oder eine in der 3D-Ansicht anklicken</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <location filename="../../freecad_trabecula/gui/prism_section.py"/>
        <source>Sites</source>
        <translation>Stellen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>Sites on</source>
        <translation>Stellen auf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Sites, pores, paths and couplings; the preview and its porosity follow every change. OK keeps the design.</source>
        <translation>Stellen, Poren, Pfade und Kopplungen; Vorschau und Porosität folgen jeder Änderung. OK behält den Entwurf.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Size of the end sections, mm</source>
        <translation>Größe der Endquerschnitte, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/export_dialog.py"/>
        <source>Size of the file</source>
        <translation>Größe der Datei</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Size of the pore</source>
        <translation>Größe der Pore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Slice an STL, OBJ, PLY or 3MF file</source>
        <translation>Eine STL-, OBJ-, PLY- oder 3MF-Datei schneiden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <location filename="../../freecad_trabecula/gui/analysis_panel.py"/>
        <source>Slice analysis</source>
        <translation>Schnittanalyse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Slice the sample in layers as thick as the voxels are to be: each is a target.</source>
        <translation>Die Probe in so dicken Schichten schneiden, wie die Voxel werden sollen: jede ist ein Zielwert.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Sliced area</source>
        <translation>Schnittfläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Sliced area, mm²</source>
        <translation>Schnittfläche, mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Slices</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Slices, porosity, thickness of trabeculae; two bodies side by side.</source>
        <translation>Schnitte, Porosität, Trabekeldicke; zwei Körper nebeneinander.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_panel.py"/>
        <source>Slices: {}</source>
        <translation>Schnitte: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Solid</source>
        <translation>Undurchsichtig</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Solid voxels</source>
        <translation>Volle Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Something is on its way already: wait, or cancel it</source>
        <translation>Etwas läuft bereits: warten oder abbrechen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/why.py"/>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Spacing u, v</source>
        <translation>Abstand u, v</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Spoilt slices</source>
        <translation>Fehlerhafte Schnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Start from this design of the thesis. Select nothing: it brings its own body</source>
        <translation>Mit diesem Entwurf der Dissertation beginnen. Nichts auswählen: er bringt seinen Körper mit</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Stations</source>
        <translation>Stationen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>Step {} of {}</source>
        <translation>Schritt {} von {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Strategy</source>
        <translation>Strategie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Strategy {} makes voxels without tables; another strategy fills layers from edited ones</source>
        <translation>Die Strategie {} macht Voxel ohne Tabellen; eine andere füllt Schichten aus geänderten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Strategy's own choices</source>
        <translation>Optionen der Strategie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Sum of the rods, mm³</source>
        <translation>Summe der Stäbe, mm³</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Switch site off</source>
        <translation>Stelle abschalten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Tables of {}</source>
        <translation>Tabellen von {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_saving.py"/>
        <source>Tables, report and plots are in {}</source>
        <translation>Tabellen, Bericht und Diagramme sind in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>Tables, report and plots of what is ticked, in a folder</source>
        <translation>Tabellen, Bericht und Diagramme der angekreuzten Analysen in einen Ordner</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Take a bone or a design</source>
        <translation>Knochen oder Entwurf wählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Take a sample</source>
        <translation>Eine Probe nehmen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/edits_list.py"/>
        <source>Take the chosen change back</source>
        <translation>Die gewählte Änderung zurücknehmen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Take the chosen face away</source>
        <translation>Die gewählte Fläche wegnehmen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Take this seed</source>
        <translation>Diesen Startwert nehmen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Tangents</source>
        <translation>Tangenten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Targets</source>
        <translation>Zielwerte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Tb.Th, Tb.Sp, Conn.D, DA … on voxels (slow)</source>
        <translation>Tb.Th, Tb.Sp, Conn.D, DA … mit Voxeln (langsam)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>The body to be filled</source>
        <translation>Der Körper, der gefüllt wird</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>The bone that the voxels are to match: a click brings in a mesh or a solid.</source>
        <translation>Der Knochen, zu dem die Voxel passen sollen: ein Klick holt ein Netz oder einen Volumenkörper.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>The channels are cut out of the body. Volumes, parts and loose pieces are checked.</source>
        <translation>Die Kanäle werden aus dem Körper geschnitten. Volumen, Teile und lose Teile werden geprüft.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>The contours are being worked out …</source>
        <translation>Die Konturen werden berechnet …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>The design is sliced as the sample was: the second route to its areas.</source>
        <translation>Der Entwurf wird wie die Probe geschnitten: der zweite Weg zu seinen Flächen.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>The design's own tables; cells can be edited, their sums must stay</source>
        <translation>Die Tabellen des Entwurfs; Zellen sind änderbar, ihre Summen müssen bleiben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>The next seed: other draws, other pairs</source>
        <translation>Der nächste Startwert: andere Zufallszahlen, andere Paare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>The sample is being worked out …</source>
        <translation>Die Probe wird berechnet …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>The thesis' designs, to start from</source>
        <translation>Die Entwürfe der Dissertation als Ausgangspunkt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>The totals differ; a design scales all curves to their mean, {} mm³</source>
        <translation>Die Summen unterscheiden sich; ein Entwurf bringt alle Kurven auf ihr Mittel, {} mm³</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Thickness of the layers, axes, mending; Tb.Th, Tb.Sp, Conn.D and DA if they are ticked.</source>
        <translation>Dicke der Schichten, Achsen, Reparatur; Tb.Th, Tb.Sp, Conn.D und DA, wenn angekreuzt.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/export_dialog.py"/>
        <source>This body is out of date: build it again first</source>
        <translation>Dieser Körper ist veraltet: zuerst neu erzeugen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Tick the faces that get a compact layer</source>
        <translation>Flächen ankreuzen, die eine kompakte Schicht erhalten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Time budget</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Time for a rod</source>
        <translation>Zeit je Stab</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>To all</source>
        <translation>Auf alle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>To one total by</source>
        <translation>Ausgleich der Summe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>To the empty layer</source>
        <translation>Zur leeren Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>To the last step</source>
        <translation>Zum letzten Schritt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>To whose slices the porosity refers</source>
        <translation>Auf wessen Schnitte sich die Porosität bezieht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Total of</source>
        <translation>Summe von</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/transactions.py"/>
        <source>Trabecula</source>
        <translation>Trabecula</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Trabecula help</source>
        <translation>Trabecula Hilfe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Trabecula job</source>
        <translation>Trabecula-Auftrag</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preferences.py"/>
        <source>Trabecula's preferences: {}</source>
        <translation>Einstellungen von Trabecula: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>Trabeculae</source>
        <translation>Trabekel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Trabeculae counted</source>
        <translation>Trabekelzahl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Trabeculae in layers along X</source>
        <translation>Trabekel in Schichten entlang X</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Trabeculae in layers along Y</source>
        <translation>Trabekel in Schichten entlang Y</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Trabeculae in layers along Z</source>
        <translation>Trabekel in Schichten entlang Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Trabecular area, mm²</source>
        <translation>Trabekelfläche, mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Tries</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Union of the rods in the envelope</source>
        <translation>Vereinigung der Stäbe im Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Variants</source>
        <translation>Varianten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Voids that no opening reaches</source>
        <translation>Hohlräume ohne Öffnung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Volume by slices, mm³</source>
        <translation>Volumen aus Schnitten, mm³</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Volume of the mesh</source>
        <translation>Volumen des Netzes</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Volume of the voxels</source>
        <translation>Volumen der Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_panel.py"/>
        <source>Voxel design</source>
        <translation>Voxelentwurf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>Voxel layers</source>
        <translation>Voxelschichten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Voxel size</source>
        <translation>Voxelgröße</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>Voxels asked for in each column, from the left</source>
        <translation>Verlangte Voxel je Spalte, von links</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>Voxels asked for in each row, from the lowest</source>
        <translation>Verlangte Voxel je Zeile, von unten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Voxels in one piece with the bone's sliced areas in every layer along X, Y and Z.</source>
        <translation>Zusammenhängende Voxel mit den Schnittflächen des Knochens in jeder Schicht entlang X, Y und Z.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Voxels within</source>
        <translation>Voxel innerhalb</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>Watch a layer being filled</source>
        <translation>Füllen einer Schicht beobachten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Wavelengths</source>
        <translation>Wellenlängen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>What do you want to do?</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>What the rods' colours mean</source>
        <translation>Was die Farben der Stäbe bedeuten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>What the scaffold is to be like: a file, or a mesh of the document.</source>
        <translation>Wie das Gerüst werden soll: eine Datei oder ein Netz des Dokuments.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>Where the plane is, mm</source>
        <translation>Wo die Ebene liegt, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Whole</source>
        <translation>Gesamt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/why.py"/>
        <source>Why? Formula, source, second route</source>
        <translation>Warum? Formel, Quelle, zweiter Weg</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Write files for a printer, a CAD system or a table; sizes are shown first.</source>
        <translation>Dateien für einen Drucker, ein CAD-System oder eine Tabelle schreiben; vorher wird die Größe gezeigt.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/report_writing.py"/>
        <source>Write report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Write tables</source>
        <translation>Tabellen schreiben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Write …</source>
        <translation>Schreiben …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>X-ray</source>
        <translation>Röntgenblick</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/work_text.py"/>
        <source>about {}</source>
        <translation>etwa {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>along {}</source>
        <translation>entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>alpha, columns</source>
        <translation>alpha, Spalten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>alpha: voxels in the lines (x, z)</source>
        <translation>alpha: Voxel in den Linien (x, z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>an analysis is on its way already</source>
        <translation>eine Analyse läuft bereits</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>and {} more</source>
        <translation>und {} weitere</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>area of outer contours, mm²</source>
        <translation>Fläche der äußeren Konturen, mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>area of outer contours, mm² (light: many)</source>
        <translation>Fläche der äußeren Konturen, mm² (hell: viele)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>area, mm²</source>
        <translation>Fläche, mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>areas in mm²</source>
        <translation>Flächen in mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>as drawn</source>
        <translation>wie gezogen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>as the design</source>
        <translation>wie der Entwurf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>as they stand</source>
        <translation>der Reihe nach</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>asked for</source>
        <translation>verlangt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/fields.py"/>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/recomputing.py"/>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>being computed</source>
        <translation>wird berechnet</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>beta, rows</source>
        <translation>beta, Zeilen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>beta: voxels in the lines (y, z)</source>
        <translation>beta: Voxel in den Linien (y, z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>box of the body</source>
        <translation>Quader um den Körper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>box of the sample</source>
        <translation>Quader der Probe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>build a scaffold first</source>
        <translation>zuerst ein Gerüst erzeugen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>build a scaffold or a network first</source>
        <translation>zuerst ein Gerüst oder ein Netzwerk erzeugen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>by rays, loose pieces left in</source>
        <translation>mit Strahlen, lose Teile mitgezählt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>case </source>
        <translation>Fall </translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>chance: {:.1f} %</source>
        <translation>Zufall: {:.1f} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>choose a design …</source>
        <translation>Entwurf wählen …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/command.py"/>
        <source>close the open task panel first</source>
        <translation>zuerst das offene Aufgabenfenster schließen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>co-ordinate along {}, mm</source>
        <translation>Koordinate entlang {}, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>columns, u stays smallest</source>
        <translation>Spalten, u bleibt am kleinsten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>contours (as the thesis)</source>
        <translation>Konturen (wie in der Dissertation)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>coupling</source>
        <translation>Kopplung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>craniofacial implant</source>
        <translation>Schädelimplantat</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>cube</source>
        <translation>Würfel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>deflection {}, {} stations</source>
        <translation>Abweichung {}, {} Stationen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>design</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>design: {} made, {} asked for</source>
        <translation>Entwurf: {} erzeugt, {} verlangt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>direction: 0.6,0.8,0</source>
        <translation>Richtung: 0.6,0.8,0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>drawn curves</source>
        <translation>gezeichnete Kurven</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/start_commands.py"/>
        <source>everything is up to date</source>
        <translation>alles ist aktuell</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>failed, left out</source>
        <translation>misslungen, weggelassen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>false</source>
        <translation>falsch</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>faulty rods are being mended …</source>
        <translation>fehlerhafte Stäbe werden repariert …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/work_text.py"/>
        <source>files of {}</source>
        <translation>Dateien von {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>from seed</source>
        <translation>ab Startwert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>heights: 0.5 1.0 2.5</source>
        <translation>Höhen: 0.5 1.0 2.5</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>humerus implant</source>
        <translation>Humerusimplantat</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>kind of the contours</source>
        <translation>Art der Konturen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/language.py"/>
        <source>language code</source>
        <translation>de</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>layer </source>
        <translation>Schicht </translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>leaves the envelope</source>
        <translation>verlässt den Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>mended</source>
        <translation>repariert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preferences.py"/>
        <source>must be a folder that is there</source>
        <translation>muss ein vorhandener Ordner sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preferences.py"/>
        <source>must be a length above 0 mm</source>
        <translation>muss eine Länge über 0 mm sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preferences.py"/>
        <source>must be the number of one of {}</source>
        <translation>muss die Nummer eines von {} sein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preferences.py"/>
        <source>must lie in {}..{}</source>
        <translation>muss in {}..{} liegen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_envelope.py"/>
        <source>new prism</source>
        <translation>neues Prisma</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/command.py"/>
        <source>no document is open</source>
        <translation>kein Dokument ist offen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>no face picked</source>
        <translation>keine Fläche gewählt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_model.py"/>
        <source>no voxels have these sums in columns and rows</source>
        <translation>keine Voxel haben diese Summen in Spalten und Zeilen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/command.py"/>
        <source>nothing has been designed or analysed yet</source>
        <translation>noch ist nichts entworfen oder analysiert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>nothing that is seen can be coloured by that</source>
        <translation>nichts Sichtbares kann danach gefärbt werden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>nothing: drawn anew</source>
        <translation>nichts: neu gezeichnet</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>number of trabeculae</source>
        <translation>Anzahl der Trabekel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>of the scaffold of each</source>
        <translation>des Gerüsts von jedem</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>outer contours</source>
        <translation>äußere Konturen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>outlines as wires</source>
        <translation>Umrisse als Drähte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/install.py"/>
        <source>pip could not install {}; it says why below.</source>
        <translation>pip konnte {} nicht installieren; der Grund steht unten.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>plates</source>
        <translation>Platten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>plates ({})</source>
        <translation>Platten ({})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>porosity of the slices along {}</source>
        <translation>Porosität der Schnitte entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>porosity …</source>
        <translation>Porosität …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>porosity ≈ {} %</source>
        <translation>Porosität ≈ {} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>porosity, %</source>
        <translation>Porosität, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>prism</source>
        <translation>Prisma</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>recovery of the rods</source>
        <translation>Behebung der Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>rods</source>
        <translation>Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>rods ({})</source>
        <translation>Stäbe ({})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>rows, v stays smallest</source>
        <translation>Zeilen, v bleibt am kleinsten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>sample</source>
        <translation>Probe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>sample: asks for {} voxels</source>
        <translation>Probe: verlangt {} Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>sample: {} asked for, {} by centres</source>
        <translation>Probe: {} verlangt, {} nach Mittelpunkten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>select a network, a scaffold, a mesh or a solid</source>
        <translation>ein Netzwerk, ein Gerüst, ein Netz oder einen Volumenkörper auswählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>select a solid, or faces of one</source>
        <translation>einen Volumenkörper oder Flächen davon auswählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>size of the rods</source>
        <translation>Größe der Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>slice </source>
        <translation>Schnitt </translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_view.py"/>
        <source>sliced area along {}, {}</source>
        <translation>Schnittfläche entlang {}, {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>sliced area less that of {}, mm²</source>
        <translation>Schnittfläche minus die von {}, mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>sliced area, mm²</source>
        <translation>Schnittfläche, mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>solids</source>
        <translation>Volumenkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>spoilt</source>
        <translation>fehlerhaft</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/build_bar.py"/>
        <source>starting</source>
        <translation>beginnt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_model.py"/>
        <source>sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>sum of the rods {:.1f} %</source>
        <translation>Summe der Stäbe {:.1f} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>the shortest first</source>
        <translation>die kürzeste zuerst</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/command.py"/>
        <source>there is no analysis yet</source>
        <translation>es gibt noch keine Analyse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>there is no design of rods or voxels yet</source>
        <translation>es gibt noch keinen Entwurf von Stäben oder Voxeln</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/command.py"/>
        <source>there is no design of rods yet</source>
        <translation>es gibt noch keinen Stabentwurf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/command.py"/>
        <source>there is no voxel design yet</source>
        <translation>es gibt noch keinen Voxelentwurf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>there is only one analysis</source>
        <translation>es gibt nur eine Analyse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>to</source>
        <translation>nach</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>total along {}: {} mm³, {} % of the box</source>
        <translation>Summe entlang {}: {} mm³, {} % des Quaders</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>trabeculae in the layers along {}</source>
        <translation>Trabekel in den Schichten entlang {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>true</source>
        <translation>wahr</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>voids ({})</source>
        <translation>Hohlräume ({})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>voxels in the layer</source>
        <translation>Voxel in der Schicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>{:.1f} h</source>
        <translation>{:.1f} h</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>{:.3f} against {:.3f}, at most {:.3g} % apart (allowed: {:g} %)</source>
        <translation>{:.3f} gegen {:.3f}, höchstens {:.3g} % auseinander (erlaubt: {:g} %)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>{:.9g} against {:.9g}, {:.2g} apart (at most {:.2g})</source>
        <translation>{:.9g} gegen {:.9g}, {:.2g} auseinander (höchstens {:.2g})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>{} ({:.3g} mm³)</source>
        <translation>{} ({:.3g} mm³)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>{} ({} rods{})</source>
        <translation>{} ({} Stäbe{})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>{} = {:.3f} mm, {} contours</source>
        <translation>{} = {:.3f} mm, {} Konturen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/panels.py"/>
        <source>{} belongs to no design yet</source>
        <translation>{} gehört noch zu keinem Entwurf</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>{} corners: about {}, {} of memory, {} as STEP</source>
        <translation>{} Ecken: etwa {}, {} Speicher, {} als STEP</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>{} engine</source>
        <translation>Verfahren {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/notice.py"/>
        <source>{} failed</source>
        <translation>{} ist misslungen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>{} from the low end, mm</source>
        <translation>{} ab dem unteren Ende, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>{} has the seed {}</source>
        <translation>{} hat den Startwert {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>{} has too many triangles to be filled</source>
        <translation>{} hat zu viele Dreiecke, um gefüllt zu werden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/background.py"/>
        <source>{} is being computed: the status bar shows how far it is</source>
        <translation>{} wird gerade berechnet: die Statusleiste zeigt, wie weit es ist</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/notice.py"/>
        <source>{} is done</source>
        <translation>{} ist fertig</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/install.py"/>
        <source>{} is installed.</source>
        <translation>{} ist installiert.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>{} is up to date and without error</source>
        <translation>{} ist aktuell und ohne Fehler</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>{} leave the envelope</source>
        <translation>{} verlassen den Hüllkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>{} left out</source>
        <translation>{} weggelassen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>{} lines that make {} again are on the clipboard</source>
        <translation>{} Zeilen, die {} wieder erzeugen, sind in der Zwischenablage</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>{} mended</source>
        <translation>{} repariert</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>{} mm², porosity {} %</source>
        <translation>{} mm², Porosität {} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/work_text.py"/>
        <source>{} of memory</source>
        <translation>{} Speicher</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>{} of {} hold</source>
        <translation>{} von {} erfüllt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>{} rods</source>
        <translation>{} Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>{} to {}</source>
        <translation>{} bis {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/document_work.py"/>
        <source>{} was deleted meanwhile</source>
        <translation>{} wurde inzwischen gelöscht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/report_writing.py"/>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>{} was written</source>
        <translation>{} wurde geschrieben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/export_dialog.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_export.py"/>
        <source>{} was written: {}</source>
        <translation>{} wurde geschrieben: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preferences.py"/>
        <source>{} {}, got {}; {} is taken</source>
        <translation>{} {}, hier {}; {} wird genommen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/child_work.py"/>
        <source>{}, a few seconds left</source>
        <translation>{}, noch einige Sekunden</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/child_work.py"/>
        <source>{}, about {} h {} min left</source>
        <translation>{}, noch etwa {} h {} min</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/child_work.py"/>
        <source>{}, about {} min left</source>
        <translation>{}, noch etwa {} min</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/child_work.py"/>
        <source>{}, about {} s left</source>
        <translation>{}, noch etwa {} s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>{}, c = {} mm</source>
        <translation>{}, c = {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>{}: mean {:.2f}, standard deviation {:.2f}, {:.2f} to {:.2f}, of {} variants</source>
        <translation>{}: Mittel {:.2f}, Standardabweichung {:.2f}, {:.2f} bis {:.2f}, von {} Varianten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>{}: next column {}, {} voxels into the rows that need most</source>
        <translation>{}: nächste Spalte {}, {} Voxel in die Zeilen, die am meisten brauchen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>{}: next row {}, {} voxels into the columns that need most</source>
        <translation>{}: nächste Zeile {}, {} Voxel in die Spalten, die am meisten brauchen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>{}: no design with these numbers any more</source>
        <translation>{}: kein Entwurf mit diesen Zahlen mehr</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>{}: the layer is filled</source>
        <translation>{}: die Schicht ist gefüllt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>{}; {} sums or cells are wrong</source>
        <translation>{}; {} Summen oder Zellen sind falsch</translation>
    </message>
</context>
<context>
    <name>Trabecula_AnalyseNow</name>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Analyse at once</source>
        <translation>Sofort analysieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Slice a body as its kind asks for and show the plots. Select a scaffold, mesh or solid</source>
        <translation>Einen Körper schneiden, wie es zu ihm passt, und die Diagramme zeigen. Gerüst, Netz oder Volumenkörper auswählen</translation>
    </message>
</context>
<context>
    <name>Trabecula_Analysis</name>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Slice analysis</source>
        <translation>Schnittanalyse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Slice and measure every slice. Select a mesh, a solid, a design or an analysis, or nothing to choose a file</source>
        <translation>Schneiden und jeden Schnitt vermessen. Netz, Volumenkörper, Entwurf oder Analyse auswählen, oder nichts, um eine Datei zu wählen</translation>
    </message>
</context>
<context>
    <name>Trabecula_Body</name>
    <message>
        <location filename="../../freecad_trabecula/gui/start_commands.py"/>
        <source>Body from a file</source>
        <translation>Körper aus einer Datei</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/start_commands.py"/>
        <source>Bring a solid or a mesh into the document: STEP, IGES, BREP, STL, 3MF. Needs nothing</source>
        <translation>Einen Volumenkörper oder ein Netz ins Dokument holen: STEP, IGES, BREP, STL, 3MF. Braucht nichts</translation>
    </message>
</context>
<context>
    <name>Trabecula_Colours</name>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Give colours a meaning; a legend says which. Select objects, or nothing for all that are seen</source>
        <translation>Farben eine Bedeutung geben; eine Legende sagt, welche. Objekte auswählen, oder nichts für alle sichtbaren</translation>
    </message>
</context>
<context>
    <name>Trabecula_Compare</name>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Compare analyses</source>
        <translation>Analysen vergleichen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Show two or more analyses on shared axes, and how near they are. Select them, or none for all</source>
        <translation>Zwei oder mehr Analysen auf gemeinsamen Achsen zeigen, und wie nahe sie sich sind. Sie auswählen, oder keine für alle</translation>
    </message>
</context>
<context>
    <name>Trabecula_CopyScript</name>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>Copy as script</source>
        <translation>Als Skript kopieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>Copy the Python that makes it again. Select a design or an analysis, or nothing for all of the document</source>
        <translation>Das Python kopieren, das es wieder erzeugt. Einen Entwurf oder eine Analyse auswählen, oder nichts für das ganze Dokument</translation>
    </message>
</context>
<context>
    <name>Trabecula_Design</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Design a network of rods. Select a solid, or a design to change; with nothing selected a prism is filled</source>
        <translation>Ein Netzwerk von Stäben entwerfen. Einen Volumenkörper oder einen zu ändernden Entwurf auswählen; ohne Auswahl wird ein Prisma gefüllt</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Design rods</source>
        <translation>Stäbe entwerfen</translation>
    </message>
</context>
<context>
    <name>Trabecula_EditSite</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Change, move or switch off one site or its pore. Needs a design; select one of several</source>
        <translation>Eine Stelle oder ihre Pore ändern, verschieben oder abschalten. Braucht einen Entwurf; von mehreren einen auswählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Edit site and pore</source>
        <translation>Stelle und Pore bearbeiten</translation>
    </message>
</context>
<context>
    <name>Trabecula_Export</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Write scaffold, channels or rods as STL, STEP, BREP, OBJ, PLY, 3MF, sizes first. Needs a scaffold or a network</source>
        <translation>Gerüst, Kanäle oder Stäbe als STL, STEP, BREP, OBJ, PLY, 3MF schreiben, zuerst die Größen. Braucht ein Gerüst oder ein Netzwerk</translation>
    </message>
</context>
<context>
    <name>Trabecula_FaceSites</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Lay sites on faces. Select a solid, whose faces you pick next, or faces of one</source>
        <translation>Stellen auf Flächen setzen. Einen Volumenkörper auswählen, dessen Flächen danach angeklickt werden, oder Flächen davon</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Sites on faces</source>
        <translation>Stellen auf Flächen</translation>
    </message>
</context>
<context>
    <name>Trabecula_Help</name>
    <message>
        <location filename="../../freecad_trabecula/gui/help_commands.py"/>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_commands.py"/>
        <source>Show or hide the help: tutorials, commands, files, the method, the glossary. Needs nothing</source>
        <translation>Die Hilfe ein- oder ausblenden: Anleitungen, Befehle, Dateien, Methode, Glossar. Braucht nichts</translation>
    </message>
</context>
<context>
    <name>Trabecula_LayerShapes</name>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Layer shapes</source>
        <translation>Schichtkörper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Make wires or solids of layers, after an estimate. Needs a voxel design; select one of several</source>
        <translation>Drähte oder Volumenkörper aus Schichten machen, nach einer Schätzung. Braucht einen Voxelentwurf; von mehreren einen auswählen</translation>
    </message>
</context>
<context>
    <name>Trabecula_MeasureFile</name>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Measure a file</source>
        <translation>Eine Datei vermessen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Slice a mesh from a file: STL, OBJ, PLY, 3MF. Needs nothing</source>
        <translation>Ein Netz aus einer Datei schneiden: STL, OBJ, PLY, 3MF. Braucht nichts</translation>
    </message>
</context>
<context>
    <name>Trabecula_Network</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Build network</source>
        <translation>Netzwerk erzeugen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Build the rods as solids (STEP); no Boolean is needed. Needs a design; select one of several</source>
        <translation>Die Stäbe als Volumenkörper erzeugen (STEP); ohne boolesche Operation. Braucht einen Entwurf; von mehreren einen auswählen</translation>
    </message>
</context>
<context>
    <name>Trabecula_OpenJob</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Open a job file: all that a design needs. Select nothing: it names its own body</source>
        <translation>Eine Auftragsdatei öffnen: alles, was ein Entwurf braucht. Nichts auswählen: sie nennt ihren Körper</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Open job</source>
        <translation>Auftrag öffnen</translation>
    </message>
</context>
<context>
    <name>Trabecula_Plots</name>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Show or hide the profiles of analyses and the slice under the cursor. Select the analyses that are to be shown</source>
        <translation>Profile der Analysen und den Schnitt unter dem Mauszeiger ein- oder ausblenden. Die Analysen auswählen, die gezeigt werden sollen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Slices and plots</source>
        <translation>Schnitte und Diagramme</translation>
    </message>
</context>
<context>
    <name>Trabecula_Preferences</name>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>B-Rep</source>
        <translation>B-Rep</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Blocks keep volume and areas exactly; smooth keeps the volume</source>
        <translation>Blöcke halten Volumen und Flächen genau ein; glatt hält das Volumen ein</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Contours that count as plates, in the picture of a slice</source>
        <translation>Konturen, die als Platten zählen, im Bild eines Schnitts</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Contours that count as rods, in the picture of a slice</source>
        <translation>Konturen, die als Stäbe zählen, im Bild eines Schnitts</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Contours: plates</source>
        <translation>Konturen: Platten</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Contours: rods</source>
        <translation>Konturen: Stäbe</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Defaults are read when an object or its panel is made. What is in a document stays as it is; scripts and the command line have their own.</source>
        <translation>Vorgaben werden gelesen, wenn ein Objekt oder sein Fenster entsteht. Was in einem Dokument steht, bleibt, wie es ist; Skripte und die Befehlszeile haben eigene.</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Design</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Edge of the voxels of a new design; that of an analysis is its thickness</source>
        <translation>Kante der Voxel eines neuen Entwurfs; bei einer Analyse ist es ihre Dicke</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Engine</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Faces of new channels</source>
        <translation>Flächen neuer Kanäle</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Faces of new networks of rods</source>
        <translation>Flächen neuer Stabnetzwerke</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Faces of new scaffolds and voxel designs</source>
        <translation>Flächen neuer Gerüste und Voxelentwürfe</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Files and work</source>
        <translation>Dateien und Rechenarbeit</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Folder for exports</source>
        <translation>Ordner für Exporte</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>How the layers of a new voxel design are filled</source>
        <translation>Wie die Schichten eines neuen Voxelentwurfs gefüllt werden</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Language, decimal sign and theme are those of FreeCAD (General). A change of language takes full effect when FreeCAD is started again.</source>
        <translation>Sprache, Dezimalzeichen und Farbschema sind die von FreeCAD (Allgemein). Eine andere Sprache gilt ganz, wenn FreeCAD neu gestartet ist.</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Largest pore</source>
        <translation>Größte Pore</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Lines of new wireframes</source>
        <translation>Linien neuer Drahtmodelle</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>New objects</source>
        <translation>Neue Objekte</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>One number reproduces all draws</source>
        <translation>Eine Zahl, die alle Zufallsziehungen wiederholbar macht</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Open the guide with the workbench</source>
        <translation>Den Leitfaden mit dem Arbeitsbereich öffnen</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Pores of a new design are drawn uniformly between smallest and largest</source>
        <translation>Poren eines neuen Entwurfs werden gleichverteilt zwischen kleinster und größter gezogen</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Rods</source>
        <translation>Stäbe</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Sample</source>
        <translation>Probe</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Scaffold</source>
        <translation>Gerüst</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Slice thickness</source>
        <translation>Schnittdicke</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Smallest pore</source>
        <translation>Kleinste Pore</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Strategy</source>
        <translation>Strategie</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>The design's voxels in the pictures of layers and its curves</source>
        <translation>Die Voxel des Entwurfs in den Schichtbildern und seine Kurven</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>The sample's voxels in the pictures of layers and its curves</source>
        <translation>Die Voxel der Probe in den Schichtbildern und ihre Kurven</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Thickness of the layers of a new slice analysis; a voxel design is sliced by its own layers</source>
        <translation>Dicke der Schichten einer neuen Schnittanalyse; ein Voxelentwurf wird in seinen eigenen Schichten geschnitten</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Threads that numpy and scipy may use in long work; 0: as many as there are. manifold3d and our own code use one</source>
        <translation>Threads, die numpy und scipy bei langer Arbeit nutzen dürfen; 0: alle, die es gibt. manifold3d und unser eigener Code nutzen einen</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Voxel size</source>
        <translation>Voxelgröße</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Voxel surface</source>
        <translation>Voxeloberfläche</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Where dialogs for files to be written open; empty: beside the document</source>
        <translation>Wo Dialoge für zu schreibende Dateien beginnen; leer: neben dem Dokument</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Wireframe</source>
        <translation>Drahtmodell</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>best for tables</source>
        <translation>beste Tabellen</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>by field</source>
        <translation>nach Feld</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>mesh: exact triangles; field: rays and cells, for many rods; B-Rep: STEP</source>
        <translation>Netz: genaue Dreiecke; Feld: Strahlen und Zellen, für viele Stäbe; B-Rep: STEP</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>minimum zeros</source>
        <translation>wenigste Nullen</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>random layers</source>
        <translation>zufällige Schichten</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>sequential</source>
        <translation>der Reihe nach</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>smooth</source>
        <translation>glatt</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>trabecular</source>
        <translation>trabekulär</translation>
    </message>
</context>
<context>
    <name>Trabecula_Presets</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Designs of the thesis</source>
        <translation>Entwürfe der Dissertation</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Start from a design of the thesis. Select nothing: it brings its own body</source>
        <translation>Mit einem Entwurf der Dissertation beginnen. Nichts auswählen: er bringt seinen Körper mit</translation>
    </message>
</context>
<context>
    <name>Trabecula_Renew</name>
    <message>
        <location filename="../../freecad_trabecula/gui/start_commands.py"/>
        <source>Bring up to date</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/start_commands.py"/>
        <source>Compute anew what is out of date; analyses and comparisons follow. Needs a design that was changed</source>
        <translation>Neu berechnen, was veraltet ist; Analysen und Vergleiche folgen. Braucht einen geänderten Entwurf</translation>
    </message>
</context>
<context>
    <name>Trabecula_Results</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Porosity, volumes, counts, recoveries, pore sizes, checks. Needs a design; select one of several</source>
        <translation>Porosität, Volumen, Anzahlen, Behebungen, Porengrößen, Prüfungen. Braucht einen Entwurf; von mehreren einen auswählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
</context>
<context>
    <name>Trabecula_RodInfo</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Rod at a click</source>
        <translation>Stab unter dem Klick</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Show or hide what is known of a rod. Select one in the 3D view</source>
        <translation>Zeigen oder ausblenden, was von einem Stab bekannt ist. Einen in der 3D-Ansicht auswählen</translation>
    </message>
</context>
<context>
    <name>Trabecula_SaveAnalyses</name>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Save tables and plots</source>
        <translation>Tabellen und Diagramme speichern</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Write tables, report and plots into a folder; of several their comparison. Select analyses, or none for all</source>
        <translation>Tabellen, Bericht und Diagramme in einen Ordner schreiben; von mehreren ihren Vergleich. Analysen auswählen, oder keine für alle</translation>
    </message>
</context>
<context>
    <name>Trabecula_SaveJob</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Save job</source>
        <translation>Auftrag speichern</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Save the design as a job file, which the command line runs too. Needs a design; select one of several</source>
        <translation>Den Entwurf als Auftragsdatei speichern, die auch die Befehlszeile ausführt. Braucht einen Entwurf; von mehreren einen auswählen</translation>
    </message>
</context>
<context>
    <name>Trabecula_Scaffold</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Build scaffold</source>
        <translation>Gerüst erzeugen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Cut the channels out of the envelope: scaffold, channels, porosity. Needs a design; select one of several</source>
        <translation>Die Kanäle aus dem Hüllkörper schneiden: Gerüst, Kanäle, Porosität. Braucht einen Entwurf; von mehreren einen auswählen</translation>
    </message>
</context>
<context>
    <name>Trabecula_Section</name>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Cut the 3D view open along X, Y, Z or as you look at it. Needs a document; the document does not change</source>
        <translation>Die 3D-Ansicht entlang X, Y, Z oder in Blickrichtung aufschneiden. Braucht ein Dokument; es ändert sich nicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Section plane</source>
        <translation>Schnittebene</translation>
    </message>
</context>
<context>
    <name>Trabecula_Sights</name>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Look through</source>
        <translation>Durchsehen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Solid, in a glass envelope, or as an X-ray. Select a design, or nothing for all</source>
        <translation>Undurchsichtig, in gläsernem Hüllkörper oder als Röntgenblick. Einen Entwurf auswählen, oder nichts für alle</translation>
    </message>
</context>
<context>
    <name>Trabecula_Start</name>
    <message>
        <location filename="../../freecad_trabecula/gui/start_commands.py"/>
        <source>Show or hide the guide: three ways to work, step by step, and examples. Needs nothing</source>
        <translation>Den Leitfaden ein- oder ausblenden: drei Arbeitswege, Schritt für Schritt, und Beispiele. Braucht nichts</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/start_commands.py"/>
        <source>Start</source>
        <translation>Start</translation>
    </message>
</context>
<context>
    <name>Trabecula_Switch</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Rods or channels</source>
        <translation>Stäbe oder Kanäle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Show rods or channels: two views of one wireframe. Needs a scaffold</source>
        <translation>Stäbe oder Kanäle zeigen: zwei Ansichten eines Drahtmodells. Braucht ein Gerüst</translation>
    </message>
</context>
<context>
    <name>Trabecula_Variants</name>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>Make the design again with 10 other seeds, side by side with their spread. Select a design or voxels</source>
        <translation>Den Entwurf mit 10 anderen Startwerten wiederholen, nebeneinander mit ihrer Streuung. Einen Entwurf oder Voxel auswählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>Other seeds</source>
        <translation>Andere Startwerte</translation>
    </message>
</context>
<context>
    <name>Trabecula_VoxelExport</name>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Export voxels</source>
        <translation>Voxel exportieren</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Write mesh, voxels or images of layers; sizes are shown first. Needs a voxel design; select one of several</source>
        <translation>Netz, Voxel oder Bilder der Schichten schreiben; zuerst die Größen. Braucht einen Voxelentwurf; von mehreren einen auswählen</translation>
    </message>
</context>
<context>
    <name>Trabecula_VoxelLayers</name>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Show or hide the layers of sample and design with their counts. Select a voxel design, or nothing for the last</source>
        <translation>Die Schichten von Probe und Entwurf mit ihren Anzahlen ein- oder ausblenden. Einen Voxelentwurf auswählen, oder nichts für den letzten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Voxel layers</source>
        <translation>Voxelschichten</translation>
    </message>
</context>
<context>
    <name>Trabecula_VoxelTables</name>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>See, edit, read and write the tables alpha and beta. Needs a voxel design; select one of several</source>
        <translation>Die Tabellen alpha und beta ansehen, ändern, lesen und schreiben. Braucht einen Voxelentwurf; von mehreren einen auswählen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Tables</source>
        <translation>Tabellen</translation>
    </message>
</context>
<context>
    <name>Trabecula_Voxels</name>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Design voxels</source>
        <translation>Voxel entwerfen</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Design voxels with the sliced areas of a sample along X, Y and Z. Select a body, an analysis or a voxel design</source>
        <translation>Voxel mit den Schnittflächen einer Probe entlang X, Y und Z entwerfen. Körper, Analyse oder Voxelentwurf auswählen</translation>
    </message>
</context>
<context>
    <name>Trabecula_WatchLayer</name>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Watch a layer</source>
        <translation>Schicht beobachten</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Watch how a layer is filled, step by step. Select a voxel design for its layers, or nothing for own numbers</source>
        <translation>Schritt für Schritt beobachten, wie eine Schicht gefüllt wird. Einen Voxelentwurf für seine Schichten auswählen, oder nichts für eigene Zahlen</translation>
    </message>
</context>
<context>
    <name>Trabecula_WriteReport</name>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>Write all of the document into one HTML page and open it. Needs a scaffold, an analysis or voxels</source>
        <translation>Alles im Dokument in eine HTML-Seite schreiben und sie öffnen. Braucht ein Gerüst, eine Analyse oder Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>Write report</source>
        <translation>Bericht schreiben</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>&amp;Rods</source>
        <translation>&amp;Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>&amp;Slices</source>
        <translation>S&amp;chnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>&amp;Trabecula</source>
        <translation>&amp;Trabecula</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>&amp;Voxels</source>
        <translation>&amp;Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>S&amp;eeing</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>S&amp;tudy</source>
        <translation>&amp;Untersuchung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>Trabecula</source>
        <translation>Trabecula</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>Trabecula help</source>
        <translation>Trabecula: Hilfe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>Trabecula rods</source>
        <translation>Trabecula: Stäbe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>Trabecula seeing</source>
        <translation>Trabecula: Ansicht</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>Trabecula slices</source>
        <translation>Trabecula: Schnitte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>Trabecula study</source>
        <translation>Trabecula: Untersuchung</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>Trabecula voxels</source>
        <translation>Trabecula: Voxel</translation>
    </message>
</context>
</TS>
