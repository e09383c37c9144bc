<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr">
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>Drive</source>
        <translation>Lecteur</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Raccourci</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Inconnu</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Drive</source>
        <translation>Lecteur</translation>
    </message>
    <message>
        <source>Change to detail view mode</source>
        <translation>Afficher les détails</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Ne pas enregistrer</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
</context>
<context>
    <name>edits</name>
    <message>
        <source>correct the start angle</source>
        <translation>correction de l’angle de départ</translation>
    </message>
    <message>
        <source>set the edition of the test</source>
        <translation>définition de l’édition de l’essai</translation>
    </message>
    <message>
        <source>choose what the report has</source>
        <translation>choix du contenu du rapport</translation>
    </message>
    <message>
        <source>change the nominal radius</source>
        <translation>modification du rayon nominal</translation>
    </message>
    <message>
        <source>change the contouring feed</source>
        <translation>modification de la vitesse d’avance de contournage</translation>
    </message>
    <message>
        <source>change the source of the signal</source>
        <translation>modification de la source du signal</translation>
    </message>
    <message>
        <source>change the reference circle</source>
        <translation>modification du cercle de référence</translation>
    </message>
    <message>
        <source>change the centring</source>
        <translation>modification du centrage</translation>
    </message>
    <message>
        <source>change what the angles are</source>
        <translation>modification de la nature des angles</translation>
    </message>
    <message>
        <source>change the sense of an arc</source>
        <translation>modification du sens d’un arc</translation>
    </message>
    <message>
        <source>change the order of the arcs</source>
        <translation>modification de l’ordre des arcs</translation>
    </message>
    <message>
        <source>change the evaluated range of an arc</source>
        <translation>modification de l’étendue évaluée d’un arc</translation>
    </message>
    <message>
        <source>change the plane</source>
        <translation>modification du plan</translation>
    </message>
    <message>
        <source>plan the targets</source>
        <translation>planification des points visés</translation>
    </message>
    <message>
        <source>add a planned test</source>
        <translation>ajout d’un essai planifié</translation>
    </message>
    <message>
        <source>change a point to agree</source>
        <translation>modification d’un point à convenir</translation>
    </message>
    <message>
        <source>take an agreement from the conditions</source>
        <translation>reprise d’un accord des conditions</translation>
    </message>
    <message>
        <source>remove a sensor</source>
        <translation>suppression d’un capteur</translation>
    </message>
    <message>
        <source>add a sensor</source>
        <translation>ajout d’un capteur</translation>
    </message>
    <message>
        <source>change the instruments of the test</source>
        <translation>modification des instruments de l’essai</translation>
    </message>
    <message>
        <source>remove the picture</source>
        <translation>suppression de l’image</translation>
    </message>
    <message>
        <source>choose a picture</source>
        <translation>choix d’une image</translation>
    </message>
    <message>
        <source>change who signs</source>
        <translation>modification des signataires</translation>
    </message>
    <message>
        <source>add an instrument</source>
        <translation>ajout d’un instrument</translation>
    </message>
    <message>
        <source>remove an instrument</source>
        <translation>suppression d’un instrument</translation>
    </message>
    <message>
        <source>fill from a template</source>
        <translation>remplissage depuis un modèle</translation>
    </message>
    <message>
        <source>change “%1”</source>
        <translation>modification de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>type a reading</source>
        <translation>saisie d’un relevé</translation>
    </message>
    <message>
        <source>move a target</source>
        <translation>déplacement d’un point visé</translation>
    </message>
    <message numerus="yes">
        <source>clear %n reading(s)</source>
        <translation>
            <numerusform>effacement de %n relevé</numerusform>
            <numerusform>effacement de %n relevés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>set %n reading(s) aside</source>
        <translation>
            <numerusform>mise à l’écart de %n relevé</numerusform>
            <numerusform>mise à l’écart de %n relevés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>take %n reading(s) back</source>
        <translation>
            <numerusform>reprise de %n relevé</numerusform>
            <numerusform>reprise de %n relevés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>fill %n reading(s)</source>
        <translation>
            <numerusform>recopie de %n relevé</numerusform>
            <numerusform>recopie de %n relevés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>paste of %n reading(s)</source>
        <translation>
            <numerusform>collage de %n relevé</numerusform>
            <numerusform>collage de %n relevés</numerusform>
        </translation>
    </message>
    <message>
        <source>insert a target</source>
        <translation>insertion d’un point visé</translation>
    </message>
    <message numerus="yes">
        <source>delete %n target(s)</source>
        <translation>
            <numerusform>suppression de %n point visé</numerusform>
            <numerusform>suppression de %n points visés</numerusform>
        </translation>
    </message>
    <message>
        <source>add a run</source>
        <translation>ajout d’une passe</translation>
    </message>
    <message>
        <source>insert a run</source>
        <translation>insertion d’une passe</translation>
    </message>
    <message numerus="yes">
        <source>delete %n run(s)</source>
        <translation>
            <numerusform>suppression de %n passe</numerusform>
            <numerusform>suppression de %n passes</numerusform>
        </translation>
    </message>
    <message>
        <source>add a test</source>
        <translation>ajout d’un essai</translation>
    </message>
    <message>
        <source>rename the test</source>
        <translation>changement du nom de l’essai</translation>
    </message>
    <message>
        <source>duplicate the test</source>
        <translation>duplication de l’essai</translation>
    </message>
    <message>
        <source>repeat the test</source>
        <translation>nouvel essai semblable</translation>
    </message>
    <message>
        <source>delete the test</source>
        <translation>suppression de l’essai</translation>
    </message>
    <message numerus="yes">
        <source>cut %n reading(s)</source>
        <translation>
            <numerusform>coupure de %n relevé</numerusform>
            <numerusform>coupure de %n relevés</numerusform>
        </translation>
    </message>
    <message>
        <source>import a measurement file</source>
        <translation>importation d’un fichier de mesure</translation>
    </message>
    <message numerus="yes">
        <source>add %n arc(s)</source>
        <translation>
            <numerusform>ajout de %n arc</numerusform>
            <numerusform>ajout de %n arcs</numerusform>
        </translation>
    </message>
    <message>
        <source>change a point</source>
        <translation>modification d’un point</translation>
    </message>
    <message>
        <source>delete an arc</source>
        <translation>suppression d’un arc</translation>
    </message>
    <message>
        <source>change a reading</source>
        <translation>modification d’un relevé</translation>
    </message>
    <message>
        <source>paste readings</source>
        <translation>collage de relevés</translation>
    </message>
    <message>
        <source>remove readings</source>
        <translation>suppression de relevés</translation>
    </message>
    <message>
        <source>take a typical value</source>
        <translation>reprise d’une valeur usuelle</translation>
    </message>
    <message>
        <source>add a drift test</source>
        <translation>ajout d’un essai de dérive</translation>
    </message>
    <message>
        <source>state what an arc leaves out</source>
        <translation>indication de la partie non évaluée d’un arc</translation>
    </message>
    <message>
        <source>declare what was not declared</source>
        <translation>déclaration de ce qui n’était pas déclaré</translation>
    </message>
    <message>
        <source>paste limits</source>
        <translation>coller des limites</translation>
    </message>
    <message>
        <source>paste a block</source>
        <translation>collage d’un bloc</translation>
    </message>
    <message>
        <source>confirm the sign of the deviations</source>
        <translation>confirmer le signe des écarts</translation>
    </message>
    <message>
        <source>change the acceptance sheet</source>
        <translation>modification de la fiche de réception</translation>
    </message>
    <message>
        <source>paste rows</source>
        <translation>collage de lignes</translation>
    </message>
    <message>
        <source>add a row</source>
        <translation>ajout d’une ligne</translation>
    </message>
    <message>
        <source>remove rows</source>
        <translation>suppression de lignes</translation>
    </message>
    <message>
        <source>fill like the last test</source>
        <translation>remplissage d’après le dernier essai</translation>
    </message>
    <message>
        <source>choose the test to compare with</source>
        <translation>choisir l’essai de comparaison</translation>
    </message>
    <message>
        <source>take E_VE from a drift test</source>
        <translation>prendre l’E_VE d’un essai de dérive</translation>
    </message>
</context>
<context>
    <name>examples</name>
    <message>
        <source>X axis, published example</source>
        <translation>Axe X, exemple publié</translation>
    </message>
    <message>
        <source>Long axis, with its zone</source>
        <translation>Axe long, avec sa zone</translation>
    </message>
    <message>
        <source>Z axis, from one direction</source>
        <translation>Axe Z, dans un seul sens</translation>
    </message>
    <message>
        <source>Rotary table C, 360°</source>
        <translation>Table rotative C, 360°</translation>
    </message>
    <message>
        <source>Centre off</source>
        <translation>Centre décalé</translation>
    </message>
    <message>
        <source>Scale mismatch</source>
        <translation>Différence d’échelle</translation>
    </message>
    <message>
        <source>Squareness</source>
        <translation>Perpendicularité</translation>
    </message>
    <message>
        <source>Servo mismatch</source>
        <translation>Défaut de servo</translation>
    </message>
    <message>
        <source>Backlash</source>
        <translation>Jeu à l’inversion</translation>
    </message>
    <message>
        <source>Lateral play</source>
        <translation>Jeu latéral</translation>
    </message>
    <message>
        <source>Straightness</source>
        <translation>Rectitude</translation>
    </message>
    <message>
        <source>Periodic deviation</source>
        <translation>Écart périodique</translation>
    </message>
    <message>
        <source>Reversal spike</source>
        <translation>Pic de réversibilité</translation>
    </message>
    <message>
        <source>Common lag, three feeds</source>
        <translation>Retard commun, trois avances</translation>
    </message>
    <message>
        <source>YZ plane, feedback signal</source>
        <translation>Plan YZ, signal de retour</translation>
    </message>
    <message>
        <source>XY plane, full circles</source>
        <translation>Plan XY, cercles complets</translation>
    </message>
    <message>
        <source>ZX plane, partial arc</source>
        <translation>Plan ZX, arc partiel</translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n arc(s), %2 points</source>
        <translation>
            <numerusform>%1 · %n arc, %2 points</numerusform>
            <numerusform>%1 · %n arcs, %2 points</numerusform>
        </translation>
    </message>
    <message>
        <source>Vibration in the rest</source>
        <translation>Vibration dans le reste</translation>
    </message>
    <message numerus="yes">
        <source>%1 · %2 targets, %n run(s)</source>
        <translation>
            <numerusform>%1 · %2 points, %n passe</numerusform>
            <numerusform>%1 · %2 points, %n passes</numerusform>
        </translation>
    </message>
    <message>
        <source>As found and as left</source>
        <translation>Avant et après réglage</translation>
    </message>
    <message>
        <source>Type test, eight machines</source>
        <translation>Essai de type, 8 machines</translation>
    </message>
</context>
<context>
    <name>palmer::ui::AgreedPointsPage</name>
    <message>
        <source>settled</source>
        <translation>réglé</translation>
    </message>
    <message>
        <source>Agreed</source>
        <translation>Convenu</translation>
    </message>
    <message>
        <source>Not agreed</source>
        <translation>Non convenu</translation>
    </message>
    <message>
        <source>Not applicable</source>
        <translation>Sans objet</translation>
    </message>
    <message>
        <source>text of the agreement</source>
        <translation>texte de l’accord</translation>
    </message>
    <message>
        <source>Text of an agreement</source>
        <translation>Texte d’un accord</translation>
    </message>
    <message>
        <source>take from the conditions</source>
        <translation>reprendre des conditions</translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 points to be agreed</source>
        <translation>
            <numerusform>%n point sur %1 à convenir</numerusform>
            <numerusform>%n points sur %1 à convenir</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 characters, where a test file holds no more than %2: the text before is kept.</source>
        <translation>%1 caractères, alors qu’un fichier d’essai en admet %2 au plus&#xa0;: le texte précédent est conservé.</translation>
    </message>
    <message>
        <source>Not declared</source>
        <translation>Non déclaré</translation>
    </message>
    <message>
        <source>Number of an agreement</source>
        <translation>Valeur d’un accord</translation>
    </message>
    <message>
        <source>%1: number</source>
        <translation>%1&#xa0;: valeur</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) that do not apply</source>
        <translation>
            <numerusform>%n point sans objet</numerusform>
            <numerusform>%n points sans objet</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::ArcCurvesView</name>
    <message>
        <source>Δr %1, least squares centre</source>
        <translation>Δr %1, centre des moindres carrés</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ArcDialog</name>
    <message>
        <source>New arc</source>
        <translation>Nouvel arc</translation>
    </message>
    <message>
        <source>One point a line, for example angle and radial deviation:</source>
        <translation>Un point par ligne, par exemple angle et écart radial&#xa0;:</translation>
    </message>
    <message>
        <source>Headings may name columns, units and sense.</source>
        <translation>Des titres peuvent nommer les colonnes, les unités et le sens.</translation>
    </message>
    <message>
        <source>&amp;Table of points</source>
        <translation>&amp;Tableau des points</translation>
    </message>
    <message>
        <source>as recognised</source>
        <translation>comme reconnu</translation>
    </message>
    <message>
        <source>Co&amp;lumns</source>
        <translation>&amp;Colonnes</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>&amp;Unité</translation>
    </message>
    <message>
        <source>&amp;Decimal mark</source>
        <translation>Séparateur &amp;décimal</translation>
    </message>
    <message>
        <source>&amp;Sense</source>
        <translation>&amp;Sens</translation>
    </message>
    <message>
        <source>An&amp;gles</source>
        <translation>An&amp;gles</translation>
    </message>
    <message>
        <source>Sta&amp;rt angle</source>
        <translation>Angle de dépa&amp;rt</translation>
    </message>
    <message>
        <source>&amp;Extent of the arc</source>
        <translation>&amp;Étendue de l’arc</translation>
    </message>
    <message>
        <source>The extent of an arc is a number of degrees above 0.</source>
        <translation>L’étendue d’un arc est un nombre de degrés supérieur à 0.</translation>
    </message>
    <message>
        <source>%1, %2 points: %3 … %4</source>
        <comment>sense of a path</comment>
        <translation>%1, %2 points&#xa0;: %3 … %4</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Add %n point(s)</source>
        <translation>
            <numerusform>&amp;Ajouter %n point</numerusform>
            <numerusform>&amp;Ajouter %n points</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Ajouter</translation>
    </message>
    <message>
        <source>Questions and remarks</source>
        <translation>Questions et remarques</translation>
    </message>
    <message>
        <source>Con&amp;firm all</source>
        <translation>Tout con&amp;firmer</translation>
    </message>
    <message numerus="yes">
        <source>%n question(s) to answer</source>
        <translation>
            <numerusform>%n question en attente de réponse</numerusform>
            <numerusform>%n questions en attente de réponse</numerusform>
        </translation>
    </message>
    <message>
        <source>read as %1, in %2</source>
        <comment>columns, unit</comment>
        <translation>lu comme %1, en %2</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ArcsModel</name>
    <message>
        <source>repetition</source>
        <translation>répétition</translation>
    </message>
    <message>
        <source>evaluated</source>
        <translation>évalué</translation>
    </message>
    <message>
        <source>Measured but not evaluated: feed-in, feed-out, angular overshoot</source>
        <translation>Mesuré mais non évalué&#xa0;: approche, dégagement, dépassement angulaire</translation>
    </message>
    <message>
        <source>Radius of the least squares circle − nominal radius</source>
        <translation>Rayon du cercle des moindres carrés − rayon nominal</translation>
    </message>
    <message>
        <source>Of each sense the first arc is evaluated; further ones are repetitions</source>
        <translation>De chaque sens, le premier arc est évalué&#x202f;; les suivants sont des répétitions</translation>
    </message>
    <message>
        <source>points</source>
        <translation>points</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>coupé</translation>
    </message>
    <message>
        <source>use</source>
        <translation>emploi</translation>
    </message>
    <message>
        <source>R_LSC − R %1</source>
        <comment>unit</comment>
        <translation>R_LSC − R %1</translation>
    </message>
</context>
<context>
    <name>palmer::ui::CircleFigureView</name>
    <message>
        <source>Combined</source>
        <translation>Combinée</translation>
    </message>
    <message>
        <source>G(b) and G side by side</source>
        <translation>G(b) et G côte à côte</translation>
    </message>
    <message>
        <source>Which figure</source>
        <translation>Choix de la figure</translation>
    </message>
    <message>
        <source>All paths in one figure, or the figures of the standard about their own centres</source>
        <translation>Toutes les trajectoires en une figure, ou les figures de la norme, chacune autour de son centre</translation>
    </message>
    <message>
        <source>Show the path anticlockwise</source>
        <translation>Afficher la trajectoire en sens antihoraire</translation>
    </message>
    <message>
        <source>Show the path clockwise</source>
        <translation>Afficher la trajectoire en sens horaire</translation>
    </message>
    <message>
        <source>Show repeated paths</source>
        <translation>Afficher les trajectoires répétées</translation>
    </message>
    <message>
        <source>Circle figure</source>
        <translation>Figure de circularité</translation>
    </message>
    <message>
        <source>Plus and minus zoom, arrows move, 0 shows the whole; the wheel zooms</source>
        <translation>Plus et moins agrandissent et réduisent, les flèches déplacent, 0 montre tout&#x202f;; la molette agrandit et réduit</translation>
    </message>
