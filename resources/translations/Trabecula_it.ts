<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="it" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>0 makes sheets, 1 makes rods of the texture; -1: fitted to the sample, or 0.3 without one</source>
        <translation>0 fa lamine, 1 fa aste della tessitura; -1: adattato al campione, o 0,3 senza campione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>A contour that fills so much of its box is a rod, else a plate</source>
        <translation>Un contorno che riempie tanto del suo rettangolo è un'asta, altrimenti una piastra</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Axes along which the number of trabeculae per layer is a target too</source>
        <translation>Assi lungo i quali anche il numero di trabecole per strato è un obiettivo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Axes of the planes: x, y, z, or a direction such as 0.6,0.8,0</source>
        <translation>Assi dei piani: x, y, z, o una direzione come 0.6,0.8,0</translation>
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
        <translation>Base</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Blocks keep volume and areas exactly; smooth keeps the volume</source>
        <translation>I blocchi conservano esattamente volume e aree; liscia conserva il volume</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>Body and face of the mark</source>
        <translation>Corpo e faccia del contrassegno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Body within which voxels may lie; none: the sample's box</source>
        <translation>Corpo entro il quale possono stare i voxel; nessuno: il parallelepipedo del campione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Cell of the field engine</source>
        <translation>Cella del motore a campo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Changes of single sites by hand, a JSON record a line: {"site": "Face1.2.3", "action": "off"}</source>
        <translation>Modifiche a mano di singoli siti, un record JSON per riga: {"site": "Face1.2.3", "action": "off"}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Closed contours of a shorter perimeter are left out</source>
        <translation>I contorni chiusi di perimetro minore sono esclusi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Co-ordinates of planes, mm; with at = heights</source>
        <translation>Coordinate dei piani, mm; con at = heights</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Co-ordinates of the planes along the axis, ascending</source>
        <translation>Coordinate dei piani lungo l'asse, crescenti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Compact layers</source>
        <translation>Strati compatti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Compatible tables by construction, or by the thesis' try-and-repeat</source>
        <translation>Tabelle compatibili per costruzione, o per tentativi ripetuti come nella tesi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Component of the unit tangent at each corner</source>
        <translation>Componente della tangente unitaria a ogni vertice</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Component of the unit tangent at each corner: direction in which a linear law grows</source>
        <translation>Componente della tangente unitaria a ogni vertice: direzione in cui cresce una legge lineare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Component of the unit tangent at each corner: formula of x, y, z (mm) and a random u in 0..1</source>
        <translation>Componente della tangente unitaria a ogni vertice: formula di x, y, z (mm) e di un u casuale in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Component of the unit tangent at each corner: how it varies over the design</source>
        <translation>Componente della tangente unitaria a ogni vertice: come varia nel progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Component of the unit tangent at each corner: the constant value, or the least; linear, radial: at the start</source>
        <translation>Componente della tangente unitaria a ogni vertice: il valore costante, o il minimo; lineare, radiale: all'inizio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Component of the unit tangent at each corner: the greatest value; linear, radial: at the end</source>
        <translation>Componente della tangente unitaria a ogni vertice: il valore massimo; lineare, radiale: alla fine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Connected parts (6 neighbours)</source>
        <translation>Parti connesse (6 vicini)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Connected pieces of the channels</source>
        <translation>Parti connesse dei canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Connected pieces of the scaffold</source>
        <translation>Parti connesse dello scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Contacts by a corner alone</source>
        <translation>Contatti per solo vertice</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Contacts by an edge alone</source>
        <translation>Contatti per solo spigolo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Contacts that are avoided: none by an edge alone, or none by an edge or a corner alone; any: all are allowed</source>
        <translation>Contatti evitati: nessuno per solo spigolo, o nessuno per solo spigolo o vertice; qualsiasi: tutti ammessi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Contours are offset by this into the material (tool compensation)</source>
        <translation>I contorni sono traslati di tanto verso il materiale (compensazione utensile)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Contours of all slices that are counted</source>
        <translation>Contorni di tutte le sezioni che si contano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Contours of no more area are not counted</source>
        <translation>I contorni di area non maggiore non si contano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Convergence points; none means the centre of the envelope</source>
        <translation>Punti di convergenza; nessuno significa il centro dell'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Corners of the spline; with 4 they lie on the square, else on a polygon of its area</source>
        <translation>Vertici della spline; se 4 stanno sul quadrato, altrimenti su un poligono di pari area</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>Count of faces; points on the face and normals there</source>
        <translation>Numero di facce; punti sulla faccia e normali in essi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Couplings</source>
        <translation>Accoppiamenti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Cross-sections of a rod: one all along, or one at each end</source>
        <translation>Sezioni di un'asta: una per tutta la lunghezza, o una a ogni estremo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Diameter of the circle, or side of the square through the corners</source>
        <translation>Diametro del cerchio, o lato del quadrato per i vertici</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Diameter of the circle, or side of the square through the corners: direction in which a linear law grows</source>
        <translation>Diametro del cerchio, o lato del quadrato per i vertici: direzione in cui cresce una legge lineare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Diameter of the circle, or side of the square through the corners: formula of x, y, z (mm) and a random u in 0..1</source>
        <translation>Diametro del cerchio, o lato del quadrato per i vertici: formula di x, y, z (mm) e di un u casuale in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Diameter of the circle, or side of the square through the corners: how it varies over the design</source>
        <translation>Diametro del cerchio, o lato del quadrato per i vertici: come varia nel progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Diameter of the circle, or side of the square through the corners: the constant value, or the least; linear, radial: at the start</source>
        <translation>Diametro del cerchio, o lato del quadrato per i vertici: il valore costante, o il minimo; lineare, radiale: all'inizio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Diameter of the circle, or side of the square through the corners: the greatest value; linear, radial: at the end</source>
        <translation>Diametro del cerchio, o lato del quadrato per i vertici: il valore massimo; lineare, radiale: alla fine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Difference between both volumes, %</source>
        <translation>Differenza tra i due volumi, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Direction of the co-ordinate line u; none means the face's own</source>
        <translation>Direzione della linea coordinata u; nessuna significa quella della faccia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Direction of the co-ordinate line u; none means the face's own (the zero vector) (d1)</source>
        <translation>Direzione della linea coordinata u; nessuna significa quella della faccia (il vettore nullo) (d1)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Direction of the co-ordinate line v; none means across d1</source>
        <translation>Direzione della linea coordinata v; nessuna significa trasversale a d1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Direction of the co-ordinate line v; none means across d1 (the zero vector) (d2)</source>
        <translation>Direzione della linea coordinata v; nessuna significa trasversale a d1 (il vettore nullo) (d2)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Distance of triangles from a solid; 0: chosen</source>
        <translation>Distanza dei triangoli da un solido; 0: scelta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Drawn curve along X: place over the edge, share of the layer; none: the sample's</source>
        <translation>Curva disegnata lungo X: posizione sul lato, quota dello strato; nessuna: quella del campione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Drawn curve along Y</source>
        <translation>Curva disegnata lungo Y</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Drawn curve along Z</source>
        <translation>Curva disegnata lungo Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Edges dx, dy, dz of a voxel; one number makes a cube</source>
        <translation>Lati dx, dy, dz di un voxel; un solo numero fa un cubo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Edges of the box for the random middle point (Eq. 3.1)</source>
        <translation>Lati del parallelepipedo per il punto intermedio casuale (Eq. 3.1)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Edges of the box of drawn curves, mm</source>
        <translation>Lati del parallelepipedo delle curve disegnate, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Engine that cut the channels</source>
        <translation>Motore che ha tagliato i canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Face at which the rods start</source>
        <translation>Faccia dalla quale partono le aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Face at which they end</source>
        <translation>Faccia alla quale terminano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>Face of the envelope</source>
        <translation>Faccia dell'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Face of the envelope, as FreeCAD names it</source>
        <translation>Faccia dell'involucro, come la chiama FreeCAD</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Faces to be thickened; none means no layer</source>
        <translation>Facce da ispessire; nessuna significa nessuno strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Field of the strategies by-field and best-tables: voxels lie where it is high</source>
        <translation>Campo delle strategie per campo e migliori da tabelle: i voxel stanno dove è alto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Gap fill: largest gap of an open contour that is closed</source>
        <translation>Chiusura lacune: massima lacuna di un contorno aperto che viene chiusa</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Gap fill: rounds of closing</source>
        <translation>Chiusura lacune: numero di passate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Given table alpha, lines (x, z); none: drawn</source>
        <translation>Tabella alpha data, linee (x, z); nessuna: estratta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Given table beta, lines (y, z); none: drawn</source>
        <translation>Tabella beta data, linee (y, z); nessuna: estratta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Greatest distance of the triangles from the true rod; 0 chooses 1/40 of the mean size</source>
        <translation>Massima distanza dei triangoli dall'asta vera; 0 sceglie 1/40 della dimensione media</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Greatest number of rods; 0 means as many as the smaller face has sites</source>
        <translation>Massimo numero di aste; 0 significa quanti siti ha la faccia minore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Hash of the numbers of each rod</source>
        <translation>Impronta dei numeri di ogni asta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Height along Z</source>
        <translation>Altezza lungo Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>How a row of a table is drawn: in proportion to what the columns still need, or uniformly as in the thesis</source>
        <translation>Come si estrae una riga di tabella: in proporzione a ciò che manca alle colonne, o uniformemente come nella tesi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>How rounded counts are brought to one total: largest remainders, or the thesis' random layers</source>
        <translation>Come i conteggi arrotondati sono portati a un solo totale: resti maggiori, o gli strati casuali della tesi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>How the layers are filled</source>
        <translation>Come si riempiono gli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Keep pieces that channels cut off all round, and closed voids as they are</source>
        <translation>Conservare come sono i pezzi che i canali isolano e i vuoti chiusi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/on_demand.py"/>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Key of the inputs of the result</source>
        <translation>Chiave dei dati del risultato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Largest difference of one rod, %</source>
        <translation>Massima differenza di un'asta, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Layers</source>
        <translation>Strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Layers along X (N)</source>
        <translation>Strati lungo X (N)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Layers along Y (M)</source>
        <translation>Strati lungo Y (M)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Layers along Z (P)</source>
        <translation>Strati lungo Z (P)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance from the border along u</source>
        <translation>Distanza minima dal bordo lungo u</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance from the border along u (b_u)</source>
        <translation>Distanza minima dal bordo lungo u (b_u)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance from the border along v</source>
        <translation>Distanza minima dal bordo lungo v</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance from the border along v (b_v)</source>
        <translation>Distanza minima dal bordo lungo v (b_v)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance of the sites from the borders along X</source>
        <translation>Distanza minima dei siti dai bordi lungo X</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance of the sites from the borders along X (a_x)</source>
        <translation>Distanza minima dei siti dai bordi lungo X (a_x)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance of the sites from the borders along Y</source>
        <translation>Distanza minima dei siti dai bordi lungo Y</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance of the sites from the borders along Y (a_y)</source>
        <translation>Distanza minima dei siti dai bordi lungo Y (a_y)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance of the sites from the borders along Z</source>
        <translation>Distanza minima dei siti dai bordi lungo Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Least distance of the sites from the borders along Z (a_z)</source>
        <translation>Distanza minima dei siti dai bordi lungo Z (a_z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Least thickness in voxels</source>
        <translation>Spessore minimo in voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Least void between solid in voxels</source>
        <translation>Vuoto minimo tra il materiale, in voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length along X</source>
        <translation>Lunghezza lungo X</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the first end of a 2-point curve</source>
        <translation>Lunghezza della tangente al primo estremo di una curva a 2 punti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the first end of a 2-point curve: direction in which a linear law grows</source>
        <translation>Lunghezza della tangente al primo estremo di una curva a 2 punti: direzione in cui cresce una legge lineare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the first end of a 2-point curve: formula of x, y, z (mm) and a random u in 0..1</source>
        <translation>Lunghezza della tangente al primo estremo di una curva a 2 punti: formula di x, y, z (mm) e di un u casuale in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the first end of a 2-point curve: how it varies over the design</source>
        <translation>Lunghezza della tangente al primo estremo di una curva a 2 punti: come varia nel progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the first end of a 2-point curve: the constant value, or the least; linear, radial: at the start</source>
        <translation>Lunghezza della tangente al primo estremo di una curva a 2 punti: il valore costante, o il minimo; lineare, radiale: all'inizio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the first end of a 2-point curve: the greatest value; linear, radial: at the end</source>
        <translation>Lunghezza della tangente al primo estremo di una curva a 2 punti: il valore massimo; lineare, radiale: alla fine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the second end of a 2-point curve</source>
        <translation>Lunghezza della tangente al secondo estremo di una curva a 2 punti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the second end of a 2-point curve: direction in which a linear law grows</source>
        <translation>Lunghezza della tangente al secondo estremo di una curva a 2 punti: direzione in cui cresce una legge lineare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the second end of a 2-point curve: formula of x, y, z (mm) and a random u in 0..1</source>
        <translation>Lunghezza della tangente al secondo estremo di una curva a 2 punti: formula di x, y, z (mm) e di un u casuale in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the second end of a 2-point curve: how it varies over the design</source>
        <translation>Lunghezza della tangente al secondo estremo di una curva a 2 punti: come varia nel progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the second end of a 2-point curve: the constant value, or the least; linear, radial: at the start</source>
        <translation>Lunghezza della tangente al secondo estremo di una curva a 2 punti: il valore costante, o il minimo; lineare, radiale: all'inizio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangent at the second end of a 2-point curve: the greatest value; linear, radial: at the end</source>
        <translation>Lunghezza della tangente al secondo estremo di una curva a 2 punti: il valore massimo; lineare, radiale: alla fine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangents in sides of the square; 1 is the thesis' unit tangent</source>
        <translation>Lunghezza delle tangenti in lati del quadrato; 1 è la tangente unitaria della tesi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangents in sides of the square; 1 is the thesis' unit tangent: direction in which a linear law grows</source>
        <translation>Lunghezza delle tangenti in lati del quadrato; 1 è la tangente unitaria della tesi: direzione in cui cresce una legge lineare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangents in sides of the square; 1 is the thesis' unit tangent: formula of x, y, z (mm) and a random u in 0..1</source>
        <translation>Lunghezza delle tangenti in lati del quadrato; 1 è la tangente unitaria della tesi: formula di x, y, z (mm) e di un u casuale in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangents in sides of the square; 1 is the thesis' unit tangent: how it varies over the design</source>
        <translation>Lunghezza delle tangenti in lati del quadrato; 1 è la tangente unitaria della tesi: come varia nel progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangents in sides of the square; 1 is the thesis' unit tangent: the constant value, or the least; linear, radial: at the start</source>
        <translation>Lunghezza delle tangenti in lati del quadrato; 1 è la tangente unitaria della tesi: il valore costante, o il minimo; lineare, radiale: all'inizio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Length of the tangents in sides of the square; 1 is the thesis' unit tangent: the greatest value; linear, radial: at the end</source>
        <translation>Lunghezza delle tangenti in lati del quadrato; 1 è la tangente unitaria della tesi: il valore massimo; lineare, radiale: alla fine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Mean deviation of the numbers of trabeculae per layer along X, Y, Z, %; none if they were not asked for</source>
        <translation>Scarto medio dei numeri di trabecole per strato lungo X, Y, Z, %; nessuno se non erano richiesti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Mean of sliced area over envelope area, over the axes, %</source>
        <translation>Media dell'area sezionata sull'area dell'involucro, sugli assi, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Memory budget of the B-Rep engine</source>
        <translation>Limite di memoria del motore B-Rep</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Memory budget of the B-Rep engine (memory_gb)</source>
        <translation>Limite di memoria del motore B-Rep (memory_gb)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Minimum zeros propagation: columns are solved one after the other (fewest zeros u), or rows (fewest zeros v)</source>
        <translation>Propagazione del minimo di zeri: si risolvono una dopo l'altra le colonne (minimo di zeri u) o le righe (minimo di zeri v)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Most voxels in a line (x, z), thesis 6.2.4.3; 0 means M</source>
        <translation>Massimo di voxel in una linea (x, z), tesi 6.2.4.3; 0 significa M</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Most voxels in a line (y, z); 0 means N</source>
        <translation>Massimo di voxel in una linea (y, z); 0 significa N</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Name of the site, e.g. Face1.2.-3; for add: the face and any new word, e.g. Face1.extra</source>
        <translation>Nome del sito, p. es. Face1.2.-3; per aggiungere: la faccia e una parola nuova, p. es. Face1.extra</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Names of the rods in the order of the solids</source>
        <translation>Nomi delle aste nell'ordine dei solidi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>New place; it is set on the face</source>
        <translation>Nuova posizione; è riportata sulla faccia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>New size of the pore</source>
        <translation>Nuova dimensione del poro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>New tangent components, one per corner, in 0..1</source>
        <translation>Nuove componenti delle tangenti, una per vertice, in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Number of rods</source>
        <translation>Numero di aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Number of triangles</source>
        <translation>Numero di triangoli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Off: the coupling makes no rods</source>
        <translation>No: l'accoppiamento non fa aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Offset of the contours into the material</source>
        <translation>Traslazione dei contorni verso il materiale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>On: also Tb.Th, Tb.Sp, Conn.D, DA ... on voxels; slow</source>
        <translation>Sì: anche Tb.Th, Tb.Sp, Conn.D, DA ... su voxel; lento</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>On: made after the channels and closes them; off: the channels go through</source>
        <translation>Sì: fatto dopo i canali e li chiude; no: i canali lo attraversano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>On: only from SliceLow to SliceHigh is sliced</source>
        <translation>Sì: si seziona solo da SliceLow a SliceHigh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>On: the value counts. Origin P of the co-ordinate lines; none means the centre of the face</source>
        <translation>Sì: il valore conta. Origine P delle linee coordinate; nessuna significa il centro della faccia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>One number reproduces all draws</source>
        <translation>Un solo numero riproduce tutte le estrazioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>One number reproduces all random draws</source>
        <translation>Un solo numero riproduce tutte le estrazioni casuali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Open contours shorter than this are left out</source>
        <translation>I contorni aperti più corti sono esclusi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Origin P of the co-ordinate lines; none means the centre of the face</source>
        <translation>Origine P delle linee coordinate; nessuna significa il centro della faccia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Pairs of faces in order, a JSON record a line: {"first": "Face1", "second": "Face2", "association": "random"}</source>
        <translation>Coppie di facce in ordine, un record JSON per riga: {"first": "Face1", "second": "Face2", "association": "random"}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Pairs of tables that are tried before the search gives up</source>
        <translation>Coppie di tabelle tentate prima che la ricerca si arrenda</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Paths</source>
        <translation>Percorsi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Paths of this coupling; none means those of the design</source>
        <translation>Percorsi di questo accoppiamento; nessuno significa quelli del progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Pieces that channels cut off all round</source>
        <translation>Pezzi isolati dai canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Plain sum of the rods' volumes over the envelope's, %</source>
        <translation>Somma semplice dei volumi delle aste su quello dell'involucro, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Planes at the layers' middles, at their bottoms (thesis), at heights</source>
        <translation>Piani a metà degli strati, alla loro base (tesi), a quote date</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Points that hardly turn a contour are left out</source>
        <translation>I punti che piegano appena un contorno sono esclusi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Pores</source>
        <translation>Pori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Pores that overlap or reach over a border</source>
        <translation>Pori che si sovrappongono o superano un bordo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Processor time that it took, s</source>
        <translation>Tempo di processore impiegato, s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Random displacement of each corner, in sides of the square</source>
        <translation>Spostamento casuale di ogni vertice, in lati del quadrato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>Results</source>
        <translation>Risultati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Rods</source>
        <translation>Aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Rods of the wireframe</source>
        <translation>Aste del telaio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Rods that leave the envelope between their ends</source>
        <translation>Aste che escono dall'involucro tra i loro estremi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Rods that no remedy mended; they are left out</source>
        <translation>Aste che nessun rimedio ha riparato; sono escluse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Rods that the last recompute built or took anew</source>
        <translation>Aste che l'ultimo ricalcolo ha costruito o preso di nuovo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Rods that were cut away</source>
        <translation>Aste tagliate via</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Rods that were mended: fault, remedy, attempts</source>
        <translation>Aste riparate: difetto, rimedio, tentativi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>STL, OBJ, PLY or 3MF that is sliced if there is no source</source>
        <translation>STL, OBJ, PLY o 3MF sezionato se non c'è un corpo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>STL, OBJ, PLY, 3MF, an analysis' CSV or JSON, NPY</source>
        <translation>STL, OBJ, PLY, 3MF, CSV o JSON di un'analisi, NPY</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Scaffold</source>
        <translation>Scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sections through which the surface of a solid rod is laid</source>
        <translation>Sezioni per le quali passa la superficie di un'asta solida</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Share of the envelope inside the rods, nothing taken away or filled, %</source>
        <translation>Quota dell'involucro entro le aste, nulla tolto o riempito, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Share of the envelope that is not scaffold, % (Eq. 2.2)</source>
        <translation>Quota dell'involucro che non è scaffold, % (Eq. 2.2)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Share of the voxels in the largest part, %</source>
        <translation>Quota dei voxel nella parte maggiore, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Short name used in couplings and reports, e.g. A; none means the face's own</source>
        <translation>Nome breve usato in accoppiamenti e relazioni, p. es. A; nessuno significa quello della faccia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Short name used in couplings and reports, e.g. A; none means the face's own (name)</source>
        <translation>Nome breve usato in accoppiamenti e relazioni, p. es. A; nessuno significa quello della faccia (name)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Sites</source>
        <translation>Siti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sites along X</source>
        <translation>Siti lungo X</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sites along X (n_x)</source>
        <translation>Siti lungo X (n_x)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sites along Y</source>
        <translation>Siti lungo Y</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sites along Y (n_y)</source>
        <translation>Siti lungo Y (n_y)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sites along Z</source>
        <translation>Siti lungo Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sites along Z (n_z)</source>
        <translation>Siti lungo Z (n_z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Sites available, rods, sites left, for each coupling (tables 4.2, 4.5)</source>
        <translation>Siti disponibili, aste, siti rimasti, per ogni accoppiamento (tabelle 4.2, 4.5)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/prism_sites.py"/>
        <source>Sites on all faces</source>
        <translation>Siti su tutte le facce</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Sites on its faces</source>
        <translation>Siti sulle sue facce</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>Sites on the face</source>
        <translation>Siti sulla faccia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Sites that earlier couplings used may be used again</source>
        <translation>I siti usati da accoppiamenti precedenti possono essere riusati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>Sizes of the rods' end sections, mm</source>
        <translation>Dimensioni delle sezioni di estremità delle aste, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Slices</source>
        <translation>Sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Slices along all axes</source>
        <translation>Sezioni lungo tutti gli assi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Slices on which the mesh is not closed: their numbers may be wrong</source>
        <translation>Sezioni in cui la mesh non è chiusa: i loro numeri possono essere errati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Solid voxels</source>
        <translation>Voxel pieni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Solid voxels over all of the envelope, %</source>
        <translation>Voxel pieni su tutti quelli dell'involucro, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Spacing of the lines along v</source>
        <translation>Passo delle linee lungo v</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Spacing of the lines along v (c_v)</source>
        <translation>Passo delle linee lungo v (c_v)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Spacing of the sites along u</source>
        <translation>Passo dei siti lungo u</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Spacing of the sites along u (c_u)</source>
        <translation>Passo dei siti lungo u (c_u)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Sum of sliced area x thickness, mean of the axes</source>
        <translation>Somma di area sezionata x spessore, media degli assi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Sum of the solids' volumes; overlaps count twice</source>
        <translation>Somma dei volumi dei solidi; le sovrapposizioni contano due volte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Sum of the volumes of the rods' meshes: the independent route</source>
        <translation>Somma dei volumi delle mesh delle aste: la via indipendente</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Targets from sections through the middles of the layers (Eq. 6.1), or from the volumes of the slabs</source>
        <translation>Obiettivi da sezioni a metà degli strati (Eq. 6.1), o dai volumi delle lastre</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>The analysis: its numbers</source>
        <translation>L'analisi: i suoi numeri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>The analysis: names, tables, places of its numbers</source>
        <translation>L'analisi: nomi, tabelle, posti dei suoi numeri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>The body that is sliced; none: the file</source>
        <translation>Il corpo sezionato; nessuno: il file</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>The body to be filled</source>
        <translation>Il corpo da riempire</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>The design: its numbers</source>
        <translation>Il progetto: i suoi numeri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>The design: names, places of its numbers</source>
        <translation>Il progetto: nomi, posti dei suoi numeri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/prism_sites.py"/>
        <source>The prism, a box</source>
        <translation>Il prisma, un parallelepipedo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>The sample: a body, or an analysis; none: the file</source>
        <translation>Il campione: un corpo, o un'analisi; nessuno: il file</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>The scaffold of which this is a part</source>
        <translation>Lo scaffold di cui questo fa parte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/on_demand.py"/>
        <source>The wireframe whose rods these are</source>
        <translation>Il telaio di cui queste sono le aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>The wireframe: its numbers</source>
        <translation>Il telaio: i suoi numeri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>The wireframe: names, tables, places of its numbers</source>
        <translation>Il telaio: nomi, tabelle, posti dei suoi numeri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Thickness of a layer</source>
        <translation>Spessore di uno strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Thickness of the layer</source>
        <translation>Spessore dello strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Tilt of the inner sections towards the path's normal planes</source>
        <translation>Inclinazione delle sezioni interne verso i piani normali del percorso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Time budget of the B-Rep engine</source>
        <translation>Limite di tempo del motore B-Rep</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Time budget of the B-Rep engine (seconds)</source>
        <translation>Limite di tempo del motore B-Rep (seconds)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Time that it took, s</source>
        <translation>Tempo impiegato, s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Times that tangents or middle points are drawn again before the path is changed</source>
        <translation>Quante volte tangenti o punti intermedi sono estratti di nuovo prima di cambiare il percorso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>To whose slices the porosity refers; none: the body's box</source>
        <translation>Alle cui sezioni si riferisce la porosità; nessuno: il parallelepipedo del corpo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Triangles that were sliced</source>
        <translation>Triangoli sezionati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>True areas of the rods' end sections, mm^2</source>
        <translation>Aree vere delle sezioni di estremità delle aste, mm^2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Unit of the file; auto: guessed, and said</source>
        <translation>Unità del file; auto: stimata, e detta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Unit of the numbers before they became mm</source>
        <translation>Unità dei numeri prima che diventassero mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>Version of the object</source>
        <translation>Versione dell'oggetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Voids that no opening reaches</source>
        <translation>Vuoti senza apertura</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Volume of the channels</source>
        <translation>Volume dei canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Volume of the envelope</source>
        <translation>Volume dell'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Volume of the layers outside of the envelope</source>
        <translation>Volume degli strati fuori dell'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Volume of the mesh: the independent route</source>
        <translation>Volume della mesh: la via indipendente</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Volume of the pieces that channels cut off all round</source>
        <translation>Volume dei pezzi isolati dai canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Volume of the same cut by the mesh engine: the independent route</source>
        <translation>Volume dello stesso taglio col motore a mesh: la via indipendente</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Volume of the scaffold</source>
        <translation>Volume dello scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Volume of the scaffold as it is shown</source>
        <translation>Volume dello scaffold come è mostrato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Volume of the solid voxels</source>
        <translation>Volume dei voxel pieni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Volume of the solid, loose pieces included</source>
        <translation>Volume del solido, pezzi staccati inclusi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Volume of the triangles: the independent route</source>
        <translation>Volume dei triangoli: la via indipendente</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Volume of the voids that no opening reaches</source>
        <translation>Volume dei vuoti senza apertura</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Volumes of the rods' meshes, mm^3</source>
        <translation>Volumi delle mesh delle aste, mm^3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>Volumes of the solids, mm^3</source>
        <translation>Volumi dei solidi, mm^3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Voxels at the envelope's boundary belong to it when their centre does, when they touch it, or when they lie inside it whole</source>
        <translation>I voxel al bordo dell'involucro vi appartengono se vi sta il loro centro, se lo toccano, o se vi stanno per intero</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Wavelengths of the trabecular texture along X, Y, Z; 0: fitted to the sample, or eight voxels without one</source>
        <translation>Lunghezze d'onda della tessitura trabecolare lungo X, Y, Z; 0: adattate al campione, o otto voxel senza campione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>What is to be known</source>
        <translation>Ciò che c'è da sapere</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>What overlaps counts as often as it overlaps, or once (union)</source>
        <translation>Ciò che si sovrappone conta tante volte quante si sovrappone, o una sola (unione)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>What the last recompute said</source>
        <translation>Ciò che ha detto l'ultimo ricalcolo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>What this is of the scaffold</source>
        <translation>Che cosa è questo dello scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>What was worked out twice, by independent routes, and how far the two differ</source>
        <translation>Ciò che è calcolato due volte, per vie indipendenti, e di quanto differiscono</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Where the layers begin</source>
        <translation>Dove cominciano gli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Where the layers begin; nan: where the body does</source>
        <translation>Dove cominciano gli strati; nan: dove comincia il corpo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>Where the layers end</source>
        <translation>Dove finiscono gli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>Where the layers end; nan: where the body does</source>
        <translation>Dove finiscono gli strati; nan: dove finisce il corpo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Whether all rods were cut</source>
        <translation>Se tutte le aste sono state tagliate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Whether every layer along X, Y and Z has the voxels asked for</source>
        <translation>Se ogni strato lungo X, Y e Z ha i voxel richiesti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Whether scaffold and channels are closed</source>
        <translation>Se scaffold e canali sono chiusi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>Whether the mesh is closed</source>
        <translation>Se la mesh è chiusa</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/on_demand.py"/>
        <source>Whether the result belongs to the present inputs</source>
        <translation>Se il risultato corrisponde ai dati attuali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>Which axis' real total is the common one (thesis: z)</source>
        <translation>Il totale reale di quale asse è quello comune (tesi: z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Which of several convergence points a rod takes</source>
        <translation>Quale di più punti di convergenza prende un'asta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>Why it stopped, if it did</source>
        <translation>Perché si è fermato, se si è fermato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>Why this engine, and what it was expected to take</source>
        <translation>Perché questo motore, e che cosa ci si aspettava che richiedesse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>Width along Y</source>
        <translation>Larghezza lungo Y</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>circle, or closed spline through corners with random tangents</source>
        <translation>cerchio, o spline chiusa per vertici con tangenti casuali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>inwards: the outer part of the envelope; outwards: added to it</source>
        <translation>verso l'interno: la parte esterna dell'involucro; verso l'esterno: gli si aggiunge</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>mesh: exact triangles; field: rays and cells, for many rods; brep: STEP</source>
        <translation>mesh: triangoli esatti; campo: raggi e celle, per molte aste; B-Rep: STEP</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>off, move (to point), add (at point), pore (size and turns)</source>
        <translation>no, sposta (al punto), aggiungi (nel punto), poro (dimensione e tangenti)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>orthogonal: along the normal; straight: joins the sites; centre: 3-point curve through a convergence point; box: through a random point of a box about it (Eq. 3.1); tension: 2-point curve along the inner normals</source>
        <translation>ortogonale: lungo la normale; retto: unisce i siti; centro: curva a 3 punti per un punto di convergenza; riquadro: per un punto casuale di un parallelepipedo attorno ad esso (Eq. 3.1); tensione: curva a 2 punti lungo le normali interne</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>random pairs of sites, or site (i, j) to site (i, j)</source>
        <translation>coppie casuali di siti, o sito (i, j) con sito (i, j)</translation>
    </message>
</context>
<context>
    <name>Choices</name>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>add</source>
        <translation>aggiungi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>any</source>
        <translation>qualsiasi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>auto</source>
        <translation>automatico</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>best-tables</source>
        <translation>migliori tabelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>blocks</source>
        <translation>blocchi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>border</source>
        <translation>bordo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>bottom</source>
        <translation>alla base</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>box</source>
        <translation>riquadro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>brep</source>
        <translation>B-Rep</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>by-field</source>
        <translation>per campo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>centre</source>
        <translation>centro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>circle</source>
        <translation>cerchio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>columns</source>
        <translation>colonne</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>constant</source>
        <translation>costante</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>constraint</source>
        <translation>con vincolo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>corner</source>
        <translation>per vertice</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>coupling</source>
        <translation>accoppiamento</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>edge</source>
        <translation>per spigolo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>expression</source>
        <translation>formula</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>field</source>
        <translation>campo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>gyroid</source>
        <translation>giroide</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>half</source>
        <translation>per metà</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>heavy</source>
        <translation>forte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>heights</source>
        <translation>quote</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>inside</source>
        <translation>interna</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>inwards</source>
        <translation>verso l'interno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>linear</source>
        <translation>lineare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>mean</source>
        <translation>media</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>mesh</source>
        <translation>mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>middle</source>
        <translation>a metà</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>minimum-zeros</source>
        <translation>minimo di zeri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>move</source>
        <translation>sposta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>nearest</source>
        <translation>più vicino</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>noise</source>
        <translation>rumore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>none</source>
        <translation>nessuno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>normal</source>
        <translation>normale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>off</source>
        <translation>no</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>orthogonal</source>
        <translation>ortogonale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>outwards</source>
        <translation>verso l'esterno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>picked faces</source>
        <translation>facce scelte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>plain</source>
        <translation>semplice</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>pore</source>
        <translation>poro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>prism</source>
        <translation>prisma</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>proportional</source>
        <translation>proporzionale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>radial</source>
        <translation>radiale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>random</source>
        <translation>casuale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>random-layers</source>
        <translation>strati casuali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>recovery</source>
        <translation>recupero</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>remainders</source>
        <translation>resti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>repeat</source>
        <translation>ripetizione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>rods and plates</source>
        <translation>aste e piastre</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>rows</source>
        <translation>righe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>same</source>
        <translation>stesso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>sequential</source>
        <translation>sequenziale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>sheets</source>
        <translation>lamine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>size</source>
        <translation>dimensione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>slab</source>
        <translation>lastra</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>smooth</source>
        <translation>liscia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>spline</source>
        <translation>spline</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>straight</source>
        <translation>retto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>tension</source>
        <translation>tensione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>thesis</source>
        <translation>tesi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>touched</source>
        <translation>toccata</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>trabecular</source>
        <translation>trabecolare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>uniform</source>
        <translation>uniforme</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>union</source>
        <translation>unione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>winding</source>
        <translation>avvolgimento</translation>
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
        <translation> (chiuso: farne prima un solido)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source> (the widest gap: {} mm)</source>
        <translation> (la lacuna più larga: {} mm)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source> ({} % of it lie outside any block of 2 x 2 x 2 voxels)</source>
        <translation> (il {} % sta fuori da ogni blocco di 2 x 2 x 2 voxel)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/feasibility.py"/>
        <source> ... ({} layers)</source>
        <translation> ... ({} strati)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source> The thesis needed {} s for alpha, beta and the layers of 103 x 94 x 103 voxels by this strategy.</source>
        <translation> La tesi ha richiesto {} s per alfa, beta e gli strati di 103 x 94 x 103 voxel con questa strategia.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source> about {} mm</source>
        <translation> intorno a {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thresholds.py"/>
        <source> above {}</source>
        <translation> oltre {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masked_tables.py"/>
        <source> and with {}</source>
        <translation> e con {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source> and {} more stretches</source>
        <translation> e altri {} tratti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source> by an edge</source>
        <translation> per uno spigolo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source> by an edge or a corner</source>
        <translation> per uno spigolo o un vertice</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source> or {}</source>
        <translation> o {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source> there twice: the material counts twice</source>
        <translation> presenti due volte: il materiale conta due volte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source> turned against the neighbours</source>
        <translation> rovesciate rispetto alle vicine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source> within the mask</source>
        <translation> nella maschera</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>, box of {} mm</source>
        <translation>, parallelepipedo {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>, one of them in layer {} along Z</source>
        <translation>, uno dei quali nello strato {} lungo Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>, {} of them spoilt</source>
        <translation>, {} guaste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>1 / (Tb.Th + Tb.Sp); programs that measure between mid-axes, or divide BV/TV by Tb.Th, get other numbers</source>
        <translation>1 / (Tb.Th + Tb.Sp); i programmi che misurano tra gli assi medi, o dividono BV/TV per Tb.Th, danno altri numeri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>1 less what the body adds to the Euler number of the structure it was cut out of: the box's faces count half, its edges a quarter, its corners an eighth</source>
        <translation>1 meno ciò che il corpo aggiunge al numero di Eulero della struttura da cui è tagliato: le facce del parallelepipedo contano metà, gli spigoli un quarto, i vertici un ottavo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>100 (1 - V_solid / V_envelope), volumes by the kernel</source>
        <translation>100 (1 - V_solid / V_envelope), volumi dal nucleo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>100 (1 - sliced area / area of the envelope's slice)</source>
        <translation>100 (1 - area sezionata / area della sezione dell'involucro)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>100 (V_envelope - V_scaffold) / V_envelope, volumes by the divergence theorem over the triangles of what is exported</source>
        <translation>100 (V_envelope - V_scaffold) / V_envelope, volumi col teorema della divergenza sui triangoli di ciò che si esporta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>100 V_union / V_envelope, the union by the engine, before loose pieces are taken away or voids filled</source>
        <translation>100 V_union / V_envelope, unione fatta dal motore, prima di togliere pezzi staccati o riempire vuoti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>100 V_union / V_envelope, the union of the rods by parallel rays through their triangles, with its standard error; loose pieces stay</source>
        <translation>100 V_union / V_envelope, unione delle aste con raggi paralleli attraverso i loro triangoli, col suo errore standard; i pezzi staccati restano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>100 solid voxels / voxels of the envelope</source>
        <translation>100 voxel pieni / voxel dell'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>100 sum V_rod / V_envelope, crossings counted as often as they come; what the thesis added up for case 1</source>
        <translation>100 somma V_rod / V_envelope, incroci contati tante volte quante si presentano; così sommava la tesi nel caso 1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>100 sum of sliced areas / sum of the envelope's</source>
        <translation>100 somma delle aree sezionate / somma di quelle dell'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>100 times the mean over an axis' layers of |made - asked for| / asked for</source>
        <translation>100 per la media sugli strati di un asse di |fatti - richiesti| / richiesti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>100 voxels of the largest part / solid voxels</source>
        <translation>100 voxel della parte maggiore / voxel pieni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>100 x twice the common solid voxels over the sum of both</source>
        <translation>100 x il doppio dei voxel pieni comuni sulla somma dei due</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>1e-9 of it for blocks; told for smooth surfaces</source>
        <translation>1e-9 di esso per i blocchi; dichiarato per superfici lisce</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>2 BV / BS over the largest edge of a voxel</source>
        <translation>2 BV / BS sul lato maggiore di un voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/path_laws.py"/>
        <source>2-point curve along the inner normals</source>
        <translation>curva a 2 punti lungo le normali interne</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/path_laws.py"/>
        <source>3-point curve through a convergence point</source>
        <translation>curva a 3 punti per un punto di convergenza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>6e-15 on 960 planes; of solids what tessellation changes</source>
        <translation>6e-15 su 960 piani; per i solidi quanto cambia la triangolazione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>: the mesh is not watertight</source>
        <translation>: la mesh non è a tenuta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>A graph over the slices (thesis ch. 9): trabeculae are joined where they overlap on neighbouring slices. Its counts depend on the thickness of the layers.</source>
        <translation>Un grafo sulle sezioni (tesi cap. 9): le trabecole sono unite dove si sovrappongono su sezioni vicine. I suoi conteggi dipendono dallo spessore degli strati.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>All checks held.</source>
        <translation>Tutti i controlli superati.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_makers.py"/>
        <source>Analysis {}</source>
        <translation>Analisi {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>BS over BV</source>
        <translation>BS su BV</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>BV over TV; porosity is 1 less it</source>
        <translation>BV su TV; la porosità è 1 meno questa</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>BV/TV is {} by triangles and {} by voxels: parts of the mesh overlap (then the voxels are right), or are thinner than a voxel</source>
        <translation>BV/TV è {} per triangoli e {} per voxel: parti della mesh si sovrappongono (allora valgono i voxel), o sono più sottili di un voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Checks</source>
        <translation>Controlli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Choices</source>
        <translation>Scelte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>Comparison</source>
        <translation>Confronto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>Conn over TV</source>
        <translation>Conn su TV</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Couplings</source>
        <translation>Accoppiamenti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>DA by all lines through BS, from its normals: the second route, exact</source>
        <translation>DA con tutte le linee per BS, dalle sue normali: la seconda via, esatta</translation>
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
        <translation>Definizioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>Design</source>
        <translation>Progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>Differences on shared layers</source>
        <translation>Differenze sugli strati comuni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/connectivity.py"/>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>Euler number</source>
        <translation>numero di Eulero</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Exact on every layer of the three axes, but its mesh is not watertight.</source>
        <translation>Esatto su ogni strato dei tre assi, ma la mesh non è a tenuta.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Exact on every layer of the three axes.</source>
        <translation>Esatto su ogni strato dei tre assi.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Exact on every layer of the three axes; the mesh is watertight.</source>
        <translation>Esatto su ogni strato dei tre assi; la mesh è a tenuta.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>FAILED</source>
        <translation>FALLITO</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Faces and sites</source>
        <translation>Facce e siti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/envelope.py"/>
        <source>File from which the envelope was made</source>
        <translation>File da cui è fatto l'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Files</source>
        <translation>File</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>Green's theorem over the cubic pieces, exact</source>
        <translation>teorema di Green sui tratti cubici, esatto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Heavy</source>
        <translation>Forte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>Hellinger distance of the distributions of trabecular area over logarithmic bins, five per decade with borders at 10^(k/5) mm2: sqrt(sum (sqrt p - sqrt q)^2 / 2); 0 = equal, 1 = no bin shared</source>
        <translation>distanza di Hellinger delle distribuzioni di area trabecolare su classi logaritmiche, cinque per decade con limiti a 10^(k/5) mm2: radice(somma (radice p - radice q)^2 / 2); 0 = uguali, 1 = nessuna classe comune</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>How many designs</source>
        <translation>Quanti progetti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Input</source>
        <translation>Dati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Interconnectivity</source>
        <translation>Interconnessione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>Kolmogorov-Smirnov distance of the distributions of trabecular area (net of holes, each trabecula of each slice once): largest difference of the two shares of trabeculae up to an area; not binned; 0 = equal, 1 = apart</source>
        <translation>distanza di Kolmogorov-Smirnov delle distribuzioni di area trabecolare (al netto dei fori, ogni trabecola di ogni sezione una volta): massima differenza delle quote fino a un'area; senza classi; 0 = uguali, 1 = separate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Layers</source>
        <translation>Strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>Layers of {}</source>
        <translation>Strati di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Leave the envelope</source>
        <translation>Escono dall'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Left out, since nothing mended them</source>
        <translation>Tralasciate, perché nulla le ha riparate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>Left out, to keep this file small:</source>
        <translation>Tralasciati, per tenere piccolo questo file:</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>Lengths are mm. Under each table stands why its numbers are what they are.</source>
        <translation>Lunghezze in mm. Sotto ogni tabella è detto perché i suoi numeri sono quello che sono.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>MIL.max over MIL.min by lines through the voxels, up to 10 % low; 1 = isotropic; 1 - 1/DA^2 goes from 0 to 1</source>
        <translation>MIL.max su MIL.min con linee tra i voxel, fino al 10 % in meno; 1 = isotropo; 1 - 1/DA^2 va da 0 a 1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Made with {}.</source>
        <translation>Fatto con {}.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Mesh</source>
        <translation>Mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Morphometry</source>
        <translation>Morfometria</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>None.</source>
        <translation>Nessuno.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>None: the slices came from a file of layers.</source>
        <translation>Nessuna: le sezioni vengono da un file di strati.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Not all checks held: see Checks.</source>
        <translation>Non tutti i controlli superati: vedi Controlli.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Not exact: {} layers have other counts than asked for.</source>
        <translation>Non esatto: {} strati hanno conteggi diversi da quelli richiesti.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Note:</source>
        <translation>Nota:</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Of {} pairs of tables drawn without regard for each other {} came to their end; {} % of their layers were compatible, and {} pairs in all layers.</source>
        <translation>Di {} coppie di tabelle estratte senza riguardo l'una per l'altra {} sono giunte alla fine; il {} % dei loro strati era compatibile, e {} coppie in tutti gli strati.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Off</source>
        <translation>No</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/on_demand.py"/>
        <source>On: computed with every recompute; off: shown as out of date until it is updated</source>
        <translation>Sì: calcolato a ogni ricalcolo; no: mostrato come non aggiornato finché non lo si aggiorna</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>On: the value counts. {}</source>
        <translation>Sì: il valore conta. {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/trabecular.py"/>
        <source>One connected part of sheets and rods, like the sample's; no floating voxel, no closed cavity</source>
        <translation>Una sola parte connessa di lamine e aste, come quelle del campione; nessun voxel sospeso, nessuna cavità chiusa</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>Pearson's correlation of the profiles over the shared layers; 1 = same shape; none if a profile is constant</source>
        <translation>correlazione di Pearson dei profili sugli strati comuni; 1 = stessa forma; nessuna se un profilo è costante</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Pores</source>
        <translation>Pori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Recoveries</source>
        <translation>Recuperi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Rods and plates are outer contours; the thesis classes voids with the plates, and counts every contour as a trabecula. A negative trabecular area is a void's. Porosity refers to {}.</source>
        <translation>Aste e piastre sono contorni esterni; la tesi mette i vuoti tra le piastre e conta ogni contorno come trabecola. Un'area trabecolare negativa è di un vuoto. La porosità si riferisce a {}.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>Rods and plates as in the thesis: every contour, voids too, by area / box.</source>
        <translation>Aste e piastre come nella tesi: ogni contorno, anche i vuoti, secondo area / rettangolo.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>Round(sliced area / area of a voxel's face), brought to one total of the three axes</source>
        <translation>Round(area sezionata / area di una faccia del voxel), portato a un solo totale dei tre assi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>Samples are laid side by side by {}; differences are against {}.</source>
        <translation>I campioni sono affiancati secondo {}; le differenze sono rispetto a {}.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>Sections with the same value, as the thesis counts them, are where two curves meet.</source>
        <translation>Le sezioni con lo stesso valore, come le conta la tesi, sono dove due curve si incontrano.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/makers.py"/>
        <source>Sites {}</source>
        <translation>Siti {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>Slice analysis</source>
        <translation>Analisi per sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>Slice passport</source>
        <translation>Passaporto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>Sliced area (mm2)</source>
        <translation>Area sezionata (mm2)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Slices along the axes</source>
        <translation>Sezioni lungo gli assi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>Slices of {}</source>
        <translation>Sezioni: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/envelope.py"/>
        <source>Solid in that file</source>
        <translation>Solido in quel file</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>Solid{}{} ({})</source>
        <translation>Solid{}{} ({})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/examples.py"/>
        <source>Specimen {}</source>
        <translation>Provino {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Tables that fit</source>
        <translation>Tabelle compatibili</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>The deltas are the common total less the sum of the counts rounded by Eq. 6.1.</source>
        <translation>I delta sono il totale comune meno la somma dei conteggi arrotondati con l'Eq. 6.1.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>The design</source>
        <translation>Il progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>The mesh is faulty: the numbers are not to be trusted where it is.</source>
        <translation>La mesh è difettosa: in quei punti i numeri non sono attendibili.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>The scores are in [{}]({}).</source>
        <translation>I punteggi sono in [{}]({}).</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>The whole run took {} s.{}</source>
        <translation>L'intera esecuzione è durata {} s.{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>Total number of plates</source>
        <translation>Numero totale di piastre</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>Total number of rods</source>
        <translation>Numero totale di aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>Totals and ranges</source>
        <translation>Totali e intervalli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>Trabecular area range (mm2)</source>
        <translation>Intervallo delle aree trabecolari (mm2)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>Underwood, Quantitative Stereology, 1970 (S_V = 2 P_L)</source>
        <translation>Underwood, Quantitative Stereology, 1970 (S_V = 2 P_L)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>Voxel design</source>
        <translation>Progetto a voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>Voxel design of {}</source>
        <translation>Progetto a voxel: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>Voxels of drawn curves</source>
        <translation>Voxel di curve disegnate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>Voxels {}</source>
        <translation>Voxel {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>Warning: {}</source>
        <translation>Avviso: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/envelope.py"/>
        <source>What was mended in the file's solid, and what looks wrong</source>
        <translation>Che cosa è stato riparato nel solido del file, e che cosa sembra errato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>Why? Formulas, sources, second routes</source>
        <translation>Perché? Formule, fonti, seconde vie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>a 3MF file must be a whole ZIP archive: {}</source>
        <translation>un file 3MF deve essere un archivio ZIP intero: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>a 3MF file must hold {}</source>
        <translation>un file 3MF deve contenere {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>a Boolean must be one of {}, got {}</source>
        <translation>un'operazione booleana deve essere una di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_formats.py"/>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>a PLY file must begin with its header</source>
        <translation>un file PLY deve cominciare con la sua intestazione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/install.py"/>
        <source>a Python {} with pip must be there to install manifold3d, and none was found</source>
        <translation>per installare manifold3d deve esserci un Python {} con pip, e non se ne è trovato nessuno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_panel.py"/>
        <source>a body to be sliced must be chosen, got none: choose an object or a file</source>
        <translation>si deve scegliere un corpo da sezionare, qui nessuno: scegliere un oggetto o un file</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/voxelise.py"/>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <location filename="../../freecad_trabecula/core/rays.py"/>
        <source>a box must satisfy low &lt; high on every axis, got {} and {} mm</source>
        <translation>per un riquadro deve valere basso &lt; alto su ogni asse, qui {} e {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masked_tables.py"/>
        <source>a cap of {} on {}</source>
        <translation>un massimo di {} per {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>a change by hand does not</source>
        <translation>una modifica a mano non lo fa</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>a change by hand does not fit the design: {}</source>
        <translation>una modifica a mano non si accorda col progetto: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/sites.py"/>
        <source>a change by hand must name a site of face {} ({} sites), got {}</source>
        <translation>una modifica a mano deve nominare un sito della faccia {} ({} siti), qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/pieces.py"/>
        <source>a closed mesh must hold some volume, got {} mm3</source>
        <translation>una mesh chiusa deve avere un volume, qui {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/coordinate_lines.py"/>
        <source>a co-ordinate line could not be followed for {} mm</source>
        <translation>non si è potuta seguire una linea coordinata per {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/coordinate_lines.py"/>
        <source>a co-ordinate line has no end after {} steps and {} mm</source>
        <translation>una linea coordinata non ha fine dopo {} passi e {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/coordinate_lines.py"/>
        <source>a co-ordinate line left the face unnoticed after {} mm</source>
        <translation>una linea coordinata è uscita dalla faccia senza avviso dopo {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/coordinate_lines.py"/>
        <source>a co-ordinate line's plane touches the face</source>
        <translation>il piano di una linea coordinata tocca la faccia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>a comparison needs at least two analyses, got {}</source>
        <translation>un confronto richiede almeno due analisi, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a convergence point's co-ordinate</source>
        <translation>una coordinata di un punto di convergenza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/couplings.py"/>
        <source>a coupled face must have at least 1 site, got 0 on face {}: less spacing or border</source>
        <translation>una faccia accoppiata deve avere almeno 1 sito, qui 0 sulla faccia {}: ridurre distanze o bordi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a coupling must join faces of the job ({}), got {}</source>
        <translation>un accoppiamento deve unire facce del lavoro ({}), qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/couplings.py"/>
        <source>a coupling must join faces that have sites ({}), got {}</source>
        <translation>un accoppiamento deve unire facce che hanno siti ({}), qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a coupling needs two faces, got {}</source>
        <translation>un accoppiamento richiede due facce, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>a curve along {} must ask for some material, got {}</source>
        <translation>una curva lungo {} deve chiedere del materiale, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>a curve along {} must have at least one point, got {}</source>
        <translation>una curva lungo {} deve avere almeno un punto, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>a curve's places along {} must lie in 0..1 of the edge, got {}</source>
        <translation>le posizioni di una curva lungo {} devono stare in 0..1 del lato, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/verification.py"/>
        <source>a design for these targets must have the shape {}, got {}</source>
        <translation>un progetto per questi obiettivi deve avere la forma {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a design must be an array with three axes, got {}</source>
        <translation>un progetto deve essere una matrice a tre assi, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/smooth_surface.py"/>
        <source>a design must have at least one solid voxel to have a surface, got {}</source>
        <translation>un progetto deve avere almeno un voxel pieno per avere una superficie, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/blocks.py"/>
        <source>a design must have at least one voxel to have a mesh, got 0</source>
        <translation>un progetto deve avere almeno un voxel per avere una mesh, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masks.py"/>
        <source>a design must have at least one voxel; the densities in this mask make, got {}</source>
        <translation>un progetto deve avere almeno un voxel; le densità in questa maschera danno, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a design must have at most {} rods; this one would take about {} hours and {} GB, got {}</source>
        <translation>un progetto può avere al più {} aste; questo richiederebbe circa {} ore e {} GB, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>a design must have at most {} voxels; {} would take about {} GB of memory; larger voxels make fewer, got {}</source>
        <translation>un progetto può avere al più {} voxel; {} richiederebbero circa {} GB di memoria; voxel più grandi sono di meno, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/report_sections.py"/>
        <source>a design must have its scaffold to be told of: build it first</source>
        <translation>un progetto deve avere il suo scaffold per la relazione: costruirlo prima</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/variants.py"/>
        <source>a design must have solid voxels, got 0</source>
        <translation>un progetto deve avere voxel pieni, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/export_dialog.py"/>
        <source>a design needs a network or a scaffold to be exported, got none: build one first</source>
        <translation>per essere esportato un progetto richiede una rete o uno scaffold, qui nessuno: prima costruirne uno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/report_sections.py"/>
        <source>a design with its scaffold, an analysis or voxels are needed</source>
        <translation>servono un progetto col suo scaffold, un'analisi o dei voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>a design with these counts and rules exists, but was not found; another seed may do</source>
        <translation>un progetto con questi conteggi e queste regole esiste, ma non è stato trovato; forse un altro seme basta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/coordinate_lines.py"/>
        <source>a direction must not be along the face's normal at the origin of its line, got ({}, {}, {})</source>
        <translation>una direzione non deve essere lungo la normale alla faccia nell'origine della sua linea, qui ({}, {}, {})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/arguments.py"/>
        <source>a document is needed, got {}</source>
        <translation>serve un documento, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/anisotropy.py"/>
        <source>a fabric ellipsoid needs at least 6 directions, got {}</source>
        <translation>un ellissoide di tessitura richiede almeno 6 direzioni, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/anisotropy.py"/>
        <source>a fabric needs a surface that lines cross, got none</source>
        <translation>una tessitura richiede una superficie tagliata da linee, qui nessuna</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/couplings.py"/>
        <source>a face can be coupled with itself only if it is curved: rods of the flat face {} would lie in its plane</source>
        <translation>una faccia si può accoppiare con sé stessa solo se è curva: le aste della faccia piana {} starebbero nel suo piano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a face must be named, got {}</source>
        <translation>una faccia deve essere nominata, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>a face must be one of Face1..Face{} or {}, got {}</source>
        <translation>una faccia deve essere una di Face1..Face{} o {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>a face must be one of Face1..Face{}, got {}</source>
        <translation>una faccia deve essere una di Face1..Face{}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_sites.py"/>
        <source>a face must have at most {} sites, but spacings of {} and {} mm give about {} on {}</source>
        <translation>una faccia può avere al più {} siti, ma passi di {} e {} mm ne danno circa {} su {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>a face must have one normal per vertex, got {} for {} vertices</source>
        <translation>una faccia deve avere una normale per vertice, qui {} per {} vertici</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>a face of {} must be one of Face1..Face{}, got {}</source>
        <translation>una faccia di {} deve essere una di Face1..Face{}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>a face to be thickened must have at least one triangle, got 0</source>
        <translation>una faccia da ispessire deve avere almeno un triangolo, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>a fault without a name</source>
        <translation>un difetto senza nome</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/nodes.py"/>
        <source>a field may have {} nodes; a cell size of {} mm needs {}</source>
        <translation>un campo può avere {} nodi; una cella di {} mm ne richiede {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/layer_analysis.py"/>
        <source>a file of layers is read as it is: heights and a range cannot be chosen</source>
        <translation>un file di strati si legge com'è: quote e intervallo non si possono scegliere</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>a folder must hold the report.json of design, analyse, compare or voxels, got {} with another record</source>
        <translation>una cartella deve contenere il report.json di design, analyse, compare o voxels, qui {} con un altro contenuto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>a folder must hold the report.json of design, analyse, compare or voxels, got {}, which holds no JSON: {}</source>
        <translation>una cartella deve contenere il report.json di design, analyse, compare o voxels, qui {}, che non contiene JSON: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>a folder must hold the report.json of design, analyse, compare or voxels, got {}: {}</source>
        <translation>una cartella deve contenere il report.json di design, analyse, compare o voxels, qui {}: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a job must be JSON: {}</source>
        <translation>un lavoro deve essere JSON: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/jobs.py"/>
        <source>a job must have the sites of 1 prism, or those of faces, got {} prisms and {} faces in {}</source>
        <translation>un lavoro deve avere i siti di 1 prisma, o quelli di facce, qui {} prismi e {} facce in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a job needs at least one coupling, got {}</source>
        <translation>un lavoro richiede almeno un accoppiamento, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a job needs either an envelope file or a prism, got {}</source>
        <translation>un lavoro richiede un file d'involucro o un prisma, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a job's numbers must be finite, got {}</source>
        <translation>i numeri di un lavoro devono essere finiti, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a key of a job may stand once in its object, got {} twice</source>
        <translation>una chiave di un lavoro può stare una volta nel suo oggetto, qui {} due volte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>a law must be one of {}, got {}</source>
        <translation>una legge deve essere una di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>a law's bounds must be finite numbers, got {} and {}</source>
        <translation>i limiti di una legge devono essere numeri finiti, qui {} e {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>a law's bounds must satisfy low &lt;= high, got {} and {}</source>
        <translation>per i limiti di una legge deve valere minimo &lt;= massimo, qui {} e {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>a layer</source>
        <translation>uno strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a layer along {} holds {} voxels, but layer {} is asked for {}</source>
        <translation>uno strato lungo {} contiene {} voxel, ma allo strato {} ne sono chiesti {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a layer along {} holds {} voxels, but the area {} mm² of layer {} asks for {}</source>
        <translation>uno strato lungo {} contiene {} voxel, ma l'area {} mm² dello strato {} ne chiede {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/layer_outlines.py"/>
        <source>a layer must be an array of two axes, got {}</source>
        <translation>uno strato deve essere una matrice a due assi, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/voxel_shapes.py"/>
        <source>a layer must be one of 0..{}, got {}</source>
        <translation>uno strato deve essere uno di 0..{}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>a layer must be thinner than the least radius of its face's curvature: at {} mm {} of {} triangles fold</source>
        <translation>uno strato deve essere più sottile del minimo raggio di curvatura della sua faccia: a {} mm si piegano {} di {} triangoli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>a layer must be thinner than the least radius of its face's curvature: at {} mm {} of {} triangles fold, and smoothing does not help</source>
        <translation>uno strato deve essere più sottile del minimo raggio di curvatura della sua faccia: a {} mm si piegano {} di {} triangoli, e lisciare non aiuta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a layer's thickness must be greater than 0, got {}</source>
        <translation>lo spessore di uno strato deve essere maggiore di 0, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/arguments.py"/>
        <source>a list of objects is needed, got {}</source>
        <translation>serve una lista di oggetti, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/arguments.py"/>
        <source>a list of whole numbers is needed, got {}</source>
        <translation>serve una lista di numeri interi, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>a mask for these targets must have the shape {}, got {}</source>
        <translation>una maschera per questi obiettivi deve avere la forma {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masks.py"/>
        <source>a mask must be in one part, got parts of {} and {} cells</source>
        <translation>una maschera deve essere in un pezzo, qui parti di {} e {} celle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masks.py"/>
        <source>a mask must have at least one cell, got {}</source>
        <translation>una maschera deve avere almeno una cella, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>a mask must have at least one cell; {} has in the targets' box, got {}</source>
        <translation>una maschera deve avere almeno una cella; {} ne ha nel parallelepipedo degli obiettivi, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>a mask must have at least one voxel, got 0</source>
        <translation>una maschera deve avere almeno un voxel, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_formats.py"/>
        <source>a mesh format must be one of {}, got {}</source>
        <translation>un formato di mesh deve essere uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>a mesh must be closed to be filled with voxels: {}</source>
        <translation>una mesh deve essere chiusa per essere riempita di voxel: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_solids.py"/>
        <source>a mesh must be closed to become a solid, got {} holes with {} open edges</source>
        <translation>una mesh deve essere chiusa per diventare un solido, qui {} fori con {} spigoli aperti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/slabs.py"/>
        <source>a mesh must have at least one triangle, got 0</source>
        <translation>una mesh deve avere almeno un triangolo, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/meshes.py"/>
        <source>a mesh must have at least one vertex to have bounds, got 0</source>
        <translation>una mesh deve avere almeno un vertice per avere limiti, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_solids.py"/>
        <source>a mesh must have at most {} triangles to become a solid, got {}: reduce it (Mesh &gt; Decimation) or give a STEP file</source>
        <translation>una mesh deve avere al più {} triangoli per diventare un solido, qui {}: ridurla (Mesh &gt; Decimazione) o dare un file STEP</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_solids.py"/>
        <source>a mesh must have triangles, got 0</source>
        <translation>una mesh deve avere triangoli, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_solids.py"/>
        <source>a mesh must have two triangles at each edge, turned alike, to become a solid; got {} edges of more than two and {} edges of triangles turned unevenly</source>
        <translation>una mesh deve avere a ogni spigolo due triangoli girati allo stesso modo per diventare un solido; qui {} spigoli di più di due e {} spigoli di triangoli girati male</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/voxelise.py"/>
        <source>a mesh to be voxelised must have at least one triangle, got 0</source>
        <translation>una mesh da voxelizzare deve avere almeno un triangolo, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preview_worker.py"/>
        <source>a newer preview is wanted</source>
        <translation>si vuole un'anteprima più recente</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>a number</source>
        <translation>un numero</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/registry.py"/>
        <source>a number must be one of {} that are explained, got {}</source>
        <translation>un numero deve essere uno dei {} spiegati, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/patchwork.py"/>
        <source>a patchwork needs a closed mesh each of whose edges has two triangles</source>
        <translation>un patchwork richiede una mesh chiusa i cui spigoli hanno due triangoli ciascuno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a path's tension must be greater than 0, got {}</source>
        <translation>la tensione di un percorso deve essere maggiore di 0, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>a pitch must be three lengths above 0, got {}</source>
        <translation>un passo deve essere di tre lunghezze maggiori di 0, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/edits.py"/>
        <source>a point must be three numbers in mm, got {}</source>
        <translation>un punto deve essere fatto di tre numeri in mm, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/presets.py"/>
        <source>a preset must be one of {}, got {}</source>
        <translation>un modello deve essere uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>a profile to be compared must have slices, {} has none along {}</source>
        <translation>un profilo da confrontare deve avere sezioni, {} non ne ha lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>a quantity must be one of {}, got {}</source>
        <translation>una grandezza deve essere una di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>a range of layers must satisfy low &lt; high, got {}</source>
        <translation>per un intervallo di strati deve valere basso &lt; alto, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>a range only was sliced</source>
        <translation>è stato sezionato solo un intervallo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/report_sections.py"/>
        <source>a report must have something to tell, got nothing in {}: {}</source>
        <translation>una relazione deve avere qualcosa da dire, qui nulla in {}: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/spline_solids.py"/>
        <source>a rod must be a valid solid of positive volume, got {} mm3 for rod {}</source>
        <translation>un'asta deve essere un solido valido di volume positivo, qui {} mm3 per l'asta {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/rod_solids.py"/>
        <source>a rod must be a valid solid, got one that is not for rod {}</source>
        <translation>un'asta deve essere un solido valido, l'asta {} non lo è</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/rod_solids.py"/>
        <source>a rod's solid must have its mesh's volume within {}, got {} and {} mm3 for rod {}</source>
        <translation>il solido di un'asta deve avere il volume della sua mesh entro {}, qui {} e {} mm3 per l'asta {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>a row must have 0 &lt;= v &lt;= N and voxels &gt;= 0, got {}</source>
        <translation>per una riga deve valere 0 &lt;= v &lt;= N e voxel &gt;= 0, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>a row of {} does not fit into its ranks</source>
        <translation>una riga di {} non sta nei suoi ranghi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>a sample must be numbered 0 to {}, got {}</source>
        <translation>un campione deve avere un numero da 0 a {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>a sample must have a mesh or a shape, got {} without one</source>
        <translation>un campione deve avere una mesh o una forma, {} non ne ha</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/texture_fit.py"/>
        <source>a sample must have a surface to fit a texture to, got one that is empty or full</source>
        <translation>un campione deve avere una superficie per adattarvi una tessitura, qui è vuoto o pieno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>a sample must have at least one triangle, got 0</source>
        <translation>un campione deve avere almeno un triangolo, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a sample must have material and voids: of {} cells are solid, got {}</source>
        <translation>un campione deve avere materiale e vuoti: di {} celle sono piene, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thresholds.py"/>
        <source>a sample must have material and voids: of {} voxels above {} are solid</source>
        <translation>un campione deve avere materiale e vuoti: di {} voxel oltre {} sono pieni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thresholds.py"/>
        <source>a sample must have material and voids: of {} voxels above {} are solid, got {}</source>
        <translation>un campione deve avere materiale e vuoti: di {} voxel oltre {} sono pieni, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thresholds.py"/>
        <source>a sample must have material and voids: of {} voxels are solid</source>
        <translation>un campione deve avere materiale e vuoti: di {} voxel sono pieni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thresholds.py"/>
        <source>a sample must have material and voids: of {} voxels are solid, got {}</source>
        <translation>un campione deve avere materiale e vuoti: di {} voxel sono pieni, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a sample must have material: its sliced areas make, got {}</source>
        <translation>un campione deve avere materiale: le sue aree sezionate danno, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a sample must have voids: of {} cells its sliced areas fill, got {}</source>
        <translation>un campione deve avere vuoti: di {} celle le sue aree sezionate ne riempiono, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>a sample's mesh must be closed, got an open area of {} mm²: mend it first (Mesh &gt; Analyze &gt; Evaluate and repair)</source>
        <translation>la mesh di un campione deve essere chiusa, qui un'area aperta di {} mm²: prima ripararla (ambiente Mesh: valuta e ripara)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>a sample's mesh must not be inside out; its volume is, got {}</source>
        <translation>la mesh di un campione non deve essere rovesciata; il suo volume è, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thresholds.py"/>
        <source>a scan must have more than one grey value to be parted by Otsu's threshold, got {}</source>
        <translation>una scansione deve avere più di un livello di grigio per la soglia di Otsu, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scripts.py"/>
        <source>a script must have a design, an analysis or voxels to make, got none in {}</source>
        <translation>uno script deve avere un progetto, un'analisi o voxel da fare, qui nulla in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>a setting must read name=value, got {}</source>
        <translation>un'impostazione deve essere nome=valore, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/files.py"/>
        <source>a shape must have faces to be written into {}, got none</source>
        <translation>una forma deve avere facce per essere scritta in {}, qui nessuna</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>a shape that is cut must have at least one solid, got none</source>
        <translation>una forma da tagliare deve avere almeno un solido, qui nessuno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/workbook.py"/>
        <source>a sheet of a workbook holds at most {} contours, got {} along {}; thicker layers have fewer</source>
        <translation>un foglio contiene al più {} contorni, qui {} lungo {}; strati più spessi ne hanno meno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_sites.py"/>
        <source>a site placed by hand</source>
        <translation>un sito posto a mano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a site's co-ordinate</source>
        <translation>una coordinata di un sito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a site's name must read face.i.j, got {}</source>
        <translation>il nome di un sito deve essere face.i.j, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>a sliced area along {} must not be larger than its layer, got {} of it at {}</source>
        <translation>un'area sezionata lungo {} non deve essere maggiore del suo strato, qui {} di essa in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>a sliced area along {} must not be negative, got {} of it at {}</source>
        <translation>un'area sezionata lungo {} non deve essere negativa, qui {} di essa in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_solids.py"/>
        <source>a solid from a mesh must have its volume of {} mm3, got {} mm3</source>
        <translation>un solido da una mesh deve averne il volume di {} mm3, qui {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/tessellation.py"/>
        <source>a solid must have a volume greater than 0, got {} mm3: it is empty or inside out</source>
        <translation>un solido deve avere un volume maggiore di 0, qui {} mm3: è vuoto o rovesciato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>a solid must not cross itself; {} pairs of its triangles do, the longest crossing is {} mm at ({}) mm</source>
        <translation>un solido non deve incrociarsi; {} coppie dei suoi triangoli lo fanno, l'incrocio più lungo è {} mm in ({}) mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/patch_solids.py"/>
        <source>a solid of patches has no closed voids, got {}</source>
        <translation>un solido di toppe non ha vuoti chiusi, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>a solid scaffold must have all its channels: the B-Rep engine came to {} of {} rods, then {}; the mesh scaffold stands</source>
        <translation>uno scaffold solido deve avere tutti i suoi canali: il motore B-Rep è arrivato a {} aste su {}, poi {}; lo scaffold a mesh resta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/patch_solids.py"/>
        <source>a solid's faces must be bounded by seams that do not cross, got {} of {} seams of surfaces that nearly touch</source>
        <translation>le facce di un solido devono essere limitate da cuciture che non si incrociano, qui {} su {} cuciture di superfici quasi a contatto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/variants.py"/>
        <source>a spread must be that of at least 1 value, got 0</source>
        <translation>una dispersione deve essere di almeno 1 valore, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_triangles.py"/>
        <source>a surface must be told by {} points at most, got {} x {}</source>
        <translation>una superficie deve essere descritta da al più {} punti, qui {} x {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/patchwork.py"/>
        <source>a surface of a patchwork must meet others, got one that is closed in itself</source>
        <translation>una superficie di un patchwork deve incontrarne altre, qui una è chiusa in sé</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>a tangent component of the pore at {}</source>
        <translation>una componente della tangente del poro in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/tasks.py"/>
        <source>a task must have an object to compute, got none</source>
        <translation>un compito deve avere un oggetto da calcolare, qui nessuno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>a tenth of the void has spheres up to it</source>
        <translation>un decimo del vuoto ha sfere fino a questo diametro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>a text</source>
        <translation>un testo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/thickness.py"/>
        <source>a thickness needs a surface, got voxels that are all on one side of it</source>
        <translation>uno spessore richiede una superficie, qui i voxel stanno tutti dallo stesso lato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_triangles.py"/>
        <source>a trimmed face must have no kink inside</source>
        <translation>una faccia tagliata non deve avere pieghe all'interno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_triangles.py"/>
        <source>a trimmed face with a seam or a pole must be bent both ways</source>
        <translation>una faccia tagliata con cucitura o polo deve essere curva in entrambi i versi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_triangles.py"/>
        <source>a trimmed face with a seam or a pole must not turn away from its middle plane</source>
        <translation>una faccia tagliata con cucitura o polo non deve allontanarsi dal suo piano medio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/arguments.py"/>
        <source>a value of the type {} is needed, got {}</source>
        <translation>serve un valore del tipo {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>a variant must have rods, got none with seed {}</source>
        <translation>una variante deve avere aste, qui nessuna col seme {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_panel.py"/>
        <source>a voxel design needs a sample, got none: choose an object or a file, or draw it</source>
        <translation>un progetto a voxel richiede un campione, qui nessuno: scegliere un oggetto o un file, o disegnarlo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a voxel must have three edges above 0, got {}</source>
        <translation>un voxel deve avere tre lati maggiori di 0, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>a voxel must not be larger than the sample, {} mm along {}, got {}</source>
        <translation>un voxel non deve essere più grande del campione, {} mm lungo {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>a voxel's edges must be at least {} mm, got {}</source>
        <translation>i lati di un voxel devono essere almeno {} mm, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>a wavelength must be 0 (fitted) or more, got {}</source>
        <translation>una lunghezza d'onda deve essere 0 (adattata) o più, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>a whole number</source>
        <translation>un numero intero</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/workbook.py"/>
        <source>a workbook needs openpyxl</source>
        <translation>una cartella di lavoro richiede openpyxl</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>a {} without one</source>
        <translation>{} senza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/estimates.py"/>
        <source>about {} s</source>
        <translation>circa {} s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>alignment must be one of {}, got {}</source>
        <translation>l'allineamento deve essere uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>all</source>
        <translation>tutti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>all held</source>
        <translation>tutti superati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>all images of a stack must have one size, {} pixels, but {} has {}</source>
        <translation>tutte le immagini di una pila devono avere una sola dimensione, {} pixel, ma {} ha {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <source>all layers must have one thickness, got {} to {} mm in {} layers</source>
        <translation>tutti gli strati devono avere un solo spessore, qui da {} a {} mm in {} strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>all layers must have the voxels asked for, but {} have not: {}</source>
        <translation>tutti gli strati devono avere i voxel richiesti, ma {} non li hanno: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>all, processor time</source>
        <translation>tutti, tempo di processore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>along</source>
        <translation>lungo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/path_laws.py"/>
        <source>along the normal</source>
        <translation>lungo la normale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>along {} no slice has any area</source>
        <translation>lungo {} nessuna sezione ha area</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>along {} {}</source>
        <translation>lungo {} {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>along {} {} (the widest gap: {} mm)</source>
        <translation>lungo {} {} (la lacuna più larga: {} mm)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>along {} {} of at most {} mm2 left out of all counts</source>
        <translation>lungo {} {} di al più {} mm2 esclusi da tutti i conteggi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>along {} {} of {} slices are spoilt: layers {}</source>
        <translation>lungo {} {} sezioni su {} sono guaste: strati {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>alpha and beta must be whole numbers with blanks between, got {}</source>
        <translation>alfa e beta devono essere numeri interi separati da spazi, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>alpha and beta must have the same counts in the layers along Z, got {}</source>
        <translation>alpha e beta devono avere gli stessi conteggi negli strati lungo Z, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/propagation_steps.py"/>
        <source>alpha and beta must have the same sum, got {}</source>
        <translation>alpha e beta devono avere la stessa somma, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>an analysis along X, Y and Z is needed; {} has, got {}</source>
        <translation>serve un'analisi lungo X, Y e Z; {} ha, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>an axis must be x, y, z or a direction of three numbers such as 0.6,0.8,0, got {}</source>
        <translation>un asse deve essere x, y, z o una direzione di tre numeri come 0.6,0.8,0, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_triangles.py"/>
        <source>an edge of a curved face must have its parameters on the surface</source>
        <translation>uno spigolo di una faccia curva deve avere i suoi parametri sulla superficie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>an edge of the box of middle points</source>
        <translation>un lato del parallelepipedo dei punti intermedi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>an envelope file needs faces with sites, got {}</source>
        <translation>un file d'involucro richiede facce con siti, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/jobs.py"/>
        <source>an envelope must be a box or come from a file to be kept in a job, got {}; export it as STEP and name that file</source>
        <translation>un involucro deve essere un parallelepipedo o venire da un file per stare in un lavoro, qui {}; esportarlo come STEP e nominare quel file</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>an envelope must be a closed solid, got an open one of {} faces</source>
        <translation>un involucro deve essere un solido chiuso, qui uno aperto di {} facce</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>an envelope must be a valid solid; the kernel finds: {}</source>
        <translation>un involucro deve essere un solido valido; il nucleo trova: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>an envelope must be at most {} mm large, got {} mm</source>
        <translation>un involucro può essere grande al massimo {} mm, qui {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>an envelope must be one closed solid, got a {} of {} faces and no solid</source>
        <translation>un involucro deve essere un solido chiuso, qui {} di {} facce e nessun solido</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>an envelope must be one closed solid, got a {} of {} faces and no solid (closed: make a solid of it first)</source>
        <translation>un involucro deve essere un solido chiuso, qui {} di {} facce e nessun solido (chiuso: farne prima un solido)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>an envelope must have a shape, got an empty one</source>
        <translation>un involucro deve avere una forma, qui una vuota</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/envelope.py"/>
        <source>an envelope must have a shape, got nothing</source>
        <translation>un involucro deve avere una forma, qui nulla</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/envelope.py"/>
        <source>an envelope must have a shape, got {} without one</source>
        <translation>un involucro deve avere una forma, qui {} senza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>an envelope must have a volume greater than 0 mm3, got {} mm3</source>
        <translation>un involucro deve avere un volume maggiore di 0 mm3, qui {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>an equation must have n &gt;= 0 and k &gt;= 1, got {}</source>
        <translation>un'equazione deve avere n &gt;= 0 e k &gt;= 1, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>an estimate can be made for the mesh or the field engine, got {}</source>
        <translation>si può stimare per il motore a mesh o a campo, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/examples.py"/>
        <source>an example must be one of {}, got {}</source>
        <translation>un esempio deve essere uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>an expression holds numbers only, got {} in {}</source>
        <translation>una formula contiene solo numeri, qui {} in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>an expression must have 1 to {} characters, got {}</source>
        <translation>una formula deve avere da 1 a {} caratteri, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/arguments.py"/>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>an object of a document is needed, got {}</source>
        <translation>serve un oggetto di un documento, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>analyses to be compared must have an axis in common, got {}</source>
        <translation>le analisi da confrontare devono avere un asse in comune, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>analyses to be compared must share at least one layer of {} mm along {}, got {}</source>
        <translation>le analisi da confrontare devono avere in comune almeno uno strato di {} mm lungo {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>another program's slices in the tests; of solids the kernel's own sections (make.exact_slices)</source>
        <translation>le sezioni di un altro programma nei test; per i solidi le sezioni del nucleo (make.exact_slices)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>another seed, counts that differ less between layers or a strategy that fills tables may do</source>
        <translation>può bastare un altro seme, conteggi che differiscono meno da strato a strato o una strategia che riempie tabelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>area and volume of the triangles, BS/BV</source>
        <translation>area e volume dei triangoli, BS/BV</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>area of an outer contour less those of its holes</source>
        <translation>area di un contorno esterno meno quelle dei suoi fori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>area of the triangles, those in the box's faces (cuts) left out</source>
        <translation>area dei triangoli, esclusi quelli sulle facce del parallelepipedo (tagli)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>areas must be given along X, Y and Z, got {}</source>
        <translation>le aree devono essere date lungo X, Y e Z, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>areas must be one of {}, got {}</source>
        <translation>le aree devono essere una di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rod_colours.py"/>
        <source>as drawn</source>
        <translation>come estratta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>asked for</source>
        <translation>richiesti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>at</source>
        <translation>a</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>at given heights</source>
        <translation>a quote date</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>at most</source>
        <translation>al più</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>at most 0.2 % apart</source>
        <translation>distanti al più 0,2 %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>at most {} of the envelope apart; with the field engine {}</source>
        <translation>distanti al più {} dell'involucro; col motore a campo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>at most {} standard errors of the rays apart</source>
        <translation>distanti al più {} errori standard dei raggi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>at the layers' bottoms</source>
        <translation>alla base degli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>at the layers' middles</source>
        <translation>a metà degli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>at, mm</source>
        <translation>a, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>attempts</source>
        <translation>tentativi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>available less left is the number of rods</source>
        <translation>siti disponibili meno rimasti è il numero di aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>available sites that the coupling did not use</source>
        <translation>siti disponibili che l'accoppiamento non ha usato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/texture.py"/>
        <source>axes of a texture must be three unit vectors at right angles, got {}</source>
        <translation>gli assi di una tessitura devono essere tre versori ortogonali, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>axis</source>
        <translation>asse</translation>
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
        <translation>in calcolo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/best_layer.py"/>
        <source>best layers</source>
        <translation>strati migliori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>blocks of 2 x 2 x 2 voxels with two opposite corners alone of their kind, solid or void</source>
        <translation>blocchi di 2 x 2 x 2 voxel con due vertici opposti soli nel loro genere, pieni o vuoti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <source>bodies must be of {}, got {}</source>
        <translation>i corpi devono essere di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>bone fraction</source>
        <translation>frazione ossea</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>bone fraction BV/TV</source>
        <translation>frazione ossea BV/TV</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>bone surface</source>
        <translation>superficie ossea</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>bone volume</source>
        <translation>volume osseo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>bone volume fraction</source>
        <translation>frazione di volume osseo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>bone volume fraction, by voxels</source>
        <translation>frazione di volume osseo, per voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>border a_x, a_y, a_z, mm</source>
        <translation>bordo a_x, a_y, a_z, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>both routes</source>
        <translation>le due vie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>bounds and sum must not be negative, got {}</source>
        <translation>limiti e somma non devono essere negativi, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/branches.py"/>
        <source>branches</source>
        <translation>rami</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>branches a mm</source>
        <translation>rami per mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>branches per mm</source>
        <translation>rami per mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>branches: chains of trabeculae that go on without an event</source>
        <translation>rami: catene di trabecole che proseguono senza un evento</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <source>building the {}</source>
        <translation>costruzione: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>by another</source>
        <translation>per l'altra</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>by one route</source>
        <translation>per una via</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>bytes</source>
        <translation>byte</translation>
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
        <translation>caso {}: nessuna triangolazione senza corde nelle facce</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <source>casting rays</source>
        <translation>lancio dei raggi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>cavities found from the shells of the scaffold and from those of the channels</source>
        <translation>cavità trovate dai gusci dello scaffold e da quelli dei canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>cavities seen from inside and from outside</source>
        <translation>cavità viste da dentro e da fuori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>cell ({}, {}) is {}, beyond its bound {}</source>
        <translation>la cella ({}, {}) è {}, oltre il suo limite {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>cells of {} mm</source>
        <translation>celle di {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>chains of trabeculae that go on from slice to slice, each overlapping one of the next and no other, over the distance from the first slice to the last</source>
        <translation>catene di trabecole che proseguono di sezione in sezione, ognuna sovrapposta a una sola della successiva, sulla distanza dalla prima all'ultima sezione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>changes by hand</source>
        <translation>modifiche a mano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>channels</source>
        <translation>canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>channels by triangles and by rays, mm3</source>
        <translation>canali per triangoli e per raggi, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>channels can be shown once a scaffold is built, got none: build the scaffold first</source>
        <translation>i canali si possono mostrare quando c'è uno scaffold, qui nessuno: prima costruire lo scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>checks</source>
        <translation>controlli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>checks that failed</source>
        <translation>controlli falliti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>choice</source>
        <translation>scelta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>choice of the convergence point</source>
        <translation>la scelta del punto di convergenza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>clock time of cutting the channels</source>
        <translation>tempo d'orologio del taglio dei canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>clock time of targets, design and mesh</source>
        <translation>tempo d'orologio di obiettivi, progetto e mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>closed cavities</source>
        <translation>cavità chiuse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>closed contour</source>
        <translation>contorno chiuso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>closed layers need a Boolean, which takes them out of the rods, and that needs manifold3d: {}; or choose layers that are not closed</source>
        <translation>gli strati chiusi richiedono un'operazione booleana che li tolga dalle aste, e questa manifold3d: {}; oppure scegliere strati non chiusi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>closed shells of its triangles, the voids inside one counted with it</source>
        <translation>gusci chiusi dei suoi triangoli, i vuoti interni contati con essi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>closed shells of their triangles, the holes inside one counted with it</source>
        <translation>gusci chiusi dei loro triangoli, i fori interni contati con essi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>closed voids</source>
        <translation>vuoti chiusi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>closed voids are {} of the envelope: many channels have no way out</source>
        <translation>i vuoti chiusi sono {} dell'involucro: molti canali non hanno uscita</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>co-ordinate along the axis, mm</source>
        <translation>coordinata lungo l'asse, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/meshes.py"/>
        <source>co-ordinates must be finite and below 3.4e38 mm for a file, got {}</source>
        <translation>le coordinate per un file devono essere finite e sotto 3.4e38 mm, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <source>co-ordinates of rods must be finite, got nan or infinite mm</source>
        <translation>le coordinate delle aste devono essere finite, qui nan o infinito mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rays.py"/>
        <source>co-ordinates of triangles must be finite, got nan or infinite mm</source>
        <translation>le coordinate dei triangoli devono essere finite, qui nan o infinito mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>common total less the sum of an axis' rounded counts</source>
        <translation>totale comune meno la somma dei conteggi arrotondati di un asse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>compact layer</source>
        <translation>strato compatto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>components (6-neighbours)</source>
        <translation>parti (6 vicini)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>connected channels</source>
        <translation>canali connessi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>connected parts</source>
        <translation>parti connesse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>connected pieces of the channels that touch no face of the envelope</source>
        <translation>parti connesse dei canali che non toccano alcuna faccia dell'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>connected pieces of the scaffold</source>
        <translation>parti connesse dello scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>connected pieces of the scaffold that channels cut off all round; they are taken away unless they are to be kept</source>
        <translation>parti connesse dello scaffold isolate dai canali; sono tolte, se non si vogliono tenere</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>connectivity</source>
        <translation>connettività</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>connectivity density</source>
        <translation>densità di connettività</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/contacts.py"/>
        <source>contacts</source>
        <translation>contatti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>contacts by a corner alone</source>
        <translation>contatti per solo vertice</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>contacts by an edge alone</source>
        <translation>contatti per solo spigolo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>contour filter, closed, mm</source>
        <translation>filtro dei contorni, chiusi, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>contour filter, open, mm</source>
        <translation>filtro dei contorni, aperti, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>contours</source>
        <translation>contorni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>contours a slice</source>
        <translation>contorni per sezione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>contours counted above, mm2</source>
        <translation>contorni contati sopra, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/contours.py"/>
        <source>contours must have one start more than planes, and as many points as the last start says, got {} starts, {} planes, {} marks, points {}</source>
        <translation>i contorni devono avere un inizio in più dei piani e tanti punti quanti dice l'ultimo inizio, qui {} inizi, {} piani, {} marche, punti {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/contours.py"/>
        <source>contours must lie in the order of their planes, 0..{}</source>
        <translation>i contorni devono stare nell'ordine dei loro piani, 0..{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>contours of more area than the least</source>
        <translation>contorni di area maggiore della minima</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>contours of more area than the least on a slice, holes among them: the thesis' number of trabeculae</source>
        <translation>contorni di una sezione di area maggiore della minima, fori compresi: il numero di trabecole della tesi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>contours that are no holes</source>
        <translation>contorni che non sono fori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>contours that are no rods, voids among them (their area is negative)</source>
        <translation>contorni che non sono aste, vuoti compresi (la loro area è negativa)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>contours were filtered</source>
        <translation>i contorni sono stati filtrati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>contours were offset</source>
        <translation>i contorni sono stati traslati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>contours were smoothed</source>
        <translation>i contorni sono stati lisciati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>contours whose area is at least 0.6 of their box</source>
        <translation>contorni la cui area è almeno 0,6 del loro rettangolo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>count</source>
        <translation>conteggio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>count of the pairs that were coupled</source>
        <translation>conteggio delle coppie accoppiate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>count of the solid voxels</source>
        <translation>conteggio dei voxel pieni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>count of the solid voxels of the layer</source>
        <translation>conteggio dei voxel pieni dello strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/entropy_counts.py"/>
        <source>counting by entropy</source>
        <translation>conteggio per entropia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>counting it anew</source>
        <translation>nuovo conteggio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sampled_layers.py"/>
        <source>counting layers</source>
        <translation>conteggio degli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sampled_tables.py"/>
        <source>counting tables</source>
        <translation>conteggio delle tabelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>counts as often as it overlaps</source>
        <translation>conta tante volte quante si sovrappone</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>counts once</source>
        <translation>conta una volta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/assembly.py"/>
        <source>couplings</source>
        <translation>accoppiamenti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/slices.py"/>
        <source>cutting triangles</source>
        <translation>taglio dei triangoli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_sites.py"/>
        <source>d1 and d2 must differ by at least 1 degree on the face, got {} degrees</source>
        <translation>d1 e d2 devono differire di almeno 1 grado sulla faccia, qui {} gradi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>definition</source>
        <translation>definizione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>degree of anisotropy</source>
        <translation>grado di anisotropia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>degree of anisotropy, by triangles</source>
        <translation>grado di anisotropia, per triangoli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>delta</source>
        <translation>delta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masks.py"/>
        <source>densities must be 0 to 1, got {} in layer {} along {}</source>
        <translation>le densità devono stare da 0 a 1, qui {} nello strato {} lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>design</source>
        <translation>progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>designs are counted in boxes, not in, got {}</source>
        <translation>i progetti si contano in parallelepipedi, non in, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_search.py"/>
        <source>designs are searched for exhaustively up to {} cells, got {}</source>
        <translation>i progetti si cercano esaustivamente fino a {} celle, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/variants.py"/>
        <source>designs must have one shape and solid voxels, got shapes {}</source>
        <translation>i progetti devono avere una sola forma e voxel pieni, qui le forme {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>designs with these counts</source>
        <translation>progetti con questi conteggi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>designs with this design's tables</source>
        <translation>progetti con le tabelle di questo progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>diameter of the circle, or side of the square through the corners, as drawn from the law of the pores</source>
        <translation>diametro del cerchio, o lato del quadrato per i vertici, estratto dalla legge dei pori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>diameter of the largest sphere in the solid</source>
        <translation>diametro della massima sfera nel solido</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>diameter of the largest sphere in the void</source>
        <translation>diametro della massima sfera nel vuoto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>difference</source>
        <translation>differenza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>difference half way along the shared stretch, linear between the layers' middles</source>
        <translation>differenza a metà del tratto comune, lineare tra le metà degli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>difference in the middle</source>
        <translation>differenza a metà</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>difference of the largest size over the shared layers, with its sign; at: the middle of its layer</source>
        <translation>differenza massima in modulo sugli strati comuni, col suo segno; a: la metà del suo strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/thickness.py"/>
        <source>distances</source>
        <translation>distanze</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>divergence theorem over its triangles</source>
        <translation>teorema della divergenza sui suoi triangoli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>divergence theorem over its triangles in double precision</source>
        <translation>teorema della divergenza sui suoi triangoli in doppia precisione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>divergence theorem over the triangles of union of the rods and envelope</source>
        <translation>teorema della divergenza sui triangoli di unione delle aste e involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>divergence theorem over their triangles</source>
        <translation>teorema della divergenza sui loro triangoli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>dmean area</source>
        <translation>dmean area</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/svg_layers.py"/>
        <source>drawing layers</source>
        <translation>disegno degli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_files.py"/>
        <source>drawing {}</source>
        <translation>disegno di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/profiles.py"/>
        <source>each contour must have one row of measures, got {} and {}</source>
        <translation>ogni contorno deve avere una riga di misure, qui {} e {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>each face must have at least three corners, got {}</source>
        <translation>ogni faccia deve avere almeno tre vertici, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/plane_triangles.py"/>
        <source>each point of a face must be used by its triangles; a border crosses itself</source>
        <translation>ogni punto di una faccia deve essere usato dai suoi triangoli; un bordo si incrocia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>each variable must have two bounds, got {}</source>
        <translation>ogni variabile deve avere due limiti, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>each vertex must have three co-ordinates</source>
        <translation>ogni vertice deve avere tre coordinate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>edges at which two solid voxels meet across, the other two being void</source>
        <translation>spigoli ai quali si incontrano in diagonale due voxel pieni, essendo vuoti gli altri due</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>end sections by size</source>
        <translation>sezioni di estremità per dimensione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>engine</source>
        <translation>motore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/features/designs.py"/>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>envelope</source>
        <translation>involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>envelope less rods</source>
        <translation>involucro meno aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>equal layers</source>
        <translation>strati uguali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>equal layers, and pairs of neighbours between which the curves cross</source>
        <translation>strati uguali, e coppie di vicini tra cui le curve si incrociano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>equal numbers</source>
        <translation>numeri uguali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>equal numbers on every layer of the three axes, or the design is refused</source>
        <translation>numeri uguali su ogni strato dei tre assi, o il progetto è rifiutato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>equal numbers, or the scaffold is refused</source>
        <translation>numeri uguali, o lo scaffold è rifiutato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>error: the computation broke off; the report view says where</source>
        <translation>errore: il calcolo si è interrotto; il rapporto dice dove</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>error: {}</source>
        <translation>errore: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/variants.py"/>
        <source>estimate by rays</source>
        <translation>stima per raggi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>estimated area of the end sections</source>
        <translation>area stimata delle sezioni di estremità</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>estimated area s^2, mm2</source>
        <translation>area stimata s^2, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>estimated porosity</source>
        <translation>porosità stimata</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>every axis may be named once, got {}</source>
        <translation>ogni asse può essere nominato una volta, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/pieces.py"/>
        <source>every cavity must lie in a body, but {} of {} lie in none: the mesh is inside out or crosses itself</source>
        <translation>ogni cavità deve stare in un corpo, ma {} su {} non stanno in nessuno: la mesh è rovesciata o si incrocia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>every face must be named once, got {}</source>
        <translation>ogni faccia deve essere nominata una volta, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>every face must be named once, got {} again in {}</source>
        <translation>ogni faccia deve essere nominata una volta, qui {} di nuovo in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>every layer must have its count in a design with {}; none was found</source>
        <translation>ogni strato deve avere il suo conteggio in un progetto con: {}; nessuno è stato trovato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_moves.py"/>
        <source>every layer must have its count in one part without closed cavities; after {} flips {} layers are off by {} voxels together, layer {} along {} by {}; another seed, fewer restrictions or smaller voxels may do</source>
        <translation>ogni strato deve avere il suo conteggio in una parte senza cavità chiuse; dopo {} scambi {} strati sbagliano di {} voxel insieme, lo strato {} lungo {} di {}; un altro seme, meno vincoli o voxel più piccoli possono bastare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/verification.py"/>
        <source>every layer must have its count of voxels; {} layers differ: {}</source>
        <translation>ogni strato deve avere il suo conteggio di voxel; {} strati differiscono: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_moves.py"/>
        <source>exact moves</source>
        <translation>scambi esatti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>exact slices</source>
        <translation>sezioni esatte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_makers.py"/>
        <source>exact slices are those of a solid, got a file</source>
        <translation>le sezioni esatte sono quelle di un solido, qui un file</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_makers.py"/>
        <source>exact slices are those of a solid, got {}</source>
        <translation>le sezioni esatte sono quelle di un solido, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>face</source>
        <translation>faccia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>face 1</source>
        <translation>faccia 1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>face 2</source>
        <translation>faccia 2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>face sites</source>
        <translation>siti della faccia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>facets</source>
        <translation>faccette</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>facets that are there twice</source>
        <translation>faccette presenti due volte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>facets that run through others</source>
        <translation>faccette che ne attraversano altre</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>facets turned against their neighbours</source>
        <translation>faccette rovesciate rispetto alle vicine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>facets without area</source>
        <translation>faccette senza area</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>failed and left out</source>
        <translation>fallite ed escluse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rod_colours.py"/>
        <source>failed, left out</source>
        <translation>fallita, esclusa</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>fault</source>
        <translation>difetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/assembly.py"/>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>faults</source>
        <translation>difetti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/texture.py"/>
        <source>field</source>
        <translation>campo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>file</source>
        <translation>file</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>fill rule</source>
        <translation>regola di riempimento</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>final sites 1</source>
        <translation>siti finali 1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>final sites 2</source>
        <translation>siti finali 2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/soundness.py"/>
        <source>finding doubles</source>
        <translation>ricerca dei doppioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/soundness.py"/>
        <source>finding parts</source>
        <translation>ricerca delle parti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>floating voxels</source>
        <translation>voxel sospesi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>formula</source>
        <translation>formula</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>gap fill, iterations</source>
        <translation>chiusura lacune, passate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>gap fill, maximum, mm</source>
        <translation>chiusura lacune, massimo, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>given tables are needed, got none</source>
        <translation>servono tabelle date, qui nessuna</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>given tables need a strategy that fills layers from them ({}), got {}</source>
        <translation>tabelle date richiedono una strategia che riempia gli strati da esse ({}), qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>greatest</source>
        <translation>massimo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>half a layer (a whole one with planes at bottoms) times the total variation of the sliced area: Niederreiter 1992, DOI 10.1137/1.9781611970081</source>
        <translation>mezzo strato (uno intero con piani alla base) per la variazione totale dell'area sezionata: Niederreiter 1992, DOI 10.1137/1.9781611970081</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>half a layer's variation</source>
        <translation>variazione di mezzo strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>half of the void has spheres up to it</source>
        <translation>metà del vuoto ha sfere fino a questo diametro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>heights must be finite, got {}</source>
        <translation>le quote devono essere finite, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>heights must be given with at='heights', and only then, got {}</source>
        <translation>le quote vanno date con at='heights', e solo allora, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>heights must be numbers between blanks, mm, got {}</source>
        <translation>le altezze devono essere numeri tra spazi, mm, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>heights must rise, got {}</source>
        <translation>le quote devono crescere, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/slices.py"/>
        <source>heights of planes must be finite and rise</source>
        <translation>le quote dei piani devono essere finite e crescenti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>how often a faulty rod was drawn anew until it was sound</source>
        <translation>quante volte un'asta difettosa è stata estratta di nuovo finché era sana</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>images must be of the kind {}, got {}</source>
        <translation>le immagini devono essere del tipo {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>images of this kind need Pillow</source>
        <translation>immagini di questo tipo richiedono Pillow</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>in the envelope</source>
        <translation>nell'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>in the middle</source>
        <translation>a metà</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>initial sites 1</source>
        <translation>siti iniziali 1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>initial sites 2</source>
        <translation>siti iniziali 2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>intercepts of lines through the voxels, BS/BV.vox</source>
        <translation>intersezioni di linee attraverso i voxel, BS/BV.vox</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/joining.py"/>
        <source>islands</source>
        <translation>isole</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>it must name a site of face {}, which has {} sites</source>
        <translation>deve nominare un sito della faccia {}, che ha {} siti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>it must name a site of one of the faces {}</source>
        <translation>deve nominare un sito di una delle facce {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>items must show objects of the model, at most {} deep, got {}</source>
        <translation>gli elementi devono mostrare oggetti del modello, al più {} livelli, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>its face, {} so far, is now Face{} of {}</source>
        <translation>la sua faccia, finora {}, è ora Face{} di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>its own end</source>
        <translation>il suo estremo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>its standard deviation</source>
        <translation>la sua deviazione standard</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>its volume against the voxels'</source>
        <translation>il suo volume rispetto a quello dei voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/repair.py"/>
        <source>joining open contours</source>
        <translation>unione dei contorni aperti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <source>joining the slabs</source>
        <translation>unione delle lastre</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/neighbours.py"/>
        <source>joining the triangles</source>
        <translation>connessione dei triangoli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/path_laws.py"/>
        <source>joins the sites</source>
        <translation>unisce i siti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>junctions a mm</source>
        <translation>giunzioni per mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>junctions per mm</source>
        <translation>giunzioni per mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>junctions: splits and joins</source>
        <translation>giunzioni: divisioni e unioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>largest</source>
        <translation>massima</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>largest alpha, beta</source>
        <translation>massimi alfa, beta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/thickness.py"/>
        <source>largest balls</source>
        <translation>massime sfere</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>largest difference</source>
        <translation>differenza massima</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>largest of the tables alpha and beta</source>
        <translation>massimo delle tabelle alfa e beta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>largest trabecular area</source>
        <translation>area trabecolare massima</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>largest trabecular separation</source>
        <translation>separazione trabecolare massima</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>largest trabecular thickness</source>
        <translation>spessore trabecolare massimo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>largest value of b less largest of a over the shared layers</source>
        <translation>massimo di b meno massimo di a sugli strati comuni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>layer thickness, mm</source>
        <translation>spessore degli strati, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/feasibility.py"/>
        <source>layer {} along {}</source>
        <translation>strato {} lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>layer {} along {} is empty between others: no design is one piece</source>
        <translation>lo strato {} lungo {} è vuoto tra altri: nessun progetto è in un solo pezzo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/verification.py"/>
        <source>layer {} along {}: {} for {}</source>
        <translation>strato {} lungo {}: {} per {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/voxel_shapes.py"/>
        <source>layer {} as solids must hold the {} mm3 of its voxels, the kernel gives {} mm3</source>
        <translation>lo strato {} come solidi deve contenere i {} mm3 dei suoi voxel, il nucleo dà {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/layer_fill.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>layers</source>
        <translation>strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>layers N x M x P</source>
        <translation>strati N x M x P</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>layers added to it</source>
        <translation>strati aggiunti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/voxel_shapes.py"/>
        <source>layers as solids</source>
        <translation>strati come solidi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>layers follow smoothed normals at {} points where a face bends more sharply than {} mm</source>
        <translation>gli strati seguono normali lisciate in {} punti, dove una faccia curva più di {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>layers inwards must leave a part of the envelope, but {} mm take all of it</source>
        <translation>gli strati verso l'interno devono lasciare una parte dell'involucro, ma {} mm lo prendono tutto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>layers inwards that the channels go through are the envelope itself: nothing changes</source>
        <translation>gli strati verso l'interno attraversati dai canali sono l'involucro stesso: non cambia nulla</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>layers on faces that bend sharply need the package scipy</source>
        <translation>gli strati su facce molto curve richiedono il pacchetto scipy</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>layers whose middles (or bottoms) lie in the body</source>
        <translation>strati le cui metà (o basi) stanno nel corpo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/feasibility.py"/>
        <source>layers {} along {}</source>
        <translation>strati {} lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>least</source>
        <translation>minimo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>least and greatest of the variants</source>
        <translation>minimo e massimo delle varianti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>least and greatest of the variants' porosities</source>
        <translation>minima e massima porosità delle varianti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>least cap on alpha and beta with which a table has the layers' sums</source>
        <translation>minimo massimo su alfa e beta col quale una tabella ha le somme degli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>leave the envelope</source>
        <translation>escono dall'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rod_colours.py"/>
        <source>leaves the envelope</source>
        <translation>esce dall'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>left out by smoothing</source>
        <translation>tralasciati dalla lisciatura</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>left out by the filter</source>
        <translation>tralasciati dal filtro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>length of the sample along X, Y, Z over the voxel's edge, rounded</source>
        <translation>lunghezza del campione lungo X, Y, Z sul lato del voxel, arrotondata</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/estimates.py"/>
        <source>less than 1 s</source>
        <translation>meno di 1 s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>levelling tables</source>
        <translation>livellamento delle tabelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>lines through the voxels, DA</source>
        <translation>linee attraverso i voxel, DA</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>longest half axis of the fabric ellipsoid, by voxels</source>
        <translation>semiasse maggiore dell'ellissoide di tessitura, per voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>longest mean intercept length</source>
        <translation>massima lunghezza media di intercetta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/crossings.py"/>
        <source>looking for triangles that cross</source>
        <translation>ricerca di triangoli che si incrociano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>loops</source>
        <translation>anelli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>loops: ways that part and meet again</source>
        <translation>anelli: vie che si separano e si ritrovano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>loose</source>
        <translation>pezzi staccati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>loose pieces</source>
        <translation>pezzi staccati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>loose pieces are {} of the envelope: the channels cut the scaffold apart</source>
        <translation>i pezzi staccati sono {} dell'involucro: i canali tagliano lo scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>loose pieces taken away</source>
        <translation>pezzi staccati tolti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>m (guessed: the body would be {} mm large)</source>
        <translation>m (stimato: il corpo sarebbe di {} mm)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>manual design a rod, s (thesis 2.3.3)</source>
        <translation>progetto a mano di un'asta, s (tesi 2.3.3)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>mean</source>
        <translation>media</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>mean bone fraction</source>
        <translation>frazione ossea media</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>mean bone fraction, %</source>
        <translation>frazione ossea media, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>mean bone fraction, along {} against {}</source>
        <translation>frazione ossea media, lungo {} contro {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>mean deviation</source>
        <translation>scarto medio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>mean deviation of the trabeculae</source>
        <translation>scarto medio delle trabecole</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>mean difference</source>
        <translation>differenza media</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/anisotropy.py"/>
        <source>mean intercept length</source>
        <translation>lunghezza media di intercetta (MIL)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>mean of b less mean of a over the shared layers</source>
        <translation>media di b meno media di a sugli strati comuni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>mean over the shared layers of sample less first sample</source>
        <translation>media sugli strati comuni di campione meno primo campione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>mean over the solid of the largest inscribed sphere's diameter</source>
        <translation>media sul solido del diametro della massima sfera inscritta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>mean over the void inside the box of the largest inscribed sphere's diameter: mean pore size</source>
        <translation>media sul vuoto nel parallelepipedo del diametro della massima sfera inscritta: dimensione media dei pori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>mean overlap, %</source>
        <translation>sovrapposizione media, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>mean porosity of the variants</source>
        <translation>porosità media delle varianti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>mean sliced area</source>
        <translation>area sezionata media</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>mean sliced area, mm2</source>
        <translation>area sezionata media, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>mean thickness of the sample</source>
        <translation>spessore medio del campione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>mean thickness of the sample (2 BV/BS), voxels</source>
        <translation>spessore medio del campione (2 BV/BS), voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>mean trabecular area of b less that of a</source>
        <translation>area trabecolare media di b meno quella di a</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/contours.py"/>
        <source>measuring contours</source>
        <translation>misura dei contorni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/soundness.py"/>
        <source>measuring triangles</source>
        <translation>misura dei triangoli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>meetings</source>
        <translation>incontri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>mended by</source>
        <translation>riparata con</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/recovery.py"/>
        <source>mending: {}, {}</source>
        <translation>riparazione: {}, {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>mesh</source>
        <translation>mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>mesh Booleans need the package manifold3d</source>
        <translation>le operazioni booleane con mesh richiedono il pacchetto manifold3d</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>mesh {}{} of the {}</source>
        <translation>mesh {}{} di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>middle</source>
        <translation>metà</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/texture.py"/>
        <source>mix of sheets and rods must be 0 to 4, got {}</source>
        <translation>la mistura di lamine e aste deve stare da 0 a 4, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>mm (guessed: the body would be {} mm large)</source>
        <translation>mm (stimato: il corpo sarebbe di {} mm)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>more than 2 % is noted: the mesh overlaps itself</source>
        <translation>oltre il 2 % è segnalato: la mesh si sovrappone a sé stessa</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>most solid voxels in a line (x, z) and (y, z)</source>
        <translation>massimo di voxel pieni in una linea (x, z) e (y, z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>must be a finite number</source>
        <translation>deve essere un numero finito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>must be at least {}</source>
        <translation>deve essere almeno {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>must be finite</source>
        <translation>devono essere finiti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>must be whole numbers</source>
        <translation>devono essere numeri interi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>must lie in {}..{}</source>
        <translation>deve stare in {}..{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>must not be larger than its layer</source>
        <translation>non deve essere maggiore del suo strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>must not be negative</source>
        <translation>non devono essere negativi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>name</source>
        <translation>nome</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>nine tenths of the void have spheres up to it</source>
        <translation>nove decimi del vuoto hanno sfere fino a questo diametro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_rules.py"/>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>no closed cavity</source>
        <translation>nessuna cavità chiusa</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>no contact{} alone</source>
        <translation>nessun contatto solo{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_search.py"/>
        <source>no design has these counts: no set of layers contradicts another by itself, but a search of all designs found none</source>
        <translation>nessun progetto ha questi conteggi: nessun insieme di strati ne contraddice da solo un altro, ma la ricerca di tutti i progetti non ne ha trovati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>no design with these counts exists that has {}</source>
        <translation>non esiste un progetto con questi conteggi che abbia: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>no design with these counts exists{}</source>
        <translation>non esiste un progetto con questi conteggi{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>no error</source>
        <translation>nessun errore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/trabecular.py"/>
        <source>no field was tried</source>
        <translation>nessun campo è stato provato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/best_layer.py"/>
        <source>no layer has these {} voxels in columns and {} in rows</source>
        <translation>nessuno strato ha questi {} voxel in colonne e {} in righe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>no pair of tables was found in {} tries that alpha &lt;= {} and beta &lt;= {} allow: larger caps leave more room</source>
        <translation>in {} tentativi non si è trovata una coppia di tabelle ammessa da alfa &lt;= {} e beta &lt;= {}: limiti maggiori lasciano più spazio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masked_tables.py"/>
        <source>no pair of tables was found within the mask in {} tries{}; strategy trabecular, which needs no tables, may find a design</source>
        <translation>nella maschera non si è trovata una coppia di tabelle in {} tentativi{}; la strategia trabecolare, che non richiede tabelle, può trovare un progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/joining.py"/>
        <source>no part with {} voxels was found in the field</source>
        <translation>nel campo non si è trovata una parte con {} voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/surfaces.py"/>
        <source>no point of the face's surface lies near ({}) mm</source>
        <translation>nessun punto della superficie della faccia è vicino a ({}) mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>no rod may be left out</source>
        <translation>nessuna asta può mancare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>no sample came to its end</source>
        <translation>nessuna estrazione è giunta alla fine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>no shape</source>
        <translation>nessuna forma</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>no solid of patches: {} mm3 against {} of the mesh; then </source>
        <translation>nessun solido di toppe: {} mm3 contro {} della mesh; poi </translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>no solid of patches: {}; then </source>
        <translation>nessun solido di toppe: {}; poi </translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masked_tables.py"/>
        <source>no table has these sums: columns {} ask for {}, and the rows can give them {}{}</source>
        <translation>nessuna tabella ha queste somme: le colonne {} chiedono {}, e le righe possono darne {}{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>no tolerance: another rule</source>
        <translation>nessuna tolleranza: un'altra regola</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>no tolerance: it says how far variants are from chance</source>
        <translation>nessuna tolleranza: dice quanto le varianti distano dal caso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>no tolerance: the estimate is the thesis'</source>
        <translation>nessuna tolleranza: la stima è quella della tesi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>no tolerance: voxels round the surface</source>
        <translation>nessuna tolleranza: voxel attorno alla superficie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/local_scale.py"/>
        <source>no wavelengths were found that bring the numbers of trabeculae near to those asked for</source>
        <translation>non si sono trovate lunghezze d'onda che portino i numeri di trabecole vicino a quelli richiesti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>none</source>
        <translation>nessuna</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>none of {} pairs of tables was compatible; pairing 'constraint' finds them by construction, and lower caps make them likelier</source>
        <translation>nessuna di {} coppie di tabelle era compatibile; l'abbinamento 'constraint' le trova per costruzione, e massimi minori le rendono più probabili</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/surfaces.py"/>
        <source>none of {} points tried lies inside the face of {} mm2</source>
        <translation>nessuno di {} punti provati sta nella faccia di {} mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>normals of the triangles, DA.mesh</source>
        <translation>normali dei triangoli, DA.mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>not all held</source>
        <translation>non tutti superati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>not looked for</source>
        <translation>non cercate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>nothing is left of the envelope: the rods fill it</source>
        <translation>dell'involucro non resta nulla: le aste lo riempiono</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>number</source>
        <translation>numero</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>number of</source>
        <translation>numero di</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>number of parts</source>
        <translation>numero di parti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>numbers by two routes</source>
        <translation>numeri per due vie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/trabeculae.py"/>
        <source>numbers of trabeculae along {} need a sample, or targets that hold them; got neither</source>
        <translation>i numeri di trabecole lungo {} richiedono un campione, o obiettivi che li contengano; qui nessuno dei due</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>of</source>
        <translation>di</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/plane_offsets.py"/>
        <source>offsets</source>
        <translation>scostamenti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/fill.py"/>
        <source>offsetting contours</source>
        <translation>traslazione dei contorni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>ok</source>
        <translation>superato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_rules.py"/>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>one part</source>
        <translation>una parte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/trabecular.py"/>
        <source>one part needs voxels in every layer between its first and last; along {} layers {} and {} are asked for {} and {} voxels, and {} between them for none</source>
        <translation>una sola parte richiede voxel in ogni strato tra il primo e l'ultimo; lungo {} agli strati {} e {} ne sono chiesti {} e {}, e tra essi a {} nessuno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>one solid of {} must be chosen as the envelope: {}; a compound is taken apart by Part &gt; Compound &gt; Explode compound</source>
        <translation>un solido di {} deve essere scelto come involucro: {}; un composto si scompone nell'ambiente Part (Esplodi composto)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>only a cut that was made can be undone, got 0 cuts</source>
        <translation>solo un taglio fatto può essere annullato, qui 0 tagli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>only a strategy that fills tables, in several parts or with cavities, can have these counts</source>
        <translation>solo una strategia che riempie tabelle, in più parti o con cavità, può avere questi conteggi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>only {} can be called in {}</source>
        <translation>solo {} si può chiamare in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>open contour</source>
        <translation>contorno aperto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>open edge</source>
        <translation>spigolo aperto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>open edges</source>
        <translation>spigoli aperti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>operator {} is not allowed in {}</source>
        <translation>l'operatore {} non è ammesso in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/on_demand.py"/>
        <source>out of date: update it</source>
        <translation>non aggiornato: aggiornarlo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>outer contours</source>
        <translation>contorni esterni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>outer contours a slice</source>
        <translation>contorni esterni per sezione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>outer contours that are no rods</source>
        <translation>contorni esterni che non sono aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>outer contours whose area is at least 0.6 of their box</source>
        <translation>contorni esterni la cui area è almeno 0,6 del loro rettangolo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/voxel_shapes.py"/>
        <source>outlines of layers</source>
        <translation>contorni degli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>output</source>
        <translation>risultato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>over the solid</source>
        <translation>sul solido</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>over the void</source>
        <translation>sul vuoto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>overlap of two variants</source>
        <translation>sovrapposizione di due varianti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>overlap to expect of unrelated designs with the same layers</source>
        <translation>sovrapposizione attesa di progetti indipendenti con gli stessi strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/variants.py"/>
        <source>overlap with seed {}</source>
        <translation>sovrapposizione col seme {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>overlaps</source>
        <translation>sovrapposizioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>overlaps less trabeculae plus parts of the graph: ways that part and meet again</source>
        <translation>sovrapposizioni meno trabecole più parti del grafo: vie che si separano e si ritrovano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>own definition</source>
        <translation>definizione propria</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>own definition (docs/method.md, section 1)</source>
        <translation>definizione propria (docs/method.md, sezione 1)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/thickness.py"/>
        <source>painting balls</source>
        <translation>disegno delle sfere</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masked_tables.py"/>
        <source>pairing 'repeat' fills boxes only; pairing 'constraint' works within a mask</source>
        <translation>l'abbinamento 'repeat' riempie solo parallelepipedi; 'constraint' lavora in una maschera</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>pairs of the couplings that are on, less the rods that nothing mended</source>
        <translation>coppie degli accoppiamenti attivi, meno le aste che nulla ha riparato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <source>part</source>
        <translation>parte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>part of the balance of all volumes</source>
        <translation>parte del bilancio di tutti i volumi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>parts</source>
        <translation>parti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>parts less handles plus cavities by another program in the tests (scikit-image)</source>
        <translation>parti meno manici più cavità di un altro programma nei test (scikit-image)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>parts less handles plus cavities, of the voxels as a closed body</source>
        <translation>parti meno manici più cavità, dei voxel come corpo chiuso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/designs.py"/>
        <source>parts of a design are {}, got {}</source>
        <translation>le parti di un progetto sono {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>parts of a layer's solid voxels, neighbours by an edge of their squares</source>
        <translation>parti dei voxel pieni di uno strato, vicini per un lato dei loro quadrati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>parts of solid voxels, neighbours by a face</source>
        <translation>parti di voxel pieni, vicini per una faccia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>parts of void voxels, neighbours by a face, that touch no border</source>
        <translation>parti di voxel vuoti, vicini per una faccia, che non toccano alcun bordo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/labelling.py"/>
        <source>parts of voxels and distances between them need scipy</source>
        <translation>le parti di voxel e le distanze tra loro richiedono scipy</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>parts that hang together from slice to slice</source>
        <translation>parti connesse da sezione a sezione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>pasted: recompute the document</source>
        <translation>incollato: ricalcolare il documento</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>path</source>
        <translation>percorso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>phase</source>
        <translation>fase</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>picture of seed {}</source>
        <translation>immagine del seme {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>pieces</source>
        <translation>pezzi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>pieces of solid voxels, 26 neighbours</source>
        <translation>pezzi di voxel pieni, 26 vicini</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>pieces of void voxels, 6 neighbours, that touch no face of the box</source>
        <translation>pezzi di voxel vuoti, 6 vicini, che non toccano facce del parallelepipedo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>pieces: {}</source>
        <translation>pezzi: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>plain sum of the rods</source>
        <translation>somma semplice delle aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>plain sum of the rods, %</source>
        <translation>somma semplice delle aste, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>planes</source>
        <translation>piani</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/slabs.py"/>
        <source>planes must rise, got {}</source>
        <translation>i piani devono crescere, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>plates</source>
        <translation>piastre</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>plates of all contours</source>
        <translation>piastre di tutti i contorni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>plates, by that rule</source>
        <translation>piastre, secondo quella regola</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>plates, voids among them</source>
        <translation>piastre, vuoti compresi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_files.py"/>
        <source>plots must be one of {}, none, got {}</source>
        <translation>i grafici devono essere uno di {}, none, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/plots.py"/>
        <source>plots need matplotlib</source>
        <translation>i grafici richiedono matplotlib</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>points along {} must lie apart by at least {}, got {}</source>
        <translation>i punti lungo {} devono distare almeno {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>points of Eq. 2.1 on a prism; points of the co-ordinate lines on other faces</source>
        <translation>punti dell'Eq. 2.1 su un prisma; punti delle linee coordinate su altre facce</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>pore diameter, 10 % of the void</source>
        <translation>diametro dei pori, 10 % del vuoto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>pore diameter, 50 % of the void</source>
        <translation>diametro dei pori, 50 % del vuoto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>pore diameter, 90 % of the void</source>
        <translation>diametro dei pori, 90 % del vuoto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>pore layout</source>
        <translation>la forma dei pori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>pore sizes must be at least {} mm, got {}</source>
        <translation>le dimensioni dei pori devono essere almeno {} mm, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>pores</source>
        <translation>pori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/assembly.py"/>
        <source>pores and paths</source>
        <translation>pori e percorsi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>porosities must be found by one of {}, {}, got {}</source>
        <translation>le porosità si trovano per uno di {}, {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>porosity</source>
        <translation>porosità</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/colouring.py"/>
        <source>porosity along {}</source>
        <translation>porosità lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>porosity of a slice</source>
        <translation>porosità di una sezione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>porosity of the STEP scaffold</source>
        <translation>porosità dello scaffold STEP</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>porosity of the scaffold</source>
        <translation>porosità dello scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>porosity range, %</source>
        <translation>porosità, intervallo, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>porosity {} % by the {} engine</source>
        <translation>porosità {} %, motore {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/solid_scaffold.py"/>
        <source>porosity {} %, {} rods cut; solid and mesh differ by {} %</source>
        <translation>porosità {} %, {} aste tagliate; solido e mesh differiscono del {} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>porosity, %</source>
        <translation>porosità, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>porosity, % (Eq. 2.2)</source>
        <translation>porosità, % (Eq. 2.2)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>prism l x w x h, mm</source>
        <translation>prisma l x w x h, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>quantity</source>
        <translation>grandezza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/layer_fill.py"/>
        <location filename="../../freecad_trabecula/core/voxels/strategies/random_layers.py"/>
        <source>random layers</source>
        <translation>strati casuali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/random_layers.py"/>
        <source>random tables; each layer drawn nearly uniformly from all that have these row and column sums</source>
        <translation>tabelle casuali; ogni strato estratto quasi uniformemente tra tutti quelli con queste somme di righe e colonne</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/sequential.py"/>
        <source>random tables; in each layer line after line, into the lines that need most (thesis case 2)</source>
        <translation>tabelle casuali; in ogni strato una linea dopo l'altra, nelle linee che richiedono di più (tesi caso 2)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/minimum_zeros.py"/>
        <source>random tables; in each layer the shortest line first, into the lines that need most (thesis case 1)</source>
        <translation>tabelle casuali; in ogni strato prima la linea più corta, nelle linee che richiedono di più (tesi caso 1)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/best_tables.py"/>
        <source>random tables; of all layers that they allow the one that is highest on the chosen field (linear program)</source>
        <translation>tabelle casuali; di tutti gli strati che ammettono quello più alto nel campo scelto (programma lineare)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>range, mm</source>
        <translation>intervallo, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>rates of compatible tables</source>
        <translation>quote di tabelle compatibili</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/porosity_estimate.py"/>
        <source>rays</source>
        <translation>raggi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rays.py"/>
        <source>rays need closed meshes: each ray must leave as often as it enters; {} rays do not</source>
        <translation>i raggi richiedono mesh chiuse: ogni raggio deve uscire quante volte entra; {} raggi non lo fanno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rays.py"/>
        <source>rays per direction must be &gt;= 1, got {}</source>
        <translation>i raggi per direzione devono essere &gt;= 1, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>rays through the rods' own triangles</source>
        <translation>raggi attraverso i triangoli delle aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>reading layers</source>
        <translation>lettura degli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>redraws must lie in 0..100, got {}</source>
        <translation>le ripetizioni devono stare in 0..100, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>relative L1 distance of the profiles: sum |b - a| / sum |a| over the shared layers; 0 = equal</source>
        <translation>distanza L1 relativa dei profili: somma |b - a| / somma |a| sugli strati comuni; 0 = uguali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>relative L2 distance of the profiles: sqrt(sum (b - a)^2 / sum a^2) over the shared layers; 0 = equal</source>
        <translation>distanza L2 relativa dei profili: radice(somma (b - a)^2 / somma a^2) sugli strati comuni; 0 = uguali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/packing.py"/>
        <source>results must be numbers, texts, arrays or records of them, got {}</source>
        <translation>i risultati devono essere numeri, testi, matrici o record di essi, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/packing.py"/>
        <source>results must be of classes of {}, got {}</source>
        <translation>i risultati devono essere di classi di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>rod</source>
        <translation>asta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>rod if area / box is at least</source>
        <translation>asta se area / rettangolo è almeno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>rod {}{} of {}</source>
        <translation>asta {}{} di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <location filename="../../freecad_trabecula/core/porosity_estimate.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>rods</source>
        <translation>aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>rods and plates by a rule that turning the part does not change (report)</source>
        <translation>aste e piastre con una regola che non cambia ruotando il pezzo (rapporto)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rod_colours.py"/>
        <source>rods are coloured by one of {}, got {}</source>
        <translation>le aste si colorano secondo uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>rods are designed in a solid or a closed mesh, got {}, which has neither: select a body, or nothing for a new prism</source>
        <translation>le aste si progettano in un solido o in una mesh chiusa, qui {}, che non ha né l'uno né l'altra: selezionare un corpo, o niente per un nuovo prisma</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>rods begin on faces with sites, got none: press Pick faces and click them in the view</source>
        <translation>le aste partono da facce con siti, qui nessuna: premere il tasto che sceglie le facce e cliccarle nella vista</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>rods cut from the STEP scaffold</source>
        <translation>aste tagliate dallo scaffold STEP</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>rods join a pair of faces, got no pair: add one in the section Couplings</source>
        <translation>le aste uniscono una coppia di facce, qui nessuna coppia: aggiungerne una nella sezione Accoppiamenti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>rods left out</source>
        <translation>aste escluse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/second_routes.py"/>
        <source>rods made, of those that were coupled</source>
        <translation>aste fatte, di quelle accoppiate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>rods mended</source>
        <translation>aste riparate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/nodes.py"/>
        <source>rods must be closed meshes: each ray must leave as often as it enters, {} do not</source>
        <translation>le aste devono essere mesh chiuse: ogni raggio deve uscire quante volte entra, {} non lo fanno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>rods of all contours</source>
        <translation>aste di tutti i contorni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>rods of the wireframe</source>
        <translation>aste del telaio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>rods whose channels the B-Rep engine cut, of all</source>
        <translation>aste i cui canali ha tagliato il motore B-Rep, su tutte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>rods, by the rule that turning does not change</source>
        <translation>aste, secondo la regola che non cambia ruotando</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>rounds of gap fill must be at least 0, got {}</source>
        <translation>le passate di chiusura lacune devono essere almeno 0, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>row sums and column sums must agree, got {} and {}</source>
        <translation>somme di righe e colonne devono accordarsi, qui {} e {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>sample</source>
        <translation>campione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>sample size, bounding box, mm</source>
        <translation>dimensioni del campione, riquadro, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>scaffold</source>
        <translation>scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>scaffold + channels</source>
        <translation>scaffold + canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>scaffold + channels + loose pieces = envelope</source>
        <translation>scaffold + canali + pezzi staccati = involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>scaffold + channels + loose pieces = envelope, mm3</source>
        <translation>scaffold + canali + pezzi staccati = involucro, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>scaffold + channels + loose pieces, each by its own triangles, against the envelope</source>
        <translation>scaffold + canali + pezzi staccati, ciascuno coi suoi triangoli, contro l'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>scaffold + channels = envelope</source>
        <translation>scaffold + canali = involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>scaffold + channels = envelope, mm3</source>
        <translation>scaffold + canali = involucro, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>scaffold in double and in single precision, mm3</source>
        <translation>scaffold in precisione doppia e singola, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>scatter of the corners</source>
        <translation>dispersione dei vertici</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>score</source>
        <translation>punteggio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>score {}</source>
        <translation>punteggio {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>sd</source>
        <translation>dev. st.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/seam_settling.py"/>
        <location filename="../../freecad_trabecula/geometry/patch_solids.py"/>
        <source>seams of channels</source>
        <translation>cuciture dei canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>second</source>
        <translation>seconda</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>second route</source>
        <translation>seconda via</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>sections</source>
        <translation>sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>sections a rod</source>
        <translation>sezioni per asta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>sections per rod must be 1 or 2, got {}</source>
        <translation>le sezioni per asta devono essere 1 o 2, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/page.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>seed</source>
        <translation>seme</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/variants.py"/>
        <source>seeds must lie in 0..{}, got {} to {}</source>
        <translation>i semi devono stare in 0..{}, qui da {} a {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>shapes of layers must take at most {} of memory; fewer layers take less, got {}</source>
        <translation>le forme degli strati possono richiedere al massimo {} di memoria; meno strati ne richiedono meno, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>share of contours that are rods (thesis' rule), b less a</source>
        <translation>quota di contorni che sono aste (regola della tesi), b meno a</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>share of solid voxels, BV/TV.vox</source>
        <translation>quota di voxel pieni, BV/TV.vox</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>share of solid voxels: the second route</source>
        <translation>quota di voxel pieni: la seconda via</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>share of the largest</source>
        <translation>quota della maggiore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>share of the largest part</source>
        <translation>quota della parte maggiore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>shared layers on which both values are the same number</source>
        <translation>strati comuni su cui i due valori sono lo stesso numero</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>shortest half axis of the fabric ellipsoid, by voxels</source>
        <translation>semiasse minore dell'ellissoide di tessitura, per voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>shortest mean intercept length</source>
        <translation>minima lunghezza media di intercetta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_sites.py"/>
        <source>site ({}, {}) came to lie outside its face, a line of which crossed the border unnoticed</source>
        <translation>il sito ({}, {}) è finito fuori dalla sua faccia, una linea della quale ha passato il bordo senza avviso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>sites</source>
        <translation>siti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>sites along {} must be at least 2 (Eq. 2.1 divides by n - 1), got {}</source>
        <translation>i siti lungo {} devono essere almeno 2 (Eq. 2.1 divide per n - 1), qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sites available</source>
        <translation>siti disponibili</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sites left</source>
        <translation>siti rimasti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>sites n_x, n_y, n_z</source>
        <translation>siti n_x, n_y, n_z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sites of both faces that are on and that no earlier coupling used</source>
        <translation>siti attivi delle due facce che nessun accoppiamento precedente ha usato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/designs.py"/>
        <location filename="../../freecad_trabecula/features/tasks.py"/>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <location filename="../../freecad_trabecula/geometry/face_sites.py"/>
        <source>sites on {}</source>
        <translation>siti su {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>size</source>
        <translation>dimensione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>size of the end sections</source>
        <translation>dimensione delle sezioni di estremità</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>size, mm</source>
        <translation>dimensione, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>slice analysis</source>
        <translation>analisi per sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>slice comparison</source>
        <translation>confronto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>slice passport</source>
        <translation>passaporto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>sliced area</source>
        <translation>area sezionata</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>sliced area, mm2</source>
        <translation>area sezionata, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>sliced area, mm²</source>
        <translation>area sezionata, mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>sliced areas</source>
        <translation>aree sezionate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>sliced areas {}, got {} mm² in layer {} along {}</source>
        <translation>le aree sezionate {}, qui {} mm² nello strato {} lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>slices</source>
        <translation>sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>slices through an open, turned or doubled place of the mesh</source>
        <translation>sezioni attraverso un punto aperto, rovesciato o doppio della mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/slices.py"/>
        <source>slicing along {}</source>
        <translation>sezionamento lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/annealing.py"/>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>small box</source>
        <translation>scatola piccola</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>smallest possible caps</source>
        <translation>minimi massimi possibili</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>smallest possible caps on alpha, beta</source>
        <translation>minimi massimi possibili per alfa, beta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>smallest value of b less smallest of a over the shared layers</source>
        <translation>minimo di b meno minimo di a sugli strati comuni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/voxels/smooth_surface.py"/>
        <source>smoothing</source>
        <translation>lisciatura</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>solid and mesh of a rod must agree within {} % of its volume, got {} and {} mm^3 for rod {} and {} such rods in all</source>
        <translation>solido e mesh di un'asta devono accordarsi entro {} % del suo volume, qui {} e {} mm^3 per l'asta {} e {} aste così in tutto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>solid and mesh of the scaffold must agree within {}, got {} and {} mm3</source>
        <translation>solido e mesh dello scaffold devono accordarsi entro {}, qui {} e {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thinnest.py"/>
        <source>solid must be at least {} and void {} voxels thick; of {} solid ones {} and of the void {} stayed thinner; longer waves or smaller voxels may do</source>
        <translation>il solido deve essere spesso almeno {} e il vuoto {} voxel; di {} pieni {} e del vuoto {} sono rimasti più sottili; onde più lunghe o voxel più piccoli possono bastare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/patch_solids.py"/>
        <source>solid of patches</source>
        <translation>solido di toppe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>solid voxels</source>
        <translation>voxel pieni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>solid voxels outside of the largest part</source>
        <translation>voxel pieni fuori della parte maggiore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>solid voxels x dx dy dz</source>
        <translation>voxel pieni x dx dy dz</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>solid: rod {}{} of {}</source>
        <translation>solido: asta {}{} di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/rod_solids.py"/>
        <source>solids of rods</source>
        <translation>solidi delle aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>source</source>
        <translation>fonte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>spacing={} unit=mm</source>
        <translation>spacing={} unit=mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>specific bone surface</source>
        <translation>superficie ossea specifica</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>specific bone surface, by voxels</source>
        <translation>superficie ossea specifica, per voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>spoilt slices</source>
        <translation>sezioni guaste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sqrt(sum (P - mean)^2 / (n - 1)); of a sample, as the thesis' repeats are</source>
        <translation>sqrt(somma (P - media)^2 / (n - 1)); di un campione statistico, come nelle ripetizioni della tesi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>standard deviation of the variants</source>
        <translation>deviazione standard delle varianti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>standard error</source>
        <translation>errore standard</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>standard error, %</source>
        <translation>errore standard, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>step</source>
        <translation>passo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>sum (x_i y_i+1 - x_i+1 y_i) / 2 over the corners of a contour, voids negative; least and greatest of the contours of more area than the least</source>
        <translation>somma (x_i y_i+1 - x_i+1 y_i) / 2 sui vertici di un contorno, vuoti negativi; minima e massima dei contorni di area maggiore della minima</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>sum of area x thickness, mm3</source>
        <translation>somma di area x spessore, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>sum of both axes' tolerances of the volume</source>
        <translation>somma delle tolleranze di volume dei due assi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>sum of sliced area x thickness</source>
        <translation>somma di area sezionata x spessore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>sum of sliced areas over the number of slices</source>
        <translation>somma delle aree sezionate sul numero di sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>sum of the areas of all contours of a slice</source>
        <translation>somma delle aree di tutti i contorni di una sezione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>sum of the layers along each of the three axes</source>
        <translation>somma degli strati lungo ciascuno dei tre assi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sum of the rods</source>
        <translation>somma delle aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sum of the rods' solids by the kernel, where the network is built</source>
        <translation>somma dei solidi delle aste dal nucleo, dove la rete è costruita</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sum of the variants' porosities over their number</source>
        <translation>somma delle porosità delle varianti sul loro numero</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sum of the volumes of the rods' solids by the kernel, crossings counted as often as they come</source>
        <translation>somma dei volumi dei solidi delle aste dal nucleo, incroci contati tante volte quante si presentano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>sum over the rods of 30 to 75 s, by curvature of the path and number of sections</source>
        <translation>somma sulle aste di 30 a 75 s, secondo la curvatura del percorso e il numero di sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>sums of the targets along X, Y and Z</source>
        <translation>somme degli obiettivi lungo X, Y e Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/smooth_surface.py"/>
        <source>surface of the voxels</source>
        <translation>superficie dei voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>surface, mm2</source>
        <translation>superficie, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>symbol</source>
        <translation>simbolo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>table {} must have {} lines and {} layers along Z, got {} and {}</source>
        <translation>la tabella {} deve avere {} righe e {} strati lungo Z, qui {} e {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_inputs.py"/>
        <source>table {} must have {} x {} cells for these targets, got {}: its tables were given for another sample or voxel size</source>
        <translation>la tabella {} deve avere {} x {} celle per questi obiettivi, qui {}: le sue tabelle sono state date per un altro campione o lato dei voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>table {}: {}</source>
        <translation>tabella {}: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masked_tables.py"/>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>tables</source>
        <translation>tabelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>tables alpha</source>
        <translation>tabelle alpha</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/counting.py"/>
        <source>tables beta</source>
        <translation>tabelle beta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_inputs.py"/>
        <source>tables must be alpha and beta, of whole numbers, got {}</source>
        <translation>le tabelle devono essere alfa e beta, di numeri interi, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/flows.py"/>
        <source>tables within a mask need scipy 1.6 or later</source>
        <translation>le tabelle in una maschera richiedono scipy 1.6 o successivo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>taken away</source>
        <translation>tolto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>tangent component</source>
        <translation>componente della tangente</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>tangent pull</source>
        <translation>tiro della tangente</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>targets are read from {}, .csv, .json, the folder of an analysis or a folder of images, got {}</source>
        <translation>gli obiettivi si leggono da {}, .csv, .json, dalla cartella di un'analisi o da una cartella di immagini, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/plane_offsets.py"/>
        <source>targets of {} layers do not fit a field of {}</source>
        <translation>obiettivi di {} strati non si accordano con un campo di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>the B-Rep engine makes no compact layers, got {} faces with a layer: use the mesh engine</source>
        <translation>il motore B-Rep non fa strati compatti, qui {} facce con uno strato: usare il motore a mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_formats.py"/>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>the PLY file ends too early</source>
        <translation>il file PLY finisce troppo presto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_formats.py"/>
        <source>the PLY file must be binary, little-endian</source>
        <translation>il file PLY deve essere binario, little-endian</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_formats.py"/>
        <source>the PLY file must hold vertices and faces, got {}</source>
        <translation>il file PLY deve contenere vertici e facce, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <location filename="../../freecad_trabecula/features/analysis_makers.py"/>
        <source>the axis must be one of {}, got {}</source>
        <translation>l'asse deve essere uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/rays.py"/>
        <source>the axis of rays must be 0, 1 or 2, got {}</source>
        <translation>l'asse dei raggi deve essere 0, 1 o 2, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/best_layer.py"/>
        <source>the best layer of given tables needs scipy 1.6 or later</source>
        <translation>il miglior strato per tabelle date richiede scipy 1.6 o successivo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>the body could not be measured as a whole: {}</source>
        <translation>il corpo non si è potuto misurare nel suo insieme: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the border distance along {} must satisfy 0 &lt;= a &lt; edge / 2 = {} mm, got {}</source>
        <translation>per la distanza dal bordo lungo {} deve valere 0 &lt;= a &lt; spigolo / 2 = {} mm, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the border distance {}</source>
        <translation>la distanza dal bordo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/plane_triangles.py"/>
        <source>the border of a face must not cross itself, nor run through a point of its own</source>
        <translation>il bordo di una faccia non deve incrociarsi né passare per un proprio punto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>the box of drawn curves must have three edges, got {}</source>
        <translation>il parallelepipedo delle curve disegnate deve avere tre lati, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/feasibility.py"/>
        <source>the cap on {} must be at least {}, got {}: {} ask for {} voxels, and the layers along Z can give them {}</source>
        <translation>il massimo per {} deve essere almeno {}, qui {}: {} chiedono {} voxel, e gli strati lungo Z possono darne loro {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the cell must be greater than 0, got {}</source>
        <translation>la cella deve essere maggiore di 0, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <source>the cell size must be above 0 mm, got {}</source>
        <translation>il lato della cella deve superare 0 mm, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>the cells of the field engine are too coarse for these rods: make them smaller, or take the mesh engine</source>
        <translation>le celle del motore a campo sono troppo grosse per queste aste: rimpicciolirle, o usare il motore a mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the change of a site</source>
        <translation>la modifica di un sito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>the channels</source>
        <translation>i canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/pieces.py"/>
        <source>the channels must leave some material, got 0 mm3 of scaffold: the rods fill the whole envelope</source>
        <translation>i canali devono lasciare del materiale, qui 0 mm3 di scaffold: le aste riempiono tutto l'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>the compensation must be finite, got {}</source>
        <translation>la compensazione deve essere finita, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>the correction must be one of {}, got {}</source>
        <translation>la correzione deve essere una di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>the counts along {} must be a list, got {}</source>
        <translation>i conteggi lungo {} devono essere una lista, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>the counts along {} must be numbers, got {}</source>
        <translation>i conteggi lungo {} devono essere numeri, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the deflection</source>
        <translation>lo scostamento</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/tessellation.py"/>
        <source>the deflection must be 0 mm or more, got {} mm</source>
        <translation>lo scostamento deve essere 0 mm o più, qui {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/envelope_sources.py"/>
        <source>the density of an envelope must lie between 0 and 1, got {}</source>
        <translation>la densità di un involucro deve stare tra 0 e 1, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>the design</source>
        <translation>il progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>the design {} must be open to be made again, got none: it was closed</source>
        <translation>il progetto {} deve essere aperto per essere rifatto, qui nessuno: è stato chiuso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/layer_fill.py"/>
        <location filename="../../freecad_trabecula/core/voxels/propagation_steps.py"/>
        <source>the direction must be one of {}, got {}</source>
        <translation>la direzione deve essere una di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>the direction of a law must be three finite numbers, got {}</source>
        <translation>la direzione di una legge deve essere di tre numeri finiti, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>the direction of a linear law must not be zero, got {}</source>
        <translation>la direzione di una legge lineare non deve essere nulla, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the direction {} must not be zero, got {}</source>
        <translation>la direzione {} non deve essere nulla, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scripts.py"/>
        <source>the document must have the body {}, got none in {}: open the document with it first, or give one of yours this name</source>
        <translation>il documento deve avere il corpo {}, qui nessuno in {}: aprire prima il documento che lo contiene, o dare questo nome a uno proprio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/document_work.py"/>
        <source>the document was closed</source>
        <translation>il documento è stato chiuso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/drawn_curves.py"/>
        <source>the edges of a drawn box must be above 0, got {}</source>
        <translation>i lati di un parallelepipedo disegnato devono superare 0, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the engine</source>
        <translation>il motore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>the envelope</source>
        <translation>l'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the envelope is only {} mm large: was its file in metres or inches, not mm?</source>
        <translation>l'involucro è di soli {} mm: il suo file era in metri o pollici, non mm?</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the envelope is {} mm large: was its file in micrometres, not mm?</source>
        <translation>l'involucro è di {} mm: il suo file era in micrometri, non mm?</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/nodes.py"/>
        <source>the envelope must be at least two cells thick; it measures {} mm, a cell {} mm</source>
        <translation>l'involucro deve essere spesso almeno due celle; misura {} mm, una cella {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_envelope.py"/>
        <source>the envelope must be checked before rods are built: wait a moment</source>
        <translation>l'involucro deve essere verificato prima che si costruiscano aste: attendere un momento</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>the envelope must enclose a volume above 0, got {} mm3: it is inside out</source>
        <translation>l'involucro deve racchiudere un volume maggiore di 0, qui {} mm3: è rovesciato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/tessellation.py"/>
        <source>the envelope's triangles are the kernel's and may differ between versions of FreeCAD: {}</source>
        <translation>i triangoli dell'involucro sono del nucleo e possono differire tra versioni di FreeCAD: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/field.py"/>
        <source>the envelope's triangles must turn counter-clockwise seen from outside; its volume is {} mm³</source>
        <translation>i triangoli dell'involucro devono essere antiorari visti da fuori; il suo volume è {} mm³</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>the expression {} cannot be computed: {}</source>
        <translation>la formula {} non si può calcolare: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>the expression {} cannot be read: {}</source>
        <translation>la formula {} non si può leggere: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>the expression {} must give finite numbers, got {} at ({}) mm</source>
        <translation>la formula {} deve dare numeri finiti, qui {} in ({}) mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/surfaces.py"/>
        <source>the face has no normal at ({}) mm</source>
        <translation>la faccia non ha normale in ({}) mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>the face's own</source>
        <translation>quella della faccia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the faces of an IGES file must bound a closed body; these {} do not, with gaps up to {} mm closed (a STEP file keeps solids)</source>
        <translation>le facce di un file IGES devono limitare un corpo chiuso; queste {} non lo fanno, con lacune fino a {} mm chiuse (un file STEP conserva i solidi)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_formats.py"/>
        <source>the faces of the PLY file must be triangles</source>
        <translation>le facce del file PLY devono essere triangoli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/chosen_fields.py"/>
        <source>the field must be one of {}, got {}</source>
        <translation>il campo deve essere uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the file of an envelope must be readable, got {}</source>
        <translation>il file di un involucro deve essere leggibile, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the file of an envelope must end in one of {}, got {}</source>
        <translation>il file di un involucro deve finire in uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the file of an envelope must hold a mesh, but {} cannot be read as one</source>
        <translation>il file di un involucro deve contenere una mesh, ma {} non si può leggere come tale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the file of an envelope must hold a shape, but {} cannot be read as one</source>
        <translation>il file di un involucro deve contenere una forma, ma {} non si può leggere come tale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the file of an envelope must hold a shape, got none in {}</source>
        <translation>il file di un involucro deve contenere una forma, qui nessuna in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_source.py"/>
        <source>the file {} could not be read: {}</source>
        <translation>il file {} non si è potuto leggere: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/files.py"/>
        <source>the file's extension must be one of {}, got {}</source>
        <translation>l'estensione del file deve essere una di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_files.py"/>
        <source>the folder {} could not be made: {}</source>
        <translation>la cartella {} non si è potuta creare: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/results.py"/>
        <source>the folder {} must hold results that were written to the end: {}</source>
        <translation>la cartella {} deve contenere risultati scritti fino in fondo: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>the format of a PLY file must be ascii or binary, got {}</source>
        <translation>il formato di un file PLY deve essere ascii o binary, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the greatest number of rods of a coupling must be 0 (all) or more, got {}</source>
        <translation>il massimo numero di aste di un accoppiamento deve essere 0 (tutte) o più, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_export.py"/>
        <source>the images need a new folder, but {} is there already</source>
        <translation>le immagini richiedono una nuova cartella, ma {} c'è già</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>the images of {} must be of one kind, got {}</source>
        <translation>le immagini di {} devono essere di un solo tipo, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>the job file {} cannot be read: {}</source>
        <translation>il file di lavoro {} non si può leggere: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>the job file {} must be a text in UTF-8: {}</source>
        <translation>il file di lavoro {} deve essere un testo in UTF-8: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>the job's schema must be {}, got {}</source>
        <translation>lo schema del lavoro deve essere {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/brep_text.py"/>
        <source>the kernel could not read a shape of {} characters</source>
        <translation>il nucleo non ha potuto leggere una forma di {} caratteri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/brep_text.py"/>
        <source>the kernel could not read a shape of {} characters: {}</source>
        <translation>il nucleo non ha potuto leggere una forma di {} caratteri: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>the kernel cuts rod {} wrongly in every way tried</source>
        <translation>il nucleo taglia male l'asta {} in ogni modo provato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_solids.py"/>
        <source>the kernel made no solid of {} triangles: {}</source>
        <translation>il nucleo non ha fatto un solido da {} triangoli: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/cutting.py"/>
        <source>the kernel made no triangles of a face at a deflection of {} mm</source>
        <translation>il nucleo non ha fatto triangoli di una faccia con uno scostamento di {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/tessellation.py"/>
        <source>the kernel made no triangles of a solid at a deflection of {} mm</source>
        <translation>il nucleo non ha fatto triangoli di un solido con uno scostamento di {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>the kernel refused it</source>
        <translation>il nucleo l'ha rifiutato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/file_sizes.py"/>
        <source>the kind must be one of npy, nrrd, vti, png, bmp, tiff, got {}</source>
        <translation>il tipo deve essere uno di npy, nrrd, vti, png, bmp, tiff, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the largest size of an envelope must be at most {} times its least, got {} and {} mm</source>
        <translation>la dimensione maggiore di un involucro può essere al massimo {} volte la minore, qui {} e {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>the last layer must not lie below the first, got {} to {}</source>
        <translation>l'ultimo strato non può stare sotto il primo, qui da {} a {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>the layers along X, Y and Z must ask for the same total, got {}, {} and {} voxels: X - Z = {}, Y - Z = {}</source>
        <translation>gli strati lungo X, Y e Z devono chiedere lo stesso totale, qui {}, {} e {} voxel: X - Z = {}, Y - Z = {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_search.py"/>
        <source>the layers contradict each other; count {}</source>
        <translation>gli strati si contraddicono; contando {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>the layers were not to be made</source>
        <translation>gli strati non erano da fare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the lean</source>
        <translation>l'inclinazione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>the low ends of their boxes</source>
        <translation>gli estremi inferiori dei loro parallelepipedi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>the mask must have the shape {}, got {}</source>
        <translation>la maschera deve avere la forma {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masks.py"/>
        <source>the mask's layers along {} have {} cells, but the common total is {}</source>
        <translation>gli strati della maschera lungo {} hanno {} celle, ma il totale comune è {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the memory budget</source>
        <translation>il limite di memoria</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>the memory budget of {} GB is used up ({} GB)</source>
        <translation>il limite di memoria di {} GB è esaurito ({} GB)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>the mesh does not enclose a volume</source>
        <translation>la mesh non racchiude un volume</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>the mesh is inside out, or flat: its volume is {} mm3</source>
        <translation>la mesh è rovesciata, o piatta: il suo volume è {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_objects.py"/>
        <source>the mesh kernel must hold a closed mesh, got an open one of {} triangles</source>
        <translation>il nucleo delle mesh deve contenere una mesh chiusa, qui una aperta di {} triangoli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_objects.py"/>
        <source>the mesh kernel must hold {} vertices and {} triangles, got {} and {}</source>
        <translation>il nucleo delle mesh deve contenere {} vertici e {} triangoli, qui {} e {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>the mesh must be closed and hold the {} mm3 of its voxels, got {} mm3</source>
        <translation>la mesh deve essere chiusa e contenere i {} mm3 dei suoi voxel, qui {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/mesh_solids.py"/>
        <source>the mesh was inside out; its triangles have been turned round</source>
        <translation>la mesh era rovesciata; i suoi triangoli sono stati girati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>the middles of their boxes</source>
        <translation>i centri dei loro parallelepipedi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>the model of a 3MF file may have at most {} bytes</source>
        <translation>il modello di un file 3MF può avere al più {} byte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>the model of a 3MF file must be proper XML: {}</source>
        <translation>il modello di un file 3MF deve essere XML corretto: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>the model of a 3MF file must have an item to build</source>
        <translation>il modello di un file 3MF deve avere un elemento da costruire</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>the nearest one found has {} contacts</source>
        <translation>il più vicino trovato ha {} contatti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>the nearest one found has {} contacts, one of them in layer {} along Z</source>
        <translation>il più vicino trovato ha {} contatti, uno dei quali nello strato {} lungo Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>the nearest one found has {} voxels instead of {} in layer {} along {}</source>
        <translation>il più vicino trovato ha {} voxel invece di {} nello strato {} lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the number of corners of a pore must lie in 3..12, got {}</source>
        <translation>il numero di vertici di un poro deve stare in 3..12, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/arguments.py"/>
        <source>the object must be in the document {}, got {} of {}</source>
        <translation>l'oggetto deve stare nel documento {}, qui {} di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/arguments.py"/>
        <source>the object must be of the kind {}, got {} ({})</source>
        <translation>l'oggetto deve essere del tipo {}, qui {} ({})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/layer_fill.py"/>
        <location filename="../../freecad_trabecula/core/voxels/propagation_steps.py"/>
        <source>the order must be one of {}, got {}</source>
        <translation>l'ordine deve essere uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_sites.py"/>
        <source>the origin on face {}</source>
        <translation>l'origine sulla faccia {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>the pixels of {} must have a pitch: none stands in the images, and none was given</source>
        <translation>i pixel di {} devono avere un passo: non sta nelle immagini, e non è stato dato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>the plane at {} mm along {} could not be cut: {}</source>
        <translation>il piano a {} mm lungo {} non si è potuto tagliare: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>the planes are not those of layers</source>
        <translation>i piani non sono quelli di strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/edits.py"/>
        <source>the pore at {} must get a size or tangent components, got neither</source>
        <translation>il poro in {} deve ricevere una dimensione o componenti delle tangenti, qui nulla</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/pores.py"/>
        <source>the pore at {} takes {} tangent components, got {}</source>
        <translation>il poro in {} richiede {} componenti delle tangenti, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/colouring.py"/>
        <source>the porosity of slices along {} is that of an analysis of {}, got none: analyse it first</source>
        <translation>la porosità delle sezioni lungo {} è quella di un'analisi di {}, qui nessuna: analizzarlo prima</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/jobs.py"/>
        <source>the prism of a job has a corner at the origin and its edges along X, Y, Z: the box's placement must be the identity, got {} of {}</source>
        <translation>il prisma di un lavoro ha un vertice nell'origine e i lati lungo X, Y, Z: il posizionamento del parallelepipedo deve essere l'identità, qui {} di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the prism's edge along {}</source>
        <translation>il lato del prisma lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>the range of layers must meet the body, {}..{} mm, got {}</source>
        <translation>l'intervallo degli strati deve incontrare il corpo, {}..{} mm, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>the ratio from which a contour is a rod must lie in 0..1, got {}</source>
        <translation>il rapporto da cui un contorno è un'asta deve stare in 0..1, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>the rectangle of the bounding box</source>
        <translation>il rettangolo del riquadro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/smooth_surface.py"/>
        <source>the rounds of smoothing must be 0 or more, got {}</source>
        <translation>le passate di lisciatura devono essere 0 o più, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>the same along another axis</source>
        <translation>lo stesso lungo un altro asse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>the same cut by the mesh engine</source>
        <translation>lo stesso tagliato dal motore a mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>the same in single precision, as it is in the file; and the balance of all volumes</source>
        <translation>lo stesso in singola precisione, com'è nel file; e il bilancio di tutti i volumi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>the same, net of holes, mm2</source>
        <translation>la stessa al netto dei fori, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>the sample's mean thickness is {} voxels; below {} its trabeculae are not resolved ({} % of it lie outside any block of 2 x 2 x 2 voxels): voxels of {} mm would resolve them</source>
        <translation>lo spessore medio del campione è {} voxel; sotto {} le sue trabecole non sono risolte (il {} % sta fuori da ogni blocco di 2 x 2 x 2 voxel): voxel di {} mm le risolverebbero</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>the sample's mean thickness is {} voxels; below {} its trabeculae are not resolved: voxels of {} mm would resolve them</source>
        <translation>lo spessore medio del campione è {} voxel; sotto {} le sue trabecole non sono risolte: voxel di {} mm le risolverebbero</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>the sample's voxels must have the shape {}, got {}</source>
        <translation>i voxel del campione devono avere la forma {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>the scaffold</source>
        <translation>lo scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>the scaffold, once it is built</source>
        <translation>lo scaffold, una volta costruito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_search.py"/>
        <source>the search for a design gave up after {} s</source>
        <translation>la ricerca di un progetto si è arresa dopo {} s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_search.py"/>
        <source>the search for a design needs scipy 1.9 or later</source>
        <translation>la ricerca di un progetto richiede scipy 1.9 o successivo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the seed must lie in 0..{}, got {}</source>
        <translation>il seme deve stare in 0..{}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the short name of a face must hold no dot, got {}</source>
        <translation>il nome breve di una faccia non deve contenere punti, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the side of a layer</source>
        <translation>il lato di uno strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/slices.py"/>
        <source>the side of a plane must be one of {}, got {}</source>
        <translation>il lato di un piano deve essere uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>the sites {} lost their face {}: {} has Face1..Face{}; choose another face</source>
        <translation>i siti {} hanno perso la loro faccia {}: {} ha Face1..Face{}; scegliere un'altra faccia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>the sites {} must be on faces of {}, got none</source>
        <translation>i siti {} devono stare su facce di {}, qui nessuna</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>the sites {} must be on faces of {}, got {}</source>
        <translation>i siti {} devono stare su facce di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the size of the pore at {}</source>
        <translation>la dimensione del poro in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/voxelise.py"/>
        <source>the size of voxels must be &gt; 0, got {} mm</source>
        <translation>il lato dei voxel deve essere &gt; 0, qui {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>the slices' volume was not held against the mesh's: {}</source>
        <translation>il volume delle sezioni non è stato confrontato con quello della mesh: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the solid must be one of Solid1..Solid{}, got {}</source>
        <translation>il solido deve essere uno di Solid1..Solid{}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the solid was inside out (volume {} mm3) and has been turned</source>
        <translation>il solido era rovesciato (volume {} mm3) ed è stato girato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the solid was invalid ({}) and has been mended</source>
        <translation>il solido non era valido ({}) ed è stato riparato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>the solver must be one of {}, got {}</source>
        <translation>il metodo di soluzione deve essere uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/branches.py"/>
        <source>the spacing of rows must be &gt; 0, got {} mm</source>
        <translation>il passo delle righe deve essere &gt; 0, qui {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the spacing {} must be greater than 0, got {}</source>
        <translation>il passo {} deve essere maggiore di 0, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the stations of a rod must lie in 3..33, got {}</source>
        <translation>le stazioni di un'asta devono stare in 3..33, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/registry.py"/>
        <source>the strategy must be one of {}, got {}</source>
        <translation>la strategia deve essere una di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>the surface must be one of {}, got {}</source>
        <translation>la superficie deve essere una di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>the table must have {} rows and {} columns, got {}</source>
        <translation>la tabella deve avere {} righe e {} colonne, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>the tables are not compatible in layer {} along Z, and {} layers in all: no voxels have these sums in columns and rows</source>
        <translation>le tabelle non sono compatibili nello strato {} lungo Z, e in {} strati in tutto: nessun voxel ha queste somme in colonne e righe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>the tables are not compatible in layer {} along Z, and {} layers in all: no voxels within the mask have these sums in columns and rows</source>
        <translation>le tabelle non sono compatibili nello strato {} lungo Z, e in {} strati in tutto: nessun voxel nella maschera ha queste somme in colonne e righe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/layer_fill.py"/>
        <source>the tables are not compatible: no layer {} along Z has these {} voxels in columns and {} in rows; {} of {} layers fail</source>
        <translation>le tabelle non sono compatibili: nessuno strato {} lungo Z ha questi {} voxel in colonne e {} in righe; {} strati su {} falliscono</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/tasks.py"/>
        <source>the task could not be written into {}: {}</source>
        <translation>il compito non si è potuto scrivere in {}: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/cli_layers.py"/>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <source>the thickness of a layer must be above 0 mm, got {}</source>
        <translation>lo spessore di uno strato deve superare 0 mm, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>the thickness of a layer must be greater than 0, got {}</source>
        <translation>lo spessore di uno strato deve essere maggiore di 0, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>the thickness of common layers must be &gt; 0, got {} mm</source>
        <translation>lo spessore degli strati comuni deve essere &gt; 0, qui {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>the time budget</source>
        <translation>il limite di tempo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/scaffold_solids.py"/>
        <source>the time budget of {} s is used up</source>
        <translation>il limite di tempo di {} s è esaurito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>the total must be one of {}, got {}</source>
        <translation>il totale deve essere uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/layers.py"/>
        <source>the triangles of a face must run along each edge at most once each way</source>
        <translation>i triangoli di una faccia devono percorrere ogni spigolo al più una volta per verso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/tessellation.py"/>
        <source>the triangles of a solid</source>
        <translation>i triangoli di un solido</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/tessellation.py"/>
        <source>the triangles' volume must be the solid's to {} mm3 (deflection times area), got {} against {} mm3</source>
        <translation>il volume dei triangoli deve essere quello del solido entro {} mm3 (scostamento per area), qui {} contro {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>the union of rods</source>
        <translation>l'unione delle aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>the unit is {}; name it if this is wrong</source>
        <translation>l'unità è {}; indicarla se è sbagliata</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>the unit must be auto or one of {}, got {}</source>
        <translation>l'unità deve essere auto o una di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <source>the unit must be one of auto, {}, got {}</source>
        <translation>l'unità deve essere auto o una di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <source>the unit must be one of {}, got {}</source>
        <translation>l'unità deve essere una di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>the unit of a 3MF file must be one of {}, got {}</source>
        <translation>l'unità di un file 3MF deve essere una di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_makers.py"/>
        <source>the unit of a file must be one of auto, {}, got {}</source>
        <translation>l'unità di un file deve essere auto o una di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>the voxel size</source>
        <translation>il lato dei voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>the wavelength</source>
        <translation>la lunghezza d'onda</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/on_demand.py"/>
        <source>the window must not wait</source>
        <translation>la finestra non deve aspettare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/child_work.py"/>
        <source>the work could not be handed over in {}: {}</source>
        <translation>il lavoro non si è potuto consegnare in {}: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>the {} of a box must be greater than 0 mm, got {} mm</source>
        <translation>{} di un parallelepipedo deve essere maggiore di 0 mm, qui {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>the {} of {} and {} must leave some volume, got 0 mm3</source>
        <translation>{} di {} e {} deve lasciare un volume, qui 0 mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>the {}{} fullest columns ask for {}, and the rows can give them {}</source>
        <translation>le {}{} colonne più piene chiedono {}, e le righe possono darne {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>their own zeros</source>
        <translation>i loro zeri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>there is no mesh</source>
        <translation>non c'è una mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>there may be at most {} heights, got {}</source>
        <translation>ci possono essere al più {} quote, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>there may be at most {} planes along an axis; {} mm in layers of {} mm are {} planes, which would take about {} times the minute and 15 GB that {} take; layers of at least {} mm are possible</source>
        <translation>ci possono essere al più {} piani per asse; {} mm in strati di {} mm sono {} piani, che richiedono circa {} volte il minuto e i 15 GB di {}; sono possibili strati di almeno {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/voxelise.py"/>
        <source>there may be at most {} voxels, a size of {} mm makes {}</source>
        <translation>ci possono essere al più {} voxel, un lato di {} mm ne dà {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>there must be a file or folder of that name, got {}</source>
        <translation>deve esistere un file o una cartella con quel nome, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>there must be at least one axis to slice along, got {}</source>
        <translation>serve almeno un asse lungo cui sezionare, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/contacts.py"/>
        <source>there must be no contacts by an edge alone, but of {} contacts {}{} could not be removed without splitting the solid or closing a cavity; another seed or smaller voxels may do</source>
        <translation>non devono esserci contatti per solo spigolo, ma di {} contatti {}{} non si sono potuti togliere senza dividere il solido o chiudere una cavità; un altro seme o voxel più piccoli possono bastare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/contacts.py"/>
        <source>there must be no contacts by an edge or a corner alone, but of {} contacts {}{} could not be removed without splitting the solid or closing a cavity; another seed or smaller voxels may do</source>
        <translation>non devono esserci contatti per solo spigolo o vertice, ma di {} contatti {}{} non si sono potuti togliere senza dividere il solido o chiudere una cavità; un altro seme o voxel più piccoli possono bastare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/branches.py"/>
        <source>there must be one row of measures for each contour, got {}, {}</source>
        <translation>serve una riga di misure per ogni contorno, qui {}, {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/triples.py"/>
        <source>there must be three values, one along X, Y and Z each, got {}</source>
        <translation>devono essere tre valori, uno lungo X, Y e Z ciascuno, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>thesis</source>
        <translation>tesi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis Eq. 2.1, section 4.2.2</source>
        <translation>tesi Eq. 2.1, sezione 4.2.2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis Eq. 2.2</source>
        <translation>tesi Eq. 2.2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis Eq. 2.2, of a slice</source>
        <translation>tesi Eq. 2.2, di una sezione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis Eq. 5.1</source>
        <translation>tesi Eq. 5.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis Eq. 6.1</source>
        <translation>tesi Eq. 6.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis Eq. 6.2 and Eq. 6.6</source>
        <translation>tesi Eq. 6.2 ed Eq. 6.6</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>thesis ch. 9 (interconnectivity of trabeculae); graph of the slices</source>
        <translation>tesi cap. 9 (interconnessione delle trabecole); grafo delle sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis chapter 9</source>
        <translation>tesi capitolo 9</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis section 2.3.3</source>
        <translation>tesi sezione 2.3.3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis section 2.4.1</source>
        <translation>tesi sezione 2.4.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis section 2.4.5, tables 4.2 and 4.5</source>
        <translation>tesi sezione 2.4.5, tabelle 4.2 e 4.5</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis section 2.4.7</source>
        <translation>tesi sezione 2.4.7</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis section 4.3.1</source>
        <translation>tesi sezione 4.3.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis section 5.2.3</source>
        <translation>tesi sezione 5.2.3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis section 5.2.3.1</source>
        <translation>tesi sezione 5.2.3.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis section 5.2.3.3</source>
        <translation>tesi sezione 5.2.3.3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis section 5.4</source>
        <translation>tesi sezione 5.4</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis section 5.4.2</source>
        <translation>tesi sezione 5.4.2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis section 6.2.1</source>
        <translation>tesi sezione 6.2.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis section 6.2.1, after Eq. 6.1</source>
        <translation>tesi sezione 6.2.1, dopo l'Eq. 6.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis section 6.2.4, by Gale 1957, DOI 10.2140/pjm.1957.7.1073</source>
        <translation>tesi sezione 6.2.4, da Gale 1957, DOI 10.2140/pjm.1957.7.1073</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis section 6.3.1</source>
        <translation>tesi sezione 6.3.1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>thesis section 6.4</source>
        <translation>tesi sezione 6.4</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis sections 3.3.5 and 4.2.4</source>
        <translation>tesi sezioni 3.3.5 e 4.2.4</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>thesis tables 4.2 and 4.5</source>
        <translation>tesi tabelle 4.2 e 4.5</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>thesis tables 5.11, 5.12 and 5.13</source>
        <translation>tesi tabelle 5.11, 5.12 e 5.13</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/thinnest.py"/>
        <source>thickness</source>
        <translation>spessore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/path_laws.py"/>
        <source>through a random point of a box about it (Eq. 3.1)</source>
        <translation>per un punto casuale di un parallelepipedo attorno ad esso (Eq. 3.1)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>time</source>
        <translation>tempo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>time by hand</source>
        <translation>tempo a mano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>time for a rod</source>
        <translation>tempo per asta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>time of all, s</source>
        <translation>tempo totale, s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>time of the network a rod, s</source>
        <translation>tempo della rete per asta, s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>time of the network, s</source>
        <translation>tempo della rete, s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>time of the slices, processor s</source>
        <translation>tempo delle sezioni, s di processore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>time over the number of rods</source>
        <translation>tempo sul numero di aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>to {} site {} a point is needed, got {}</source>
        <translation>per {} il sito {} serve un punto, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>tool compensation, mm</source>
        <translation>compensazione utensile, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>total number of plates</source>
        <translation>numero totale di piastre</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>total number of rods</source>
        <translation>numero totale di aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>total volume</source>
        <translation>volume totale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/trabeculae.py"/>
        <source>trabeculae</source>
        <translation>trabecole</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>trabeculae (mean)</source>
        <translation>trabecole (media)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>trabeculae a layer along {}</source>
        <translation>trabecole per strato lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/colouring.py"/>
        <source>trabeculae along {}</source>
        <translation>trabecole lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>trabeculae of a layer</source>
        <translation>trabecole di uno strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>trabeculae that appear</source>
        <translation>trabecole che appaiono</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>trabeculae that end</source>
        <translation>trabecole che finiscono</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>trabeculae that join</source>
        <translation>trabecole che si uniscono</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>trabeculae that overlap several of the next slice (splits) or of the one before (joins), over that distance</source>
        <translation>trabecole che si sovrappongono a più d'una della sezione successiva (divisioni) o della precedente (unioni), su quella distanza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>trabeculae that split</source>
        <translation>trabecole che si dividono</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>trabeculae too small to be followed</source>
        <translation>trabecole troppo piccole per essere seguite</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>trabecular area</source>
        <translation>area trabecolare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>trabecular area range, mm2</source>
        <translation>area trabecolare, intervallo, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>trabecular area, net of holes</source>
        <translation>area trabecolare al netto dei fori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>trabecular number</source>
        <translation>numero trabecolare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>trabecular separation</source>
        <translation>separazione trabecolare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>trabecular thickness</source>
        <translation>spessore trabecolare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_source.py"/>
        <source>triangles</source>
        <translation>triangoli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/plane_triangles.py"/>
        <source>triangles between trimmed borders need the Python package scipy</source>
        <translation>i triangoli tra bordi tagliati richiedono il pacchetto Python scipy</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>triangles must have the shape (count, 3, 3), got {}</source>
        <translation>i triangoli devono avere la forma (numero, 3, 3), qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_triangles.py"/>
        <source>triangles must lie within {} mm of a face, got {} mm</source>
        <translation>i triangoli devono stare entro {} mm da una faccia, qui {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>triangles must name vertices 0..{} of their object</source>
        <translation>i triangoli devono nominare vertici 0..{} del loro oggetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_triangles.py"/>
        <source>triangles of a face must not fold over</source>
        <translation>i triangoli di una faccia non devono ripiegarsi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>triangles of solids</source>
        <translation>triangoli dei solidi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>triangles of the body</source>
        <translation>triangoli del corpo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>triangles of the mesh</source>
        <translation>triangoli della mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>true area of the curve: it is 1.46 s^2 in the mean</source>
        <translation>area vera della curva: in media è 1,46 s^2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>true area of the end sections</source>
        <translation>area vera delle sezioni di estremità</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>true area, mm2</source>
        <translation>area vera, mm2</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>true or false</source>
        <translation>vero o falso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>twice the surfaces crossed per length by parallel lines in all directions, over BV/TV.vox: the second route</source>
        <translation>il doppio delle superfici attraversate per unità di lunghezza da linee parallele in tutte le direzioni, su BV/TV.vox: la seconda via</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>two independent routes must agree, but they do not: {}</source>
        <translation>due vie indipendenti devono accordarsi, ma non lo fanno: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>um (guessed: the body would be {} mm large)</source>
        <translation>um (stimato: il corpo sarebbe di {} mm)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/fill.py"/>
        <source>union and compensation need the package manifold3d</source>
        <translation>unione e compensazione richiedono il pacchetto manifold3d</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>union by parallel rays through the rods' own triangles: no Boolean</source>
        <translation>unione con raggi paralleli attraverso i triangoli delle aste: nessuna operazione booleana</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>union of rods</source>
        <translation>unione delle aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>union of the rods in the envelope</source>
        <translation>unione delle aste nell'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>union of the rods, %</source>
        <translation>unione delle aste, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>unit</source>
        <translation>unità</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>unit of the file</source>
        <translation>unità del file</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/fill.py"/>
        <source>uniting contours</source>
        <translation>unione dei contorni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>unknown name {} in {}; known are {}</source>
        <translation>nome sconosciuto {} in {}; sono noti {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>up to 10 % low</source>
        <translation>fino al 10 % in meno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>up to date</source>
        <translation>aggiornato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>value</source>
        <translation>valore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/passport.py"/>
        <source>value of b over value of a, less 1; 0 = equal</source>
        <translation>valore di b su valore di a, meno 1; 0 = uguali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>variable</source>
        <translation>variabile</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/variants.py"/>
        <source>variants must be 1 to {}, got {}</source>
        <translation>le varianti devono essere da 1 a {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>variants must be those of a wireframe or of a voxel design, got {}</source>
        <translation>le varianti devono essere di un telaio o di un progetto a voxel, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>verification</source>
        <translation>verifica</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>vertices of rods must have the shape (rods, vertices, 3), got {}</source>
        <translation>i vertici delle aste devono avere la forma (aste, vertici, 3), qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>voids that no opening reaches</source>
        <translation>vuoti che nessuna apertura raggiunge</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/variants.py"/>
        <source>voids without an opening</source>
        <translation>vuoti senza apertura</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>volume along</source>
        <translation>volume lungo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>volume along {}, sum of area x thickness against the mesh, mm3</source>
        <translation>volume lungo {}, somma di area x spessore contro la mesh, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>volume by slices</source>
        <translation>volume dalle sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>volume by the triangles, BV/TV</source>
        <translation>volume dai triangoli, BV/TV</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>volume by the triangles; what overlaps counts twice</source>
        <translation>volume dai triangoli; ciò che si sovrappone conta due volte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>volume of layers outside of the envelope</source>
        <translation>volume degli strati fuori dell'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>volume of the STEP scaffold</source>
        <translation>volume dello scaffold STEP</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>volume of the body's box</source>
        <translation>volume del parallelepipedo del corpo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>volume of the channels</source>
        <translation>volume dei canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>volume of the envelope</source>
        <translation>volume dell'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <location filename="../../freecad_trabecula/features/second_routes.py"/>
        <source>volume of the mesh and of the voxels, mm3</source>
        <translation>volume della mesh e dei voxel, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>volume of the mesh by the divergence theorem</source>
        <translation>volume della mesh col teorema della divergenza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>volume of the mesh of the same rods</source>
        <translation>volume della mesh delle stesse aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>volume of the mesh over the body's length</source>
        <translation>volume della mesh sulla lunghezza del corpo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/second_routes.py"/>
        <source>volume of the rods, solids against meshes, mm3</source>
        <translation>volume delle aste, solidi contro mesh, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>volume of the scaffold</source>
        <translation>volume dello scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/second_routes.py"/>
        <source>volume of the scaffold, solid against mesh, mm3</source>
        <translation>volume dello scaffold, solido contro mesh, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>volume of the solid by the kernel</source>
        <translation>volume del solido dal nucleo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>volume of the triangles by the divergence theorem</source>
        <translation>volume dei triangoli col teorema della divergenza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>volume of the voxels</source>
        <translation>volume dei voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>volume of {}, mm3</source>
        <translation>volume ({}), mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <source>volume, mm3</source>
        <translation>volume, mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>volume, mm³</source>
        <translation>volume, mm³</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>volumes by rays</source>
        <translation>volumi per raggi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>voxel counts {}, got {} in layer {} along {}</source>
        <translation>i conteggi di voxel {}, qui {} nello strato {} lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report.py"/>
        <source>voxel design</source>
        <translation>progetto a voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>voxel, mm</source>
        <translation>voxel, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/voxelise.py"/>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>voxels</source>
        <translation>voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>voxels asked for in a layer</source>
        <translation>voxel richiesti in uno strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>voxels asked for, counted by a routine of its own (core/voxels/verification.py)</source>
        <translation>voxel richiesti, contati da una procedura a sé (core/voxels/verification.py)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/voxel_numbers.py"/>
        <source>voxels made in a layer</source>
        <translation>voxel fatti in uno strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/voxelise.py"/>
        <source>voxels must be a bool array [z, y, x], got {} of {}</source>
        <translation>i voxel devono essere una matrice bool [z, y, x], qui {} di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>voxels must be as large as the layers of the sample, {} mm along {}, got {} mm, which makes {} layers of the sample's {}: slice it again with layers of {} mm</source>
        <translation>i voxel devono essere grandi quanto gli strati del campione, {} mm lungo {}, qui {} mm, che fanno {} strati dei {} del campione: sezionarlo di nuovo in strati di {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/strategies/by_field.py"/>
        <source>voxels where the chosen field is highest, as nearly as the counts of the layers allow</source>
        <translation>voxel dove il campo scelto è più alto, per quanto lo consentono i conteggi degli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>watertight</source>
        <translation>a tenuta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>watertight {}: faulty edges</source>
        <translation>{} a tenuta: spigoli difettosi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/local_scale.py"/>
        <source>wavelengths</source>
        <translation>lunghezze d'onda</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/texture.py"/>
        <source>wavelengths must be three lengths above 2 voxels, got {}</source>
        <translation>le lunghezze d'onda devono essere tre lunghezze oltre 2 voxel, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>what</source>
        <translation>che cosa</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/packing.py"/>
        <source>what a document holds must be a value of this version: {}</source>
        <translation>ciò che un documento contiene deve essere un valore di questa versione: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_source.py"/>
        <source>what is sliced must be a mesh or have a solid, got {} without</source>
        <translation>ciò che si seziona deve essere una mesh o avere un solido, qui {} senza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_source.py"/>
        <source>what is sliced must have triangles, got none in {}</source>
        <translation>ciò che si seziona deve avere triangoli, qui nessuno in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/guides.py"/>
        <location filename="../../freecad_trabecula/geometry/patch_solids.py"/>
        <source>what meets what</source>
        <translation>che cosa incontra che cosa</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>what overlaps was united</source>
        <translation>ciò che si sovrappone è stato unito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>whether a design exists</source>
        <translation>se esiste un progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/slice_numbers.py"/>
        <source>which is up to 10 % low</source>
        <translation>che è fino al 10 % in meno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>whole</source>
        <translation>intero</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>wider than {} mm bridged</source>
        <translation>più larghe di {} mm superate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/texture.py"/>
        <source>width of a texture must be 0.02 to 1, got {}</source>
        <translation>la larghezza di una tessitura deve stare da 0.02 a 1, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/assembly.py"/>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>wireframe</source>
        <translation>telaio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>with contacts 'any' there is one</source>
        <translation>con i contatti «any» ce n'è uno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/small_boxes.py"/>
        <source>with contacts '{}' there is one</source>
        <translation>con i contatti «{}» ce n'è uno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/feasibility.py"/>
        <source>within the mask layer {} along {} holds {} voxels, but is asked for {}</source>
        <translation>nella maschera lo strato {} lungo {} contiene {} voxel, ma ne sono chiesti {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/masked_tables.py"/>
        <source>within the mask{}</source>
        <translation>nella maschera{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/cli_layers.py"/>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>writing layers</source>
        <translation>scrittura degli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/report_sections.py"/>
        <source>writing the report</source>
        <translation>scrittura del rapporto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>writing the tables of {}</source>
        <translation>scrittura delle tabelle di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/workbook.py"/>
        <source>writing the workbook's sheet {}</source>
        <translation>scrittura del foglio {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>yes</source>
        <translation>sì</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>{} (the file's)</source>
        <translation>{} (del file)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>{} (the zero vector)</source>
        <translation>{} (il vettore nullo)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{} about {} mm</source>
        <translation>{} intorno a {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <source>{} against {}</source>
        <translation>{} contro {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>{} against {}, {} apart</source>
        <translation>{} contro {}, distanti {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>{} against {}, {} of it apart</source>
        <translation>{} contro {}, distanti {} di esso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/morphometry.py"/>
        <source>{} along {}</source>
        <translation>{} lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>{} and {}</source>
        <translation>{} e {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>{} and {} layers of {} and {} voxels</source>
        <translation>{} e {} strati di {} e {} voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>{} and {} more stretches</source>
        <translation>{} e altri {} tratti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>{} apart</source>
        <translation>distanti {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>{} apart (at most {})</source>
        <translation>distanti {} (al più {})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/feasibility.py"/>
        <source>{} ask for {} voxels together, but the layers along {} leave them at most {}</source>
        <translation>{} chiedono {} voxel insieme, ma gli strati lungo {} ne lasciano loro al più {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/feasibility.py"/>
        <source>{} ask for {} voxels together, each voxel counted in every such layer it lies in; {} voxels give them at most {}</source>
        <translation>{} chiedono {} voxel insieme, ogni voxel contato in ciascuno dei suoi strati; {} voxel ne danno loro al più {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>{} below {} mm3 left out</source>
        <translation>{} sotto {} mm3 esclusi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/colouring.py"/>
        <source>{} can be coloured by one of {}, got {}</source>
        <translation>{} si può colorare secondo uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>{} changes by hand do not</source>
        <translation>{} modifiche a mano non lo fanno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>{} changes by hand do not fit the design: {}</source>
        <translation>{} modifiche a mano non si accordano col progetto: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/feature.py"/>
        <source>{} could not be computed: {}</source>
        <translation>{} non si è potuto calcolare: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>{} could not be read as CSV: {}</source>
        <translation>{} non si è potuto leggere come CSV: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{} could not be read as JSON: {}</source>
        <translation>{} non si è potuto leggere come JSON: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>{} could not be read as XLSX: {}</source>
        <translation>{} non si è potuto leggere come XLSX: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>{} could not be read: there is no such file or folder</source>
        <translation>{} non si è potuto leggere: non esiste un tale file o cartella</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <location filename="../../freecad_trabecula/core/analysis/tables.py"/>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{} could not be read: {}</source>
        <translation>{} non si è potuto leggere: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_source.py"/>
        <source>{} could not be written into {}: {}</source>
        <translation>{} non si è potuto scrivere in {}: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/files.py"/>
        <source>{} could not be written whole: is the disk full?</source>
        <translation>{} non si è potuto scrivere per intero: il disco è pieno?</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <location filename="../../freecad_trabecula/geometry/files.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_export.py"/>
        <source>{} could not be written: {}</source>
        <translation>{} non si è potuto scrivere: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{} end sections; their true area is {} of the estimated.</source>
        <translation>{} sezioni di estremità; la loro area vera è {} volte quella stimata.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>{} engine, {} rods, {} triangles, cells of {} mm: about {} s and {} GB</source>
        <translation>motore {}, {} aste, {} triangoli, celle di {} mm: circa {} s e {} GB</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>{} engine, {} rods, {} triangles, {} pairs that come near: about {} s and {} GB</source>
        <translation>motore {}, {} aste, {} triangoli, {} coppie che si avvicinano: circa {} s e {} GB</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>{} faces were sewn to a solid, gaps up to {} mm</source>
        <translation>{} facce sono state cucite in un solido, lacune fino a {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>{} has no key {}; known are {}</source>
        <translation>{} non ha la chiave {}; sono note {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/flows.py"/>
        <source>{} have {} cells for them, and </source>
        <translation>{} hanno {} celle per essi, e </translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/tasks.py"/>
        <source>{} holds no task that can be read: {}</source>
        <translation>{} non contiene un compito leggibile: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/json_values.py"/>
        <source>{} is incomplete: {}</source>
        <translation>{} è incompleto: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{} is no folder of an analysis: {} {}</source>
        <translation>{} non è la cartella di un'analisi: {} {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>{} is no proper {} file: {}</source>
        <translation>{} non è un vero file {}: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{} is not a whole analysis: {}</source>
        <translation>{} non è un'analisi completa: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>{} is not allowed in {}</source>
        <translation>{} non è ammesso in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/targets.py"/>
        <source>{} layers of {} voxels cannot hold {}</source>
        <translation>{} strati di {} voxel non possono contenerne {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{} mm {} on {}</source>
        <translation>{} mm {} su {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/envelopes.py"/>
        <source>{} mm, {} mm3</source>
        <translation>{} mm, {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>{} mm3 together</source>
        <translation>{} mm3 insieme</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{} must be JSON: {}</source>
        <translation>{} deve essere JSON: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/tables.py"/>
        <source>{} must be UTF-8 text: {}</source>
        <translation>{} deve essere testo UTF-8: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>{} must be a closed mesh of finite co-ordinates, got {}</source>
        <translation>{} deve essere una mesh chiusa di coordinate finite, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/meshes.py"/>
        <source>{} must be a closed mesh, each edge in two triangles that run along it opposite ways; it has {} triangles, {} open edges, {} edges of more than two triangles, {} edges run unevenly, {} triangles with a vertex named twice</source>
        <translation>{} deve essere una mesh chiusa, ogni spigolo in due triangoli che lo percorrono in versi opposti; ha {} triangoli, {} spigoli aperti, {} spigoli di più di due triangoli, {} spigoli percorsi male, {} triangoli con un vertice doppio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>{} must be a finite number, got {}</source>
        <translation>{} deve essere un numero finito, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>{} must be a flat image, got {}</source>
        <translation>{} deve essere un'immagine piana, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/json_values.py"/>
        <source>{} must be a list of numbers, got {}</source>
        <translation>{} deve essere una lista di numeri, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/json_values.py"/>
        <source>{} must be a list of numbers: {}</source>
        <translation>{} deve essere una lista di numeri: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/json_values.py"/>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>{} must be a list, got {}</source>
        <translation>{} deve essere una lista, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>{} must be a number a computer can hold, got {}</source>
        <translation>{} deve essere un numero che un calcolatore può contenere, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{} must be a whole NPY file of numbers: {}</source>
        <translation>{} deve essere un file NPY intero di numeri: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>{} must be an image that can be read: {}</source>
        <translation>{} deve essere un'immagine leggibile: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/json_values.py"/>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>{} must be an object with keys, got {}</source>
        <translation>{} deve essere un oggetto con chiavi, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>{} must be at least 0, got {}</source>
        <translation>{} deve essere almeno 0, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>{} must be at least {}, got {}</source>
        <translation>{} deve essere almeno {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>{} must be computed anew: {}</source>
        <translation>{} deve essere ricalcolato: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/colouring.py"/>
        <source>{} must be computed before its rods are coloured, got: {}</source>
        <translation>{} deve essere calcolato prima di colorarne le aste, stato: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>{} must be finite, got {}</source>
        <translation>{} deve essere finito, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <source>{} must be finite, or nan for the body's own, got {}</source>
        <translation>{} deve essere finito, o nan per quello del corpo, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>{} must be linked to 1 face, got {}</source>
        <translation>{} deve essere collegato a 1 faccia, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/prism_sites.py"/>
        <source>{} must be linked to a box, got nothing</source>
        <translation>{} deve essere collegato a un parallelepipedo, qui nulla</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/prism_sites.py"/>
        <source>{} must be linked to a box, got {}</source>
        <translation>{} deve essere collegato a un parallelepipedo, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scaffold.py"/>
        <source>{} must be linked to a scaffold, got {}</source>
        <translation>{} deve essere collegato a uno scaffold, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>{} must be linked to a wireframe, got {}</source>
        <translation>{} deve essere collegato a un telaio, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>{} must be made of curves to get others, it follows another sample</source>
        <translation>{} deve essere fatto di curve per averne altre, segue un altro campione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>{} must be one number or three, got {}</source>
        <translation>{} deve essere di un numero o di tre, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/parameters.py"/>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>{} must be one of {}, got {}</source>
        <translation>{} deve essere uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{} must be the report of a {}</source>
        <translation>{} deve essere la relazione di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>{} must be up to date for its contours, got: {}</source>
        <translation>{} deve essere aggiornato per i suoi contorni, stato: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis_files.py"/>
        <source>{} must be up to date to be saved, got: {}</source>
        <translation>{} deve essere aggiornato per essere salvato, stato: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/exports.py"/>
        <source>{} must be up to date to be written: update it first</source>
        <translation>{} deve essere aggiornato per essere scritto: aggiornarlo prima</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/scripts.py"/>
        <source>{} must be without error to be written as a script, got: {}</source>
        <translation>{} deve essere senza errori per essere scritto come script, stato: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/exports.py"/>
        <source>{} must be without error to be written, got {}</source>
        <translation>{} deve essere senza errori per essere scritto, stato: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/json_values.py"/>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>{} must be {}, got {}</source>
        <translation>{} deve essere {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{} must begin with NRRD000, got {}</source>
        <translation>{} deve cominciare con NRRD000, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{} must give the sizes of its voxels (spacings or space directions)</source>
        <translation>{} deve dare le dimensioni dei suoi voxel (spacings o space directions)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{} must have a column {}; it has, got {}</source>
        <translation>{} deve avere una colonna {}; ha, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{} must have a line of names and one for each layer, got {}</source>
        <translation>{} deve avere una riga di nomi e una per strato, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/exports.py"/>
        <source>{} must have a mesh or a shape to be written, got neither</source>
        <translation>{} deve avere una mesh o una forma per essere scritto, qui nessuna delle due</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_inputs.py"/>
        <source>{} must have a sample, a source, a file or drawn curves, got none</source>
        <translation>{} deve avere un campione, un corpo, un file o curve disegnate, qui nulla</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>{} must have a source or a file to be sliced, got neither</source>
        <translation>{} deve avere un corpo o un file da sezionare, qui nessuno dei due</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>{} must have at least one rod, got 0</source>
        <translation>{} deve avere almeno un'asta, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>{} must have at least one solid, got a {} without one</source>
        <translation>{} deve avere almeno un solido, qui {} senza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/sections.py"/>
        <source>{} must have at least one solid, got no shape</source>
        <translation>{} deve avere almeno un solido, qui nessuna forma</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>{} must have at least one triangle, got 0</source>
        <translation>{} deve avere almeno un triangolo, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>{} must have been computed, got: {}</source>
        <translation>{} deve essere stato calcolato, stato: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{} must have the layers 0, 1, ... along {}, got {}</source>
        <translation>{} deve avere gli strati 0, 1, ... lungo {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{} must have the schema {}, got {}</source>
        <translation>{} deve avere lo schema {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>{} must have the sheets alpha and beta; it has, got {}</source>
        <translation>{} deve avere i fogli alpha e beta; ha, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/booleans.py"/>
        <source>{} must have triangles counter-clockwise seen from outside, got a volume of {} mm3</source>
        <translation>{} deve avere triangoli antiorari visti da fuori, qui un volume di {} mm3</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/exports.py"/>
        <source>{} must have triangles to be written, got 0</source>
        <translation>{} deve avere triangoli per essere scritto, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/records.py"/>
        <source>{} must have {} values, got {}</source>
        <translation>{} deve avere {} valori, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{} must hold an array of three axes, got {}</source>
        <translation>{} deve contenere una matrice a tre assi, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/layer_analysis.py"/>
        <source>{} must hold at least one layer, got 0</source>
        <translation>{} deve contenere almeno uno strato, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>{} must hold at least one triangle, got 0</source>
        <translation>{} deve contenere almeno un triangolo, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{} must hold finite numbers, got {} that are not</source>
        <translation>{} deve contenere numeri finiti, qui {} che non lo sono</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/image_stacks.py"/>
        <source>{} must hold images ({}), got {}</source>
        <translation>{} deve contenere immagini ({}), qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{} must hold numbers, got {}</source>
        <translation>{} deve contenere numeri, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{} must hold {}</source>
        <translation>{} deve contenere {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{} must hold, got {}</source>
        <translation>{} deve contenere, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/propagation_steps.py"/>
        <source>{} must lie in 0..{}, got {}</source>
        <translation>{} deve stare in 0..{}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <location filename="../../freecad_trabecula/core/voxels/parameters.py"/>
        <source>{} must lie in {}..{}, got {}</source>
        <translation>{} deve stare in {}..{}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/face_sites.py"/>
        <source>{} must lie on it to {} mm, got a distance of {} mm</source>
        <translation>{} deve starvi sopra entro {} mm, qui una distanza di {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>{} must name a field of the job; known here are {}, got {}</source>
        <translation>{} deve nominare un campo del lavoro; qui noti {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/job.py"/>
        <source>{} must number one of {} entries, got {}</source>
        <translation>{} deve indicare una di {} voci, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/colouring.py"/>
        <source>{} must show the rods of {}, got {}: update it</source>
        <translation>{} deve mostrare le aste di {}, qui {}: aggiornarlo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/laws.py"/>
        <source>{} needs brackets</source>
        <translation>{} richiede parentesi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/meshes.py"/>
        <source>{} of a mesh must have the shape (count, 3), got {}</source>
        <translation>{} di una mesh devono avere la forma (numero, 3), qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>{} of it apart</source>
        <translation>distanti {} di esso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>{} of the body and the voxels</source>
        <translation>{} del corpo e dei voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>{} of the envelope</source>
        <translation>{} dell'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison_report.py"/>
        <location filename="../../freecad_trabecula/core/estimates.py"/>
        <source>{} of {}</source>
        <translation>{} di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_makers.py"/>
        <source>{} of {} and {}</source>
        <translation>{} di {} e {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{} of {} rods were faulty when they were drawn.</source>
        <translation>{} aste su {} erano difettose quando sono state estratte.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>{} pairs of pores overlap on face {}: pores must be smaller than their spacing</source>
        <translation>{} coppie di pori si sovrappongono sulla faccia {}: i pori devono essere più piccoli del loro passo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>{} pairs that come near</source>
        <translation>{} coppie che si avvicinano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>{} parts</source>
        <translation>{} parti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/geometry/design.py"/>
        <source>{} pores reach over the border of face {}: half their size must not exceed the distance from it</source>
        <translation>{} pori superano il bordo della faccia {}: metà della loro dimensione non deve superare la distanza da esso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/wireframe.py"/>
        <source>{} rods</source>
        <translation>{} aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/network.py"/>
        <source>{} rods, {} mm^3 with overlaps</source>
        <translation>{} aste, {} mm^3 con sovrapposizioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/face_sites.py"/>
        <source>{} sites</source>
        <translation>{} siti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>{} slices, bone fraction {} %</source>
        <translation>{} sezioni, frazione ossea {} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/analysis.py"/>
        <source>{} slices, {} of them spoilt, bone fraction {} %</source>
        <translation>{} sezioni, {} guaste, frazione ossea {} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/explanations/design_numbers.py"/>
        <source>{} standard errors, loose pieces and voids left aside</source>
        <translation>{} errori standard, senza pezzi staccati e vuoti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>{} that no opening reaches, {} mm3 together: {}</source>
        <translation>{} senza apertura, {} mm3 insieme: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>{} through others: what overlaps {} (fill rule '{}')</source>
        <translation>{} attraverso altre: ciò che si sovrappone {} (regola di riempimento '{}')</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <location filename="../../freecad_trabecula/core/analysis/report_text.py"/>
        <location filename="../../freecad_trabecula/core/voxels/report_text.py"/>
        <source>{} to {}</source>
        <translation>da {} a {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{} to {} ({})</source>
        <translation>da {} a {} ({})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/meshes.py"/>
        <source>{} vertices still share their point in single precision after {} nudges</source>
        <translation>{} vertici condividono ancora il loro punto in precisione singola dopo {} spostamenti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>{} voxels in one part, exact along X, Y and Z, bone fraction {} %</source>
        <translation>{} voxel in una parte, esatti lungo X, Y e Z, frazione ossea {} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/voxel_design.py"/>
        <source>{} voxels in {} parts, exact along X, Y and Z, bone fraction {} %</source>
        <translation>{} voxel in {} parti, esatti lungo X, Y e Z, frazione ossea {} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/migrations.py"/>
        <source>{} was made by a later version of Trabecula: its schema must be at most {}, got {}; update Trabecula</source>
        <translation>{} è stato fatto da una versione successiva di Trabecula: il suo schema deve essere al più {}, qui {}; aggiornare Trabecula</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/report.py"/>
        <source>{} without area: no slice is spoilt by that</source>
        <translation>{} senza area: nessuna sezione è guasta per questo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/design.py"/>
        <source>{} x {} x {} layers, {} cells: about {} GB of memory and {} s</source>
        <translation>{} x {} x {} strati, {} celle: circa {} GB di memoria e {} s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/flows.py"/>
        <source>{} {} ask for {} voxels together, but </source>
        <translation>{} {} chiedono {} voxel insieme, ma </translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/flows.py"/>
        <source>{} {} ask for {} voxels together, but the other layers along {} are asked for {} in all</source>
        <translation>{} {} chiedono {} voxel insieme, ma agli altri strati lungo {} ne sono chiesti {} in tutto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>{} {} must be one JSON object, got {}: {}</source>
        <translation>{} {} deve essere un oggetto JSON, qui {}: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/tables.py"/>
        <source>{} {} sums to {}, asked for {}</source>
        <translation>{} {} dà {}, richiesto {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_search.py"/>
        <source>{} {} times</source>
        <translation>{} {} volte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{}, box of {} mm</source>
        <translation>{}, parallelepipedo {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{}, box of {} mm about {} mm</source>
        <translation>{}, parallelepipedo {} mm intorno a {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <source>{}, cut off all round, {} mm3 together, the largest {} mm3: {}</source>
        <translation>{}, isolati, {} mm3 insieme, il maggiore {} mm3: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>{}, got {}</source>
        <translation>{}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/parameters.py"/>
        <source>{}, got {} {}</source>
        <translation>{}, qui {} {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/tables.py"/>
        <source>{}, line 1: the columns must be {}, got {}</source>
        <translation>{}, riga 1: le colonne devono essere {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{}, line {}</source>
        <translation>{}, riga {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{}, line {}: a layer must stand there once, got {}</source>
        <translation>{}, riga {}: uno strato deve starci una volta, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/tables.py"/>
        <source>{}, line {}: it must hold {} numbers, got {}</source>
        <translation>{}, riga {}: deve contenere {} numeri, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{}, line {}: the axis must be x, y or z, got {}</source>
        <translation>{}, riga {}: l'asse deve essere x, y o z, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/html_report/sections.py"/>
        <source>{}, seen from a corner</source>
        <translation>{}, visto da un angolo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/report_text.py"/>
        <source>{}, size {} mm</source>
        <translation>{}, dimensione {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: a binary STL file has at least {}{} bytes, got {}</source>
        <translation>{}: un file STL binario ha almeno {}{} byte, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>{}: a mesh file must end in .stl, .obj, .ply or .3mf, got {}</source>
        <translation>{}: un file di mesh deve finire in .stl, .obj, .ply o .3mf, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <source>{}: a polyline must end with C or O; that of line {}{} is cut off</source>
        <translation>{}: una polilinea deve finire con C o O; quella della riga {}{} è troncata</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>{}: a table must have sums and cells, got rows, got {}</source>
        <translation>{}: una tabella deve avere somme e celle, qui righe, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: a voxel must have three edges above 0, got {}</source>
        <translation>{}: un voxel deve avere tre lati maggiori di 0, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>{}: all rows must have the same length, got {}</source>
        <translation>{}: tutte le righe devono avere la stessa lunghezza, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: an ASCII STL file must end with 'endsolid'; this one is cut off</source>
        <translation>{}: un file STL ASCII deve finire con 'endsolid'; questo è troncato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/ssl.py"/>
        <source>{}: an SSL file must begin with 'Slice V0' and 'SLICES()'; this one holds neither</source>
        <translation>{}: un file SSL deve cominciare con 'Slice V0' e 'SLICES()'; questo non ha né l'uno né l'altro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: an STL file must hold at least one triangle, got 0</source>
        <translation>{}: un file STL deve contenere almeno un triangolo, qui 0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{}: axes.{} does not fit its profile of {} slices: {}</source>
        <translation>{}: axes.{} non si accorda col suo profilo di {} sezioni: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>{}: co-ordinates must be finite</source>
        <translation>{}: le coordinate devono essere finite</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/triangles.py"/>
        <source>{}: co-ordinates must be finite and at most {} mm, got {}..{} mm</source>
        <translation>{}: le coordinate devono essere finite e al più {} mm, qui {}..{} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: co-ordinates must be finite; triangle {}{} of {} has {}</source>
        <translation>{}: le coordinate devono essere finite; il triangolo {}{} di {} ha {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: co-ordinates must be numbers: {}</source>
        <translation>{}: le coordinate devono essere numeri: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>{}: direction in which a linear law grows</source>
        <translation>{}: direzione in cui cresce una legge lineare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: each facet must have three vertices, got {} vertices in {} facets</source>
        <translation>{}: ogni faccetta deve avere tre vertici, qui {} vertici in {} faccette</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_files.py"/>
        <source>{}: every sum and cell must be a whole number, got {}</source>
        <translation>{}: ogni somma e cella deve essere un numero intero, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>{}: formula of x, y, z (mm) and a random u in 0..1</source>
        <translation>{}: formula di x, y, z (mm) e di un u casuale in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>{}: how it varies over the design</source>
        <translation>{}: come varia nel progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{}: it must be a number, got {}</source>
        <translation>{}: deve essere un numero, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/sources.py"/>
        <source>{}: its values must be lists of numbers: {}</source>
        <translation>{}: i suoi valori devono essere liste di numeri: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{}: layers must be those of the profile</source>
        <translation>{}: gli strati devono essere quelli del profilo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{}: mesh</source>
        <translation>{}: mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{}: morphometry</source>
        <translation>{}: morfometria</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/folder.py"/>
        <source>{}: parameters</source>
        <translation>{}: parametri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: sizes must be three numbers above 0, got {}</source>
        <translation>{}: le dimensioni devono essere tre numeri maggiori di 0, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: sizes must be whole numbers, got {}</source>
        <translation>{}: le dimensioni devono essere numeri interi, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: spacings, directions and origin must be numbers: {}</source>
        <translation>{}: spacings, directions e origin devono essere numeri: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/tables.py"/>
        <source>{}: the column {} must hold whole numbers</source>
        <translation>{}: la colonna {} deve contenere numeri interi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>{}: the constant value, or the least; linear, radial: at the start</source>
        <translation>{}: il valore costante, o il minimo; lineare, radiale: all'inizio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/exact_search.py"/>
        <source>{}: the counts weigh {}, no design above {}</source>
        <translation>{}: i conteggi pesano {}, nessun progetto oltre {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: the data must stand in the file itself, not in a data file of their own</source>
        <translation>{}: i dati devono stare nel file stesso, non in un file di dati a parte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: the encoding must be raw or gzip, got {}</source>
        <translation>{}: la codifica deve essere raw o gzip, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: the file became shorter while it was read, at triangle {}{}</source>
        <translation>{}: il file si è accorciato durante la lettura, al triangolo {}{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/features/base.py"/>
        <source>{}: the greatest value; linear, radial: at the end</source>
        <translation>{}: il valore massimo; lineare, radiale: alla fine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: the header must end with an empty line; the file is cut off</source>
        <translation>{}: l'intestazione deve finire con una riga vuota; il file è troncato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/tables.py"/>
        <source>{}: the layers must be counted 0, 1, 2, ...</source>
        <translation>{}: gli strati devono essere contati 0, 1, 2, ...</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: the packed data are damaged or cut off: {}</source>
        <translation>{}: i dati compressi sono danneggiati o troncati: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/stl.py"/>
        <source>{}: the size of a binary STL file must be 84 + 50 bytes for each triangle; its header says {} triangles, {} bytes hold {} and {} bytes more</source>
        <translation>{}: un file STL binario deve avere 84 + 50 byte per triangolo; la sua intestazione dice {} triangoli, {} byte ne contengono {} e {} byte in più</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: the type must be one of {}, got {}</source>
        <translation>{}: il tipo deve essere uno di {}, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/mesh_readers.py"/>
        <source>{}: triangles must name vertices 0..{}, got {}..{}</source>
        <translation>{}: i triangoli devono nominare vertici 0..{}, qui {}..{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/bodies.py"/>
        <location filename="../../freecad_trabecula/core/explanations/explanation.py"/>
        <source>{}: {} against {}, {} apart (at most {})</source>
        <translation>{}: {} contro {}, distanti {} (al più {})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>{}: {} is resampled by area from layers of {} mm.</source>
        <translation>{}: {} è ricampionato per area da strati di {} mm.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>{}: {} layers of {} mm, {} to {} mm.</source>
        <translation>{}: {} strati di {} mm, da {} a {} mm.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>{}: {} reaches {} mm below and {} mm above.</source>
        <translation>{}: {} arriva {} mm più in basso e {} mm più in alto.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/analysis/comparison.py"/>
        <source>{}: {} to {} mm</source>
        <translation>{}: da {} a {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/volume_files.py"/>
        <source>{}: {} x {} x {} values of {} are {} bytes, got {}</source>
        <translation>{}: {} x {} x {} valori di {} sono {} byte, qui {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>{}; closed layers need a Boolean</source>
        <translation>{}; gli strati chiusi richiedono un'operazione booleana</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>{}; exact</source>
        <translation>{}; esatto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/optional_packages.py"/>
        <source>{}; install it with: {}</source>
        <translation>{}; si installa con: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>{}; the exact mesh engine needs manifold3d: {}</source>
        <translation>{}; il motore esatto a mesh richiede manifold3d: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/engines.py"/>
        <source>{}; the exact mesh engine would take about {} s</source>
        <translation>{}; il motore esatto a mesh richiederebbe circa {} s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/core/voxels/table_pairs.py"/>
        <source>{}; {} sums or cells are wrong</source>
        <translation>{}; {} somme o celle sono errate</translation>
    </message>
</context>
<context>
    <name>Labels</name>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Analysis {}</source>
        <translation>Analisi {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Bone</source>
        <translation>Osso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Channels</source>
        <translation>Canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Envelope</source>
        <translation>Involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Example_measure</source>
        <translation>Esempio_misura</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Example_rods</source>
        <translation>Esempio_aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Example_voxels</source>
        <translation>Esempio_voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Layers of {}</source>
        <translation>Strati di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Loose</source>
        <translation>Pezzi staccati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Network</source>
        <translation>Rete</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Scaffold</source>
        <translation>Scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Sites</source>
        <translation>Siti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Sites {}</source>
        <translation>Siti {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>SolidScaffold</source>
        <translation>Scaffold solido</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Specimen {}</source>
        <translation>Provino {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Voids</source>
        <translation>Vuoti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Voxels of drawn curves</source>
        <translation>Voxel da curve disegnate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Voxels {}</source>
        <translation>Voxel {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/labels.py"/>
        <source>Wireframe</source>
        <translation>Telaio</translation>
    </message>
</context>
<context>
    <name>Trabecula</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>  area</source>
        <translation>  area</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>  at</source>
        <translation>  a</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>  size</source>
        <translation>  dimensione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>, layers on {} faces</source>
        <translation>, strati su {} facce</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>, porosity {:.2f} %</source>
        <translation>, porosità {:.2f} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>, {} left</source>
        <translation>, ancora {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <source>1 section</source>
        <translation>1 sezione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <source>2 sections</source>
        <translation>2 sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>30 to 75 s a rod, by curvature and sections (thesis 2.3.3)</source>
        <translation>da 30 a 75 s per asta, secondo curvatura e sezioni (tesi 2.3.3)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>A click brings in a mesh or a solid from a file; one of the document will do as well.</source>
        <translation>Un clic importa una mesh o un solido da un file; va bene anche uno del documento.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>A further direction: as if the part were turned</source>
        <translation>Un'altra direzione: come se il pezzo fosse ruotato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>A mesh, an analysis' CSV, targets or voxels from a file</source>
        <translation>Mesh, CSV di un'analisi, obiettivi o voxel da un file</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/install.py"/>
        <source>A package is missing</source>
        <translation>Manca un pacchetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>Across the direction in which you look now</source>
        <translation>Trasversale alla direzione in cui si guarda ora</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Add a convergence point</source>
        <translation>Aggiungere un punto di convergenza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Add a coupling</source>
        <translation>Aggiungere un accoppiamento</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Again</source>
        <translation>Di nuovo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>All sums are right and every layer can be filled</source>
        <translation>Tutte le somme sono giuste e ogni strato si può riempire</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>All ways to work</source>
        <translation>Tutti i modi di lavorare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysing.py"/>
        <location filename="../../freecad_trabecula/gui/analysis_panel.py"/>
        <source>Analyse</source>
        <translation>Analizza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>Analyse a mesh, a solid or a design to see its slices</source>
        <translation>Analizzare una mesh, un solido o un progetto per vederne le sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Analyse it</source>
        <translation>Analizza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Analyse the scaffold</source>
        <translation>Analizza lo scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Analyse the voxels</source>
        <translation>Analizza i voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Another bone, or a design: a click brings it in, the next one measures it.</source>
        <translation>Un altro osso, o un progetto: un clic lo importa, il successivo lo misura.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>Areas</source>
        <translation>Aree</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>As</source>
        <translation>Come</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>As many voxels in every layer along X, Y and Z as the targets ask, in one piece.</source>
        <translation>In ogni strato lungo X, Y e Z tanti voxel quanti ne chiedono gli obiettivi, in un solo pezzo.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>As seen</source>
        <translation>Come visto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>As they were</source>
        <translation>Com'erano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Attempts</source>
        <translation>Tentativi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Available</source>
        <translation>Disponibili</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Axes</source>
        <translation>Assi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Back</source>
        <translation>Indietro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Begin</source>
        <translation>Inizia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>Begin with</source>
        <translation>Iniziare da</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Being computed …</source>
        <translation>In calcolo …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Blocks keep volume and areas exactly; smooth keeps the volume</source>
        <translation>I blocchi conservano esattamente volume e aree; liscia conserva il volume</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <location filename="../../freecad_trabecula/gui/export_dialog.py"/>
        <source>Body</source>
        <translation>Corpo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Body to be sliced</source>
        <translation>Corpo da sezionare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Body within which voxels may lie</source>
        <translation>Corpo entro il quale possono stare i voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Bone fraction</source>
        <translation>Frazione ossea</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/prism_section.py"/>
        <source>Border</source>
        <translation>Bordo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Border u, v</source>
        <translation>Bordo u, v</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Both on shared axes, with their differences and a passport of how near they are.</source>
        <translation>Entrambi su assi comuni, con le differenze e un passaporto di quanto sono vicini.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/why.py"/>
        <source>Both routes</source>
        <translation>Le due vie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Box</source>
        <translation>Riquadro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/renewing.py"/>
        <source>Bring up to date</source>
        <translation>Aggiorna</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/build_bar.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_panel.py"/>
        <source>Build</source>
        <translation>Costruisci</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Build the scaffold</source>
        <translation>Costruisci lo scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/build_bar.py"/>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <location filename="../../freecad_trabecula/gui/recomputing.py"/>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Cancelled</source>
        <translation>Annullato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Cell</source>
        <translation>Cella</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Cells at its border</source>
        <translation>Celle sul bordo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Change a value and build again: analysis and comparison follow in the plots.</source>
        <translation>Cambiare un valore e ricostruire: analisi e confronto seguono nei grafici.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Change the design</source>
        <translation>Cambia il progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/edits_list.py"/>
        <source>Changes by hand</source>
        <translation>Modifiche a mano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Channels</source>
        <translation>Canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_panel.py"/>
        <source>Checking the envelope …</source>
        <translation>Controllo dell'involucro …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Checks</source>
        <translation>Controlli</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Choice</source>
        <translation>Scelta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_panel.py"/>
        <source>Choose a body or a file</source>
        <translation>Scegliere un corpo o un file</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>Click a rod in the 3D view</source>
        <translation>Cliccare un'asta nella vista 3D</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Click faces in the 3D view; a second click takes one away</source>
        <translation>Cliccare le facce nella vista 3D; un secondo clic ne toglie una</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_view.py"/>
        <source>Click for a new point, drag points, right click takes one away</source>
        <translation>Cliccare per un nuovo punto, trascinare i punti, il clic destro ne toglie uno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/task_panels.py"/>
        <source>Close the open task panel first</source>
        <translation>Chiudere prima il pannello aperto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/build_bar.py"/>
        <source>Close the panel; the status bar shows how far it is and can end it</source>
        <translation>Chiude il pannello; la barra di stato mostra l'avanzamento e può interromperlo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Closed cavities</source>
        <translation>Cavità chiuse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Closes channels</source>
        <translation>Chiude i canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Co-ordinates of the planes, mm, for planes at heights</source>
        <translation>Coordinate dei piani in mm, per piani a quote date</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>Colour</source>
        <translation>Colore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Colour by</source>
        <translation>Colora per</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Compact layers</source>
        <translation>Strati compatti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Compare</source>
        <translation>Confronta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Compensation</source>
        <translation>Compensazione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Component of the unit tangent, 0 to 1</source>
        <translation>Componente della tangente unitaria, da 0 a 1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Connected channels</source>
        <translation>Canali connessi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Connected parts</source>
        <translation>Parti connesse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Connected pieces of the scaffold</source>
        <translation>Parti connesse dello scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>Constant value, or least; at the start</source>
        <translation>Valore costante, o minimo; all'inizio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Contacts avoided</source>
        <translation>Contatti evitati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Contacts by a corner alone</source>
        <translation>Contatti per solo vertice</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Contacts by an edge alone</source>
        <translation>Contatti per solo spigolo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Contents</source>
        <translation>Indice</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Contours</source>
        <translation>Contorni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Convergence point</source>
        <translation>Punto di convergenza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Convergence points: {}</source>
        <translation>Punti di convergenza: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Convergence: centre of the envelope</source>
        <translation>Convergenza: centro dell'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <source>Corners</source>
        <translation>Vertici</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Couple the opposite faces of the prism</source>
        <translation>Accoppiare le facce opposte del prisma</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Couplings</source>
        <translation>Accoppiamenti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>Cut</source>
        <translation>Taglio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Deflection</source>
        <translation>Scostamento</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Design a scaffold in this body</source>
        <translation>Progetta uno scaffold in questo corpo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/building.py"/>
        <location filename="../../freecad_trabecula/gui/design_panel.py"/>
        <source>Design rods</source>
        <translation>Progetta aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Design the rods</source>
        <translation>Progetta le aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Design the voxels</source>
        <translation>Progetta i voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_panel.py"/>
        <source>Design voxels</source>
        <translation>Progetta voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>Design voxels of a body or an analysis to see their layers</source>
        <translation>Progettare voxel da un corpo o da un'analisi per vederne gli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Design voxels that match a bone</source>
        <translation>Progetta voxel simili a un osso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Design with these</source>
        <translation>Progetta con queste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>Difference</source>
        <translation>Differenza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>Direction in which the value grows</source>
        <translation>Direzione in cui il valore cresce</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Direction u</source>
        <translation>Direzione u</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Direction v</source>
        <translation>Direzione v</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>Draw sliced areas</source>
        <translation>Disegna le aree sezionate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Draw the sliced areas along X, Y and Z, anew or from those of an analysis</source>
        <translation>Disegnare le aree sezionate lungo X, Y e Z, da zero o da quelle di un'analisi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Earlier: its faces' sites are taken first</source>
        <translation>Prima: i siti delle sue facce sono presi per primi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/prism_section.py"/>
        <source>Edge</source>
        <translation>Lato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>Edges X, Y, Z</source>
        <translation>Lati X, Y, Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Edit site and pore</source>
        <translation>Modifica sito e poro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Engine</source>
        <translation>Motore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Envelope</source>
        <translation>Involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Envelope and surface</source>
        <translation>Involucro e superficie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Estimate by rays (quick)</source>
        <translation>Stima per raggi (rapida)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Every slice along X, Y and Z is measured: areas, porosity, contours.</source>
        <translation>Ogni sezione lungo X, Y e Z è misurata: aree, porosità, contorni.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Exact on every layer of the three axes</source>
        <translation>Esatto in ogni strato dei tre assi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Example</source>
        <translation>Esempio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/example_projects.py"/>
        <source>Example project</source>
        <translation>Progetto d'esempio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <location filename="../../freecad_trabecula/gui/export_dialog.py"/>
        <source>Export</source>
        <translation>Esporta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Export …</source>
        <translation>Esporta …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Face</source>
        <translation>Faccia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Face at which the rods start</source>
        <translation>Faccia dalla quale partono le aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Face at which they end</source>
        <translation>Faccia alla quale terminano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Faces</source>
        <translation>Facce</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Fault</source>
        <translation>Difetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Field</source>
        <translation>Campo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Figures</source>
        <translation>Dati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Filter open, closed</source>
        <translation>Filtro aperti, chiusi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>First layer along Z</source>
        <translation>Primo strato lungo Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>First site</source>
        <translation>Primo sito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>First tension</source>
        <translation>Tensione inizio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_saving.py"/>
        <source>Folder for tables, report and plots</source>
        <translation>Cartella per tabelle, relazione e grafici</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_export.py"/>
        <source>Folder for the images' folder</source>
        <translation>Cartella in cui creare quella delle immagini</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/export_dialog.py"/>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/why.py"/>
        <source>Formula</source>
        <translation>Formula</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>Formula of x, y, z (mm) and a random u in 0..1</source>
        <translation>Formula di x, y, z (mm) e di un u casuale in 0..1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Forward</source>
        <translation>Avanti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>From</source>
        <translation>Da</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Gap fill</source>
        <translation>Chiusura lacune</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Give all faces the spacings and borders of the chosen one</source>
        <translation>Dare a tutte le facce passi e bordi di quella scelta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Give colours a meaning; a legend says which. Select objects, or nothing for all that are seen</source>
        <translation>Dare un significato ai colori; una legenda dice quale. Selezionare oggetti, o nulla per tutti quelli visibili</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Glass envelope</source>
        <translation>Involucro di vetro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Glossary</source>
        <translation>Glossario</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/qt.py"/>
        <source>Glossary: what the words mean</source>
        <translation>Glossario: che cosa significano le parole</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/law_field.py"/>
        <source>Greatest value; at the end</source>
        <translation>Valore massimo; alla fine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Guide</source>
        <translation>Guida</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Heat map</source>
        <translation>Densità</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/qt.py"/>
        <source>Help: what can be done here</source>
        <translation>Aiuto: che cosa si può fare qui</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>How sites are set</source>
        <translation>Come si dispongono i siti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>How the cut is filled</source>
        <translation>Come si riempie il taglio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/build_bar.py"/>
        <source>In the background</source>
        <translation>In secondo piano</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/install.py"/>
        <source>Install {}</source>
        <translation>Installa {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>It could not be computed: its Status says why.</source>
        <translation>Non si è potuto calcolare: il suo Status dice perché.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Keep loose pieces</source>
        <translation>Tieni pezzi staccati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>Last layer</source>
        <translation>Ultimo strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Later</source>
        <translation>Dopo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>Layer along Z</source>
        <translation>Strato lungo Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>Layer shapes</source>
        <translation>Forme degli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>Layers</source>
        <translation>Strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Layers along X, Y, Z</source>
        <translation>Strati lungo X, Y, Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <source>Layout</source>
        <translation>Forma</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Lean</source>
        <translation>Inclinazione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Least thickness</source>
        <translation>Spessore minimo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Least void</source>
        <translation>Vuoto minimo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Left</source>
        <translation>Rimasti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>Length</source>
        <translation>Lunghezza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Lines solved</source>
        <translation>Linee risolte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Look at the layers</source>
        <translation>Guarda gli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Look at the plots</source>
        <translation>Guarda i grafici</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Look through</source>
        <translation>Trasparenza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Look through bodies and envelope. Select a design, or nothing for all</source>
        <translation>Guardare attraverso corpi e involucro. Selezionare un progetto, o nulla per tutti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Loose pieces</source>
        <translation>Pezzi staccati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Mean bone fraction, %</source>
        <translation>Frazione ossea media, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Mean deviation of the trabeculae, %</source>
        <translation>Scarto medio delle trabecole, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Measure a bone</source>
        <translation>Misura un osso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Measure a bone or a design</source>
        <translation>Misura un osso o un progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Measure another</source>
        <translation>Misurane un altro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Measure the targets</source>
        <translation>Misura gli obiettivi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Measures</source>
        <translation>Misure</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Memory budget</source>
        <translation>Limite di memoria</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>Mended</source>
        <translation>Riparata</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Mending</source>
        <translation>Riparazione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Meshes</source>
        <translation>Mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Most in a line (x, z)</source>
        <translation>Massimo per linea (x, z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Most in a line (y, z)</source>
        <translation>Massimo per linea (y, z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Most rods</source>
        <translation>Aste al più</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Move site</source>
        <translation>Sposta sito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>No preview</source>
        <translation>Nessuna anteprima</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>No rod is left out</source>
        <translation>Nessuna asta è esclusa</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>No rod leaves the envelope</source>
        <translation>Nessuna asta esce dall'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>No voxels fill layer {} along Z; {} layers do not go</source>
        <translation>Nessun voxel riempie lo strato {} lungo Z; {} strati non riescono</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Not now: the steps before it come first</source>
        <translation>Non ora: prima i passi che lo precedono</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/command.py"/>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Not now: {}</source>
        <translation>Non ora: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Nothing was found.</source>
        <translation>Nessun risultato.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/why.py"/>
        <source>Number</source>
        <translation>Numero</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>Numbers</source>
        <translation>Numeri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>Off: share of the layer in %</source>
        <translation>No: quota dello strato in %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Off: three edges along X, Y, Z</source>
        <translation>No: tre lati lungo X, Y, Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_export.py"/>
        <source>One image a layer along Z, in a new folder</source>
        <translation>Un'immagine per strato lungo Z, in una nuova cartella</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>One number reproduces all draws</source>
        <translation>Un solo numero riproduce tutte le estrazioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>One step back</source>
        <translation>Un passo indietro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>One step on</source>
        <translation>Un passo avanti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>One total</source>
        <translation>Un solo totale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Only from, to</source>
        <translation>Solo da, a</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Open a small project of this kind, in a new document</source>
        <translation>Aprire un piccolo progetto di questo tipo, in un nuovo documento</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_envelope.py"/>
        <source>Open envelope</source>
        <translation>Apri involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Open job</source>
        <translation>Apri lavoro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Opposite faces</source>
        <translation>Facce opposte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>Order</source>
        <translation>Ordine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Other seeds: {}</source>
        <translation>Altri semi: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>Other side</source>
        <translation>Altro lato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Out of date: click to bring everything up to date.</source>
        <translation>Non aggiornato: cliccare per aggiornare tutto.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Outer contours</source>
        <translation>Contorni esterni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>Outside</source>
        <translation>Fuori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Overlaps</source>
        <translation>Sovrapposizioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>Pairs</source>
        <translation>Coppie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Pairs of tables</source>
        <translation>Coppie di tabelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>Passport</source>
        <translation>Passaporto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Path</source>
        <translation>Percorso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Path: {}</source>
        <translation>Percorso: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>Paths</source>
        <translation>Percorsi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Paths from {} to {}</source>
        <translation>Percorsi da {} a {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Paths of its own</source>
        <translation>Percorsi propri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Paths of this coupling alone</source>
        <translation>Percorsi di questo solo accoppiamento</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Pick a body</source>
        <translation>Scegli un corpo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/picking.py"/>
        <source>Pick a face of {}</source>
        <translation>Indicare una faccia di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Pick a site</source>
        <translation>Indicare un sito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Pick faces</source>
        <translation>Scegli facce</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Pick the origin on the chosen face</source>
        <translation>Indicare l'origine sulla faccia scelta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Place</source>
        <translation>Posizione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Place of the site</source>
        <translation>Posizione del sito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Plain colours</source>
        <translation>Colori semplici</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Plain sum of the rods</source>
        <translation>Somma semplice delle aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Planes</source>
        <translation>Piani</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Plates</source>
        <translation>Piastre</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Point at a diagram: the slice there is drawn beside it and shown in the 3D view.</source>
        <translation>Indicare un grafico: la sezione in quel punto è disegnata accanto e mostrata nella vista 3D.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Pore sizes</source>
        <translation>Dimensioni dei pori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preferences.py"/>
        <source>PoreSmallest and PoreLargest: {}; {:g} and {:g} mm are taken</source>
        <translation>PoreSmallest e PoreLargest: {}; si prendono {:g} e {:g} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>Pores</source>
        <translation>Pori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Porosity</source>
        <translation>Porosità</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Porosity in</source>
        <translation>Porosità in</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Porosity of slices along X</source>
        <translation>Porosità delle sezioni lungo X</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Porosity of slices along Y</source>
        <translation>Porosità delle sezioni lungo Y</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Porosity of slices along Z</source>
        <translation>Porosità delle sezioni lungo Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Porosity of the scaffold (Eq. 2.2)</source>
        <translation>Porosità dello scaffold (Eq. 2.2)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Porosity, %</source>
        <translation>Porosità, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>Preset</source>
        <translation>Modello</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>Preview …</source>
        <translation>Anteprima …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>Profiles have no picture</source>
        <translation>I profili non hanno immagine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <source>Pull</source>
        <translation>Tiro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>Quantity</source>
        <translation>Grandezza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>Raise or lower the curves until all ask for the mean volume</source>
        <translation>Alzare o abbassare le curve finché tutte chiedono il volume medio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Range and heights</source>
        <translation>Intervallo e quote</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Read tables</source>
        <translation>Leggi tabelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Read …</source>
        <translation>Leggi …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_panel.py"/>
        <source>Reading the envelope …</source>
        <translation>Lettura dell'involucro …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Recoveries</source>
        <translation>Recuperi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Redraws</source>
        <translation>Ripetizioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Remedy</source>
        <translation>Rimedio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Remove the chosen coupling</source>
        <translation>Rimuovere l'accoppiamento scelto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Remove this point</source>
        <translation>Rimuovere questo punto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Results</source>
        <translation>Risultati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>Reuse sites</source>
        <translation>Riusa i siti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>Rod</source>
        <translation>Asta</translation>
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
        <translation>Aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Rods as solids and as meshes, mm³</source>
        <translation>Aste come solidi e come mesh, mm³</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Rods by coupling</source>
        <translation>Aste per accoppiamento</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Rods by hand (thesis' estimate)</source>
        <translation>Aste a mano (stima della tesi)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Rods by recovery</source>
        <translation>Aste per recupero</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Rods by size</source>
        <translation>Aste per dimensione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Rods from</source>
        <translation>Aste da</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Rods or channels</source>
        <translation>Aste o canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Rods through a box, an implant or any solid; channels, porosity, files for a printer.</source>
        <translation>Aste in un parallelepipedo, un impianto o un solido qualsiasi; canali, porosità, file per una stampante.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Rounds</source>
        <translation>Passate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Rows of tables</source>
        <translation>Righe delle tabelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>Run on, or stop</source>
        <translation>Proseguire, o fermare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_panel.py"/>
        <source>STEP scaffold</source>
        <translation>Scaffold STEP</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>STEP scaffold: porosity</source>
        <translation>Scaffold STEP: porosità</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>STEP scaffold: rods cut</source>
        <translation>Scaffold STEP: aste tagliate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>STEP scaffold: time</source>
        <translation>Scaffold STEP: tempo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>STEP scaffold: volume</source>
        <translation>Scaffold STEP: volume</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Sample</source>
        <translation>Campione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Sample and design side by side, layer by layer, with the counts of both.</source>
        <translation>Campione e progetto affiancati, strato per strato, con i conteggi di entrambi.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Sample of a voxel design</source>
        <translation>Campione di un progetto a voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Samples</source>
        <translation>Campioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Save CSV …</source>
        <translation>Salva CSV …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Save job</source>
        <translation>Salva lavoro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Save variants</source>
        <translation>Salva varianti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>Save …</source>
        <translation>Salva …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <location filename="../../freecad_trabecula/gui/design_panel.py"/>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Scaffold</source>
        <translation>Scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Scaffold as solid and as mesh, mm³</source>
        <translation>Scaffold come solido e come mesh, mm³</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Scaffold of each (exact)</source>
        <translation>Scaffold di ognuno (esatto)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/build_bar.py"/>
        <source>Scaffold: {} engine, about {}, {}</source>
        <translation>Scaffold: motore {}, circa {}, {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <source>Scatter</source>
        <translation>Dispersione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Search all pages</source>
        <translation>Cerca in tutte le pagine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Search: {}</source>
        <translation>Ricerca: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/why.py"/>
        <source>Second route</source>
        <translation>Seconda via</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>Second site</source>
        <translation>Secondo sito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/paths_section.py"/>
        <source>Second tension</source>
        <translation>Tensione fine</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>Section</source>
        <translation>Taglio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>Section plane</source>
        <translation>Piano di taglio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <source>Sections</source>
        <translation>Sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Seed</source>
        <translation>Seme</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/notice.py"/>
        <source>Seen</source>
        <translation>Visto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Select a wireframe or its sites first</source>
        <translation>Selezionare prima un telaio o i suoi siti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Select the solid or the closed mesh to be filled. A click here brings one in from a file; without one a box is filled.</source>
        <translation>Selezionare il solido o la mesh chiusa da riempire. Un clic qui ne porta uno da un file; senza, si riempie un parallelepipedo.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Set pore</source>
        <translation>Imposta poro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Share of the largest part</source>
        <translation>Quota della parte maggiore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Sheets 0 … rods 1</source>
        <translation>Lamina 0, asta 1</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/notice.py"/>
        <source>Show</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Show bodies in a clear envelope. Select a design, or nothing for all</source>
        <translation>Mostrare i corpi in un involucro trasparente. Selezionare un progetto, o nulla per tutti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Show bodies solid, no envelope. Select a design, or nothing for all</source>
        <translation>Mostrare i corpi solidi, senza involucro. Selezionare un progetto, o nulla per tutti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Show when Trabecula is chosen</source>
        <translation>Mostra quando si sceglie Trabecula</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Side</source>
        <translation>Lato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Site</source>
        <translation>Sito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Site; or click one in the 3D view</source>
        <translation>Sito; o cliccarne uno nella vista 3D</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <location filename="../../freecad_trabecula/gui/prism_section.py"/>
        <source>Sites</source>
        <translation>Siti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>Sites on</source>
        <translation>Siti su</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Sites, pores, paths and couplings; the preview and its porosity follow every change. OK keeps the design.</source>
        <translation>Siti, pori, percorsi e accoppiamenti; anteprima e porosità seguono ogni modifica. OK conserva il progetto.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Size</source>
        <translation>Dimensione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>Size of the end sections, mm</source>
        <translation>Dimensione delle sezioni di estremità, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/export_dialog.py"/>
        <source>Size of the file</source>
        <translation>Dimensione del file</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Size of the pore</source>
        <translation>Dimensione del poro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Slice an STL, OBJ, PLY or 3MF file</source>
        <translation>Sezionare un file STL, OBJ, PLY o 3MF</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <location filename="../../freecad_trabecula/gui/analysis_panel.py"/>
        <source>Slice analysis</source>
        <translation>Analisi per sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Slice the sample in layers as thick as the voxels are to be: each is a target.</source>
        <translation>Sezionare il campione in strati spessi quanto dovranno essere i voxel: ognuno è un obiettivo.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Sliced area</source>
        <translation>Area sezionata</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Sliced area, mm²</source>
        <translation>Area sezionata, mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Slices</source>
        <translation>Sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Slices, porosity, thickness of trabeculae; two bodies side by side.</source>
        <translation>Sezioni, porosità, spessore delle trabecole; due corpi affiancati.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_panel.py"/>
        <source>Slices: {}</source>
        <translation>Sezioni: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Smoothing</source>
        <translation>Lisciatura</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Solid</source>
        <translation>Solido</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Solid voxels</source>
        <translation>Voxel pieni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>Something is on its way already: wait, or cancel it</source>
        <translation>Qualcosa è già in corso: aspettare, o annullarlo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/why.py"/>
        <source>Source</source>
        <translation>Fonte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Spacing u, v</source>
        <translation>Passo u, v</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Spoilt slices</source>
        <translation>Sezioni guaste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Start from this design of the thesis. Select nothing: it brings its own body</source>
        <translation>Partire da questo progetto della tesi. Non selezionare nulla: porta il proprio corpo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Stations</source>
        <translation>Stazioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>Step {} of {}</source>
        <translation>Passo {} di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Strategy</source>
        <translation>Strategia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Strategy {} makes voxels without tables; another strategy fills layers from edited ones</source>
        <translation>La strategia {} fa voxel senza tabelle; un'altra riempie strati da quelle modificate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Strategy's own choices</source>
        <translation>Opzioni della strategia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Sum of the rods, mm³</source>
        <translation>Somma delle aste, mm³</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Switch site off</source>
        <translation>Disattiva sito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Tables of {}</source>
        <translation>Tabelle di {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_saving.py"/>
        <source>Tables, report and plots are in {}</source>
        <translation>Tabelle, relazione e grafici sono in {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>Tables, report and plots of what is ticked, in a folder</source>
        <translation>Tabelle, relazione e grafici di ciò che è spuntato, in una cartella</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Take a bone or a design</source>
        <translation>Prendi un osso o un progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Take a sample</source>
        <translation>Prendi un campione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Take back</source>
        <translation>Annulla modifica</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/edits_list.py"/>
        <source>Take the chosen change back</source>
        <translation>Annullare la modifica scelta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>Take the chosen face away</source>
        <translation>Togliere la faccia scelta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Take this seed</source>
        <translation>Prendi questo seme</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/pores_section.py"/>
        <location filename="../../freecad_trabecula/gui/site_panel.py"/>
        <source>Tangents</source>
        <translation>Tangenti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Targets</source>
        <translation>Obiettivi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>Tb.Th, Tb.Sp, Conn.D, DA … on voxels (slow)</source>
        <translation>Tb.Th, Tb.Sp, Conn.D, DA … su voxel (lento)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>The body to be filled</source>
        <translation>Il corpo da riempire</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>The bone that the voxels are to match: a click brings in a mesh or a solid.</source>
        <translation>L'osso cui i voxel devono somigliare: un clic porta una mesh o un solido.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>The channels are cut out of the body. Volumes, parts and loose pieces are checked.</source>
        <translation>I canali sono tagliati dal corpo. Volumi, parti e pezzi staccati sono controllati.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>The contours are being worked out …</source>
        <translation>Calcolo dei contorni in corso …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>The design is sliced as the sample was: the second route to its areas.</source>
        <translation>Il progetto è sezionato come il campione: la seconda via alle sue aree.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>The design's own tables; cells can be edited, their sums must stay</source>
        <translation>Le tabelle del progetto; le celle si possono cambiare, le loro somme devono restare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>The next seed: other draws, other pairs</source>
        <translation>Il seme successivo: altre estrazioni, altre coppie</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>The sample is being worked out …</source>
        <translation>Calcolo del campione in corso …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>The thesis' designs, to start from</source>
        <translation>I progetti della tesi, da cui partire</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>The totals differ; a design scales all curves to their mean, {} mm³</source>
        <translation>I totali differiscono; un progetto porta tutte le curve alla loro media, {} mm³</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Thickness</source>
        <translation>Spessore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Thickness of the layers, axes, mending; Tb.Th, Tb.Sp, Conn.D and DA if they are ticked.</source>
        <translation>Spessore degli strati, assi, riparazione; Tb.Th, Tb.Sp, Conn.D e DA se spuntati.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/export_dialog.py"/>
        <source>This body is out of date: build it again first</source>
        <translation>Questo corpo non è aggiornato: ricostruirlo prima</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Tick the faces that get a compact layer</source>
        <translation>Spuntare le facce che ricevono uno strato compatto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>Time budget</source>
        <translation>Limite di tempo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Time for a rod</source>
        <translation>Tempo per asta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>To all</source>
        <translation>A tutte</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>To one total by</source>
        <translation>Stesso totale per</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>To the empty layer</source>
        <translation>Allo strato vuoto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>To the last step</source>
        <translation>All'ultimo passo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>To whose slices the porosity refers</source>
        <translation>Alle cui sezioni si riferisce la porosità</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Total of</source>
        <translation>Totale di</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/transactions.py"/>
        <source>Trabecula</source>
        <translation>Trabecula</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_dock.py"/>
        <source>Trabecula help</source>
        <translation>Trabecula aiuto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Trabecula job</source>
        <translation>Lavoro di Trabecula</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preferences.py"/>
        <source>Trabecula's preferences: {}</source>
        <translation>Preferenze di Trabecula: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>Trabeculae</source>
        <translation>Trabecole</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Trabeculae counted</source>
        <translation>Conta trabecole</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Trabeculae in layers along X</source>
        <translation>Trabecole negli strati lungo X</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Trabeculae in layers along Y</source>
        <translation>Trabecole negli strati lungo Y</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Trabeculae in layers along Z</source>
        <translation>Trabecole negli strati lungo Z</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Trabecular area, mm²</source>
        <translation>Area trabecolare, mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Tries</source>
        <translation>Tentativi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Union of the rods in the envelope</source>
        <translation>Unione delle aste nell'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>Value</source>
        <translation>Valore</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>Variants</source>
        <translation>Varianti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>Voids that no opening reaches</source>
        <translation>Vuoti senza apertura</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Volume by slices, mm³</source>
        <translation>Volume dalle sezioni, mm³</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Volume of the mesh</source>
        <translation>Volume della mesh</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>Volume of the voxels</source>
        <translation>Volume dei voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_panel.py"/>
        <source>Voxel design</source>
        <translation>Progetto a voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>Voxel layers</source>
        <translation>Strati di voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Voxel size</source>
        <translation>Lato dei voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>Voxels asked for in each column, from the left</source>
        <translation>Voxel richiesti in ogni colonna, da sinistra</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>Voxels asked for in each row, from the lowest</source>
        <translation>Voxel richiesti in ogni riga, dal basso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Voxels in one piece with the bone's sliced areas in every layer along X, Y and Z.</source>
        <translation>Voxel in un solo pezzo con le aree sezionate dell'osso in ogni strato lungo X, Y e Z.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Voxels within</source>
        <translation>Voxel entro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>Watch a layer being filled</source>
        <translation>Osserva il riempimento di uno strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>Wavelengths</source>
        <translation>Lunghezze d'onda</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/guide_dock.py"/>
        <source>What do you want to do?</source>
        <translation>Che cosa si vuole fare?</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>What the rods' colours mean</source>
        <translation>Che cosa indicano i colori delle aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>What the scaffold is to be like: a file, or a mesh of the document.</source>
        <translation>Come deve essere lo scaffold: un file, o una mesh del documento.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>Where the plane is, mm</source>
        <translation>Dove sta il piano, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>Whole</source>
        <translation>Totale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/why.py"/>
        <source>Why? Formula, source, second route</source>
        <translation>Perché? Formula, fonte, seconda via</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/doors.py"/>
        <source>Write files for a printer, a CAD system or a table; sizes are shown first.</source>
        <translation>Scrivere file per una stampante, un sistema CAD o una tabella; prima si vedono le dimensioni.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/report_writing.py"/>
        <source>Write report</source>
        <translation>Scrivi relazione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Write tables</source>
        <translation>Scrivi tabelle</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>Write …</source>
        <translation>Scrivi …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>X-ray</source>
        <translation>Raggi X</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/work_text.py"/>
        <source>about {}</source>
        <translation>circa {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>along {}</source>
        <translation>lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>alpha, columns</source>
        <translation>alpha, colonne</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>alpha: voxels in the lines (x, z)</source>
        <translation>alpha: voxel nelle linee (x, z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>an analysis is on its way already</source>
        <translation>un'analisi è già in corso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>and {} more</source>
        <translation>e altri {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>area of outer contours, mm²</source>
        <translation>area dei contorni esterni, mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>area of outer contours, mm² (light: many)</source>
        <translation>area dei contorni esterni, mm² (chiaro: molti)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>area, mm²</source>
        <translation>area, mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>areas in mm²</source>
        <translation>aree in mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>as drawn</source>
        <translation>come estratta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>as the design</source>
        <translation>come il progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>as they stand</source>
        <translation>così come sono</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>asked for</source>
        <translation>richiesti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/fields.py"/>
        <source>automatic</source>
        <translation>automatico</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/recomputing.py"/>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>being computed</source>
        <translation>in calcolo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>beta, rows</source>
        <translation>beta, righe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>beta: voxels in the lines (y, z)</source>
        <translation>beta: voxel nelle linee (y, z)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>box of the body</source>
        <translation>parallelepipedo del corpo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>box of the sample</source>
        <translation>parallelepipedo del campione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>build a scaffold first</source>
        <translation>costruire prima uno scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>build a scaffold or a network first</source>
        <translation>costruire prima uno scaffold o una rete</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>by rays, loose pieces left in</source>
        <translation>per raggi, pezzi staccati inclusi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>case </source>
        <translation>caso </translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>chance: {:.1f} %</source>
        <translation>caso: {:.1f} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>choose a design …</source>
        <translation>scegliere un progetto …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/command.py"/>
        <source>close the open task panel first</source>
        <translation>chiudere prima il pannello aperto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>co-ordinate along {}, mm</source>
        <translation>coordinata lungo {}, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>columns, u stays smallest</source>
        <translation>colonne, u resta minimo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>contours (as the thesis)</source>
        <translation>contorni (come nella tesi)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>coupling</source>
        <translation>accoppiamento</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>craniofacial implant</source>
        <translation>impianto craniofacciale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>cube</source>
        <translation>cubo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>deflection {}, {} stations</source>
        <translation>scostamento {}, {} stazioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>design</source>
        <translation>progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>design: {} made, {} asked for</source>
        <translation>progetto: {} fatti, {} richiesti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>direction: 0.6,0.8,0</source>
        <translation>direzione: 0.6,0.8,0</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_form.py"/>
        <source>drawn curves</source>
        <translation>curve disegnate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/start_commands.py"/>
        <source>everything is up to date</source>
        <translation>tutto è aggiornato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>failed, left out</source>
        <translation>fallita, esclusa</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>false</source>
        <translation>falso</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>faulty rods are being mended …</source>
        <translation>riparazione delle aste difettose …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/work_text.py"/>
        <source>files of {}</source>
        <translation>file per {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>from seed</source>
        <translation>dal seme</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_form.py"/>
        <source>heights: 0.5 1.0 2.5</source>
        <translation>quote: 0.5 1.0 2.5</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>humerus implant</source>
        <translation>impianto omerale</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>kind of the contours</source>
        <translation>tipo dei contorni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/language.py"/>
        <source>language code</source>
        <translation>it</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_dock.py"/>
        <source>layer </source>
        <translation>strato </translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <location filename="../../freecad_trabecula/gui/rod_dock.py"/>
        <source>leaves the envelope</source>
        <translation>esce dall'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>mended</source>
        <translation>riparate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preferences.py"/>
        <source>must be a folder that is there</source>
        <translation>deve essere una cartella esistente</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preferences.py"/>
        <source>must be a length above 0 mm</source>
        <translation>deve essere una lunghezza maggiore di 0 mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preferences.py"/>
        <source>must be the number of one of {}</source>
        <translation>deve essere il numero di uno tra {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preferences.py"/>
        <source>must lie in {}..{}</source>
        <translation>deve stare in {}..{}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_envelope.py"/>
        <source>new prism</source>
        <translation>nuovo prisma</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/command.py"/>
        <source>no document is open</source>
        <translation>nessun documento è aperto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>no face picked</source>
        <translation>nessuna faccia scelta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_model.py"/>
        <source>no voxels have these sums in columns and rows</source>
        <translation>nessun voxel ha queste somme in colonne e righe</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>none</source>
        <translation>nessuno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/command.py"/>
        <source>nothing has been designed or analysed yet</source>
        <translation>non è ancora stato progettato o analizzato nulla</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>nothing that is seen can be coloured by that</source>
        <translation>nulla di visibile si può colorare così</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>nothing: drawn anew</source>
        <translation>nulla: disegno nuovo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>number of trabeculae</source>
        <translation>numero di trabecole</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>of the scaffold of each</source>
        <translation>dello scaffold di ognuno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>outer contours</source>
        <translation>contorni esterni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>outlines as wires</source>
        <translation>contorni come fili</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/install.py"/>
        <source>pip could not install {}; it says why below.</source>
        <translation>pip non ha potuto installare {}; il motivo è qui sotto.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>plates</source>
        <translation>piastre</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>plates ({})</source>
        <translation>piastre ({})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>porosity of the slices along {}</source>
        <translation>porosità delle sezioni lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>porosity …</source>
        <translation>porosità …</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>porosity ≈ {} %</source>
        <translation>porosità ≈ {} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>porosity, %</source>
        <translation>porosità, %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>prism</source>
        <translation>prisma</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>recovery of the rods</source>
        <translation>recupero delle aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>rods</source>
        <translation>aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>rods ({})</source>
        <translation>aste ({})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>rows, v stays smallest</source>
        <translation>righe, v resta minimo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>sample</source>
        <translation>campione</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>sample: asks for {} voxels</source>
        <translation>campione: chiede {} voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>sample: {} asked for, {} by centres</source>
        <translation>campione: {} richiesti, {} per centri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>select a network, a scaffold, a mesh or a solid</source>
        <translation>selezionare una rete, uno scaffold, una mesh o un solido</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>select a solid, or faces of one</source>
        <translation>selezionare un solido, o alcune sue facce</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>size of the rods</source>
        <translation>dimensione delle aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>slice </source>
        <translation>sezione </translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_view.py"/>
        <source>sliced area along {}, {}</source>
        <translation>area sezionata lungo {}, {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>sliced area less that of {}, mm²</source>
        <translation>area sezionata meno quella di {}, mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>sliced area, mm²</source>
        <translation>area sezionata, mm²</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>solids</source>
        <translation>solidi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>spoilt</source>
        <translation>guaste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/build_bar.py"/>
        <source>starting</source>
        <translation>avvio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_model.py"/>
        <source>sum</source>
        <translation>somma</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>sum of the rods {:.1f} %</source>
        <translation>somma delle aste {:.1f} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>the shortest first</source>
        <translation>la più corta per prima</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/command.py"/>
        <source>there is no analysis yet</source>
        <translation>non c'è ancora un'analisi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>there is no design of rods or voxels yet</source>
        <translation>non c'è ancora un progetto di aste o voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/command.py"/>
        <source>there is no design of rods yet</source>
        <translation>non c'è ancora un progetto di aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/command.py"/>
        <source>there is no voxel design yet</source>
        <translation>non c'è ancora un progetto a voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>there is only one analysis</source>
        <translation>c'è una sola analisi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/couplings_section.py"/>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/curve_dialog.py"/>
        <source>total along {}: {} mm³, {} % of the box</source>
        <translation>totale lungo {}: {} mm³, {} % del parallelepipedo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/legend.py"/>
        <source>trabeculae in the layers along {}</source>
        <translation>trabecole negli strati lungo {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>true</source>
        <translation>vero</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>voids ({})</source>
        <translation>vuoti ({})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_layers.py"/>
        <source>voxels in the layer</source>
        <translation>voxel nello strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_figures.py"/>
        <source>yes</source>
        <translation>sì</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>{:.1f} h</source>
        <translation>{:.1f} h</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>{:.3f} against {:.3f}, at most {:.3g} % apart (allowed: {:g} %)</source>
        <translation>{:.3f} contro {:.3f}, distanti al più {:.3g} % (ammesso: {:g} %)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>{:.9g} against {:.9g}, {:.2g} apart (at most {:.2g})</source>
        <translation>{:.9g} contro {:.9g}, distanti {:.2g} (al più {:.2g})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>{} ({:.3g} mm³)</source>
        <translation>{} ({:.3g} mm³)</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/design_form.py"/>
        <source>{} ({} rods{})</source>
        <translation>{} ({} aste{})</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>{} = {:.3f} mm, {} contours</source>
        <translation>{} = {:.3f} mm, {} contorni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/panels.py"/>
        <source>{} belongs to no design yet</source>
        <translation>{} non appartiene ancora a un progetto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/layer_dialog.py"/>
        <source>{} corners: about {}, {} of memory, {} as STEP</source>
        <translation>{} vertici: circa {}, {} di memoria, {} come STEP</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/scaffold_section.py"/>
        <source>{} engine</source>
        <translation>motore {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/notice.py"/>
        <source>{} failed</source>
        <translation>{} è fallito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>{} from the low end, mm</source>
        <translation>{} dall'estremo inferiore, mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>{} has the seed {}</source>
        <translation>{} ha il seme {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/section_dock.py"/>
        <source>{} has too many triangles to be filled</source>
        <translation>{} ha troppi triangoli per essere riempito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/background.py"/>
        <source>{} is being computed: the status bar shows how far it is</source>
        <translation>{} è in corso di calcolo: la barra di stato mostra l'avanzamento</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/notice.py"/>
        <source>{} is done</source>
        <translation>{} è finito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/install.py"/>
        <source>{} is installed.</source>
        <translation>{} è installato.</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <source>{} is up to date and without error</source>
        <translation>{} è aggiornato e senza errori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>{} leave the envelope</source>
        <translation>{} escono dall'involucro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>{} left out</source>
        <translation>{} escluse</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>{} lines that make {} again are on the clipboard</source>
        <translation>{} righe che rifanno {} sono negli appunti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>{} mended</source>
        <translation>{} riparate</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_dock.py"/>
        <source>{} mm², porosity {} %</source>
        <translation>{} mm², porosità {} %</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/work_text.py"/>
        <source>{} of memory</source>
        <translation>{} di memoria</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/results_panel.py"/>
        <source>{} of {} hold</source>
        <translation>{} su {} verificati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/figures.py"/>
        <location filename="../../freecad_trabecula/gui/outcome.py"/>
        <source>{} rods</source>
        <translation>{} aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_plots.py"/>
        <source>{} to {}</source>
        <translation>da {} a {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/document_work.py"/>
        <source>{} was deleted meanwhile</source>
        <translation>{} è stato eliminato nel frattempo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/report_writing.py"/>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>{} was written</source>
        <translation>{} è stato scritto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/export_dialog.py"/>
        <location filename="../../freecad_trabecula/gui/voxel_export.py"/>
        <source>{} was written: {}</source>
        <translation>{} è stato scritto: {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/preferences.py"/>
        <source>{} {}, got {}; {} is taken</source>
        <translation>{} {}, qui {}; si prende {}</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/child_work.py"/>
        <source>{}, a few seconds left</source>
        <translation>{}, ancora qualche secondo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/child_work.py"/>
        <source>{}, about {} h {} min left</source>
        <translation>{}, ancora circa {} h {} min</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/child_work.py"/>
        <source>{}, about {} min left</source>
        <translation>{}, ancora circa {} min</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/child_work.py"/>
        <source>{}, about {} s left</source>
        <translation>{}, ancora circa {} s</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/faces_section.py"/>
        <source>{}, c = {} mm</source>
        <translation>{}, c = {} mm</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/variants_dialog.py"/>
        <source>{}: mean {:.2f}, standard deviation {:.2f}, {:.2f} to {:.2f}, of {} variants</source>
        <translation>{}: media {:.2f}, deviazione standard {:.2f}, da {:.2f} a {:.2f}, di {} varianti</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>{}: next column {}, {} voxels into the rows that need most</source>
        <translation>{}: prossima colonna {}, {} voxel nelle righe che richiedono di più</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>{}: next row {}, {} voxels into the columns that need most</source>
        <translation>{}: prossima riga {}, {} voxel nelle colonne che richiedono di più</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>{}: no design with these numbers any more</source>
        <translation>{}: nessun progetto con questi numeri</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/propagation_dialog.py"/>
        <source>{}: the layer is filled</source>
        <translation>{}: lo strato è pieno</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/table_dialog.py"/>
        <source>{}; {} sums or cells are wrong</source>
        <translation>{}; {} somme o celle sono errate</translation>
    </message>
</context>
<context>
    <name>Trabecula_AnalyseNow</name>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Analyse at once</source>
        <translation>Analizza subito</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Slice a body as its kind asks for and show the plots. Select a scaffold, mesh or solid</source>
        <translation>Sezionare un corpo come richiede il suo tipo e mostrare i grafici. Selezionare uno scaffold, una mesh o un solido</translation>
    </message>
</context>
<context>
    <name>Trabecula_Analysis</name>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Slice analysis</source>
        <translation>Analisi per sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Slice and measure every slice. Select a mesh, a solid, a design or an analysis, or nothing to choose a file</source>
        <translation>Sezionare e misurare ogni sezione. Selezionare una mesh, un solido, un progetto o un'analisi, o nulla per scegliere un file</translation>
    </message>
</context>
<context>
    <name>Trabecula_Body</name>
    <message>
        <location filename="../../freecad_trabecula/gui/start_commands.py"/>
        <source>Body from a file</source>
        <translation>Corpo da un file</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/start_commands.py"/>
        <source>Bring a solid or a mesh into the document: STEP, IGES, BREP, STL, 3MF. Needs nothing</source>
        <translation>Portare un solido o una mesh nel documento: STEP, IGES, BREP, STL, 3MF. Non serve nulla</translation>
    </message>
</context>
<context>
    <name>Trabecula_Colours</name>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Colours</source>
        <translation>Colori</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Give colours a meaning; a legend says which. Select objects, or nothing for all that are seen</source>
        <translation>Dare un significato ai colori; una legenda dice quale. Selezionare oggetti, o nulla per tutti quelli visibili</translation>
    </message>
</context>
<context>
    <name>Trabecula_Compare</name>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Compare analyses</source>
        <translation>Confronta analisi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Show two or more analyses on shared axes, and how near they are. Select them, or none for all</source>
        <translation>Mostrare due o più analisi su assi comuni, e quanto sono vicine. Selezionarle, o nessuna per tutte</translation>
    </message>
</context>
<context>
    <name>Trabecula_CopyScript</name>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>Copy as script</source>
        <translation>Copia come script</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>Copy the Python that makes it again. Select a design or an analysis, or nothing for all of the document</source>
        <translation>Copiare il Python che lo rifà. Selezionare un progetto o un'analisi, o nulla per tutto il documento</translation>
    </message>
</context>
<context>
    <name>Trabecula_Design</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Design a network of rods. Select a solid, or a design to change; with nothing selected a prism is filled</source>
        <translation>Progettare una rete di aste. Selezionare un solido, o un progetto da cambiare; senza selezione si riempie un prisma</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Design rods</source>
        <translation>Progetta aste</translation>
    </message>
</context>
<context>
    <name>Trabecula_EditSite</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Change, move or switch off one site or its pore. Needs a design; select one of several</source>
        <translation>Cambiare, spostare o disattivare un sito o il suo poro. Serve un progetto; selezionarne uno tra più</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Edit site and pore</source>
        <translation>Modifica sito e poro</translation>
    </message>
</context>
<context>
    <name>Trabecula_Export</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Export</source>
        <translation>Esporta</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Write scaffold, channels or rods as STL, STEP, BREP, OBJ, PLY, 3MF, sizes first. Needs a scaffold or a network</source>
        <translation>Scrivere scaffold, canali o aste come STL, STEP, BREP, OBJ, PLY, 3MF, prima le dimensioni. Serve uno scaffold o una rete</translation>
    </message>
</context>
<context>
    <name>Trabecula_FaceSites</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Lay sites on faces. Select a solid, whose faces you pick next, or faces of one</source>
        <translation>Disporre siti su facce. Selezionare un solido, le cui facce si indicano dopo, o alcune sue facce</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Sites on faces</source>
        <translation>Siti sulle facce</translation>
    </message>
</context>
<context>
    <name>Trabecula_Help</name>
    <message>
        <location filename="../../freecad_trabecula/gui/help_commands.py"/>
        <source>Help</source>
        <translation>Aiuto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/help_commands.py"/>
        <source>Show or hide the help: tutorials, commands, files, the method, the glossary. Needs nothing</source>
        <translation>Mostrare o nascondere l'aiuto: guide, comandi, file, metodo, glossario. Non serve nulla</translation>
    </message>
</context>
<context>
    <name>Trabecula_LayerShapes</name>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Layer shapes</source>
        <translation>Forme degli strati</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Make wires or solids of layers, after an estimate. Needs a voxel design; select one of several</source>
        <translation>Fare fili o solidi di strati, dopo una stima. Serve un progetto a voxel; selezionarne uno tra più</translation>
    </message>
</context>
<context>
    <name>Trabecula_MeasureFile</name>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Measure a file</source>
        <translation>Misura un file</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Slice a mesh from a file: STL, OBJ, PLY, 3MF. Needs nothing</source>
        <translation>Sezionare una mesh da un file: STL, OBJ, PLY, 3MF. Non serve nulla</translation>
    </message>
</context>
<context>
    <name>Trabecula_Network</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Build network</source>
        <translation>Costruisci rete</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Build the rods as solids (STEP); no Boolean is needed. Needs a design; select one of several</source>
        <translation>Costruire le aste come solidi (STEP); non serve alcuna operazione booleana. Serve un progetto; selezionarne uno tra più</translation>
    </message>
</context>
<context>
    <name>Trabecula_OpenJob</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Open a job file: all that a design needs. Select nothing: it names its own body</source>
        <translation>Aprire un file di lavoro: tutto ciò che serve a un progetto. Non selezionare nulla: nomina il proprio corpo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Open job</source>
        <translation>Apri lavoro</translation>
    </message>
</context>
<context>
    <name>Trabecula_Plots</name>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Show or hide the profiles of analyses and the slice under the cursor. Select the analyses that are to be shown</source>
        <translation>Mostrare o nascondere i profili delle analisi e la sezione sotto il cursore. Selezionare le analisi da mostrare</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Slices and plots</source>
        <translation>Sezioni e grafici</translation>
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
        <translation>I blocchi conservano esattamente volume e aree; liscia conserva il volume</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Channels</source>
        <translation>Canali</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Colours</source>
        <translation>Colori</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Contours that count as plates, in the picture of a slice</source>
        <translation>Contorni che contano come piastre, nell'immagine di una sezione</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Contours that count as rods, in the picture of a slice</source>
        <translation>Contorni che contano come aste, nell'immagine di una sezione</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Contours: plates</source>
        <translation>Contorni: piastre</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Contours: rods</source>
        <translation>Contorni: aste</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Defaults are read when an object or its panel is made. What is in a document stays as it is; scripts and the command line have their own.</source>
        <translation>I valori predefiniti sono letti quando nasce un oggetto o il suo pannello. Ciò che è in un documento resta com'è; script e riga di comando hanno i propri.</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Design</source>
        <translation>Progetto</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Edge of the voxels of a new design; that of an analysis is its thickness</source>
        <translation>Lato dei voxel di un nuovo progetto; per un'analisi è il suo spessore</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Engine</source>
        <translation>Motore</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Faces of new channels</source>
        <translation>Facce dei nuovi canali</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Faces of new networks of rods</source>
        <translation>Facce delle nuove reti di aste</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Faces of new scaffolds and voxel designs</source>
        <translation>Facce dei nuovi scaffold e progetti a voxel</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Files and work</source>
        <translation>File e lavoro</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Folder for exports</source>
        <translation>Cartella per le esportazioni</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>General</source>
        <translation>Generale</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>How the layers of a new voxel design are filled</source>
        <translation>Come si riempiono gli strati di un nuovo progetto a voxel</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Language, decimal sign and theme are those of FreeCAD (General). A change of language takes full effect when FreeCAD is started again.</source>
        <translation>Lingua, segno decimale e tema sono quelli di FreeCAD (Generale). Un cambio di lingua ha pieno effetto al riavvio di FreeCAD.</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Largest pore</source>
        <translation>Poro massimo</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Lines of new wireframes</source>
        <translation>Linee dei nuovi telai</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>New objects</source>
        <translation>Oggetti nuovi</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>One number reproduces all draws</source>
        <translation>Un solo numero riproduce tutte le estrazioni</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Open the guide with the workbench</source>
        <translation>Aprire la guida con l'ambiente</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Pores of a new design are drawn uniformly between smallest and largest</source>
        <translation>I pori di un nuovo progetto sono estratti uniformemente tra minimo e massimo</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Rods</source>
        <translation>Aste</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Sample</source>
        <translation>Campione</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Scaffold</source>
        <translation>Scaffold</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Seed</source>
        <translation>Seme</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Slice thickness</source>
        <translation>Spessore delle sezioni</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Smallest pore</source>
        <translation>Poro minimo</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Strategy</source>
        <translation>Strategia</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>The design's voxels in the pictures of layers and its curves</source>
        <translation>I voxel del progetto nelle immagini degli strati, e le sue curve</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>The sample's voxels in the pictures of layers and its curves</source>
        <translation>I voxel del campione nelle immagini degli strati, e le sue curve</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Thickness of the layers of a new slice analysis; a voxel design is sliced by its own layers</source>
        <translation>Spessore degli strati di una nuova analisi; un progetto a voxel è sezionato per i suoi strati</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Threads</source>
        <translation>Thread</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Threads that numpy and scipy may use in long work; 0: as many as there are. manifold3d and our own code use one</source>
        <translation>Thread che numpy e scipy possono usare nei lavori lunghi; 0: quanti ce ne sono. manifold3d e il nostro codice ne usano uno</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Voxel size</source>
        <translation>Lato dei voxel</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Voxel surface</source>
        <translation>Superficie dei voxel</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Where dialogs for files to be written open; empty: beside the document</source>
        <translation>Dove si aprono i dialoghi per i file da scrivere; vuoto: accanto al documento</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>Wireframe</source>
        <translation>Telaio</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>automatic</source>
        <translation>automatico</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>best for tables</source>
        <translation>migliori tabelle</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>blocks</source>
        <translation>blocchi</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>by field</source>
        <translation>per campo</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>field</source>
        <translation>campo</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>mesh</source>
        <translation>mesh</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>mesh: exact triangles; field: rays and cells, for many rods; B-Rep: STEP</source>
        <translation>mesh: triangoli esatti; campo: raggi e celle, per molte aste; B-Rep: STEP</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>minimum zeros</source>
        <translation>minimo di zeri</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>random layers</source>
        <translation>strati casuali</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>sequential</source>
        <translation>sequenziale</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>smooth</source>
        <translation>liscia</translation>
    </message>
    <message>
        <location filename="../../resources/ui/preferences.ui"/>
        <source>trabecular</source>
        <translation>trabecolare</translation>
    </message>
</context>
<context>
    <name>Trabecula_Presets</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Designs of the thesis</source>
        <translation>Progetti della tesi</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Start from a design of the thesis. Select nothing: it brings its own body</source>
        <translation>Partire da un progetto della tesi. Non selezionare nulla: porta il proprio corpo</translation>
    </message>
</context>
<context>
    <name>Trabecula_Renew</name>
    <message>
        <location filename="../../freecad_trabecula/gui/start_commands.py"/>
        <source>Bring up to date</source>
        <translation>Aggiorna</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/start_commands.py"/>
        <source>Compute anew what is out of date; analyses and comparisons follow. Needs a design that was changed</source>
        <translation>Ricalcolare ciò che non è aggiornato; analisi e confronti seguono. Serve un progetto cambiato</translation>
    </message>
</context>
<context>
    <name>Trabecula_Results</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Porosity, volumes, counts, recoveries, pore sizes, checks. Needs a design; select one of several</source>
        <translation>Porosità, volumi, conteggi, recuperi, dimensioni dei pori, controlli. Serve un progetto; selezionarne uno tra più</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Results</source>
        <translation>Risultati</translation>
    </message>
</context>
<context>
    <name>Trabecula_RodInfo</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Rod at a click</source>
        <translation>Asta al clic</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Show or hide what is known of a rod. Select one in the 3D view</source>
        <translation>Mostrare o nascondere ciò che si sa di un'asta. Selezionarne una nella vista 3D</translation>
    </message>
</context>
<context>
    <name>Trabecula_SaveAnalyses</name>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Save tables and plots</source>
        <translation>Salva tabelle e grafici</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/analysis_commands.py"/>
        <source>Write tables, report and plots into a folder; of several their comparison. Select analyses, or none for all</source>
        <translation>Scrivere tabelle, relazione e grafici in una cartella; di più analisi il confronto. Selezionare analisi, o nessuna per tutte</translation>
    </message>
</context>
<context>
    <name>Trabecula_SaveJob</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Save job</source>
        <translation>Salva lavoro</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Save the design as a job file, which the command line runs too. Needs a design; select one of several</source>
        <translation>Salvare il progetto come file di lavoro, che anche la riga di comando esegue. Serve un progetto; selezionarne uno tra più</translation>
    </message>
</context>
<context>
    <name>Trabecula_Scaffold</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Build scaffold</source>
        <translation>Costruisci scaffold</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Cut the channels out of the envelope: scaffold, channels, porosity. Needs a design; select one of several</source>
        <translation>Tagliare i canali dall'involucro: scaffold, canali, porosità. Serve un progetto; selezionarne uno tra più</translation>
    </message>
</context>
<context>
    <name>Trabecula_Section</name>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Cut the 3D view open along X, Y, Z or as you look at it. Needs a document; the document does not change</source>
        <translation>Aprire la vista 3D con un taglio lungo X, Y, Z o come si guarda. Serve un documento; il documento non cambia</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Section plane</source>
        <translation>Piano di taglio</translation>
    </message>
</context>
<context>
    <name>Trabecula_Sights</name>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Look through</source>
        <translation>Trasparenza</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/seeing_commands.py"/>
        <source>Solid, in a glass envelope, or as an X-ray. Select a design, or nothing for all</source>
        <translation>Solido, in un involucro di vetro, o ai raggi X. Selezionare un progetto, o nulla per tutti</translation>
    </message>
</context>
<context>
    <name>Trabecula_Start</name>
    <message>
        <location filename="../../freecad_trabecula/gui/start_commands.py"/>
        <source>Show or hide the guide: three ways to work, step by step, and examples. Needs nothing</source>
        <translation>Mostrare o nascondere la guida: tre modi di lavorare, passo per passo, ed esempi. Non serve nulla</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/start_commands.py"/>
        <source>Start</source>
        <translation>Avvio</translation>
    </message>
</context>
<context>
    <name>Trabecula_Switch</name>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Rods or channels</source>
        <translation>Aste o canali</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/rod_commands.py"/>
        <source>Show rods or channels: two views of one wireframe. Needs a scaffold</source>
        <translation>Mostrare aste o canali: due viste di un solo telaio. Serve uno scaffold</translation>
    </message>
</context>
<context>
    <name>Trabecula_Variants</name>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>Make the design again with 10 other seeds, side by side with their spread. Select a design or voxels</source>
        <translation>Rifare il progetto con altri 10 semi, affiancati con la loro dispersione. Selezionare un progetto o voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>Other seeds</source>
        <translation>Altri semi</translation>
    </message>
</context>
<context>
    <name>Trabecula_VoxelExport</name>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Export voxels</source>
        <translation>Esporta voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Write mesh, voxels or images of layers; sizes are shown first. Needs a voxel design; select one of several</source>
        <translation>Scrivere mesh, voxel o immagini degli strati; prima le dimensioni. Serve un progetto a voxel; selezionarne uno tra più</translation>
    </message>
</context>
<context>
    <name>Trabecula_VoxelLayers</name>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Show or hide the layers of sample and design with their counts. Select a voxel design, or nothing for the last</source>
        <translation>Mostrare o nascondere gli strati di campione e progetto con i conteggi. Selezionare un progetto a voxel, o nulla per l'ultimo</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Voxel layers</source>
        <translation>Strati di voxel</translation>
    </message>
</context>
<context>
    <name>Trabecula_VoxelTables</name>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>See, edit, read and write the tables alpha and beta. Needs a voxel design; select one of several</source>
        <translation>Vedere, modificare, leggere e scrivere le tabelle alpha e beta. Serve un progetto a voxel; selezionarne uno tra più</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Tables</source>
        <translation>Tabelle</translation>
    </message>
</context>
<context>
    <name>Trabecula_Voxels</name>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Design voxels</source>
        <translation>Progetta voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Design voxels with the sliced areas of a sample along X, Y and Z. Select a body, an analysis or a voxel design</source>
        <translation>Progettare voxel con le aree sezionate di un campione lungo X, Y e Z. Selezionare un corpo, un'analisi o un progetto a voxel</translation>
    </message>
</context>
<context>
    <name>Trabecula_WatchLayer</name>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Watch a layer</source>
        <translation>Osserva uno strato</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/voxel_commands.py"/>
        <source>Watch how a layer is filled, step by step. Select a voxel design for its layers, or nothing for own numbers</source>
        <translation>Osservare passo per passo come si riempie uno strato. Selezionare un progetto a voxel per i suoi strati, o nulla per numeri propri</translation>
    </message>
</context>
<context>
    <name>Trabecula_WriteReport</name>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>Write all of the document into one HTML page and open it. Needs a scaffold, an analysis or voxels</source>
        <translation>Scrivere tutto il documento in una pagina HTML e aprirla. Serve uno scaffold, un'analisi o voxel</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/study_commands.py"/>
        <source>Write report</source>
        <translation>Scrivi relazione</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>&amp;Help</source>
        <translation>&amp;Aiuto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>&amp;Rods</source>
        <translation>&amp;Aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>&amp;Slices</source>
        <translation>&amp;Sezioni</translation>
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
        <translation>&amp;Vista</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>S&amp;tudy</source>
        <translation>S&amp;tudio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>Trabecula</source>
        <translation>Trabecula</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>Trabecula help</source>
        <translation>Trabecula: aiuto</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>Trabecula rods</source>
        <translation>Trabecula: aste</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>Trabecula seeing</source>
        <translation>Trabecula: vista</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>Trabecula slices</source>
        <translation>Trabecula: sezioni</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>Trabecula study</source>
        <translation>Trabecula: studio</translation>
    </message>
    <message>
        <location filename="../../freecad_trabecula/gui/commands.py"/>
        <source>Trabecula voxels</source>
        <translation>Trabecula: voxel</translation>
    </message>
</context>
</TS>