</context>
<context>
    <name>palmer::ui::CirclesPage</name>
    <message>
        <source>Contouring feed</source>
        <translation>Avance de contournage</translation>
    </message>
    <message>
        <source>%1, point %2: %3 · %4</source>
        <translation>%1, point %2&#xa0;: %3 · %4</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Reference circle of G</source>
        <translation>Cercle de référence de G</translation>
    </message>
    <message>
        <source>Centring for F</source>
        <translation>Centrage pour F</translation>
    </message>
    <message>
        <source>external</source>
        <translation>externe</translation>
    </message>
    <message>
        <source>minimum zone (MZC)</source>
        <translation>zone minimale (MZC)</translation>
    </message>
    <message>
        <source>least squares (LSC)</source>
        <translation>moindres carrés (LSC)</translation>
    </message>
    <message>
        <source>of the point (polar)</source>
        <translation>du point (polaire)</translation>
    </message>
    <message>
        <source>commanded</source>
        <translation>commandé</translation>
    </message>
    <message>
        <source>The circles the width of which is G</source>
        <translation>Les cercles dont l’écartement est G</translation>
    </message>
    <message>
        <source>About which centre F is measured</source>
        <translation>Centre par rapport auquel F est mesuré</translation>
    </message>
    <message>
        <source>Whether the angles are those of the measured points or of the programmed path</source>
        <translation>Les angles sont ceux des points mesurés ou ceux de la trajectoire programmée</translation>
    </message>
    <message>
        <source>Evaluated</source>
        <translation>Évalué</translation>
    </message>
    <message>
        <source>Evaluated range, from</source>
        <translation>Étendue évaluée, de</translation>
    </message>
    <message>
        <source>Evaluated range, to</source>
        <translation>Étendue évaluée, à</translation>
    </message>
    <message>
        <source>Whole arc</source>
        <translation>Arc entier</translation>
    </message>
    <message>
        <source>Evaluate all of the arc, of more than 360° the middle 360°</source>
        <translation>Évaluer tout l’arc&#x202f;; au-delà de 360°, les 360° du milieu</translation>
    </message>
    <message>
        <source>Reverse sense</source>
        <translation>Inverser le sens</translation>
    </message>
    <message>
        <source>The arc was contoured in the other sense; the points stay as they are</source>
        <translation>L’arc a été parcouru dans l’autre sens&#x202f;; les points restent tels quels</translation>
    </message>
    <message>
        <source>Move the arc up: it was measured earlier</source>
        <translation>Monter l’arc&#xa0;: il a été mesuré plus tôt</translation>
    </message>
    <message>
        <source>Move the arc down: it was measured later</source>
        <translation>Descendre l’arc&#xa0;: il a été mesuré plus tard</translation>
    </message>
    <message>
        <source>Show radial deviations</source>
        <translation>Afficher les écarts radiaux</translation>
    </message>
    <message>
        <source>Show the points in the coordinates of the plane; the data stay as they are</source>
        <translation>Afficher les points en coordonnées du plan&#x202f;; les données restent telles quelles</translation>
    </message>
    <message>
        <source>Show distances from the centre; the data stay as they are</source>
        <translation>Afficher les distances au centre&#x202f;; les données restent telles quelles</translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation>Arcs</translation>
    </message>
    <message>
        <source>Radial deviation over the angle</source>
        <translation>Écart radial en fonction de l’angle</translation>
    </message>
    <message>
        <source>The handles set the evaluated range of the current arc; the fields above set it by number</source>
        <translation>Les poignées règlent l’étendue évaluée de l’arc courant&#x202f;; les champs au-dessus la règlent par nombre</translation>
    </message>
    <message>
        <source>a point needs a number</source>
        <translation>il faut un nombre pour un point</translation>
    </message>
    <message>
        <source>Paste &amp;or type an arc…</source>
        <translation>Ajouter un arc (&amp;tableau)…</translation>
    </message>
    <message>
        <source>Delete t&amp;he arc</source>
        <translation>Supprimer l’arc c&amp;hoisi</translation>
    </message>
    <message>
        <source>New arc…</source>
        <translation>Nouvel arc…</translation>
    </message>
    <message>
        <source>New arc</source>
        <translation>Nouvel arc</translation>
    </message>
    <message>
        <source>Add arcs from a table, typed or pasted (%1)</source>
        <translation>Ajouter des arcs depuis un tableau, saisi ou collé (%1)</translation>
    </message>
    <message>
        <source>No arc yet. Copy the points in a spreadsheet and press %1, or type them with “New arc…”.</source>
        <translation>Pas encore d’arc. Copiez les points dans un tableur et appuyez sur %1, ou saisissez-les par «&#xa0;Nouvel arc…&#xa0;».</translation>
    </message>
    <message>
        <source>Delete the arc (%1)</source>
        <translation>Supprimer l’arc (%1)</translation>
    </message>
    <message>
        <source>Coordinates %1</source>
        <comment>unit</comment>
        <translation>Coordonnées %1</translation>
    </message>
    <message>
        <source>Lengths %1</source>
        <comment>unit</comment>
        <translation>Longueurs %1</translation>
    </message>
    <message>
        <source>a circle needs a nominal radius</source>
        <translation>un cercle a besoin d’un rayon nominal</translation>
    </message>
    <message>
        <source>not greater than 0</source>
        <translation>pas supérieur à 0</translation>
    </message>
    <message>
        <source>the range needs both ends</source>
        <translation>l’étendue a besoin de ses deux extrémités</translation>
    </message>
    <message>
        <source>not below the upper end of the range</source>
        <translation>pas inférieur à la fin de l’étendue</translation>
    </message>
    <message>
        <source>not above the lower end of the range</source>
        <translation>pas supérieur au début de l’étendue</translation>
    </message>
    <message>
        <source>What the evaluated range leaves out: feed-in, overshoot…</source>
        <translation>Ce que la plage évaluée laisse de côté&#xa0;: entrée, dépassement…</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>partie exclue</translation>
    </message>
    <message>
        <source>&amp;Import a ballbar file…</source>
        <translation>&amp;Importer un fichier de ballbar…</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ColumnRoles</name>
    <message>
        <source>not read</source>
        <translation>non lue</translation>
    </message>
    <message>
        <source>target</source>
        <translation>point visé</translation>
    </message>
    <message>
        <source>position</source>
        <translation>position</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>écart</translation>
    </message>
    <message>
        <source>run</source>
        <translation>passe</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>sens</translation>
    </message>
    <message>
        <source>run number</source>
        <translation>n°&#xa0;de passe</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>angle</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>rayon</translation>
    </message>
    <message>
        <source>x coordinate</source>
        <translation>coordonnée x</translation>
    </message>
    <message>
        <source>y coordinate</source>
        <translation>coordonnée y</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>température</translation>
    </message>
    <message>
        <source>nominal value</source>
        <translation>valeur nominale</translation>
    </message>
    <message>
        <source>statistic</source>
        <translation>statistique</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>colonne %1</translation>
    </message>
    <message>
        <source>What the column “%1” is; click to change it</source>
        <translation>Ce qu’est la colonne «&#xa0;%1&#xa0;»&#x202f;; cliquer pour le changer</translation>
    </message>
</context>
<context>
    <name>palmer::ui::CompareDialog</name>
    <message>
        <source>This file has no other test of this kind: add a file.</source>
        <translation>Ce fichier n’a pas d’autre essai de ce genre&#xa0;: ajoutez un fichier.</translation>
    </message>
    <message>
        <source>%1 has no test of this kind.</source>
        <translation>%1 n’a pas d’essai de ce genre.</translation>
    </message>
    <message>
        <source>%1 cannot be opened</source>
        <translation>%1 ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>Compare with the tests of a file</source>
        <translation>Comparer aux essais d’un fichier</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>&amp;Editions</source>
        <translation>&amp;Éditions</translation>
    </message>
    <message>
        <source>&amp;Tests</source>
        <translation>E&amp;ssais</translation>
    </message>
    <message>
        <source>&amp;Add a file…</source>
        <translation>&amp;Ajouter un fichier…</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>Cop&amp;ier</translation>
    </message>
    <message>
        <source>Copy the table for a spreadsheet</source>
        <translation>Copier le tableau pour un tableur</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Editions</source>
        <translation>Éditions</translation>
    </message>
    <message>
        <source>Results by edition</source>
        <translation>Résultats par édition</translation>
    </message>
    <message>
        <source>Results by test</source>
        <translation>Résultats par essai</translation>
    </message>
    <message>
        <source>Tests and measurements (%1)</source>
        <translation>Essais et mesures (%1)</translation>
    </message>
    <message>
        <source>Deviations of the tests over one another</source>
        <translation>Écarts des essais superposés</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>grandeur</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ComparisonPage</name>
    <message>
        <source>Another file…</source>
        <translation>Un autre fichier…</translation>
    </message>
    <message>
        <source>Agreed tolerance, %1</source>
        <translation>Tolérance convenue, %1</translation>
    </message>
    <message>
        <source>%1 has no test like this one</source>
        <translation>%1 n’a pas d’essai comparable à celui-ci</translation>
    </message>
    <message>
        <source>A comparison needs the same axis or plane, directions and radius.</source>
        <translation>Une comparaison demande le même axe ou plan, les mêmes sens et le même rayon.</translation>
    </message>
    <message>
        <source>%1 cannot be opened</source>
        <translation>%1 ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>Compare with the test of a file</source>
        <translation>Comparer à l’essai d’un fichier</translation>
    </message>
    <message>
        <source>Tests and measurements (%1)</source>
        <translation>Essais et mesures (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Choose the test to compare with: of this file, such as the one as found or that before a repair, or of another file. The report then has a page of the comparison.</source>
        <translation>Choisissez l’essai de comparaison&#xa0;: un essai de ce fichier, comme l’essai avant réglage ou avant réparation, ou celui d’un autre fichier. Le rapport a alors une page de comparaison.</translation>
    </message>
    <message>
        <source>The two tests are being compared…</source>
        <translation>Comparaison des deux essais en cours…</translation>
    </message>
    <message>
        <source>A test of another file is not part of the report.</source>
        <translation>L’essai d’un autre fichier n’entre pas dans le rapport.</translation>
    </message>
    <message>
        <source>Compared with</source>
        <translation>Comparé à</translation>
    </message>
    <message>
        <source>before − after</source>
        <translation>avant − après</translation>
    </message>
    <message>
        <source>set-up untouched</source>
        <translation>montage inchangé</translation>
    </message>
    <message>
        <source>The instrument stood as it had been aligned for the other test: its misalignment is shared</source>
        <translation>L’instrument est resté tel qu’aligné pour l’autre essai&#xa0;: son défaut d’alignement est commun</translation>
    </message>
    <message>
        <source>Up to this a change is of no consequence; empty: none was agreed</source>
        <translation>Jusqu’à cette valeur un changement est sans conséquence&#x202f;; vide&#xa0;: aucune convenue</translation>
    </message>
    <message>
        <source>Copy the table for a spreadsheet</source>
        <translation>Copier le tableau pour un tableur</translation>
    </message>
    <message>
        <source>no test</source>
        <comment>to compare with</comment>
        <translation>aucun essai</translation>
    </message>
    <message>
        <source>not greater than 0</source>
        <translation>pas supérieur à 0</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ComparisonSide</name>
    <message>
        <source>Both tests</source>
        <translation>Les deux essais</translation>
    </message>
    <message numerus="yes">
        <source>%n common target(s)</source>
        <translation>
            <numerusform>%n point commun</numerusform>
            <numerusform>%n points communs</numerusform>
        </translation>
    </message>
    <message>
        <source>Uncertainty of the difference</source>
        <translation>Incertitude de la différence</translation>
    </message>
</context>
<context>
    <name>palmer::ui::CompensationDialog</name>
    <message>
        <source>From (empty: first target)</source>
        <translation>De (vide&#xa0;: premier point visé)</translation>
    </message>
    <message>
        <source>To (empty: last target)</source>
        <translation>À (vide&#xa0;: dernier point visé)</translation>
    </message>
    <message>
        <source>Interval (empty: the targets)</source>
        <translation>Intervalle (vide&#xa0;: les points visés)</translation>
    </message>
    <message>
        <source>After %1, from the table as it is written.</source>
        <translation>Selon %1, d’après la table telle qu’elle est écrite.</translation>
    </message>
    <message>
        <source>Save the compensation table</source>
        <translation>Enregistrer la table de compensation</translation>
    </message>
    <message>
        <source>%1 cannot be saved</source>
        <translation>%1 ne peut pas être enregistré</translation>
    </message>
    <message>
        <source>Compensation table</source>
        <translation>Table de compensation</translation>
    </message>
    <message>
        <source>any (CSV)</source>
        <translation>autre (CSV)</translation>
    </message>
    <message>
        <source>Sign of the values</source>
        <translation>Signe des valeurs</translation>
    </message>
    <message>
        <source>corrections, added to the command</source>
        <translation>corrections, ajoutées à la consigne</translation>
    </message>
    <message>
        <source>&amp;Each direction apart</source>
        <translation>Chaque &amp;sens à part</translation>
    </message>
    <message>
        <source>&amp;Incremental values</source>
        <translation>Valeurs &amp;incrémentales</translation>
    </message>
    <message>
        <source>Means, measured and predicted</source>
        <translation>Moyennes mesurées et prévues</translation>
    </message>
    <message>
        <source>What is written</source>
        <translation>Ce qui est écrit</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>Prévision</translation>
    </message>
    <message>
        <source>&amp;Save the table…</source>
        <translation>&amp;Enregistrer la table…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Reference point of the axis</source>
        <translation>Point de référence de l’axe</translation>
    </message>
    <message>
        <source>%1 (%2): the largest difference, written − compared, is %3 at %4 %5.</source>
        <translation>%1 (%2)&#xa0;: la plus grande différence, écrite − comparée, est de %3 à %4 %5.</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>comparé</translation>
    </message>
    <message>
        <source>Compare with a compensation table</source>
        <translation>Comparer à une table de compensation</translation>
    </message>
    <message>
        <source>%1 cannot be compared</source>
        <translation>%1 ne peut pas être comparé</translation>
    </message>
    <message>
        <source>first (0)</source>
        <translation>premier (0)</translation>
    </message>
    <message>
        <source>second (1)</source>
        <translation>second (1)</translation>
    </message>
    <message>
        <source>Compare &amp;with a table…</source>
        <translation>C&amp;omparer à une table…</translation>
    </message>
    <message>
        <source>The de&amp;viations are actual − target</source>
        <translation>Les é&amp;carts sont «&#xa0;réel − visé&#xa0;»</translation>
    </message>
    <message>
        <source>After %1, from the means at the targets: this table is not complete.</source>
        <translation>Selon %1, à partir des moyennes aux points visés&#xa0;: cette table n’est pas complète.</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ConditionsPage</name>
    <message>
        <source>Air, start</source>
        <translation>Air, début</translation>
    </message>
    <message>
        <source>Air, end</source>
        <translation>Air, fin</translation>
    </message>
    <message>
        <source>Machine, start</source>
        <translation>Machine, début</translation>
    </message>
    <message>
        <source>Machine, end</source>
        <translation>Machine, fin</translation>
    </message>
    <message>
        <source>Expansion α</source>
        <translation>Dilatation α</translation>
    </message>
    <message>
        <source>Instrument, start</source>
        <translation>Instrument, début</translation>
    </message>
    <message>
        <source>Instrument, end</source>
        <translation>Instrument, fin</translation>
    </message>
    <message>
        <source>Air %1, start</source>
        <translation>Air %1, début</translation>
    </message>
    <message>
        <source>Air %1, end</source>
        <translation>Air %1, fin</translation>
    </message>
    <message>
        <source>Machine %1, start</source>
        <translation>Machine %1, début</translation>
    </message>
    <message>
        <source>Machine %1, end</source>
        <translation>Machine %1, fin</translation>
    </message>
    <message>
        <source>Instrument %1, start</source>
        <translation>Instrument %1, début</translation>
    </message>
    <message>
        <source>Instrument %1, end</source>
        <translation>Instrument %1, fin</translation>
    </message>
    <message>
        <source>Unassigned sensor, start</source>
        <translation>Capteur non attribué, début</translation>
    </message>
    <message>
        <source>Unassigned sensor, end</source>
        <translation>Capteur non attribué, fin</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>by calculation</source>
        <translation>par calcul</translation>
    </message>
    <message>
        <source>by the range method</source>
        <translation>par l’étendue</translation>
    </message>
    <message>
        <source>Measured with: %1</source>
        <translation>Mesuré avec&#xa0;: %1</translation>
    </message>
    <message>
        <source>the maker</source>
        <translation>le constructeur</translation>
    </message>
    <message>
        <source>agreement</source>
        <translation>accord</translation>
    </message>
    <message>
        <source>All of these apply</source>
        <translation>Tout est satisfait</translation>
    </message>
    <message>
        <source>Correction to 20 °C: %1.</source>
        <translation>Correction à 20 °C&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Sensor position</source>
        <translation>Position du capteur</translation>
    </message>
    <message>
        <source>Usual in practice</source>
        <translation>D’usage</translation>
    </message>
    <message>
        <source>+ machine</source>
        <translation>+ machine</translation>
    </message>
    <message>
        <source>+ instrument</source>
        <translation>+ instrument</translation>
    </message>
    <message>
        <source>+ air</source>
        <translation>+ air</translation>
    </message>
    <message>
        <source>Unassigned</source>
        <translation>Non attribué</translation>
    </message>
    <message>
        <source>Like the last test</source>
        <translation>Comme le dernier essai</translation>
    </message>
    <message>
        <source>Fills what is open as for the last test of this machine, in this file or in the register; what is measured on the day stays open</source>
        <translation>Remplit ce qui manque comme pour le dernier essai de cette machine, dans ce fichier ou dans le registre&#x202f;; ce qui se mesure le jour de l’essai reste à indiquer</translation>
    </message>
    <message numerus="yes">
        <source>%n missing</source>
        <translation>
            <numerusform>%n manque</numerusform>
            <numerusform>%n manquent</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::CurveComparison</name>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Curve that is looked at</source>
        <translation>Courbe considérée</translation>
    </message>
    <message>
        <source>Curve that is taken off</source>
        <translation>Courbe retranchée</translation>
    </message>
    <message>
        <source>no common travel</source>
        <translation>pas de course commune</translation>
    </message>
    <message>
        <source>common travel %1 to %2</source>
        <translation>course commune %1 à %2</translation>
    </message>
</context>
<context>
    <name>palmer::ui::DiagnosisPage</name>
    <message>
        <source>Correct the start angle by %1</source>
        <translation>Corriger l’angle de départ de %1</translation>
    </message>
    <message>
        <source>The circle is being diagnosed…</source>
        <translation>Diagnostic du cercle en cours…</translation>
    </message>
    <message>
        <source>%1 of %2 parameters told apart · condition %3</source>
        <translation>%1 sur %2 séparés · conditionnement %3</translation>
    </message>
    <message>
        <source>Trace: %1</source>
        <translation>Tracer&#xa0;: %1</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <source>The instrument’s program states %1 = %2 %3; here: %4. Positive here: %5</source>
        <translation>Le programme de l’instrument indique %1 = %2 %3&#x202f;; ici&#xa0;: %4. Positif ici&#xa0;: %5</translation>
    </message>
    <message>
        <source>Its file states no sign convention: opposite signs throughout may mean the opposite one.</source>
        <translation>Son fichier n’indique pas de convention de signe&#xa0;: des signes tous opposés peuvent venir de la convention opposée.</translation>
    </message>
    <message>
        <source>No single circle tells it.</source>
        <translation>Aucun cercle seul ne le dit.</translation>
    </message>
    <message>
        <source>the frequency needs the contouring feed</source>
        <translation>la fréquence demande l’avance de contournage</translation>
    </message>
    <message>
        <source>This circle</source>
        <translation>Ce cercle</translation>
    </message>
    <message>
        <source>All feeds</source>
        <translation>Toutes les avances</translation>
    </message>
    <message>
        <source>What this circle says by itself</source>
        <translation>Ce que ce cercle dit à lui seul</translation>
    </message>
    <message>
        <source>What the tests of this plane at several feeds say together</source>
        <translation>Ce que disent ensemble les essais de ce plan à plusieurs avances</translation>
    </message>
    <message>
        <source>Trace the ticked sources</source>
        <translation>Tracer les sources cochées</translation>
    </message>
    <message>
        <source>Draw the path that the ticked sources make over the measured one</source>
        <translation>Dessiner sur le tracé mesuré celui des sources cochées</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spectre</translation>
    </message>
    <message>
        <source>What no source explains, over the angle</source>
        <translation>Ce qu’aucune source n’explique, selon l’angle</translation>
    </message>
    <message>
        <source>What no source explains, by its waves: a vibration stands out</source>
        <translation>Ce qu’aucune source n’explique, par ses ondes&#xa0;: une vibration ressort</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Plus and minus zoom, arrows move, 0 shows the whole; a rectangle drawn with the mouse is zoomed into; the wheel zooms</source>
        <translation>Plus et moins agrandissent et réduisent, les flèches déplacent, 0 montre le tout&#x202f;; un rectangle tracé à la souris est agrandi&#x202f;; la molette agrandit et réduit</translation>
    </message>
    <message>
        <source>%1: %2 ± %3 %4</source>
        <comment>source, value, half its 95 % interval, unit</comment>
        <translation>%1&#xa0;: %2 ± %3 %4</translation>
    </message>
    <message>
        <source>Wheel, plus and minus zoom; dragging and arrows move; a double click or 0 shows the whole</source>
        <translation>La molette, plus et moins agrandissent et réduisent&#x202f;; glisser et les flèches déplacent&#x202f;; un double clic ou 0 montre l’ensemble</translation>
    </message>
    <message>
        <source>Interpretation, not a result of ISO 230-4</source>
        <translation>Interprétation, pas un résultat de l’ISO&#xa0;230-4</translation>
    </message>
    <message>
        <source>measured minus sources, s = %1</source>
        <translation>mesuré moins les sources, s = %1</translation>
    </message>
    <message>
        <source>part of G(b), %1</source>
        <translation>part de G(b), %1</translation>
    </message>
</context>
<context>
    <name>palmer::ui::DriftModel</name>
    <message>
        <source>time %1</source>
        <translation>temps %1</translation>
    </message>
    <message>
        <source>deviation %1</source>
        <translation>écart %1</translation>
    </message>
    <message>
        <source>a reading has both numbers; remove the row instead</source>
        <translation>un relevé a ses deux nombres&#x202f;; supprimer plutôt la ligne</translation>
    </message>
</context>
<context>
    <name>palmer::ui::DriftPage</name>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Paste times and deviations from a table (%1)</source>
        <translation>Coller des temps et des écarts d’un tableau (%1)</translation>
    </message>
    <message>
        <source>Paste readings</source>
        <translation>Coller des relevés</translation>
    </message>
    <message>
        <source>Remove rows</source>
        <translation>Supprimer les lignes</translation>
    </message>
    <message>
        <source>Remove the readings that are selected (%1)</source>
        <translation>Supprimer les relevés sélectionnés (%1)</translation>
    </message>
    <message>
        <source>Remove the readings that are selected</source>
        <translation>Supprimer les relevés sélectionnés</translation>
    </message>
    <message>
        <source>Readings of the drift test</source>
        <translation>Relevés de l’essai de dérive</translation>
    </message>
    <message>
        <source>Environmental variation error: the largest less the smallest deviation at rest</source>
        <translation>Erreur de variation environnementale&#xa0;: le plus grand moins le plus petit écart au repos</translation>
    </message>
    <message>
        <source>E_VE = %1</source>
        <translation>E_VE = %1</translation>
    </message>
    <message>
        <source>No readings yet</source>
        <translation>Pas encore de relevés</translation>
    </message>
    <message>
        <source>No test takes its E_VE from here yet: page “Uncertainty”.</source>
        <translation>Aucun essai ne prend encore son E_VE ici&#xa0;: page «&#xa0;Incertitude&#xa0;».</translation>
    </message>
    <message>
        <source>Taken by: %1</source>
        <translation>Repris par&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ErrorBox</name>
    <message>
        <source>Place: %1</source>
        <translation>Emplacement&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ExplanationCard</name>
    <message>
        <source>Explanation of %1</source>
        <translation>Explication de %1</translation>
    </message>
    <message>
        <source>per target, %1</source>
        <translation>par point, %1</translation>
    </message>
    <message>
        <source>Esc closes · ↑↓ next result</source>
        <translation>Échap ferme · ↑↓ résultat suivant</translation>
    </message>
    <message>
        <source>Copy the explanation as text</source>
        <translation>Copier l’explication en texte</translation>
    </message>
    <message>
        <source>Close the explanation (Esc)</source>
        <translation>Fermer l’explication (Échap)</translation>
    </message>
    <message>
        <source>Close the explanation</source>
        <translation>Fermer l’explication</translation>
    </message>
    <message>
        <source>Explanation copied</source>
        <translation>Explication copiée</translation>
    </message>
</context>
<context>
    <name>palmer::ui::Exports</name>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>%1 cannot be saved</source>
        <translation>%1 ne peut pas être enregistré</translation>
    </message>
    <message>
        <source>CSV, decimal point (*.csv)</source>
        <translation>CSV, point décimal (*.csv)</translation>
    </message>
    <message>
        <source>CSV, decimal comma (*.csv)</source>
        <translation>CSV, virgule décimale (*.csv)</translation>
    </message>
    <message>
        <source>Export readings and results</source>
        <translation>Exporter relevés et résultats</translation>
    </message>
    <message>
        <source>JSON, all tests (*.json)</source>
        <translation>JSON, tous les essais (*.json)</translation>
    </message>
    <message>
        <source>Digital calibration certificate, all tests (*.xml)</source>
        <translation>Certificat d’étalonnage numérique, tous les essais (*.xml)</translation>
    </message>
    <message>
        <source>Export the data of the figure</source>
        <translation>Exporter les données de la figure</translation>
    </message>
</context>
<context>
    <name>palmer::ui::FeedDialog</name>
    <message>
        <source>Feed of the test V₁</source>
        <translation>Avance de l’essai V₁</translation>
    </message>
    <message>
        <source>ISO 230-4, annex C</source>
        <translation>ISO 230-4, annexe C</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>a number is needed</source>
        <translation>il faut un nombre</translation>
    </message>
    <message>
        <source>not greater than 0</source>
        <translation>pas supérieur à 0</translation>
    </message>
    <message>
        <source>Specified diameter d₂</source>
        <translation>Diamètre spécifié d₂</translation>
    </message>
    <message>
        <source>Specified feed V₂</source>
        <translation>Avance spécifiée V₂</translation>
    </message>
    <message>
        <source>Diameter of the test d₁</source>
        <translation>Diamètre de l’essai d₁</translation>
    </message>
</context>
<context>
    <name>palmer::ui::Field</name>
    <message>
        <source>required</source>
        <translation>requis</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>required, not stated</source>
        <translation>requis, non indiqué</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>%1; %2 kept.</source>
        <translation>%1&#x202f;; %2 gardé.</translation>
    </message>
    <message>
        <source>%1 characters, where a test file holds no more than %2</source>
        <translation>%1 caractères, alors qu’un fichier d’essai en admet %2 au plus</translation>
    </message>
    <message>
        <source>%1: no</source>
        <translation>%1&#xa0;: non</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>usage</translation>
    </message>
    <message>
        <source>usual in practice, not stated</source>
        <translation>d’usage, non indiqué</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>incomplet</translation>
    </message>
</context>
<context>
    <name>palmer::ui::FigureView</name>
    <message>
        <source>band ±%1s</source>
        <translation>bande ±%1s</translation>
    </message>
    <message>
        <source>PDF, vectors (*.pdf)</source>
        <translation>PDF, vectoriel (*.pdf)</translation>
    </message>
    <message>
        <source>SVG, vectors (*.svg)</source>
        <translation>SVG, vectoriel (*.svg)</translation>
    </message>
    <message>
        <source>PNG, picture (*.png)</source>
        <translation>PNG, image (*.png)</translation>
    </message>
    <message>
        <source>Save figure</source>
        <translation>Enregistrer la figure</translation>
    </message>
    <message>
        <source>Show single readings</source>
        <translation>Afficher les relevés</translation>
    </message>
    <message>
        <source>Copy the figure</source>
        <translation>Copier la figure</translation>
    </message>
    <message>
        <source>Save the figure as PDF, SVG or PNG</source>
        <translation>Enregistrer la figure en PDF, SVG ou PNG</translation>
    </message>
    <message>
        <source>Open the figure in a window of its own</source>
        <translation>Ouvrir la figure dans sa propre fenêtre</translation>
    </message>
    <message>
        <source>Maximise the figure</source>
        <translation>Agrandir la figure</translation>
    </message>
    <message>
        <source>Plus and minus zoom, arrows move, 0 shows the whole; the wheel zooms</source>
        <translation>Plus et moins agrandissent et réduisent, les flèches déplacent, 0 montre tout&#x202f;; la molette agrandit et réduit</translation>
    </message>
    <message>
        <source>Show the points that rule the result</source>
        <translation>Afficher les points qui déterminent le résultat</translation>
    </message>
    <message>
        <source>%1 cannot be saved</source>
        <translation>%1 ne peut pas être enregistré</translation>
    </message>
    <message>
        <source>Figure copied</source>
        <translation>Figure copiée</translation>
    </message>
    <message>
        <source>Drag the figure from here into another program</source>
        <translation>Faire glisser la figure d’ici vers un autre logiciel</translation>
    </message>
</context>
<context>
    <name>palmer::ui::FilterBar</name>
    <message>
        <source>All</source>
        <translation>Sans filtre</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Depuis</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <translation>Axe %1</translation>
    </message>
    <message>
        <source>Clear filters</source>
        <translation>Effacer les filtres</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 test(s)</source>
        <translation>
            <numerusform>%1 sur %2 essai</numerusform>
            <numerusform>%1 sur %2 essais</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::FilterChip</name>
    <message>
        <source>%1 (Delete takes the filter away)</source>
        <translation>%1 (Suppr enlève le filtre)</translation>
    </message>
</context>
<context>
    <name>palmer::ui::FindingsModel</name>
    <message>
        <source>Identification</source>
        <translation>Identification</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Conditions</translation>
    </message>
    <message>
        <source>Agreed points</source>
        <translation>Points convenus</translation>
    </message>
    <message>
        <source>Required</source>
        <translation>Requis</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s)</source>
        <translation>
            <numerusform>%n constat</numerusform>
            <numerusform>%n constats</numerusform>
        </translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Incertitude</translation>
    </message>
    <message>
        <source>Recommendation</source>
        <translation>Recommandation</translation>
    </message>
</context>
<context>
    <name>palmer::ui::FindingsPanel</name>
    <message>
        <source>Show the findings</source>
        <translation>Afficher les constats</translation>
    </message>
    <message>
        <source>Fold the findings away</source>
        <translation>Replier les constats</translation>
    </message>
    <message>
        <source>&amp;Go to the statement</source>
        <translation>&amp;Aller à l’information</translation>
    </message>
    <message>
        <source>&amp;Copy the text</source>
        <translation>&amp;Copier le texte</translation>
    </message>
</context>
<context>
    <name>palmer::ui::FolderList</name>
    <message>
        <source>Choose a folder</source>
        <translation>Choisir un dossier</translation>
    </message>
    <message>
        <source>Folders of the register</source>
        <translation>Dossiers du registre</translation>
    </message>
    <message>
        <source>&amp;Add folder…</source>
        <translation>&amp;Ajouter un dossier…</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Retirer</translation>
    </message>
</context>
<context>
    <name>palmer::ui::FoldersDialog</name>
    <message>
        <source>Folders of the register</source>
        <translation>Dossiers du registre</translation>
    </message>
    <message>
        <source>Palmer reads the test files and reports in these folders and below them, and never changes them. What you say of machines it keeps beside them, in palmer-machines.json.</source>
        <translation>Palmer lit les fichiers d’essai et les rapports de ces dossiers et de leurs sous-dossiers, et ne les modifie jamais. Ce que vous indiquez des machines est conservé à côté, dans palmer-machines.json.</translation>
    </message>
</context>
<context>
    <name>palmer::ui::Form</name>
    <message>
        <source>not greater than 0</source>
        <translation>pas supérieur à 0</translation>
    </message>
    <message>
        <source>a negative number</source>
        <translation>un nombre négatif</translation>
    </message>
    <message>
        <source>not a whole number</source>
        <translation>pas un nombre entier</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>Go to the next (F8)</source>
        <translation>Aller à la suivante (F8)</translation>
    </message>
    <message>
        <source>%1 usual</source>
        <translation>%1 d’usage</translation>
    </message>
    <message>
        <source>Calendar (Alt+Down)</source>
        <translation>Calendrier (Alt+Bas)</translation>
    </message>
    <message>
        <source>&amp;Today</source>
        <translation>&amp;Aujourd’hui</translation>
    </message>
    <message>
        <source>Temperature · %1</source>
        <translation>Température · %1</translation>
    </message>
    <message>
        <source>not between 0 and 100</source>
        <translation>pas entre 0 et 100</translation>
    </message>
</context>
<context>
    <name>palmer::ui::HelpWindow</name>
    <message>
        <source>Validation</source>
        <translation>Validation</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Pages of the help</source>
        <translation>Pages de l’aide</translation>
    </message>
    <message>
        <source>Text of the help</source>
        <translation>Texte de l’aide</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Evaluate all and &amp;save as PDF…</source>
        <translation>Tout évaluer et &amp;enregistrer en PDF…</translation>
    </message>
    <message>
        <source>Save the validation document</source>
        <translation>Enregistrer le document de validation</translation>
    </message>
    <message>
        <source>The document was not saved</source>
        <translation>Le document n’a pas été enregistré</translation>
    </message>
    <message>
        <source>Search, Enter: next place</source>
        <translation>Rechercher, Entrée&#xa0;: suivant</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>Rechercher dans l’aide</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Preuves</translation>
    </message>
    <message>
        <source>Working with Palmer</source>
        <translation>Travailler avec Palmer</translation>
    </message>
    <message>
        <source>Circular tests</source>
        <translation>Essais de circularité</translation>
    </message>
    <message>
        <source>Positioning of axes</source>
        <translation>Positionnement des axes</translation>
    </message>
    <message>
        <source>“%1” is not found</source>
        <translation>«&#xa0;%1&#xa0;» est introuvable</translation>
    </message>
</context>
<context>
    <name>palmer::ui::HistoryPdf</name>
    <message>
        <source>Number of the history, printed on every page; may be empty:</source>
        <translation>Numéro de l’historique, imprimé sur chaque page&#x202f;; peut rester vide&#xa0;:</translation>
    </message>
    <message>
        <source>Save the history</source>
        <translation>Enregistrer l’historique</translation>
    </message>
    <message>
        <source>The history was not saved</source>
        <translation>L’historique n’a pas été enregistré</translation>
    </message>
</context>
<context>
    <name>palmer::ui::IdentificationPage</name>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Replaces</source>
        <translation>Remplace</translation>
    </message>
    <message>
        <source>Date of issue</source>
        <translation>Date d’émission</translation>
    </message>
    <message>
        <source>Performed from</source>
        <translation>Réalisé du</translation>
    </message>
    <message>
        <source>to</source>
        <translation>au</translation>
    </message>
    <message>
        <source>Accreditation</source>
        <translation>Accréditation</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>Fonction</translation>
    </message>
    <message>
        <source>Customer and supplier</source>
        <translation>Client et fournisseur</translation>
    </message>
    <message>
        <source>Address of the customer</source>
        <translation>Adresse du client</translation>
    </message>
    <message>
        <source>Address of the supplier</source>
        <translation>Adresse du fournisseur</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>Choose the logo…</source>
        <translation>Choisir le logo…</translation>
    </message>
    <message>
        <source>Remove the logo</source>
        <translation>Supprimer le logo</translation>
    </message>
    <message>
        <source>Mark of the accreditation body</source>
        <translation>Marque de l’organisme d’accréditation</translation>
    </message>
    <message>
        <source>Choose the mark…</source>
        <translation>Choisir la marque…</translation>
    </message>
    <message>
        <source>Remove the mark</source>
        <translation>Supprimer la marque</translation>
    </message>
    <message>
        <source>Choose a picture</source>
        <translation>Choisir une image</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg)</source>
        <translation>Images (*.png *.svg)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>The file cannot be read.</source>
        <translation>Le fichier ne peut pas être lu.</translation>
    </message>
    <message>
        <source>The picture is larger than 4 MiB: it stands in every report. Choose a smaller one.</source>
        <translation>L’image dépasse 4&#xa0;Mio&#xa0;: elle figure dans chaque rapport. Choisissez-en une plus petite.</translation>
    </message>
    <message>
        <source>This is no picture that a report can show. Choose a PNG or an SVG.</source>
        <translation>Ce n’est pas une image qu’un rapport peut montrer. Choisissez un fichier PNG ou SVG.</translation>
    </message>
    <message>
        <source>%1: none</source>
        <translation>%1&#xa0;: aucune image</translation>
    </message>
    <message>
        <source>Country</source>
        <translation>Pays</translation>
    </message>
    <message>
        <source>two letters (ISO 3166-1), as FR</source>
        <translation>deux lettres (ISO 3166-1), comme FR</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contact</translation>
    </message>
    <message>
        <source>Signatures</source>
        <translation>Signatures</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ImportAssistant</name>
    <message>
        <source>clipboard</source>
        <translation>presse-papiers</translation>
    </message>
    <message>
        <source>Import another file</source>
        <translation>Importer un autre fichier</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Save the choices</source>
        <translation>Enregistrer les choix</translation>
    </message>
    <message>
        <source>Name of the profile</source>
        <translation>Nom du profil</translation>
    </message>
    <message>
        <source>The profile cannot be saved</source>
        <translation>Le profil ne peut pas être enregistré</translation>
    </message>
    <message>
        <source>guessed</source>
        <translation>deviné</translation>
    </message>
    <message>
        <source>There is no curve of this measurement.</source>
        <translation>Cette mesure n’a pas de courbe.</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s)</source>
        <translation>
            <numerusform>%n ligne</numerusform>
            <numerusform>%n lignes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s)</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n passe</numerusform>
            <numerusform>%n passes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n arc(s)</source>
        <translation>
            <numerusform>%n arc</numerusform>
            <numerusform>%n arcs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sensor(s)</source>
        <translation>
            <numerusform>%n capteur</numerusform>
            <numerusform>%n capteurs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&amp;Import %n reading(s)</source>
        <translation>
            <numerusform>&amp;Importer %n relevé</numerusform>
            <numerusform>&amp;Importer %n relevés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n missing reading(s)</source>
        <translation>
            <numerusform>%n relevé manquant</numerusform>
            <numerusform>%n relevés manquants</numerusform>
        </translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>&amp;Other file…</source>
        <translation>A&amp;utre fichier…</translation>
    </message>
    <message>
        <source>&amp;Paste text</source>
        <translation>&amp;Coller du texte</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importer %1</translation>
    </message>
    <message>
        <source>Destination</source>
        <translation>Destination</translation>
    </message>
    <message>
        <source>the open file</source>
        <translation>le fichier ouvert</translation>
    </message>
    <message>
        <source>a new file</source>
        <translation>un nouveau fichier</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Text as read</source>
        <translation>Texte lu</translation>
    </message>
    <message>
        <source>Recognised table</source>
        <translation>Tableau reconnu</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>&amp;Keep the original in the file</source>
        <translation>&amp;Garder l’original dans le fichier</translation>
    </message>
    <message>
        <source>&amp;Save these choices as a profile…</source>
        <translation>&amp;Enregistrer ces choix comme profil…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>%1 (hidden)</source>
        <translation>%1 (masquée)</translation>
    </message>
    <message numerus="yes">
        <source>%n question(s) to answer, and remarks</source>
        <translation>
            <numerusform>%n question en attente de réponse, et remarques</numerusform>
            <numerusform>%n questions en attente de réponse, et remarques</numerusform>
        </translation>
    </message>
    <message>
        <source>No measurement can be read yet: what is missing is said below.</source>
        <translation>Aucune mesure ne peut encore être lue&#xa0;: ce qui manque est indiqué ci-dessous.</translation>
    </message>
    <message numerus="yes">
        <source>%n question(s) to answer</source>
        <translation>
            <numerusform>%n question en attente de réponse</numerusform>
            <numerusform>%n questions en attente de réponse</numerusform>
        </translation>
    </message>
    <message>
        <source>Roles of the columns</source>
        <translation>Rôles des colonnes</translation>
    </message>
    <message>
        <source>Questions and remarks</source>
        <translation>Questions et remarques</translation>
    </message>
    <message>
        <source>Confirm &amp;all</source>
        <translation>&amp;Tout confirmer</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>Lecture de %1…</translation>
    </message>
    <message>
        <source>Being drawn…</source>
        <translation>Tracé en cours…</translation>
    </message>
    <message>
        <source>Importing %1…</source>
        <translation>Importation de %1…</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) follow</source>
        <translation>
            <numerusform>%n fichier suit</numerusform>
            <numerusform>%n fichiers suivent</numerusform>
        </translation>
    </message>
    <message>
        <source>Takes what is proposed to each assumed question and remark; a doubtful one wants its own answer</source>
        <translation>Retient ce qui est proposé à chaque question ou remarque supposée&#x202f;; une question douteuse demande sa propre réponse</translation>
    </message>
</context>
<context>
    <name>palmer::ui::InstrumentsPage</name>
    <message>
        <source>Description</source>
        <translation>Désignation</translation>
    </message>
    <message>
        <source>Short name</source>
        <translation>Nom court</translation>
    </message>
    <message>
        <source>Add an instrument</source>
        <translation>Ajouter un instrument</translation>
    </message>
    <message>
        <source>Instrument %1</source>
        <translation>Instrument %1</translation>
    </message>
    <message>
        <source>Remove the instrument</source>
        <translation>Supprimer l’instrument</translation>
    </message>
    <message>
        <source>another instrument is called so</source>
        <translation>un autre instrument porte ce nom</translation>
    </message>
    <message>
        <source>the tests name the instrument so: it cannot be empty</source>
        <translation>les essais nomment ainsi l’instrument&#xa0;: il ne peut pas être vide</translation>
    </message>
    <message>
        <source>Traceable to</source>
        <translation>Raccordé à</translation>
    </message>
    <message>
        <source>Its accreditation</source>
        <translation>Son accréditation</translation>
    </message>
    <message>
        <source>Its certificate</source>
        <translation>Son certificat</translation>
    </message>
</context>
<context>
    <name>palmer::ui::KeyHints</name>
    <message>
        <source>Drift D %1</source>
        <translation>Dérive D %1</translation>
    </message>
    <message>
        <source>Steady progression from the first to the last run (t = %1): the thermal conditions may be unstable</source>
        <translation>Progression régulière de la première à la dernière passe (t = %1)&#xa0;: les conditions thermiques sont peut-être instables</translation>
    </message>
    <message>
        <source>From the first to the last run; no more than chance (t = %1)</source>
        <translation>De la première à la dernière passe&#x202f;; pas plus que le hasard (t = %1)</translation>
    </message>
    <message>
        <source>Enter</source>
        <comment>key</comment>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>follows the cycle</source>
        <translation>suit le cycle</translation>
    </message>
    <message>
        <source>Tab</source>
        <comment>key</comment>
        <translation>Tab</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>à droite</translation>
    </message>
    <message>
        <source>edits</source>
        <translation>modifier</translation>
    </message>
    <message>
        <source>pastes</source>
        <translation>coller</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
</context>
<context>
    <name>palmer::ui::LanguageSwitch</name>
    <message>
        <source>Language of the window; the report has its own</source>
        <translation>Langue de la fenêtre&#x202f;; le rapport a la sienne</translation>
    </message>
</context>
<context>
    <name>palmer::ui::LimitsPage</name>
    <message>
        <source>ISO 14253-1: conformity is to be proven</source>
        <translation>ISO 14253-1&#xa0;: conformité à prouver</translation>
    </message>
    <message>
        <source>non-conformity is to be proven</source>
        <translation>non-conformité à prouver</translation>
    </message>
    <message>
        <source>Guard band, times U</source>
        <translation>Facteur de bande de garde (× U)</translation>
    </message>
    <message>
        <source>Agreed limits</source>
        <translation>Limites convenues</translation>
    </message>
    <message>
        <source>Limit of %1</source>
        <translation>Limite de %1</translation>
    </message>
    <message>
        <source>Agreed for edition</source>
        <translation>Pour l’édition</translation>
    </message>
    <message>
        <source>of the test</source>
        <translation>de l’essai</translation>
    </message>
    <message>
        <source>Origin of all limits</source>
        <translation>Origine de toutes les limites</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Nothing was pasted</source>
        <translation>Rien n’a été collé</translation>
    </message>
    <message>
        <source>the larger of %1 and %2 in size</source>
        <translation>le plus grand de %1 et %2 en valeur absolue</translation>
    </message>
    <message>
        <source>%1 and %2 in size</source>
        <translation>%1 et %2 en valeur absolue</translation>
    </message>
    <message>
        <source>Edition of all limits</source>
        <translation>Édition de toutes les limites</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
</context>
<context>
    <name>palmer::ui::MachineDelegate</name>
    <message>
        <source>overdue %1 d</source>
        <translation>retard %1&#xa0;j</translation>
    </message>
    <message>
        <source>due in %1 d</source>
        <translation>échéance %1&#xa0;j</translation>
    </message>
    <message>
        <source>%1 d</source>
        <translation>%1&#xa0;j</translation>
    </message>
    <message>
        <source>expired</source>
        <translation>expiré</translation>
    </message>
</context>
<context>
    <name>palmer::ui::MachineHead</name>
    <message numerus="yes">
        <source>%n month(s)</source>
        <translation>
            <numerusform>%n mois</numerusform>
            <numerusform>%n mois</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: overdue since %2</source>
        <translation>%1&#xa0;: en retard depuis le %2</translation>
    </message>
    <message>
        <source>%1: next test before %2</source>
        <translation>%1&#xa0;: prochain essai avant le %2</translation>
    </message>
    <message>
        <source>certificate expires on %1</source>
        <translation>le certificat expire le %1</translation>
    </message>
</context>
<context>
    <name>palmer::ui::MachineModel</name>
    <message>
        <source>not identified</source>
        <translation>non identifiée</translation>
    </message>
    <message>
        <source>without name</source>
        <translation>sans nom</translation>
    </message>
</context>
<context>
    <name>palmer::ui::MachinePage</name>
    <message>
        <source>Year of construction</source>
        <translation>Année de construction</translation>
    </message>
    <message>
        <source>Location</source>
        <translation>Emplacement</translation>
    </message>
</context>
<context>
    <name>palmer::ui::MachineSide</name>
    <message>
        <source>Machine, serial number, type</source>
        <translation>Machine, n° de série, type</translation>
    </message>
    <message>
        <source>Search machines</source>
        <translation>Chercher une machine</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>To do %1</source>
        <translation>À traiter %1</translation>
    </message>
    <message>
        <source>The folders are being read…</source>
        <translation>Lecture des dossiers…</translation>
    </message>
    <message>
        <source>No machine found</source>
        <translation>Aucune machine trouvée</translation>
    </message>
    <message>
        <source>No machine yet</source>
        <translation>Aucune machine pour l’instant</translation>
    </message>
</context>
<context>
    <name>palmer::ui::MainWindow</name>
    <message>
        <source>&amp;Diagnosis: one influence each</source>
        <translation>&amp;Diagnostic&#xa0;: une influence à la fois</translation>
    </message>
    <message>
        <source>Open a test file</source>
        <translation>Ouvrir un fichier d’essai</translation>
    </message>
    <message>
        <source>Test files (*.palmer)</source>
        <translation>Fichiers d’essai (*.palmer)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>%1 cannot be opened</source>
        <translation>%1 ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>Lecture de %1…</translation>
    </message>
    <message>
        <source>Save the test file</source>
        <translation>Enregistrer le fichier d’essai</translation>
    </message>
    <message>
        <source>%1 cannot be saved</source>
        <translation>%1 ne peut pas être enregistré</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Save the changes before closing?</source>
        <translation>Enregistrer les modifications avant de fermer&#x202f;?</translation>
    </message>
    <message>
        <source>Otherwise the changes since the last saving are lost.</source>
        <translation>Sinon, les modifications depuis le dernier enregistrement sont perdues.</translation>
    </message>
    <message>
        <source>No file yet</source>
        <translation>Aucun fichier pour l’instant</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rétablir&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Calcul en cours…</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Modifié</translation>
    </message>
    <message>
        <source>Saved at %1</source>
        <translation>Enregistré à %1</translation>
    </message>
    <message>
        <source>Example</source>
        <translation>Exemple</translation>
    </message>
    <message>
        <source>About Palmer</source>
        <translation>À propos de Palmer</translation>
    </message>
    <message>
        <source>Evaluates tests of machine tools after ISO 230-2 and ISO 230-4 and prints the report. Free software under the GNU General Public License, version 3 or later; without any warranty.</source>
        <translation>Évalue les essais de machines-outils selon l’ISO 230-2 et l’ISO 230-4 et imprime le rapport. Logiciel libre sous licence publique générale GNU, version 3 ou ultérieure&#x202f;; sans aucune garantie.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Édition</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>E&amp;ssai</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Ai&amp;de</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Fichiers &amp;récents</translation>
    </message>
    <message>
        <source>E&amp;xamples</source>
        <translation>E&amp;xemples</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;Previous test</source>
        <translation>Essai &amp;précédent</translation>
    </message>
    <message>
        <source>&amp;Next test</source>
        <translation>Essai &amp;suivant</translation>
    </message>
    <message>
        <source>&amp;Set as edition of the test</source>
        <translation>&amp;Définir comme édition de l’essai</translation>
    </message>
    <message>
        <source>&amp;Back to the edition of the test</source>
        <translation>&amp;Revenir à l’édition de l’essai</translation>
    </message>
    <message>
        <source>&amp;Readings</source>
        <translation>&amp;Relevés</translation>
    </message>
    <message>
        <source>&amp;Conditions</source>
        <translation>&amp;Conditions</translation>
    </message>
    <message>
        <source>&amp;Agreed points</source>
        <translation>&amp;Points convenus</translation>
    </message>
    <message>
        <source>&amp;Limits</source>
        <translation>&amp;Limites</translation>
    </message>
    <message>
        <source>&amp;Next missing statement</source>
        <translation>Information manquante &amp;suivante</translation>
    </message>
    <message>
        <source>&amp;Previous missing statement</source>
        <translation>Information manquante pr&amp;écédente</translation>
    </message>
    <message>
        <source>&amp;Maximise the figure</source>
        <translation>A&amp;grandir la figure</translation>
    </message>
    <message>
        <source>&amp;About Palmer</source>
        <translation>À &amp;propos de Palmer</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>À propos de &amp;Qt</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Menus</source>
        <translation>Menus</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Re&amp;port…</source>
        <translation>Ra&amp;pport…</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
    <message>
        <source>Changes cannot be kept safe automatically: %1.</source>
        <translation>Les modifications ne peuvent pas être enregistrées automatiquement&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Rename the test</source>
        <translation>Renommer l’essai</translation>
    </message>
    <message>
        <source>Name of the test</source>
        <translation>Nom de l’essai</translation>
    </message>
    <message>
        <source>%1 is no longer where it was. Save to write it anew.</source>
        <translation>%1 n’est plus à sa place. Enregistrer pour l’écrire à nouveau.</translation>
    </message>
    <message>
        <source>Another program has changed %1. Loading it gives up the changes made here.</source>
        <translation>Un autre programme a modifié %1. Le charger abandonne les modifications faites ici.</translation>
    </message>
    <message>
        <source>Another program has changed %1.</source>
        <translation>Un autre programme a modifié %1.</translation>
    </message>
    <message>
        <source>&amp;Load it</source>
        <translation>&amp;Charger</translation>
    </message>
    <message>
        <source>&amp;Keep what is here</source>
        <translation>&amp;Garder ce qui est ici</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Another program has changed %1 since it was opened here.</source>
        <translation>Un autre programme a modifié %1 depuis son ouverture ici.</translation>
    </message>
    <message>
        <source>Saving puts what is here in its place.</source>
        <translation>L’enregistrement met à sa place ce qui est ici.</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>&amp;Remplacer</translation>
    </message>
    <message>
        <source>Kept automatically at %1</source>
        <translation>Copie de secours à %1</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>&amp;Add a positioning test…</source>
        <translation>&amp;Ajouter un essai de positionnement…</translation>
    </message>
    <message>
        <source>Rena&amp;me the test…</source>
        <translation>Reno&amp;mmer l’essai…</translation>
    </message>
    <message>
        <source>Repeat the test, &amp;without readings</source>
        <translation>Nouvel essai sem&amp;blable (sans relevés)</translation>
    </message>
    <message>
        <source>Delete the t&amp;est</source>
        <translation>Supprimer l’&amp;essai</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Nou&amp;velle fenêtre</translation>
    </message>
    <message>
        <source>P&amp;lan…</source>
        <translation>P&amp;lan…</translation>
    </message>
    <message>
        <source>Plan…</source>
        <translation>Plan…</translation>
    </message>
    <message>
        <source>Contouring &amp;feed…</source>
        <translation>&amp;Avance de contournage…</translation>
    </message>
    <message>
        <source>&amp;Units</source>
        <translation>&amp;Unités</translation>
    </message>
    <message>
        <source>Lengths: µm and mm</source>
        <translation>Longueurs&#xa0;: µm et mm</translation>
    </message>
    <message>
        <source>Lengths: mm only</source>
        <translation>Longueurs&#xa0;: mm seulement</translation>
    </message>
    <message>
        <source>Lengths: µin and inches</source>
        <translation>Longueurs&#xa0;: µin et pouces</translation>
    </message>
    <message>
        <source>Angles: arc seconds and degrees</source>
        <translation>Angles&#xa0;: secondes d’arc et degrés</translation>
    </message>
    <message>
        <source>Angles: degrees only</source>
        <translation>Angles&#xa0;: degrés seulement</translation>
    </message>
    <message>
        <source>&amp;Utilities</source>
        <translation>O&amp;utils</translation>
    </message>
    <message>
        <source>Co&amp;mpare…</source>
        <translation>C&amp;omparer…</translation>
    </message>
    <message>
        <source>Import measurement files</source>
        <translation>Importer des fichiers de mesure</translation>
    </message>
    <message>
        <source>Measurements (%1)</source>
        <translation>Mesures (%1)</translation>
    </message>
    <message>
        <source>%1 cannot be imported</source>
        <translation>%1 ne peut pas être importé</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>presse-papiers</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>Import from the clip&amp;board…</source>
        <translation>Importer &amp;depuis le presse-papiers…</translation>
    </message>
    <message>
        <source>&amp;New positioning test…</source>
        <translation>&amp;Nouvel essai de positionnement…</translation>
    </message>
    <message>
        <source>New circular &amp;test…</source>
        <translation>Nouvel essai de circu&amp;larité…</translation>
    </message>
    <message>
        <source>Add a circular &amp;test…</source>
        <translation>Ajouter un essai de circularit&amp;é…</translation>
    </message>
    <message>
        <source>Add a dri&amp;ft test</source>
        <translation>A&amp;jouter un essai de dérive</translation>
    </message>
    <message>
        <source>Uncertaint&amp;y</source>
        <translation>&amp;Incertitude</translation>
    </message>
    <message>
        <source>&amp;Readings and results…</source>
        <translation>&amp;Relevés et résultats…</translation>
    </message>
    <message>
        <source>&amp;Data of the figure…</source>
        <translation>&amp;Données de la figure…</translation>
    </message>
    <message>
        <source>&amp;Compensation table…</source>
        <translation>&amp;Table de compensation…</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>Expor&amp;ter</translation>
    </message>
    <message>
        <source>Typed and shown in red, but never taken: %1. It is not saved.</source>
        <translation>Saisi et affiché en rouge, mais jamais pris en compte&#xa0;: %1. Cela n’est pas enregistré.</translation>
    </message>
    <message>
        <source>Close without what could not be taken?</source>
        <translation>Fermer sans ce qui n’a pas pu être pris en compte&#x202f;?</translation>
    </message>
    <message>
        <source>%1 is no longer where it was. Save it before closing?</source>
        <translation>%1 n’est plus à sa place. L’enregistrer avant de fermer&#x202f;?</translation>
    </message>
    <message>
        <source>Another program has changed %1. Save what is here before closing?</source>
        <translation>Un autre programme a modifié %1. Enregistrer ce qui est ici avant de fermer&#x202f;?</translation>
    </message>
    <message>
        <source>Otherwise what is here is lost.</source>
        <translation>Sinon, ce qui est ici est perdu.</translation>
    </message>
    <message>
        <source>Test files and reports (*.palmer *.pdf)</source>
        <translation>Fichiers d’essai et rapports (*.palmer *.pdf)</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>%1 (copie)</translation>
    </message>
    <message>
        <source>Copy of the test file in a report</source>
        <translation>Copie du fichier d’essai d’un rapport</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Quitter</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) have changes that are not saved.</source>
        <translation>
            <numerusform>%n fichier a des modifications non enregistrées.</numerusform>
            <numerusform>%n fichiers ont des modifications non enregistrées.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Save all</source>
        <translation>&amp;Tout enregistrer</translation>
    </message>
    <message>
        <source>&amp;Discard all</source>
        <translation>&amp;Ne rien enregistrer</translation>
    </message>
    <message>
        <source>&amp;One by one</source>
        <translation>L’un après l’&amp;autre</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Ann&amp;uler</translation>
    </message>
    <message>
        <source>&amp;Clear the list</source>
        <translation>&amp;Vider la liste</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Raccourcis clavier</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Paramètres…</translation>
    </message>
    <message>
        <source>Ne&amp;xt pane</source>
        <translation>&amp;Volet suivant</translation>
    </message>
    <message>
        <source>Pre&amp;vious pane</source>
        <translation>V&amp;olet précédent</translation>
    </message>
    <message>
        <source>%1 is open already: %2 on %3, process %4. Who saves last overwrites the other.</source>
        <translation>%1 est déjà ouvert&#xa0;: %2 sur %3, processus %4. Le dernier enregistrement remplace l’autre.</translation>
    </message>
    <message>
        <source>&amp;Validation</source>
        <translation>&amp;Validation</translation>
    </message>
    <message>
        <source>&amp;Register of all tests…</source>
        <translation>&amp;Registre de tous les essais…</translation>
    </message>
    <message>
        <source>D&amp;iagnosis</source>
        <translation>&amp;Diagnostic</translation>
    </message>
    <message>
        <source>%1 is read-only: changes can be saved under another name.</source>
        <translation>%1 est en lecture seule&#xa0;: les modifications peuvent être enregistrées sous un autre nom.</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (lecture seule)</translation>
    </message>
    <message>
        <source>Li&amp;ke the last test of this machine</source>
        <translation>&amp;Comme le dernier essai de cette machine</translation>
    </message>
    <message>
        <source>Like the last test of a machine</source>
        <translation>Comme le dernier essai d’une machine</translation>
    </message>
    <message>
        <source>The last test of the machine cannot be read</source>
        <translation>Le dernier essai de la machine ne peut être lu</translation>
    </message>
    <message>
        <source>Neither the file nor the register has another test of this machine.</source>
        <translation>Ni le fichier ni le registre ne contiennent d’autre essai de cette machine.</translation>
    </message>
    <message>
        <source>Filled like %1%2%3. What is measured on the day of the test is still open.</source>
        <translation>Rempli comme %1%2%3. Ce qui se mesure le jour de l’essai reste à indiquer.</translation>
    </message>
    <message>
        <source>&amp;OK</source>
        <translation>&amp;OK</translation>
    </message>
    <message>
        <source>Searc&amp;h</source>
        <translation>Cherc&amp;her</translation>
    </message>
    <message>
        <source>Lar&amp;ger text</source>
        <translation>Texte plus gr&amp;and</translation>
    </message>
    <message>
        <source>Close &amp;anyway</source>
        <translation>Fermer &amp;quand même</translation>
    </message>
    <message>
        <source>&amp;Smaller text</source>
        <translation>Te&amp;xte plus petit</translation>
    </message>
    <message>
        <source>&amp;Text of usual size</source>
        <translation>Taille &amp;habituelle du texte</translation>
    </message>
    <message>
        <source>Comparis&amp;on</source>
        <translation>Co&amp;mparaison</translation>
    </message>
    <message>
        <source>T&amp;hermal behaviour</source>
        <translation>Comportement &amp;thermique</translation>
    </message>
    <message>
        <source>Duplicate the test</source>
        <translation>Dupliquer l’essai</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>À l’ouverture</translation>
    </message>
    <message>
        <source>Hist&amp;ory</source>
        <translation>H&amp;istorique</translation>
    </message>
    <message>
        <source>Dupli&amp;cate the test…</source>
        <translation>Dupli&amp;quer l’essai…</translation>
    </message>
    <message>
        <source>&amp;Go to the report…</source>
        <translation>A&amp;fficher dans le rapport…</translation>
    </message>
</context>
<context>
    <name>palmer::ui::NavigationList</name>
    <message>
        <source>Pages of the report, tests</source>
        <translation>Pages du rapport, essais</translation>
    </message>
</context>
<context>
    <name>palmer::ui::NavigationModel</name>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Identification</source>
        <translation>Identification</translation>
    </message>
    <message>
        <source>unfinished</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>provisional</source>
        <translation>provisoire</translation>
    </message>
</context>
<context>
    <name>palmer::ui::NewCircleDialog</name>
    <message>
        <source>New circular test</source>
        <translation>Nouvel essai de circularité</translation>
    </message>
    <message>
        <source>external</source>
        <translation>externe</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>&amp;Plane</source>
        <translation>&amp;Plan</translation>
    </message>
    <message>
        <source>Nominal &amp;radius</source>
        <translation>&amp;Rayon nominal</translation>
    </message>
    <message>
        <source>Contouring &amp;feed</source>
        <translation>&amp;Vitesse d’avance de contournage</translation>
    </message>
    <message>
        <source>&amp;Source of the signal</source>
        <translation>&amp;Source du signal</translation>
    </message>
    <message>
        <source>&amp;Edition</source>
        <translation>&amp;Édition</translation>
    </message>
    <message>
        <source>The arcs are typed or pasted afterwards, as tables.</source>
        <translation>Les arcs se saisissent ou se collent ensuite, en tableaux.</translation>
    </message>
    <message>
        <source>&amp;Create</source>
        <translation>&amp;Créer</translation>
    </message>
    <message>
        <source>The nominal radius is a number above 0.</source>
        <translation>Le rayon nominal est un nombre supérieur à 0.</translation>
    </message>
    <message>
        <source>The feed is a number above 0, or not stated.</source>
        <translation>L’avance est un nombre supérieur à 0, ou non indiquée.</translation>
    </message>
</context>
<context>
    <name>palmer::ui::NewTestDialog</name>
    <message>
        <source>New positioning test</source>
        <translation>Nouvel essai de positionnement</translation>
    </message>
    <message>
        <source>standard cycle</source>
        <translation>cycle normal</translation>
    </message>
    <message>
        <source>from &amp;both sides</source>
        <translation>dan&amp;s les deux sens</translation>
    </message>
    <message>
        <source>&amp;Axis</source>
        <translation>A&amp;xe</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>&amp;Mouvement</translation>
    </message>
    <message>
        <source>&amp;Travel</source>
        <translation>Long&amp;ueur d’axe</translation>
    </message>
    <message>
        <source>&amp;Edition</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>C&amp;ycle</source>
        <translation>C&amp;ycle</translation>
    </message>
    <message>
        <source>&amp;Runs</source>
        <translation>&amp;Passes</translation>
    </message>
    <message>
        <source>&amp;First target</source>
        <translation>Pr&amp;emier point visé</translation>
    </message>
    <message>
        <source>&amp;Last target</source>
        <translation>De&amp;rnier point visé</translation>
    </message>
    <message>
        <source>&amp;Number of targets</source>
        <translation>&amp;Nombre de points visés</translation>
    </message>
    <message>
        <source>Target &amp;positions</source>
        <translation>Positions &amp;visées</translation>
    </message>
    <message>
        <source>&amp;Create</source>
        <translation>&amp;Créer</translation>
    </message>
    <message>
        <source>The axis needs a name.</source>
        <translation>L’axe doit avoir un nom.</translation>
    </message>
    <message>
        <source>The target positions are numbers, parted by semicolons, blanks or lines.</source>
        <translation>Les positions visées sont des nombres, séparés par des points-virgules, des espaces ou des lignes.</translation>
    </message>
    <message>
        <source>A test has two targets at least.</source>
        <translation>Un essai a au moins deux points visés.</translation>
    </message>
    <message>
        <source>The target positions have to ascend.</source>
        <translation>Les positions visées doivent être croissantes.</translation>
    </message>
    <message>
        <source>The travel is a number above 0.</source>
        <translation>La longueur d’axe est un nombre supérieur à 0.</translation>
    </message>
    <message>
        <source>The number of runs each way is a whole number from 1 to %1.</source>
        <translation>Le nombre de passes par sens est un nombre entier de 1 à %1.</translation>
    </message>
    <message>
        <source>The first target is a number.</source>
        <translation>Le premier point visé est un nombre.</translation>
    </message>
    <message>
        <source>The last target is a number.</source>
        <translation>Le dernier point visé est un nombre.</translation>
    </message>
    <message>
        <source>The last target has to lie above the first.</source>
        <translation>Le dernier point visé doit se trouver au-dessus du premier.</translation>
    </message>
    <message>
        <source>The number of targets is a whole number from %1 to %2.</source>
        <translation>Le nombre de points visés est un nombre entier de %1 à %2.</translation>
    </message>
    <message>
        <source>A new test has %1 readings at most: fewer targets or runs.</source>
        <translation>Un nouvel essai a au plus %1 relevés&#xa0;: moins de points visés ou de passes.</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>The last target is %1, not %2: to every nominal position, each %3, a random part of up to ± %4 is added so that periodic errors show, and no target may lie beyond the ends.</source>
        <translation>Le dernier point visé est %1, et non %2&#xa0;: à chaque position nominale, tous les %3, s’ajoute une part aléatoire d’au plus ± %4 qui révèle les erreurs périodiques, et aucun point ne peut dépasser les extrémités.</translation>
    </message>
</context>
<context>
    <name>palmer::ui::PasteBar</name>
    <message numerus="yes">
        <source>%n limit(s) pasted</source>
        <translation>
            <numerusform>%n limite collée</numerusform>
            <numerusform>%n limites collées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s) read</source>
        <translation>
            <numerusform>%n position visée lue</numerusform>
            <numerusform>%n positions visées lues</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s) pasted</source>
        <translation>
            <numerusform>%n relevé collé</numerusform>
            <numerusform>%n relevés collés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) pasted, channels: %1, temperatures: %2</source>
        <translation>
            <numerusform>%n ligne collée, voies&#xa0;: %1, températures&#xa0;: %2</numerusform>
            <numerusform>%n lignes collées, voies&#xa0;: %1, températures&#xa0;: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n target(s)</source>
        <comment>readings pasted</comment>
        <translation>
            <numerusform>%1 et %n point visé</numerusform>
            <numerusform>%1 et %n points visés</numerusform>
        </translation>
    </message>
    <message>
        <source>Deviations %1</source>
        <comment>unit</comment>
        <translation>Écarts %1</translation>
    </message>
    <message>
        <source>Positions %1</source>
        <comment>unit</comment>
        <translation>Positions %1</translation>
    </message>
    <message>
        <source>What was pasted</source>
        <translation>Ce qui a été collé</translation>
    </message>
    <message>
        <source>guessed:</source>
        <translation>supposé&#xa0;:</translation>
    </message>
    <message>
        <source>Comma</source>
        <translation>Virgule</translation>
    </message>
    <message>
        <source>The decimal mark of the block is the comma: 5,4</source>
        <translation>Le séparateur décimal du tableau est la virgule&#xa0;: 5,4</translation>
    </message>
    <message>
        <source>The decimal mark of the block is the point: 5.4</source>
        <translation>Le séparateur décimal du tableau est le point&#xa0;: 5.4</translation>
    </message>
    <message>
        <source>What the numbers are</source>
        <translation>Ce que sont les nombres</translation>
    </message>
    <message>
        <source>What the numbers are, and in which unit</source>
        <translation>Ce que sont les nombres, et dans quelle unité</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n erased by empty cells</source>
        <comment>readings pasted</comment>
        <translation>
            <numerusform>%1, %n effacé par une cellule vide</numerusform>
            <numerusform>%1, %n effacés par des cellules vides</numerusform>
        </translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Undo the paste</source>
        <translation>Annuler le collage</translation>
    </message>
    <message>
        <source>Takes back what was pasted, also what it has erased</source>
        <translation>Reprend ce qui a été collé et rétablit ce qui a été effacé</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n erased by cells that are no numbers</source>
        <comment>readings pasted</comment>
        <translation>
            <numerusform>%1, %n effacé par une cellule qui n’est pas un nombre</numerusform>
            <numerusform>%1, %n effacés par des cellules qui ne sont pas des nombres</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is put before the questions are answered.</source>
        <translation>Rien n’est placé avant qu’il soit répondu aux questions.</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Réponse</translation>
    </message>
</context>
<context>
    <name>palmer::ui::PlanDialog</name>
    <message>
        <source>Travel begins at</source>
        <translation>Début de la course</translation>
    </message>
    <message>
        <source>Targets per metre</source>
        <translation>Points par mètre</translation>
    </message>
    <message>
        <source>Decimals</source>
        <translation>Décimales</translation>
    </message>
    <message>
        <source>Feed rate (empty: rapid)</source>
        <translation>Vitesse d’avance (vide&#xa0;: rapide)</translation>
    </message>
    <message>
        <source>These numbers give no plan: too many targets, or too few decimals to tell them apart.</source>
        <translation>Ces nombres ne donnent aucun plan&#xa0;: trop de points, ou trop peu de décimales pour les distinguer.</translation>
    </message>
    <message numerus="yes">
        <source>%n target(s)</source>
        <translation>
            <numerusform>%n point visé</numerusform>
            <numerusform>%n points visés</numerusform>
        </translation>
    </message>
    <message>
        <source>at a nominal position + a random part: every %1, the random part at most %2. The axis moves from %3 to %4.</source>
        <translation>à une position nominale + une part aléatoire&#xa0;: tous les %1, part aléatoire d’au plus %2. L’axe se déplace de %3 à %4.</translation>
    </message>
    <message>
        <source>A long axis: once each way over the whole travel, and a full test of the agreed zone besides, from %1 to %2.</source>
        <translation>Un axe long&#xa0;: une fois par sens sur toute la course, et en plus un essai complet de la zone convenue, de %1 à %2.</translation>
    </message>
    <message>
        <source>A long axis: once each way over the whole travel, and a full test of a zone besides, planned from %1 to %2; the zone is to be agreed.</source>
        <translation>Un axe long&#xa0;: une fois par sens sur toute la course, et en plus un essai complet d’une zone, prévu de %1 à %2&#x202f;; la zone est à convenir.</translation>
    </message>
    <message>
        <source>The step cycle needs a written agreement.</source>
        <translation>Le cycle en pas demande un accord écrit.</translation>
    </message>
    <message>
        <source>%1 cannot be saved</source>
        <translation>%1 ne peut pas être enregistré</translation>
    </message>
    <message>
        <source>Save the part program</source>
        <translation>Enregistrer le programme pièce</translation>
    </message>
    <message>
        <source>Save the plan</source>
        <translation>Enregistrer le plan</translation>
    </message>
    <message>
        <source>Plan of measurement</source>
        <translation>Plan de mesure</translation>
    </message>
    <message>
        <source>&amp;Other targets</source>
        <translation>&amp;Autres points</translation>
    </message>
    <message>
        <source>&amp;Put into the test</source>
        <translation>&amp;Placer dans l’essai</translation>
    </message>
    <message>
        <source>For a positioning test without readings</source>
        <translation>Pour un essai de positionnement sans relevés</translation>
    </message>
    <message>
        <source>&amp;New test</source>
        <translation>&amp;Nouvel essai</translation>
    </message>
    <message>
        <source>P&amp;rint…</source>
        <translation>&amp;Imprimer…</translation>
    </message>
    <message>
        <source>Save P&amp;DF…</source>
        <translation>Enregistrer P&amp;DF…</translation>
    </message>
    <message>
        <source>Part pro&amp;gram…</source>
        <translation>Pro&amp;gramme pièce…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Measuring cycle</source>
        <translation>Cycle de mesure</translation>
    </message>
    <message>
        <source>a number is needed</source>
        <translation>il faut un nombre</translation>
    </message>
    <message>
        <source>not greater than 0</source>
        <translation>pas supérieur à 0</translation>
    </message>
    <message>
        <source>not from %1 to %2</source>
        <translation>pas entre %1 et %2</translation>
    </message>
    <message>
        <source>not a whole number</source>
        <translation>pas un nombre entier</translation>
    </message>
    <message>
        <source>No part program: %1</source>
        <translation>Pas de programme pièce&#xa0;: %1</translation>
    </message>
    <message>
        <source>The random part follows ISO 230-2:2006: ISO 230-2:1988 has no rule for an unknown or long cyclic pitch.</source>
        <translation>La partie aléatoire suit l’ISO 230-2:2006&#xa0;: l’ISO 230-2:1988 n’a pas de règle pour un pas cyclique inconnu ou long.</translation>
    </message>
    <message>
        <source>at the multiples of 90° and, at random, one in each %1 of the travel. The axis moves from %2 to %3.</source>
        <translation>aux multiples de 90° et, au hasard, un par tranche de %1 de la course. L’axe va de %2 à %3.</translation>
    </message>
    <message>
        <source>of this test. The axis moves from %1 to %2.</source>
        <translation>de cet essai. L’axe se déplace de %1 à %2.</translation>
    </message>
    <message>
        <source>Plan new &amp;targets</source>
        <translation>Planifier de nouveaux &amp;points</translation>
    </message>
    <message>
        <source>Chosen by the rule of the edition; the test keeps its own until they are put into it</source>
        <translation>Choisis selon la règle de l’édition&#x202f;; l’essai garde les siens tant qu’ils n’y sont pas inscrits</translation>
    </message>
</context>
<context>
    <name>palmer::ui::PointsModel</name>
    <message>
        <source>angle °</source>
        <translation>angle °</translation>
    </message>
</context>
<context>
    <name>palmer::ui::RawTextModel</name>
    <message>
        <source>Click to read this table instead</source>
        <translation>Cliquer pour lire plutôt ce tableau</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ReadingsModel</name>
    <message>
        <source>Number of the target</source>
        <translation>Numéro du point visé</translation>
    </message>
    <message>
        <source>Run %1 %2</source>
        <translation>Passe %1 %2</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Passe %1</translation>
    </message>
    <message>
        <source>Runs %1</source>
        <translation>Passes %1</translation>
    </message>
    <message>
        <source>Computed, %1</source>
        <translation>Calculé, %1</translation>
    </message>
    <message>
        <source>Set aside, without a reason</source>
        <translation>Écarté, sans motif</translation>
    </message>
    <message>
        <source>Set aside: %1</source>
        <translation>Écarté&#xa0;: %1</translation>
    </message>
    <message>
        <source>target %1, %2</source>
        <translation>point visé %1, %2</translation>
    </message>
    <message>
        <source>no reading</source>
        <translation>pas de relevé</translation>
    </message>
    <message>
        <source>other decimal mark</source>
        <translation>autre séparateur décimal</translation>
    </message>
    <message>
        <source>%1: not taken, the reading is missing</source>
        <translation>%1&#xa0;: non repris, le relevé manque</translation>
    </message>
    <message>
        <source>Far from the other readings here: a typing error?</source>
        <translation>Loin des autres relevés de ce point&#xa0;: une erreur de saisie&#x202f;?</translation>
    </message>
    <message>
        <source>%1: not taken, the target stays where it was</source>
        <translation>%1&#xa0;: non pris en compte, le point visé reste où il était</translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s) set aside and left so: take back first (%1)</source>
        <translation>
            <numerusform>%n relevé écarté laissé ainsi&#xa0;: le reprendre d’abord (%1)</numerusform>
            <numerusform>%n relevés écartés laissés ainsi&#xa0;: les reprendre d’abord (%1)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::ReadingsPage</name>
    <message>
        <source>By run</source>
        <translation>Par passe</translation>
    </message>
    <message>
        <source>By direction</source>
        <translation>Par sens</translation>
    </message>
    <message>
        <source>Show deviations from the target positions</source>
        <translation>Afficher les écarts aux points visés</translation>
    </message>
    <message>
        <source>Show actual positions; the data stay as they are</source>
        <translation>Afficher les positions réelles&#x202f;; les données restent telles quelles</translation>
    </message>
    <message>
        <source>Runs side by side, both directions of a run together</source>
        <translation>Passes côte à côte, les deux sens d’une passe ensemble</translation>
    </message>
    <message>
        <source>All runs of one direction side by side</source>
        <translation>Toutes les passes d’un sens côte à côte</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translation>Mettre à l’écart</translation>
    </message>
    <message>
        <source>Why? The reading stays visible, struck through, and is printed with the reason.</source>
        <translation>Pour quel motif&#x202f;? Le relevé reste visible, barré, et il est imprimé avec le motif.</translation>
    </message>
    <message>
        <source>Deviations %1</source>
        <comment>unit</comment>
        <translation>Écarts %1</translation>
    </message>
    <message>
        <source>Positions %1</source>
        <comment>unit</comment>
        <translation>Positions %1</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>C&amp;oller</translation>
    </message>
    <message>
        <source>Cl&amp;ear</source>
        <translation>&amp;Effacer</translation>
    </message>
    <message>
        <source>Fill do&amp;wn</source>
        <translation>Recopier vers le &amp;bas</translation>
    </message>
    <message>
        <source>Fill ri&amp;ght</source>
        <translation>Recopier à &amp;droite</translation>
    </message>
    <message>
        <source>&amp;Set aside…</source>
        <translation>&amp;Mettre à l’écart…</translation>
    </message>
    <message>
        <source>Insert target abo&amp;ve</source>
        <translation>Insérer un point &amp;visé au-dessus</translation>
    </message>
    <message>
        <source>Insert target be&amp;low</source>
        <translation>Insérer un point visé au-dess&amp;ous</translation>
    </message>
    <message>
        <source>&amp;Delete targets</source>
        <translation>Supprimer les poi&amp;nts visés</translation>
    </message>
    <message>
        <source>Add a &amp;run each way</source>
        <translation>Ajo&amp;uter une passe par sens</translation>
    </message>
    <message>
        <source>&amp;Insert a run before</source>
        <translation>&amp;Insérer une passe avant</translation>
    </message>
    <message>
        <source>Delete r&amp;uns</source>
        <translation>Supprimer &amp;les passes</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Passe</translation>
    </message>
    <message>
        <source>Add a run each way</source>
        <translation>Ajouter une passe par sens</translation>
    </message>
    <message>
        <source>Paste a block (%1)</source>
        <translation>Coller un tableau (%1)</translation>
    </message>
    <message numerus="yes">
        <source>Leave out %n target(s) without readings</source>
        <translation>
            <numerusform>Retirer %n point visé sans relevé</numerusform>
            <numerusform>Retirer %n points visés sans relevés</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste a block</source>
        <translation>Coller un tableau</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Co&amp;uper</translation>
    </message>
    <message>
        <source>Take &amp;back</source>
        <translation>Re&amp;prendre</translation>
    </message>
    <message>
        <source>nothing to fill with: the first cell has no reading</source>
        <translation>rien à recopier&#xa0;: la première cellule n’a pas de relevé</translation>
    </message>
</context>
<context>
    <name>palmer::ui::RecoveryDialog</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>Documents with unsaved changes</source>
        <translation>Documents avec des modifications non enregistrées</translation>
    </message>
    <message>
        <source>Never saved: %1</source>
        <translation>Jamais enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>%1 — changes up to %2</source>
        <comment>file, time</comment>
        <translation>%1 — modifications jusqu’au %2</translation>
    </message>
    <message>
        <source>Palmer ended without saving these documents. Open them with their changes? The files themselves are as they were saved last.</source>
        <translation>Palmer s’est arrêté sans enregistrer ces documents. Les ouvrir avec leurs modifications&#x202f;? Les fichiers eux-mêmes sont tels qu’au dernier enregistrement.</translation>
    </message>
    <message>
        <source>&amp;Open with changes</source>
        <translation>&amp;Ouvrir avec les modifications</translation>
    </message>
    <message>
        <source>&amp;Discard the changes</source>
        <translation>&amp;Abandonner les modifications</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Plus tard</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 ne peut être lu&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>palmer::ui::RegisterFirstUse</name>
    <message>
        <source>All tests of all your machines, over the years</source>
        <translation>Tous les essais de toutes vos machines, au fil des ans</translation>
    </message>
    <message>
        <source>Name the folder in which the tests are kept. Palmer reads the .palmer files in it
and the PDF reports that contain them, and sorts them by machine.</source>
        <translation>Indiquez le dossier où sont rangés vos essais. Palmer y lit les fichiers .palmer
et les rapports PDF qui les contiennent, et les classe par machine.</translation>
    </message>
    <message>
        <source>Choose a folder…</source>
        <translation>Choisir un dossier…</translation>
    </message>
    <message>
        <source>or drop a folder into the window</source>
        <translation>ou déposez un dossier dans la fenêtre</translation>
    </message>
    <message>
        <source>Nothing is changed</source>
        <translation>Rien n’est modifié</translation>
    </message>
    <message>
        <source>Folders below included</source>
        <translation>Sous-dossiers compris</translation>
    </message>
    <message>
        <source>Always up to date</source>
        <translation>Toujours à jour</translation>
    </message>
    <message>
        <source>Your files stay the only record; Palmer never writes into them.</source>
        <translation>Vos fichiers restent la seule preuve&#x202f;; Palmer n’y écrit jamais.</translation>
    </message>
    <message>
        <source>A share, a local disk: as many as you like.</source>
        <translation>Dossier partagé, disque local&#xa0;: autant que vous voulez.</translation>
    </message>
    <message>
        <source>Watched while you work; the index can be made anew at any time.</source>
        <translation>Suivi pendant le travail&#x202f;; index refait à tout moment.</translation>
    </message>
</context>
<context>
    <name>palmer::ui::RegisterMenus</name>
    <message>
        <source>&amp;Join with another…</source>
        <translation>Ré&amp;unir à une autre…</translation>
    </message>
    <message>
        <source>&amp;Register</source>
        <translation>&amp;Registre</translation>
    </message>
    <message>
        <source>&amp;Machine</source>
        <translation>&amp;Machine</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>&amp;Essai</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>&amp;Interval</source>
        <translation>&amp;Périodicité</translation>
    </message>
    <message>
        <source>&amp;Evaluate all under…</source>
        <translation>&amp;Évaluer tout sous…</translation>
    </message>
    <message>
        <source>&amp;Sort by</source>
        <translation>&amp;Trier par</translation>
    </message>
    <message>
        <source>&amp;Folders…</source>
        <translation>&amp;Dossiers…</translation>
    </message>
    <message>
        <source>&amp;Rescan</source>
        <translation>&amp;Actualiser</translation>
    </message>
    <message>
        <source>Files with &amp;troubles…</source>
        <translation>Fichiers à &amp;problème…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>&amp;Search machines</source>
        <translation>&amp;Rechercher une machine</translation>
    </message>
    <message>
        <source>&amp;Previous machine</source>
        <translation>Machine précé&amp;dente</translation>
    </message>
    <message>
        <source>&amp;Next machine</source>
        <translation>Machine &amp;suivante</translation>
    </message>
    <message>
        <source>&amp;History report…</source>
        <translation>&amp;Historique…</translation>
    </message>
    <message>
        <source>&amp;Open test</source>
        <translation>&amp;Ouvrir l’essai</translation>
    </message>
    <message>
        <source>&amp;Compare curves</source>
        <translation>&amp;Comparer les courbes</translation>
    </message>
    <message>
        <source>C&amp;lear filters</source>
        <translation>&amp;Effacer les filtres</translation>
    </message>
    <message>
        <source>&amp;Trend alone</source>
        <translation>&amp;Tendance seule</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Raccourcis clavier</translation>
    </message>
    <message>
        <source>&amp;About Palmer</source>
        <translation>À &amp;propos de Palmer</translation>
    </message>
    <message>
        <source>&amp;Type test…</source>
        <translation>Essai de &amp;type…</translation>
    </message>
    <message>
        <source>S&amp;eparate from another…</source>
        <translation>Sép&amp;arer d’une autre…</translation>
    </message>
</context>
<context>
    <name>palmer::ui::RegisterPage</name>
    <message>
        <source>Each test under its own edition</source>
        <translation>Chaque essai selon sa propre édition</translation>
    </message>
    <message>
        <source>%1 axis</source>
        <translation>axe %1</translation>
    </message>
</context>
<context>
    <name>palmer::ui::RegisterSettings</name>
    <message>
        <source>The index stands here: %1</source>
        <translation>L’index se trouve ici&#xa0;: %1</translation>
    </message>
    <message>
        <source>The address of a server begins with postgresql://</source>
        <translation>L’adresse d’un serveur commence par postgresql://</translation>
    </message>
    <message>
        <source>The server is being asked…</source>
        <translation>Le serveur est interrogé…</translation>
    </message>
    <message>
        <source>The server keeps the register now.</source>
        <translation>Le serveur tient désormais le registre.</translation>
    </message>
    <message>
        <source>Nothing was changed: %1</source>
        <translation>Rien n’a été modifié&#xa0;: %1</translation>
    </message>
    <message>
        <source>Folders of the register</source>
        <translation>Dossiers du registre</translation>
    </message>
    <message>
        <source>Index of the register</source>
        <translation>Index du registre</translation>
    </message>
    <message>
        <source>In a file of this user</source>
        <translation>Dans un fichier de cet utilisateur</translation>
    </message>
    <message>
        <source>On a PostgreSQL server that several share</source>
        <translation>Sur un serveur PostgreSQL partagé</translation>
    </message>
    <message>
        <source>Address of the server</source>
        <translation>Adresse du serveur</translation>
    </message>
    <message>
        <source>Password, where the server asks for one</source>
        <translation>Mot de passe, si le serveur en demande un</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Mot de passe</translation>
    </message>
    <message>
        <source>Co&amp;nnect</source>
        <translation>Se c&amp;onnecter</translation>
    </message>
    <message>
        <source>The password is not stored: after the next start it is taken from your password file of PostgreSQL (~/.pgpass), or asked for here again.</source>
        <translation>Le mot de passe n’est pas enregistré&#xa0;: au prochain démarrage, il est lu dans votre fichier de mots de passe de PostgreSQL (~/.pgpass), ou à saisir de nouveau ici.</translation>
    </message>
</context>
<context>
    <name>palmer::ui::RegisterStatus</name>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stop reading: what was read stays, Rescan goes on</source>
        <translation>Arrêter la lecture&#xa0;: ce qui est lu reste, Actualiser reprend la suite</translation>
    </message>
    <message numerus="yes">
        <source>%n machine(s)</source>
        <translation>
            <numerusform>%n machine</numerusform>
            <numerusform>%n machines</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n test(s)</source>
        <translation>
            <numerusform>%n essai</numerusform>
            <numerusform>%n essais</numerusform>
        </translation>
    </message>
    <message>
        <source>No folder is watched</source>
        <translation>Aucun dossier suivi</translation>
    </message>
    <message numerus="yes">
        <source>%n folder(s) watched</source>
        <translation>
            <numerusform>%n dossier suivi</numerusform>
            <numerusform>%n dossiers suivis</numerusform>
        </translation>
    </message>
    <message>
        <source>being read</source>
        <translation>en cours de lecture</translation>
    </message>
    <message>
        <source>reading stopped</source>
        <translation>lecture arrêtée</translation>
    </message>
    <message>
        <source>up to date at %1</source>
        <translation>à jour à %1</translation>
    </message>
    <message numerus="yes">
        <source>reading %1 of %2 file(s)</source>
        <translation>
            <numerusform>lecture&#xa0;: %1 sur %2 fichier</numerusform>
            <numerusform>lecture&#xa0;: %1 sur %2 fichiers</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>encore %1&#xa0;s</translation>
    </message>
    <message numerus="yes">
        <source>%n unreadable file(s)</source>
        <translation>
            <numerusform>%n fichier illisible</numerusform>
            <numerusform>%n fichiers illisibles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) not found</source>
        <translation>
            <numerusform>%n fichier introuvable</numerusform>
            <numerusform>%n fichiers introuvables</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n test(s) shown</source>
        <translation>
            <numerusform>%n essai affiché</numerusform>
            <numerusform>%n essais affichés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n chosen</source>
        <translation>
            <numerusform>%n choisi</numerusform>
            <numerusform>%n choisis</numerusform>
        </translation>
    </message>
    <message>
        <source>F1 help</source>
        <translation>F1 aide</translation>
    </message>
</context>
<context>
    <name>palmer::ui::RegisterWindow</name>
    <message>
        <source>Join machines</source>
        <translation>Réunir des machines</translation>
    </message>
    <message>
        <source>%1
is the same machine as:</source>
        <translation>%1
est la même machine que&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Join</source>
        <translation>&amp;Réunir</translation>
    </message>
    <message>
        <source>More than half of the tests of these folders are not found. Is a drive not connected?</source>
        <translation>Plus de la moitié des essais de ces dossiers sont introuvables. Un lecteur n’est-il pas connecté&#x202f;?</translation>
    </message>
    <message>
        <source>&amp;Remove all the same</source>
        <translation>&amp;Retirer quand même</translation>
    </message>
    <message>
        <source>Files of the register</source>
        <translation>Fichiers du registre</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Choisir un dossier</translation>
    </message>
    <message>
        <source>Separate machines</source>
        <translation>Séparer des machines</translation>
    </message>
    <message>
        <source>%1
is not the same machine as:</source>
        <translation>%1
n’est pas la même machine que&#xa0;:</translation>
    </message>
    <message>
        <source>&amp;Separate</source>
        <translation>&amp;Séparer</translation>
    </message>
</context>
<context>
    <name>palmer::ui::RemarkList</name>
    <message>
        <source>confirm</source>
        <translation>confirmer</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more remark(s)</source>
        <translation>
            <numerusform>… et %n autre remarque</numerusform>
            <numerusform>… et %n autres remarques</numerusform>
        </translation>
    </message>
    <message>
        <source>Line %1, column %2: %3</source>
        <translation>Ligne %1, colonne %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>go to the line</source>
        <translation>aller à la ligne</translation>
    </message>
    <message>
        <source>confirm: %1</source>
        <translation>confirmer&#xa0;: %1</translation>
    </message>
    <message>
        <source>another answer</source>
        <translation>autre réponse</translation>
    </message>
    <message>
        <source>answer</source>
        <translation>répondre</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>douteux</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>supposé</translation>
    </message>
    <message>
        <source>Something speaks against it: it wants an answer of its own.</source>
        <translation>Quelque chose s’y oppose&#xa0;: il faut y répondre séparément.</translation>
    </message>
    <message>
        <source>The file does not say it and the usual holds.</source>
        <translation>Le fichier ne le dit pas et l’usage vaut.</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ReportBar</name>
    <message>
        <source>&amp;Details</source>
        <translation>&amp;Détails</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Differences of the report</source>
        <translation>Écarts du rapport</translation>
    </message>
    <message>
        <source>The report was not verified: %1</source>
        <translation>Le rapport n’a pas été vérifié&#xa0;: %1</translation>
    </message>
    <message>
        <source>Report verified.</source>
        <translation>Rapport vérifié.</translation>
    </message>
    <message>
        <source>Report NOT verified.</source>
        <translation>Rapport NON vérifié.</translation>
    </message>
    <message>
        <source>Edited since: the window no longer shows what was verified in the report.</source>
        <translation>Modifié depuis&#xa0;: la fenêtre ne montre plus ce qui a été vérifié dans le rapport.</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ReportDialog</name>
    <message>
        <source>Single readings in the figure</source>
        <translation>Relevés dans la figure</translation>
    </message>
    <message>
        <source>Mean repeatability (1988)</source>
        <translation>Répétabilité moyenne (1988)</translation>
    </message>
    <message numerus="yes">
        <source>%n required statement(s) missing; printed as “–”</source>
        <translation>
            <numerusform>%n information requise manque&#x202f;; elle sera remplacée par un tiret</numerusform>
            <numerusform>%n informations requises manquent&#x202f;; elles seront remplacées par un tiret</numerusform>
        </translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message numerus="yes">
        <source>%n page(s) %1 · preview = PDF = paper</source>
        <translation>
            <numerusform>%n page %1 · aperçu = PDF = papier</numerusform>
            <numerusform>%n pages %1 · aperçu = PDF = papier</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>PDF files (*.pdf)</source>
        <translation>Fichiers PDF (*.pdf)</translation>
    </message>
    <message>
        <source>%1 cannot be saved</source>
        <translation>%1 ne peut pas être enregistré</translation>
    </message>
    <message>
        <source>Composing the pages…</source>
        <translation>Composition des pages…</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>Enregistrement…</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>The printer did not accept the report.</source>
        <translation>L’imprimante n’a pas accepté le rapport.</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>Page précédente</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>Page suivante</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Zoom arrière</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Zoom avant</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Largeur</translation>
    </message>
    <message>
        <source>Pages of the report</source>
        <translation>Pages du rapport</translation>
    </message>
    <message>
        <source>Pages in small</source>
        <translation>Pages en petit</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>Both languages</source>
        <translation>Les deux langues</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>P&amp;apier</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Sections</translation>
    </message>
    <message>
        <source>&amp;Save PDF…</source>
        <translation>&amp;Enregistrer le PDF…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Imprimer…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>encore %1&#xa0;s</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Temperature curve</source>
        <translation>Courbe des températures</translation>
    </message>
    <message>
        <source>All readings (over 2000 rows)</source>
        <translation>Tous les relevés (plus de 2&#x202f;000 lignes)</translation>
    </message>
    <message>
        <source>Replace %1?</source>
        <translation>Remplacer %1&#x202f;?</translation>
    </message>
    <message>
        <source>What is there now is lost.</source>
        <translation>Ce qui s’y trouve est perdu.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Remplacer</translation>
    </message>
    <message>
        <source>In the PDF: the whole test file (%1, %2), remarks and names in it included, and the results</source>
        <translation>Dans le PDF&#xa0;: le fichier d’essai entier (%1, %2), remarques et noms compris, et les résultats</translation>
    </message>
    <message>
        <source>Attach the instrument files, too</source>
        <translation>Joindre aussi les fichiers de l’instrument</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>Open the &amp;folder</source>
        <translation>Ouvrir le &amp;dossier</translation>
    </message>
    <message>
        <source>Diagnosis of circles</source>
        <translation>Diagnostic des cercles</translation>
    </message>
    <message numerus="yes">
        <source>All readings (about %n more page(s))</source>
        <translation>
            <numerusform>Tous les relevés (environ %n page de plus)</numerusform>
            <numerusform>Tous les relevés (environ %n pages de plus)</numerusform>
        </translation>
    </message>
    <message>
        <source>U to two significant digits</source>
        <translation>U à deux chiffres significatifs</translation>
    </message>
    <message>
        <source>Attach a digital calibration certificate (DCC)</source>
        <translation>Joindre le certificat numérique (DCC)</translation>
    </message>
    <message>
        <source>Signatures</source>
        <translation>Signatures</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ResultsModel</name>
    <message>
        <source>before</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>after</source>
        <translation>après</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ResultsPanel</name>
    <message>
        <source>provisional</source>
        <translation>provisoire</translation>
    </message>
    <message>
        <source>Copy the results as a table (%1)</source>
        <translation>Copier les résultats en tableau (%1)</translation>
    </message>
    <message>
        <source>Copy the results as a table</source>
        <translation>Copier les résultats en tableau</translation>
    </message>
    <message>
        <source>test %1 of %2</source>
        <translation>essai %1 du %2</translation>
    </message>
    <message>
        <source>Before the adjustment: %1 · after it: %2</source>
        <translation>Avant réglage&#xa0;: %1 · après réglage&#xa0;: %2</translation>
    </message>
    <message>
        <source>Results copied</source>
        <translation>Résultats copiés</translation>
    </message>
    <message>
        <source>&amp;Explain</source>
        <translation>&amp;Expliquer</translation>
    </message>
    <message>
        <source>&amp;Copy with U and unit</source>
        <translation>&amp;Copier avec U et unité</translation>
    </message>
    <message>
        <source>Copy the &amp;table</source>
        <translation>Copier le &amp;tableau</translation>
    </message>
</context>
<context>
    <name>palmer::ui::RightSide</name>
    <message>
        <source>Figure</source>
        <translation>Figure</translation>
    </message>
    <message>
        <source>Figure, results, findings</source>
        <translation>Figure, résultats, constats</translation>
    </message>
    <message>
        <source>Being computed; shown is what was before</source>
        <translation>Calcul en cours&#x202f;; affiché&#xa0;: l’état précédent</translation>
    </message>
</context>
<context>
    <name>palmer::ui::Saving</name>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Documents PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Enregistré&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>palmer::ui::SearchBox</name>
    <message numerus="yes">
        <source>%n answer(s)</source>
        <translation>
            <numerusform>%n réponse</numerusform>
            <numerusform>%n réponses</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>search: %n answer(s)</source>
        <translation>
            <numerusform>recherche&#xa0;: %n réponse</numerusform>
            <numerusform>recherche&#xa0;: %n réponses</numerusform>
        </translation>
    </message>
    <message>
        <source>Settings and commands</source>
        <translation>Réglages et commandes</translation>
    </message>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation>Chercher (Ctrl+F)</translation>
    </message>
    <message>
        <source>Search fields, results, findings and settings</source>
        <translation>Chercher dans les champs, résultats, constats et réglages</translation>
    </message>
    <message>
        <source>↑↓ choose · Enter go there · Ctrl+Enter without closing · Esc close</source>
        <translation>↑↓ choisir · Entrée y aller · Ctrl+Entrée sans fermer · Échap fermer</translation>
    </message>
</context>
<context>
    <name>palmer::ui::SectionHead</name>
    <message>
        <source>Unfold the section</source>
        <translation>Déplier la section</translation>
    </message>
    <message>
        <source>Fold the section away</source>
        <translation>Replier la section</translation>
    </message>
</context>
<context>
    <name>palmer::ui::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>&amp;Language of the window</source>
        <translation>&amp;Langue de la fenêtre</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thème</translation>
    </message>
    <message>
        <source>L&amp;engths</source>
        <translation>Lo&amp;ngueurs</translation>
    </message>
    <message>
        <source>An&amp;gles</source>
        <translation>An&amp;gles</translation>
    </message>
    <message>
        <source>as the system</source>
        <translation>comme le système</translation>
    </message>
    <message>
        <source>light</source>
        <translation>clair</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>sombre</translation>
    </message>
    <message>
        <source>µm and mm</source>
        <translation>µm et mm</translation>
    </message>
    <message>
        <source>mm only</source>
        <translation>mm seulement</translation>
    </message>
    <message>
        <source>µin and inches</source>
        <translation>µin et pouces</translation>
    </message>
    <message>
        <source>arc seconds and degrees</source>
        <translation>secondes d’arc et degrés</translation>
    </message>
    <message>
        <source>degrees only</source>
        <translation>degrés seulement</translation>
    </message>
    <message>
        <source>&amp;Keep changes safe from a crash</source>
        <translation>&amp;Protéger les modifications d’un arrêt brutal</translation>
    </message>
    <message>
        <source>A copy of what is not saved, in a folder of Palmer; it goes when you save</source>
        <translation>Copie de ce qui n’est pas enregistré, dans un dossier de Palmer&#x202f;; elle disparaît à l’enregistrement</translation>
    </message>
    <message>
        <source>Keep the version &amp;before when saving</source>
        <translation>&amp;Conserver la version précédente à l’enregistrement</translation>
    </message>
    <message>
        <source>Beside the file, with .bak at the end of its name</source>
        <translation>À côté du fichier, avec .bak à la fin de son nom</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
</context>
<context>
    <name>palmer::ui::SheetModel</name>
    <message>
        <source>Link</source>
        <translation>Lien</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Norme</translation>
    </message>
</context>
<context>
    <name>palmer::ui::SheetPage</name>
    <message>
        <source>ISO 14253-1: conformity is to be proven</source>
        <translation>ISO 14253-1&#xa0;: conformité à prouver</translation>
    </message>
    <message>
        <source>non-conformity is to be proven</source>
        <translation>non-conformité à prouver</translation>
    </message>
    <message>
        <source>Guard band, times U</source>
        <translation>Facteur de bande de garde (×&#xa0;U)</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Contrôles</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Add a row</source>
        <translation>Ajouter une ligne</translation>
    </message>
    <message>
        <source>Remove rows</source>
        <translation>Supprimer les lignes</translation>
    </message>
    <message>
        <source>Take from a test…</source>
        <translation>Reprendre d’un essai…</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) pasted</source>
        <translation>
            <numerusform>%n ligne collée</numerusform>
            <numerusform>%n lignes collées</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing was checked beside the tests yet. Type into the empty row, or paste a table with number, object, tolerance, measured value, U and unit.</source>
        <translation>Rien n’a encore été contrôlé en plus des essais. Saisir dans la ligne vide, ou coller un tableau avec numéro, objet, tolérance, valeur mesurée, U et unité.</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ShortcutsDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Table of readings</source>
        <translation>Tableau des relevés</translation>
    </message>
    <message>
        <source>next reading of the measuring cycle</source>
        <translation>relevé suivant du cycle de mesure</translation>
    </message>
    <message>
        <source>the one before</source>
        <translation>relevé précédent</translation>
    </message>
    <message>
        <source>to the right, to the left</source>
        <translation>à droite, à gauche</translation>
    </message>
    <message>
        <source>edit the reading</source>
        <translation>modifier le relevé</translation>
    </message>
    <message>
        <source>restore the reading; close an explanation</source>
        <translation>rétablir le relevé&#x202f;; fermer une explication</translation>
    </message>
    <message>
        <source>first, last cell</source>
        <translation>première, dernière cellule</translation>
    </message>
</context>
<context>
    <name>palmer::ui::SimulationRow</name>
    <message>
        <source>Simulate</source>
        <translation>Simuler</translation>
    </message>
    <message>
        <source>Run the Monte Carlo simulation of this test</source>
        <translation>Lancer la simulation de Monte-Carlo de cet essai</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cancel the simulation</source>
        <translation>Annuler la simulation</translation>
    </message>
    <message>
        <source>Progress of the simulation</source>
        <translation>Avancement de la simulation</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>encore %1 s</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>germe %1</translation>
    </message>
    <message>
        <source>outdated: edited since</source>
        <translation>périmée&#xa0;: modifié depuis</translation>
    </message>
    <message>
        <source>not simulated yet</source>
        <translation>pas encore simulé</translation>
    </message>
    <message>
        <source>needs a complete budget</source>
        <translation>demande un budget complet</translation>
    </message>
    <message>
        <source>stable to half a unit of the second digit of u</source>
        <translation>stable à une demi-unité du deuxième chiffre de u</translation>
    </message>
    <message>
        <source>too few to decide</source>
        <translation>trop peu pour un verdict</translation>
    </message>
    <message numerus="yes">
        <source>%1 trial(s)</source>
        <translation>
            <numerusform>%1 tirage</numerusform>
            <numerusform>%1 tirages</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::StandardButtons</name>
    <message>
        <source>&amp;OK</source>
        <translation>&amp;OK</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Ne pas enregistrer</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
</context>
<context>
    <name>palmer::ui::StatementsBox</name>
    <message>
        <source>Take &amp;over what is stated of “%1”</source>
        <translation>Reprendre ce &amp;qui est indiqué pour «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Instruments, state of the machine, places of the sensors, agreed points that name no axis, decision rule; nothing that was measured, no limits.</source>
        <translation>Instruments, état de la machine, positions des capteurs, points convenus indépendants de l’axe, règle de décision&#x202f;; aucune valeur mesurée, aucune limite.</translation>
    </message>
</context>
<context>
    <name>palmer::ui::TargetCard</name>
    <message>
        <source>Target %1</source>
        <translation>Point visé %1</translation>
    </message>
    <message>
        <source>Readings of target %1</source>
        <translation>Relevés du point visé %1</translation>
    </message>
    <message>
        <source>Statistics of target %1</source>
        <translation>Statistiques du point visé %1</translation>
    </message>
    <message>
        <source>bidir.</source>
        <comment>short for bidirectional</comment>
        <translation>bidir.</translation>
    </message>
    <message>
        <source>Previous target</source>
        <translation>Point visé précédent</translation>
    </message>
    <message>
        <source>Next target</source>
        <translation>Point visé suivant</translation>
    </message>
</context>
<context>
    <name>palmer::ui::TemplateButton</name>
    <message>
        <source>No template yet</source>
        <translation>Aucun modèle pour l’instant</translation>
    </message>
    <message>
        <source>Cannot be read: %1</source>
        <translation>Illisible&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Keep as template…</source>
        <translation>&amp;Garder comme modèle…</translation>
    </message>
    <message>
        <source>&amp;Take from a file…</source>
        <translation>&amp;Reprendre d’un fichier…</translation>
    </message>
    <message>
        <source>&amp;Save to a file…</source>
        <translation>&amp;Enregistrer dans un fichier…</translation>
    </message>
    <message>
        <source>&amp;Delete a template</source>
        <translation>&amp;Supprimer un modèle</translation>
    </message>
    <message>
        <source>Keep as template</source>
        <translation>Garder comme modèle</translation>
    </message>
    <message>
        <source>Name of the template</source>
        <translation>Nom du modèle</translation>
    </message>
    <message>
        <source>The template cannot be kept</source>
        <translation>Le modèle ne peut pas être gardé</translation>
    </message>
    <message>
        <source>Take a template from a file</source>
        <translation>Reprendre un modèle d’un fichier</translation>
    </message>
    <message>
        <source>Templates (*.palmer-template)</source>
        <translation>Modèles (*.palmer-template)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>This template is for another page: open it there.</source>
        <translation>Ce modèle est destiné à une autre page&#xa0;: ouvrez-le là.</translation>
    </message>
    <message>
        <source>The template cannot be read</source>
        <translation>Le modèle ne peut pas être lu</translation>
    </message>
    <message>
        <source>Save a template to a file</source>
        <translation>Enregistrer un modèle dans un fichier</translation>
    </message>
    <message>
        <source>The template cannot be saved</source>
        <translation>Le modèle ne peut pas être enregistré</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>Modèles</translation>
    </message>
    <message>
        <source>Fill this page from a template, or keep it as one</source>
        <translation>Remplir cette page depuis un modèle, ou la garder comme modèle</translation>
    </message>
</context>
<context>
    <name>palmer::ui::TestFilters</name>
    <message>
        <source>since %1</source>
        <translation>depuis %1</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
</context>
<context>
    <name>palmer::ui::TestHead</name>
    <message>
        <source>Axis %1</source>
        <translation>Axe %1</translation>
    </message>
    <message>
        <source>standard cycle</source>
        <translation>cycle normal</translation>
    </message>
    <message>
        <source>Plane %1</source>
        <translation>Plan %1</translation>
    </message>
    <message>
        <source>View; test: %1</source>
        <translation>Vue&#x202f;; essai&#xa0;: %1</translation>
    </message>
    <message>
        <source>E&amp;dition</source>
        <translation>Éd&amp;ition</translation>
    </message>
    <message>
        <source>Edition the test is evaluated under</source>
        <translation>Édition selon laquelle l’essai est évalué</translation>
    </message>
    <message>
        <source>Shows the results under another edition; the file stays as it is</source>
        <translation>Montre les résultats selon une autre édition&#x202f;; le fichier reste tel quel</translation>
    </message>
    <message>
        <source>Set as edition of the test</source>
        <translation>Définir comme édition de l’essai</translation>
    </message>
    <message>
        <source>Writes this edition into the test; it can be undone</source>
        <translation>Inscrit cette édition dans l’essai&#x202f;; peut être annulé</translation>
    </message>
    <message>
        <source>&amp;Set as edition</source>
        <translation>Défi&amp;nir comme édition</translation>
    </message>
    <message>
        <source>cycle not stated</source>
        <translation>cycle non indiqué</translation>
    </message>
</context>
<context>
    <name>palmer::ui::TestTableModel</name>
    <message numerus="yes">
        <source>%n not met</source>
        <translation>
            <numerusform>%n non satisfaite</numerusform>
            <numerusform>%n non satisfaites</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not declared</source>
        <translation>
            <numerusform>%n non déclarée</numerusform>
            <numerusform>%n non déclarées</numerusform>
        </translation>
    </message>
    <message>
        <source>in accordance</source>
        <translation>selon l’édition</translation>
    </message>
    <message>
        <source>in part</source>
        <translation>en partie</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>non vérifié</translation>
    </message>
    <message>
        <source>drift</source>
        <translation>dérive</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ThermalPage</name>
    <message>
        <source>No temperatures were recorded with the drift: no response can be told.</source>
        <translation>Aucune température n’a été relevée avec la dérive&#xa0;: aucune réponse ne peut être déterminée.</translation>
    </message>
    <message>
        <source>no test of these axes</source>
        <translation>aucun essai de ces axes</translation>
    </message>
    <message>
        <source>Take %1 into the budget</source>
        <translation>Prendre %1 dans le budget</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Voie</translation>
    </message>
    <message>
        <source>serves</source>
        <translation>sert à</translation>
    </message>
    <message>
        <source>The test that takes E_VE from here</source>
        <translation>L’essai qui prend l’E_VE d’ici</translation>
    </message>
</context>
<context>
    <name>palmer::ui::TrendChart</name>
    <message>
        <source>today</source>
        <translation>aujourd’hui</translation>
    </message>
    <message>
        <source>No test with a date and a value to show.</source>
        <translation>Aucun essai daté ayant une valeur à montrer.</translation>
    </message>
</context>
<context>
    <name>palmer::ui::TrendFacts</name>
    <message>
        <source>Limit %1</source>
        <translation>Limite %1</translation>
    </message>
</context>
<context>
    <name>palmer::ui::TrendView</name>
    <message>
        <source>Evaluate all under…</source>
        <translation>Évaluer tout sous…</translation>
    </message>
    <message>
        <source>Copy the chart</source>
        <translation>Copier le graphique</translation>
    </message>
    <message>
        <source>Show tests and machines again (Esc)</source>
        <translation>Montrer de nouveau les essais et les machines (Échap)</translation>
    </message>
    <message>
        <source>Show the trend alone</source>
        <translation>Montrer la tendance seule</translation>
    </message>
    <message>
        <source>Trend of %1, %2</source>
        <translation>Tendance de %1, %2</translation>
    </message>
</context>
<context>
    <name>palmer::ui::TroubledFiles</name>
    <message>
        <source>Files of the register</source>
        <translation>Fichiers du registre</translation>
    </message>
    <message>
        <source>not found any more</source>
        <translation>introuvable désormais</translation>
    </message>
    <message>
        <source>They change nothing else. What is not found keeps its tests in the register until it is removed.</source>
        <translation>Ils ne changent rien au reste. Ce qui est introuvable garde ses essais dans le registre jusqu’à ce qu’on l’en retire.</translation>
    </message>
    <message>
        <source>&amp;Remove what is not found</source>
        <translation>&amp;Retirer ce qui est introuvable</translation>
    </message>
</context>
<context>
    <name>palmer::ui::TypeDialog</name>
    <message>
        <source>Type test of %1</source>
        <translation>Essai de type de %1</translation>
    </message>
    <message>
        <source>Axis and parameter</source>
        <translation>Axe et grandeur</translation>
    </message>
    <message>
        <source>Values of the machines</source>
        <translation>Valeurs des machines</translation>
    </message>
    <message>
        <source>&amp;Axis and parameter</source>
        <translation>&amp;Axe et grandeur</translation>
    </message>
    <message>
        <source>&amp;Save PDF…</source>
        <translation>&amp;Enregistrer le PDF…</translation>
    </message>
    <message>
        <source>Save the type test</source>
        <translation>Enregistrer l’essai de type</translation>
    </message>
    <message>
        <source>The type test was not saved</source>
        <translation>L’essai de type n’a pas été enregistré</translation>
    </message>
    <message>
        <source>No type test</source>
        <translation>Pas d’essai de type</translation>
    </message>
    <message>
        <source>The machines of this type have no test with a result.</source>
        <translation>Les machines de ce type n’ont aucun essai avec un résultat.</translation>
    </message>
</context>
<context>
    <name>palmer::ui::UncertaintyPage</name>
    <message>
        <source>uncertainty not stated</source>
        <translation>incertitude non indiquée</translation>
    </message>
    <message>
        <source>not every uncertainty stated</source>
        <translation>incertitudes non toutes indiquées</translation>
    </message>
    <message>
        <source>Temperature, machine</source>
        <translation>Température, machine</translation>
    </message>
    <message>
        <source>Temperature, instrument</source>
        <translation>Température, instrument</translation>
    </message>
    <message>
        <source>Expansion, machine</source>
        <translation>Dilatation, machine</translation>
    </message>
    <message>
        <source>Expansion, instrument</source>
        <translation>Dilatation, instrument</translation>
    </message>
    <message>
        <source>Environmental variation</source>
        <translation>Variation environnementale</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Déplacement</translation>
    </message>
    <message numerus="yes">
        <source>%n input(s) of the budget missing</source>
        <translation>
            <numerusform>%n donnée du budget manque</numerusform>
            <numerusform>%n données du budget manquent</numerusform>
        </translation>
    </message>
    <message>
        <source>Method of the uncertainty</source>
        <translation>Méthode de l’incertitude</translation>
    </message>
    <message>
        <source>Env. variation E_VE</source>
        <translation>Environnement E_VE</translation>
    </message>
    <message>
        <source>typed in</source>
        <translation>valeur saisie</translation>
    </message>
    <message>
        <source>E_VE from</source>
        <translation>E_VE selon</translation>
    </message>
    <message>
        <source>Instrument by</source>
        <translation>Instrument selon</translation>
    </message>
    <message>
        <source>certificate</source>
        <translation>certificat</translation>
    </message>
    <message>
        <source>range of its error</source>
        <translation>étendue de son erreur</translation>
    </message>
    <message>
        <source>Instrument, fixed part</source>
        <translation>Instrument&#xa0;: part fixe</translation>
    </message>
    <message>
        <source>Instrument, per metre</source>
        <translation>Instrument&#xa0;: par mètre</translation>
    </message>
    <message>
        <source>k of the certificate</source>
        <translation>k du certificat</translation>
    </message>
    <message>
        <source>Range of θ, machine</source>
        <translation>Étendue θ machine</translation>
    </message>
    <message>
        <source>Range of θ, instr.</source>
        <translation>Étendue θ instr.</translation>
    </message>
    <message>
        <source>Range of α, machine</source>
        <translation>Étendue α machine</translation>
    </message>
    <message>
        <source>Range of α, instr.</source>
        <translation>Étendue α instr.</translation>
    </message>
    <message>
        <source>Displacement, U</source>
        <translation>Déplacement, U</translation>
    </message>
    <message>
        <source>Reference length, U</source>
        <translation>Longueur de réf., U</translation>
    </message>
    <message>
        <source>Noise of a point, u</source>
        <translation>Bruit d’un point, u</translation>
    </message>
    <message>
        <source>Repeatability, u</source>
        <translation>Répétabilité, u</translation>
    </message>
    <message>
        <source>Centring, u</source>
        <translation>Centrage, u</translation>
    </message>
    <message>
        <source>one each</source>
        <translation>un pour chacun</translation>
    </message>
    <message>
        <source>one for machine and instrument</source>
        <translation>un seul pour machine et instrument</translation>
    </message>
    <message>
        <source>u of θ, machine</source>
        <translation>u de θ machine</translation>
    </message>
    <message>
        <source>u of θ, instr.</source>
        <translation>u de θ instr.</translation>
    </message>
    <message>
        <source>u of α, machine</source>
        <translation>u de α machine</translation>
    </message>
    <message>
        <source>u of α, instr.</source>
        <translation>u de α instr.</translation>
    </message>
    <message>
        <source>Expanded uncertainties, k = 2</source>
        <translation>Incertitudes étendues, k = 2</translation>
    </message>
    <message>
        <source>U(%1)</source>
        <translation>U(%1)</translation>
    </message>
    <message>
        <source>Contributions</source>
        <translation>Contributions</translation>
    </message>
    <message>
        <source>Results, %1</source>
        <translation>Résultats, %1</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Drift of the readings</source>
        <translation>Dérive des relevés</translation>
    </message>
    <message>
        <source>independent</source>
        <translation>indépendante</translation>
    </message>
    <message>
        <source>linear in time</source>
        <translation>linéaire dans le temps</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>Décision</translation>
    </message>
    <message>
        <source>ISO 14253-1: conformity is to be proven</source>
        <translation>ISO 14253-1&#xa0;: conformité à prouver</translation>
    </message>
    <message>
        <source>non-conformity is to be proven</source>
        <translation>non-conformité à prouver</translation>
    </message>
    <message>
        <source>Guard band, times U</source>
        <translation>Facteur de bande de garde (× U)</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Budget</translation>
    </message>
    <message>
        <source>Direct</source>
        <translation>Directe</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>The verdict is based on the budget (GUM) of the contributors that public drafts of annex A name</source>
        <translation>Le verdict est fondé sur le budget (GUM) des composantes que nomment des projets publics de l’annexe A</translation>
    </message>
    <message>
        <source>The verdict is based on the budget (GUM) of the contributors of ISO 230-4, 4.6</source>
        <translation>Le verdict est fondé sur le budget (GUM) des composantes de l’ISO 230-4, 4.6</translation>
    </message>
    <message>
        <source>The verdict is based on the Monte Carlo simulation (GUM Supplement 1)</source>
        <translation>Le verdict est fondé sur la simulation de Monte-Carlo (supplément 1 du GUM)</translation>
    </message>
    <message>
        <source>The expanded uncertainty of every result is entered</source>
        <translation>L’incertitude étendue de chaque résultat est saisie</translation>
    </message>
    <message>
        <source>No uncertainty is stated</source>
        <translation>Aucune incertitude n’est indiquée</translation>
    </message>
    <message>
        <source>Method: %1</source>
        <translation>Méthode&#xa0;: %1</translation>
    </message>
    <message>
        <source>a view: see the edition</source>
        <translation>vue sous une autre édition</translation>
    </message>
    <message>
        <source>Take a typical value, with its source</source>
        <translation>Reprendre une valeur usuelle, avec sa source</translation>
    </message>
    <message>
        <source>Typical values with their source</source>
        <translation>Valeurs usuelles avec leur source</translation>
    </message>
    <message>
        <source>%1/m</source>
        <translation>%1/m</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>adaptatif</translation>
    </message>
    <message>
        <source>Contributions to the uncertainty, the largest first</source>
        <translation>Contributions à l’incertitude, la plus grande d’abord</translation>
    </message>
    <message>
        <source>Calculation</source>
        <translation>Calcul</translation>
    </message>
    <message>
        <source>%1 % of U²</source>
        <translation>%1&#xa0;% de U²</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>improve first: %1, %2 % of U²</source>
        <translation>à améliorer d’abord&#xa0;: %1, %2&#xa0;% de U²</translation>
    </message>
    <message>
        <source>Expanded uncertainty of the results by both methods</source>
        <translation>Incertitude étendue des résultats selon les deux méthodes</translation>
    </message>
    <message>
        <source>distribution</source>
        <translation>répartition</translation>
    </message>
    <message>
        <source>shift</source>
        <translation>décalage</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>écart</translation>
    </message>
    <message>
        <source>%1, used for the verdict</source>
        <translation>%1, retenue pour le verdict</translation>
    </message>
    <message>
        <source>More than a third of the U of the simulation: the budget U is used for the verdict</source>
        <translation>Plus du tiers de l’U de la simulation&#xa0;: le verdict est fondé sur l’U du budget</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>&gt; 20 %</source>
        <translation>&gt; 20&#xa0;%</translation>
    </message>
    <message>
        <source>%1, more than 20 %</source>
        <translation>%1, plus de 20&#xa0;%</translation>
    </message>
    <message>
        <source>The methods differ by more than 20 %: the findings give the reason</source>
        <translation>Les méthodes diffèrent de plus de 20&#xa0;%&#xa0;: les constats en donnent la raison</translation>
    </message>
    <message>
        <source>Bold: the U used for the verdict.</source>
        <translation>En gras&#xa0;: l’incertitude retenue pour le verdict.</translation>
    </message>
    <message>
        <source>k of the displacement</source>
        <translation>k du déplacement</translation>
    </message>
    <message>
        <source>k of the length</source>
        <translation>k de la longueur</translation>
    </message>
    <message>
        <source>Actual targets</source>
        <translation>Points réels</translation>
    </message>
    <message>
        <source>The verdict is based on the budget with what the actual targets carry of its systematic part (Palmer&apos;s method)</source>
        <translation>Le verdict est fondé sur le budget avec ce que les points réels portent de sa part systématique (méthode Palmer)</translation>
    </message>
    <message>
        <source>used for the verdict</source>
        <translation>retenue pour le verdict</translation>
    </message>
    <message>
        <source>used for the verdict · %1</source>
        <translation>retenue pour le verdict · %1</translation>
    </message>
    <message>
        <source>, k = 2</source>
        <translation>, k = 2</translation>
    </message>
    <message>
        <source>actual targets</source>
        <translation>points réels</translation>
    </message>
    <message>
        <source>Monte Carlo, 95.45 %</source>
        <translation>Monte-Carlo, 95,45&#xa0;%</translation>
    </message>
    <message>
        <source>k = 2; %1 of the systematic part S = %2 is carried by the actual targets</source>
        <translation>k = 2&#x202f;; les points réels portent %1 de la part systématique S = %2</translation>
    </message>
    <message>
        <source>2s of U: %1; tolerance of u: %2</source>
        <translation>2s de U&#xa0;: %1&#x202f;; tolérance sur u&#xa0;: %2</translation>
    </message>
    <message>
        <source>interval</source>
        <translation>intervalle</translation>
    </message>
    <message>
        <source>simulation not made yet</source>
        <translation>simulation pas encore effectuée</translation>
    </message>
    <message>
        <source>Grey: simulated before the last edit of the test, outdated.</source>
        <translation>En gris&#xa0;: simulé avant la dernière modification de l’essai, périmé.</translation>
    </message>
    <message>
        <source>%1, outdated</source>
        <translation>%1, périmé</translation>
    </message>
    <message>
        <source>Test lasted, min</source>
        <translation>Durée d’essai, min</translation>
    </message>
</context>
<context>
    <name>palmer::ui::VerdictMark</name>
    <message>
        <source>limits that do not hold here</source>
        <translation>limites non applicables ici</translation>
    </message>
    <message>
        <source>NOT in accordance with the edition</source>
        <translation>NON conforme à l’édition</translation>
    </message>
    <message>
        <source>accordance with the edition not shown</source>
        <translation>conformité à l’édition non établie</translation>
    </message>
    <message>
        <source>in accordance in part</source>
        <translation>conforme en partie à l’édition</translation>
    </message>
    <message>
        <source>in accordance with the edition</source>
        <translation>conforme à l’édition</translation>
    </message>
</context>
<context>
    <name>palmer::ui::WelcomePage</name>
    <message>
        <source>Diagnosis: one influence each</source>
        <translation>Diagnostic&#xa0;: une influence à la fois</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Accueil</translation>
    </message>
    <message>
        <source>Tests of machine tools: measure, judge, print the report</source>
        <translation>Essais de machines-outils&#xa0;: mesurer, juger, imprimer le rapport</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>a test file, .palmer, or a report</source>
        <translation>un fichier d’essai .palmer ou un rapport</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>No file yet. Begin with an example.</source>
        <translation>Aucun fichier pour l’instant. Commencez par un exemple.</translation>
    </message>
    <message>
        <source>verified results</source>
        <translation>résultats vérifiés</translation>
    </message>
    <message>
        <source>&amp;New positioning test…</source>
        <translation>&amp;Nouvel essai de positionnement…</translation>
    </message>
    <message>
        <source>type or paste the readings</source>
        <translation>saisir ou coller les relevés</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>tables and files of instruments</source>
        <translation>tableaux et fichiers d’instruments</translation>
    </message>
    <message>
        <source>or drop files into the window — %1</source>
        <translation>ou déposez des fichiers dans la fenêtre — %1</translation>
    </message>
    <message>
        <source>New &amp;circular test…</source>
        <translation>Nouvel essai de &amp;circularité…</translation>
    </message>
    <message>
        <source>type or paste the points of the arcs</source>
        <translation>saisir ou coller les points des arcs</translation>
    </message>
    <message>
        <source>P&amp;lan of targets…</source>
        <translation>P&amp;lan de points…</translation>
    </message>
    <message>
        <source>targets, part program, table to fill in</source>
        <translation>points visés, programme pièce, tableau à remplir</translation>
    </message>
</context>
<context>
    <name>palmer::ui::WorkBar</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cancel reading</source>
        <translation>Annuler la lecture</translation>
    </message>
    <message>
        <source>Cancel reading: all stays as it was</source>
        <translation>Annuler la lecture&#xa0;: tout reste en l’état</translation>
    </message>
    <message>
        <source>%1 of %2 trials</source>
        <translation>%1 tirages sur %2</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 tirages</translation>
    </message>
    <message>
        <source>%1 of %2 MiB</source>
        <translation>%1 sur %2&#xa0;Mio</translation>
    </message>
</context>
<context>
    <name>palmer::ui::Workplace</name>
    <message numerus="yes">
        <source>%n target(s)</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message>
        <source>target %1, run %2 %3: %4</source>
        <translation>point %1, passe %2 %3&#xa0;: %4</translation>
    </message>
    <message>
        <source>no reading</source>
        <translation>pas de relevé</translation>
    </message>
    <message>
        <source>Pages of the test</source>
        <translation>Pages de l’essai</translation>
    </message>
    <message>
        <source>&amp;Readings</source>
        <translation>&amp;Relevés</translation>
    </message>
    <message>
        <source>&amp;Conditions</source>
        <translation>&amp;Conditions</translation>
    </message>
    <message>
        <source>&amp;Agreed points</source>
        <translation>&amp;Points convenus</translation>
    </message>
    <message>
        <source>&amp;Limits</source>
        <translation>&amp;Limites</translation>
    </message>
    <message>
        <source>next: target %1</source>
        <translation>suivant&#xa0;: point %1</translation>
    </message>
    <message numerus="yes">
        <source>%n arc(s)</source>
        <translation>
            <numerusform>%n arc</numerusform>
            <numerusform>%n arcs</numerusform>
        </translation>
    </message>
    <message>
        <source>Add a test</source>
        <translation>Ajouter un essai</translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s)</source>
        <translation>
            <numerusform>%n relevé</numerusform>
            <numerusform>%n relevés</numerusform>
        </translation>
    </message>
    <message>
        <source>U&amp;ncertainty</source>
        <translation>Incer&amp;titude</translation>
    </message>
    <message>
        <source>Dia&amp;gnosis</source>
        <translation>Dia&amp;gnostic</translation>
    </message>
    <message>
        <source>%1 · in the figure %2</source>
        <translation>%1 · sur la figure %2</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n run(s) each way</source>
        <translation>
            <numerusform>%n passe par sens</numerusform>
            <numerusform>%n passes par sens</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n run(s) ↑</source>
        <translation>
            <numerusform>%n passe ↑</numerusform>
            <numerusform>%n passes ↑</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n run(s) ↓</source>
        <translation>
            <numerusform>%n passe ↓</numerusform>
            <numerusform>%n passes ↓</numerusform>
        </translation>
    </message>
    <message>
        <source>runs: %1 ↑, %2 ↓</source>
        <translation>passes&#xa0;: %1 ↑, %2 ↓</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>C&amp;omparison</source>
        <translation>C&amp;omparaison</translation>
    </message>
    <message>
        <source>Thermal &amp;behaviour</source>
        <translation>Comportement ther&amp;mique</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ZoomButtons</name>
    <message>
        <source>Zoom out</source>
        <translation>Zoom arrière</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Zoom avant</translation>
    </message>
    <message>
        <source>Show the whole figure</source>
        <translation>Afficher la figure entière</translation>
    </message>
</context>
<context>
    <name>palmer::ui::testName</name>
    <message>
        <source>%1 circle</source>
        <translation>Cercle %1</translation>
    </message>
    <message>
        <source>%1 drift</source>
        <translation>Dérive %1</translation>
    </message>
    <message>
        <source>Axis without name</source>
        <translation>Axe sans nom</translation>
    </message>
</context>
</TS>
