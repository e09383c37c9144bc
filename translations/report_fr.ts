<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr">
<context>
    <name>report</name>
    <message>
        <source>January</source>
        <translation>janvier</translation>
    </message>
    <message>
        <source>February</source>
        <translation>février</translation>
    </message>
    <message>
        <source>March</source>
        <translation>mars</translation>
    </message>
    <message>
        <source>April</source>
        <translation>avril</translation>
    </message>
    <message>
        <source>May</source>
        <translation>mai</translation>
    </message>
    <message>
        <source>June</source>
        <translation>juin</translation>
    </message>
    <message>
        <source>July</source>
        <translation>juillet</translation>
    </message>
    <message>
        <source>August</source>
        <translation>août</translation>
    </message>
    <message>
        <source>September</source>
        <translation>septembre</translation>
    </message>
    <message>
        <source>October</source>
        <translation>octobre</translation>
    </message>
    <message>
        <source>November</source>
        <translation>novembre</translation>
    </message>
    <message>
        <source>December</source>
        <translation>décembre</translation>
    </message>
    <message>
        <source>No value for %1: the test has no targets.</source>
        <translation>Pas de valeur pour %1&#xa0;: l’essai n’a aucun point visé.</translation>
    </message>
    <message>
        <source>No value for %1: target %2 has no reading.</source>
        <translation>Pas de valeur pour %1&#xa0;: le point visé %2 n’a aucun relevé.</translation>
    </message>
    <message>
        <source>No value for %1: target %2 has no s.</source>
        <translation>Pas de valeur pour %1&#xa0;: le point visé %2 n’a pas de s.</translation>
    </message>
    <message>
        <source>The limit of %1 cannot be evaluated: %2.</source>
        <translation>La limite de %1 ne peut être évaluée&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Not proven:</source>
        <translation>Non prouvé&#xa0;:</translation>
    </message>
    <message>
        <source>Declared by the laboratory</source>
        <translation>Déclaré par le laboratoire</translation>
    </message>
    <message>
        <source>(named by no test)</source>
        <translation>(cité par aucun essai)</translation>
    </message>
    <message>
        <source>Not evaluable: %1.</source>
        <translation>Non évaluable&#xa0;: %1.</translation>
    </message>
    <message>
        <source>not evaluable</source>
        <comment>a limit</comment>
        <translation>non évaluable</translation>
    </message>
    <message>
        <source>one run in each direction</source>
        <translation>une seule passe par sens</translation>
    </message>
    <message>
        <source>a direction was not measured</source>
        <translation>un sens n’a pas été mesuré</translation>
    </message>
    <message>
        <source>a sense was not measured</source>
        <translation>un sens de parcours n’a pas été mesuré</translation>
    </message>
    <message>
        <source>feedback signal</source>
        <comment>why a limit cannot be evaluated</comment>
        <translation>signal de retour</translation>
    </message>
    <message>
        <source>reference length not calibrated</source>
        <translation>longueur de référence non étalonnée</translation>
    </message>
    <message>
        <source>calibration of the reference length not stated</source>
        <translation>étalonnage de la longueur de référence non indiqué</translation>
    </message>
    <message>
        <source>not a parameter of this test</source>
        <translation>grandeur étrangère à cet essai</translation>
    </message>
    <message>
        <source>agreed for another edition</source>
        <translation>convenue pour une autre édition</translation>
    </message>
    <message>
        <source>no value</source>
        <comment>why a limit cannot be evaluated</comment>
        <translation>pas de valeur</translation>
    </message>
    <message>
        <source>The limit of %1 has no verdict: this test has no such parameter under %2.</source>
        <translation>La limite de %1 reste sans verdict&#xa0;: sous %2, cet essai n’a pas ce paramètre.</translation>
    </message>
    <message>
        <source>The limit of %1 has no verdict: it was agreed for %2, the test is evaluated under %3.</source>
        <translation>La limite de %1 reste sans verdict&#xa0;: elle a été convenue pour %2, l’essai est évalué selon %3.</translation>
    </message>
    <message>
        <source>Nothing is proven for %1: results that depend on the temperature are not shown to hold at 20 °C.</source>
        <translation>Rien n’est prouvé pour %1&#xa0;: la validité à 20&#xa0;°C des résultats qui dépendent de la température n’est pas établie.</translation>
    </message>
    <message>
        <source>Nothing is proven for %1: results that depend on the temperature are not corrected to 20 °C.</source>
        <translation>Rien n’est prouvé pour %1&#xa0;: les résultats qui dépendent de la température ne sont pas corrigés à 20&#xa0;°C.</translation>
    </message>
    <message>
        <source>The decision rule needs the measurement uncertainty: without it nothing is proven.</source>
        <translation>La règle de décision exige l’incertitude de mesure&#xa0;: sans elle, rien n’est prouvé.</translation>
    </message>
    <message>
        <source>The correction to 20 °C cannot be applied: it needs the temperatures and the coefficients of thermal expansion of machine and instrument (0 for a laser whose compensation covers the air only).</source>
        <translation>La correction à 20&#xa0;°C ne peut pas être appliquée&#xa0;: il y faut les températures ainsi que les coefficients de dilatation thermique de la machine et de l’instrument (0 pour un laser dont la compensation ne porte que sur l’air).</translation>
    </message>
    <message>
        <source>A rotary axis has no correction to 20 °C: none was applied.</source>
        <translation>Un axe rotatif n’a pas de correction à 20&#xa0;°C&#xa0;: aucune n’a été appliquée.</translation>
    </message>
    <message>
        <source>The stated uncertainty of the expansion coefficient of the machine, %1, is below the typical minimum of %2.</source>
        <translation>L’incertitude indiquée du coefficient de dilatation de la machine, %1, est inférieure au minimum usuel de %2.</translation>
    </message>
    <message>
        <source>Acceptance code for machine tools — Part 2: Determination of accuracy and repeatability of positioning of numerically controlled machine tools</source>
        <translation>Code de réception des machines-outils — Partie 2&#xa0;: Détermination de la précision et de la répétabilité de positionnement des machines-outils à commande numérique</translation>
    </message>
    <message>
        <source>Test code for machine tools — Part 2: Determination of accuracy and repeatability of positioning numerically controlled axes</source>
        <translation>Code d’essai des machines-outils — Partie 2&#xa0;: Détermination de l’exactitude et de la répétabilité de positionnement des axes en commande numérique</translation>
    </message>
    <message numerus="yes">
        <source>No reading at %1 (%n in all): the statistics use the readings that exist.</source>
        <translation>
            <numerusform>Aucun relevé en %1 (%n au total)&#xa0;: la statistique emploie les relevés existants.</numerusform>
            <numerusform>Aucun relevé en %1 (%n au total)&#xa0;: la statistique emploie les relevés existants.</numerusform>
        </translation>
    </message>
    <message>
        <source>Approaches in the positive direction: %1, in the negative: %2; 5 each way are required.</source>
        <translation>Approches dans le sens positif&#xa0;: %1, dans le sens négatif&#xa0;: %2&#x202f;; 5 par sens sont exigées.</translation>
    </message>
    <message>
        <source>Approaches in the positive direction: %1, in the negative: %2; at least 1 each way is required.</source>
        <translation>Approches dans le sens positif&#xa0;: %1, dans le sens négatif&#xa0;: %2&#x202f;; au moins 1 par sens est exigée.</translation>
    </message>
    <message>
        <source>Runs in the positive direction: %1, in the negative: %2; each direction is evaluated with its own.</source>
        <translation>Séries dans le sens positif&#xa0;: %1, dans le sens négatif&#xa0;: %2&#x202f;; chaque sens est évalué avec les siennes.</translation>
    </message>
    <message numerus="yes">
        <source>Readings set aside without a reason: %n.</source>
        <translation>
            <numerusform>Relevés écartés sans motif&#xa0;: %n.</numerusform>
            <numerusform>Relevés écartés sans motif&#xa0;: %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>The range method for s belongs to ISO 230-2:1988 only: s is calculated here.</source>
        <translation>La méthode de l’étendue pour s n’appartient qu’à l’ISO 230-2:1988&#xa0;: s est calculé ici.</translation>
    </message>
    <message>
        <source>The range method is defined for 2 to 10 readings; target %1 has %2.</source>
        <translation>La méthode de l’étendue est définie pour 2 à 10 relevés&#x202f;; le point visé %1 en a %2.</translation>
    </message>
    <message>
        <source>The deviations at the same target progress steadily from approach to approach: D = %1 from the first to the last (t = %2, above %3). The thermal conditions may be unstable.</source>
        <translation>Les écarts à un même point visé progressent régulièrement d’une approche à l’autre&#xa0;: D = %1 de la première à la dernière (t = %2, au-dessus de %3). Les conditions thermiques sont peut-être instables.</translation>
    </message>
    <message>
        <source>The deviations at the same target progress steadily from approach to approach: D = %1 from the first to the last, beside %4 = %5 (t = %2, above %3). The thermal conditions may be unstable.</source>
        <translation>Les écarts à un même point visé progressent régulièrement d’une approche à l’autre&#xa0;: D = %1 de la première à la dernière, à comparer à %4 = %5 (t = %2, au-dessus de %3). Les conditions thermiques sont peut-être instables.</translation>
    </message>
    <message>
        <source>largest temperature gradient, 12 h before and during the test</source>
        <translation>plus grand gradient de température, 12&#xa0;h avant et pendant l’essai</translation>
    </message>
    <message>
        <source>position of the measuring reference</source>
        <translation>position de la référence de mesurage</translation>
    </message>
    <message>
        <source>warm-up</source>
        <translation>mise en température</translation>
    </message>
    <message>
        <source>feed rate between targets, when not rapid</source>
        <translation>vitesse d’avance entre les points visés, si elle n’est pas rapide</translation>
    </message>
    <message>
        <source>measuring cycle</source>
        <translation>cycle de mesurage</translation>
    </message>
    <message>
        <source>temperature gradient, 12 h before and during the test</source>
        <translation>gradient de température, 12&#xa0;h avant et pendant l’essai</translation>
    </message>
    <message>
        <source>position of the instrument and of the temperature sensors</source>
        <translation>position de l’instrument et des capteurs de température</translation>
    </message>
    <message>
        <source>feed rate between targets</source>
        <translation>vitesse d’avance entre les points visés</translation>
    </message>
    <message>
        <source>position of the axes not under test</source>
        <translation>position des axes non concernés</translation>
    </message>
    <message>
        <source>dwell at each target</source>
        <translation>temps d’arrêt à chaque point visé</translation>
    </message>
    <message>
        <source>first and last target</source>
        <translation>premier et dernier points visés</translation>
    </message>
    <message>
        <source>step cycle</source>
        <translation>cycle en pas</translation>
    </message>
    <message>
        <source>accuracy of an axis</source>
        <comment>A</comment>
        <translation>précision d’un axe</translation>
    </message>
    <message>
        <source>accuracy of an axis, unidirectional</source>
        <translation>précision d’un axe, unidirectionnelle</translation>
    </message>
    <message>
        <source>bi-directional repeatability of positioning of an axis</source>
        <translation>répétabilité de positionnement bidirectionnelle d’un axe</translation>
    </message>
    <message>
        <source>unidirectional repeatability of positioning of an axis</source>
        <translation>répétabilité de positionnement unidirectionnelle d’un axe</translation>
    </message>
    <message>
        <source>mean reversal value of an axis</source>
        <comment>1988</comment>
        <translation>erreur moyenne de réversibilité</translation>
    </message>
    <message>
        <source>mean repeatability</source>
        <translation>valeur moyenne de répétabilité</translation>
    </message>
    <message>
        <source>bi-directional accuracy of positioning of an axis</source>
        <translation>exactitude bidirectionnelle de positionnement d’un axe</translation>
    </message>
    <message>
        <source>unidirectional accuracy of positioning of an axis</source>
        <translation>exactitude unidirectionnelle de positionnement d’un axe</translation>
    </message>
    <message>
        <source>bi-directional systematic positional deviation of an axis</source>
        <translation>écart de position systématique bidirectionnel d’un axe</translation>
    </message>
    <message>
        <source>unidirectional systematic positional deviation of an axis</source>
        <translation>écart de position systématique unidirectionnel d’un axe</translation>
    </message>
    <message>
        <source>range of the mean bi-directional positional deviation of an axis</source>
        <translation>étendue de l’écart de position bidirectionnel moyen d’un axe</translation>
    </message>
    <message>
        <source>reversal value of an axis</source>
        <translation>valeur de réversibilité d’un axe</translation>
    </message>
    <message>
        <source>mean reversal value of an axis</source>
        <translation>valeur moyenne de réversibilité d’un axe</translation>
    </message>
    <message>
        <source>bi-directional positioning accuracy of an axis</source>
        <translation>exactitude bidirectionnelle de positionnement d’un axe</translation>
    </message>
    <message>
        <source>unidirectional positioning accuracy of an axis</source>
        <translation>exactitude unidirectionnelle de positionnement d’un axe</translation>
    </message>
    <message>
        <source>bi-directional systematic positioning error of an axis</source>
        <translation>écart de position systématique bidirectionnel d’un axe</translation>
    </message>
    <message>
        <source>unidirectional systematic positioning error of an axis</source>
        <translation>écart de position systématique unidirectionnel d’un axe</translation>
    </message>
    <message>
        <source>mean bi-directional positioning error of an axis</source>
        <translation>étendue de l’écart de position bidirectionnel moyen d’un axe</translation>
    </message>
    <message>
        <source>bi-directional positioning repeatability of an axis</source>
        <translation>répétabilité de positionnement bidirectionnelle d’un axe</translation>
    </message>
    <message>
        <source>unidirectional positioning repeatability of an axis</source>
        <translation>répétabilité de positionnement unidirectionnelle d’un axe</translation>
    </message>
    <message>
        <source>unidirectional positioning repeatability (UPR)</source>
        <translation>répétabilité de positionnement unidirectionnelle (UPR)</translation>
    </message>
    <message>
        <source>reversal error of an axis</source>
        <translation>valeur de réversibilité d’un axe</translation>
    </message>
    <message>
        <source>mean reversal error of an axis</source>
        <translation>valeur moyenne de réversibilité d’un axe</translation>
    </message>
    <message>
        <source>positional uncertainty (VDI: Positionsunsicherheit)</source>
        <translation>incertitude de position (VDI&#xa0;: Positionsunsicherheit)</translation>
    </message>
    <message>
        <source>positional deviation (VDI: Positionsabweichung)</source>
        <translation>écart de position (VDI&#xa0;: Positionsabweichung)</translation>
    </message>
    <message>
        <source>positional scatter (VDI: Positionsstreubreite), largest</source>
        <translation>dispersion de position (VDI&#xa0;: Positionsstreubreite), la plus grande</translation>
    </message>
    <message>
        <source>positional scatter (VDI: Positionsstreubreite), mean</source>
        <translation>dispersion de position (VDI&#xa0;: Positionsstreubreite), moyenne</translation>
    </message>
    <message>
        <source>reversal range (VDI: Umkehrspanne), largest</source>
        <translation>réversibilité (VDI&#xa0;: Umkehrspanne), la plus grande</translation>
    </message>
    <message>
        <source>reversal range (VDI: Umkehrspanne), mean</source>
        <translation>réversibilité (VDI&#xa0;: Umkehrspanne), moyenne</translation>
    </message>
    <message>
        <source>mean unidirectional positional deviation at a position</source>
        <comment>1988</comment>
        <translation>écart de position unidirectionnel moyen à une position</translation>
    </message>
    <message>
        <source>mean bi-directional positional deviation at a position</source>
        <translation>écart de position bidirectionnel moyen en un point</translation>
    </message>
    <message>
        <source>reversal value at a position</source>
        <comment>1988</comment>
        <translation>erreur de réversibilité en une position</translation>
    </message>
    <message>
        <source>range of the positional deviation</source>
        <translation>étendue de l’écart de position</translation>
    </message>
    <message>
        <source>estimator of the standard deviation</source>
        <translation>estimateur de l’écart-type</translation>
    </message>
    <message>
        <source>unidirectional repeatability of positioning at a position</source>
        <comment>1988</comment>
        <translation>répétabilité de positionnement unidirectionnelle en un point visé</translation>
    </message>
    <message>
        <source>bi-directional repeatability of positioning at a position</source>
        <comment>1988</comment>
        <translation>répétabilité de positionnement bidirectionnelle en un point visé</translation>
    </message>
    <message>
        <source>mean unidirectional positional deviation at a position</source>
        <translation>écart de position unidirectionnel moyen en un point</translation>
    </message>
    <message>
        <source>reversal value at a position</source>
        <translation>valeur de réversibilité en un point</translation>
    </message>
    <message>
        <source>estimator of the unidirectional axis repeatability of positioning at a position</source>
        <translation>estimateur de la répétabilité de l’axe unidirectionnelle du positionnement en un point</translation>
    </message>
    <message>
        <source>unidirectional repeatability of positioning at a position</source>
        <translation>répétabilité de positionnement unidirectionnelle en un point</translation>
    </message>
    <message>
        <source>bi-directional repeatability of positioning at a position</source>
        <translation>répétabilité de positionnement bidirectionnelle en un point</translation>
    </message>
    <message>
        <source>mean unidirectional positioning deviation at a position</source>
        <translation>écart de position unidirectionnel moyen en un point</translation>
    </message>
    <message>
        <source>mean bi-directional positioning deviation at a position</source>
        <translation>écart de position bidirectionnel moyen en un point</translation>
    </message>
    <message>
        <source>reversal error at a position</source>
        <translation>valeur de réversibilité en un point</translation>
    </message>
    <message>
        <source>estimator for unidirectional axis positioning repeatability at a position</source>
        <translation>estimateur de la répétabilité de l’axe unidirectionnelle du positionnement en un point</translation>
    </message>
    <message>
        <source>unidirectional positioning repeatability at a position</source>
        <translation>répétabilité de positionnement unidirectionnelle en un point</translation>
    </message>
    <message>
        <source>bi-directional positioning repeatability at a position</source>
        <translation>répétabilité de positionnement bidirectionnelle en un point</translation>
    </message>
    <message>
        <source>date of the test</source>
        <translation>date de l’essai</translation>
    </message>
    <message>
        <source>manufacturer of the machine</source>
        <translation>constructeur de la machine</translation>
    </message>
    <message>
        <source>type of the machine</source>
        <translation>type de la machine</translation>
    </message>
    <message>
        <source>serial number of the machine</source>
        <translation>numéro de série de la machine</translation>
    </message>
    <message>
        <source>name of the axis</source>
        <translation>désignation de l’axe</translation>
    </message>
    <message>
        <source>measuring system of the axis</source>
        <translation>système de mesure de l’axe</translation>
    </message>
    <message>
        <source>measuring system of the axes</source>
        <translation>système de mesure des axes</translation>
    </message>
    <message>
        <source>how the targets were chosen</source>
        <translation>choix des points visés</translation>
    </message>
    <message>
        <source>instrument</source>
        <translation>instrument de mesure</translation>
    </message>
    <message>
        <source>serial number of each instrument</source>
        <translation>numéro de série de chaque instrument</translation>
    </message>
    <message>
        <source>calibration certificate of each instrument</source>
        <translation>certificat d’étalonnage de chaque instrument</translation>
    </message>
    <message>
        <source>calibration date of each instrument</source>
        <translation>date d’étalonnage de chaque instrument</translation>
    </message>
    <message>
        <source>position of the temperature sensors</source>
        <translation>position des capteurs de température</translation>
    </message>
    <message>
        <source>coefficients of thermal expansion of machine and instrument</source>
        <translation>coefficients de dilatation thermique de la machine et de l’instrument</translation>
    </message>
    <message>
        <source>air pressure</source>
        <translation>pression de l’air</translation>
    </message>
    <message>
        <source>air humidity</source>
        <translation>humidité de l’air</translation>
    </message>
    <message>
        <source>feed rate</source>
        <translation>vitesse d’avance</translation>
    </message>
    <message>
        <source>machine complete and in working order</source>
        <translation>machine complète et en ordre de marche</translation>
    </message>
    <message>
        <source>machine unloaded</source>
        <translation>machine à vide</translation>
    </message>
    <message>
        <source>Number of targets: %1; at least 5 are required.</source>
        <translation>Nombre de points visés&#xa0;: %1&#x202f;; au moins 5 sont exigés.</translation>
    </message>
    <message>
        <source>The targets leave out %1 of the axis travel of %2: neither the whole travel nor a test inside the agreed zone.</source>
        <translation>Les points visés laissent de côté %1 de la longueur d’axe de %2&#xa0;: ce n’est ni la longueur entière ni un essai dans la zone convenue.</translation>
    </message>
    <message>
        <source>A rotary axis is tested at 0°, 90°, 180° and 270° or at the faces of the polygon; missing: %1.</source>
        <translation>Un axe rotatif est contrôlé à 0°, 90°, 180° et 270° ou aux faces du polygone&#x202f;; manquent&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Only the zone of this long axis (%1) is tested: the test over the whole travel is missing in this file.</source>
        <translation>Seule la zone de cet axe long (%1) est contrôlée&#xa0;: l’essai sur la longueur entière manque dans ce fichier.</translation>
    </message>
    <message>
        <source>Only the whole travel of this long axis (%1) is tested: the full test of an agreed zone of %2 is missing in this file.</source>
        <translation>Seule la longueur entière de cet axe long (%1) est contrôlée&#xa0;: le contrôle complet d’une zone convenue de %2 manque dans ce fichier.</translation>
    </message>
    <message>
        <source>The zone is %1 long; the full test is made on an agreed %2.</source>
        <translation>La zone a une longueur de %1&#x202f;; le contrôle complet se fait sur une longueur convenue de %2.</translation>
    </message>
    <message>
        <source>The first and the last target have to be approached from both sides; beyond them the axis has %1 and %2, the approach distance is %3.</source>
        <translation>Le premier et le dernier points visés doivent être approchés des deux côtés&#x202f;; au-delà, l’axe dispose de %1 et de %2, la distance d’approche est de %3.</translation>
    </message>
    <message>
        <source>The first and the last target have to be approached from both sides; beyond them the axis has %1 and %2.</source>
        <translation>Le premier et le dernier points visés doivent être approchés des deux côtés&#x202f;; au-delà, l’axe dispose de %1 et de %2.</translation>
    </message>
    <message>
        <source>The ends of the axis are not stated: whether the first and the last target can be approached from both sides is not checked.</source>
        <translation>Les extrémités de l’axe ne sont pas indiquées&#xa0;: il n’est pas vérifié que le premier et le dernier points visés peuvent être approchés des deux côtés.</translation>
    </message>
    <message>
        <source>The targets are evenly spaced (%1): with a new random part for every target periodic errors do not stay hidden.</source>
        <translation>Les points visés sont équidistants (%1)&#xa0;: avec une nouvelle part aléatoire pour chaque point visé, les erreurs périodiques ne restent pas cachées.</translation>
    </message>
    <message>
        <source>All intervals are whole multiples of the period of %1: its periodic error stays hidden.</source>
        <translation>Tous les intervalles sont des multiples entiers de la période de %1&#xa0;: son erreur périodique reste cachée.</translation>
    </message>
    <message>
        <source>Target spacing differs from the nominal %1 by up to %2; the random part is to stay within ± %3.</source>
        <translation>Les points visés s’écartent de leur intervalle nominal de %1 jusqu’à ±&#xa0;%2&#x202f;; la part aléatoire doit rester dans ±&#xa0;%3.</translation>
    </message>
    <message>
        <source>Test code for machine tools — Part 4: Circular tests for numerically controlled machine tools</source>
        <translation>Code d’essai des machines-outils — Partie 4&#xa0;: Essais de circularité des machines-outils à commande numérique</translation>
    </message>
    <message>
        <source>test parameters</source>
        <translation>paramètres de l’essai</translation>
    </message>
    <message>
        <source>which of the results are required</source>
        <translation>résultats demandés</translation>
    </message>
    <message>
        <source>“{”</source>
        <translation>«&#xa0;{&#xa0;»</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>la fin du fichier</translation>
    </message>
    <message>
        <source>more values than a test file can have</source>
        <translation>plus de valeurs qu’un fichier d’essai ne peut en contenir</translation>
    </message>
    <message>
        <source>a key in quotation marks or “}”</source>
        <translation>une clé entre guillemets ou «&#xa0;}&#xa0;»</translation>
    </message>
    <message>
        <source>a key in quotation marks</source>
        <translation>une clé entre guillemets</translation>
    </message>
    <message>
        <source>this key stands here twice; expected it once</source>
        <translation>cette clé figure ici deux fois&#x202f;; attendu&#xa0;: une seule fois</translation>
    </message>
    <message>
        <source>more keys than a test file can have</source>
        <translation>plus de clés qu’un fichier d’essai ne peut en contenir</translation>
    </message>
    <message>
        <source>“:”</source>
        <translation>«&#xa0;:&#xa0;»</translation>
    </message>
    <message>
        <source>“,” or “}”</source>
        <translation>«&#xa0;,&#xa0;» ou «&#xa0;}&#xa0;»</translation>
    </message>
    <message>
        <source>“,” or “]”</source>
        <translation>«&#xa0;,&#xa0;» ou «&#xa0;]&#xa0;»</translation>
    </message>
    <message>
        <source>more than 10 000 000 readings or points</source>
        <translation>plus de 10&#x202f;000&#x202f;000 de relevés ou de points</translation>
    </message>
    <message>
        <source>nested deeper than a test file can be</source>
        <translation>imbrication plus profonde qu’un fichier d’essai ne l’admet</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>une valeur</translation>
    </message>
    <message>
        <source>this number is too large; expected a finite number</source>
        <translation>ce nombre est trop grand&#x202f;; attendu&#xa0;: un nombre fini</translation>
    </message>
    <message>
        <source>the file ends inside this text; expected a quotation mark</source>
        <translation>le fichier s’arrête à l’intérieur de ce texte&#x202f;; attendu&#xa0;: un guillemet</translation>
    </message>
    <message>
        <source>a text cannot hold this character; expected UTF-8 without line breaks and control characters</source>
        <translation>un texte ne peut pas contenir ce caractère&#x202f;; attendu&#xa0;: de l’UTF-8 sans saut de ligne ni caractère de commande</translation>
    </message>
    <message>
        <source>the file ends here; expected %1</source>
        <translation>le fichier s’arrête ici&#x202f;; attendu&#xa0;: %1</translation>
    </message>
    <message>
        <source>this is no character of UTF-8; expected a test file in UTF-8</source>
        <translation>ceci n’est pas un caractère UTF-8&#x202f;; attendu&#xa0;: un fichier d’essai en UTF-8</translation>
    </message>
    <message>
        <source>found “%1”; expected %2</source>
        <translation>trouvé&#xa0;: «&#xa0;%1&#xa0;»&#x202f;; attendu&#xa0;: %2</translation>
    </message>
    <message>
        <source>a file cannot hold a number that is not finite</source>
        <translation>un fichier ne peut pas contenir un nombre qui n’est pas fini</translation>
    </message>
    <message>
        <source>this key is unknown; what others want to add goes into “extensions”</source>
        <translation>cette clé est inconnue&#x202f;; ce que d’autres veulent ajouter se place dans «&#xa0;extensions&#xa0;»</translation>
    </message>
    <message>
        <source>expected “from” to be less than “to”</source>
        <translation>attendu&#xa0;: «&#xa0;from&#xa0;» inférieur à «&#xa0;to&#xa0;»</translation>
    </message>
    <message>
        <source>expected targets that ascend strictly</source>
        <translation>attendu&#xa0;: des points visés strictement croissants</translation>
    </message>
    <message>
        <source>expected null, for this reading stands in “excluded”</source>
        <translation>attendu&#xa0;: null, car ce relevé figure dans «&#xa0;excluded&#xa0;»</translation>
    </message>
    <message>
        <source>this reading is excluded twice; expected it once</source>
        <translation>ce relevé est écarté deux fois&#x202f;; attendu&#xa0;: une seule fois</translation>
    </message>
    <message>
        <source>unknown edition “%1”; expected a designation such as ISO 230-2:1988</source>
        <translation>édition «&#xa0;%1&#xa0;» inconnue&#x202f;; attendu&#xa0;: une désignation telle que ISO 230-2:1988</translation>
    </message>
    <message>
        <source>expected at least one language</source>
        <translation>attendu&#xa0;: au moins une langue</translation>
    </message>
    <message>
        <source>unknown parameter “%1”; expected one of this kind of test, such as %2</source>
        <translation>paramètre «&#xa0;%1&#xa0;» inconnu&#x202f;; attendu&#xa0;: un paramètre de ce type d’essai, tel que %2</translation>
    </message>
    <message>
        <source>“%1” is not for this kind of test</source>
        <translation>«&#xa0;%1&#xa0;» ne concerne pas ce type d’essai</translation>
    </message>
    <message>
        <source>unknown point “%1”; expected one that this kind of test agrees on</source>
        <translation>point «&#xa0;%1&#xa0;» inconnu&#x202f;; attendu&#xa0;: un point faisant l’objet d’un accord pour ce type d’essai</translation>
    </message>
    <message>
        <source>“%1” stands here twice; expected it once</source>
        <translation>«&#xa0;%1&#xa0;» figure ici deux fois&#x202f;; attendu&#xa0;: une seule fois</translation>
    </message>
    <message>
        <source>expected the id of an instrument of this file; “%1” is none</source>
        <translation>attendu&#xa0;: l’identifiant d’un instrument de ce fichier&#x202f;; «&#xa0;%1&#xa0;» n’en est pas un</translation>
    </message>
    <message>
        <source>expected the id of a drift test of this file; “%1” is none</source>
        <translation>attendu&#xa0;: l’identifiant d’un essai de dérive de ce fichier&#x202f;; «&#xa0;%1&#xa0;» n’en est pas un</translation>
    </message>
    <message>
        <source>the key “%1” is missing</source>
        <translation>la clé «&#xa0;%1&#xa0;» manque</translation>
    </message>
    <message>
        <source>expected one of the words: %1</source>
        <translation>attendu&#xa0;: l’un des mots suivants&#xa0;: %1</translation>
    </message>
    <message>
        <source>unknown word “%1”; expected one of: %2</source>
        <translation>mot «&#xa0;%1&#xa0;» inconnu&#x202f;; attendu&#xa0;: l’un des mots suivants&#xa0;: %2</translation>
    </message>
    <message>
        <source>expected an object, in braces</source>
        <translation>attendu&#xa0;: un objet, entre accolades</translation>
    </message>
    <message>
        <source>expected a list, in square brackets</source>
        <translation>attendu&#xa0;: une liste, entre crochets</translation>
    </message>
    <message>
        <source>expected a number</source>
        <translation>attendu&#xa0;: un nombre</translation>
    </message>
    <message>
        <source>expected a number greater than 0</source>
        <translation>attendu&#xa0;: un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>expected a number that is not negative</source>
        <translation>attendu&#xa0;: un nombre positif ou nul</translation>
    </message>
    <message>
        <source>expected a whole number</source>
        <translation>attendu&#xa0;: un nombre entier</translation>
    </message>
    <message>
        <source>expected true or false</source>
        <translation>attendu&#xa0;: true ou false</translation>
    </message>
    <message>
        <source>expected a text, in quotation marks</source>
        <translation>attendu&#xa0;: un texte, entre guillemets</translation>
    </message>
    <message>
        <source>expected a date that exists, written YYYY-MM-DD</source>
        <translation>attendu&#xa0;: une date qui existe, écrite AAAA-MM-JJ</translation>
    </message>
    <message>
        <source>expected a time of day, written HH:MM</source>
        <translation>attendu&#xa0;: une heure, écrite HH:MM</translation>
    </message>
    <message>
        <source>expected bytes in base64</source>
        <translation>attendu&#xa0;: des octets en base64</translation>
    </message>
    <message>
        <source>expected a number or null</source>
        <translation>attendu&#xa0;: un nombre ou null</translation>
    </message>
    <message>
        <source>expected a whole number or null</source>
        <translation>attendu&#xa0;: un nombre entier ou null</translation>
    </message>
    <message>
        <source>expected true, false or null</source>
        <translation>attendu&#xa0;: true, false ou null</translation>
    </message>
    <message>
        <source>expected a text, in quotation marks, or null</source>
        <translation>attendu&#xa0;: un texte, entre guillemets, ou null</translation>
    </message>
    <message>
        <source>expected an object, in braces, or null</source>
        <translation>attendu&#xa0;: un objet, entre accolades, ou null</translation>
    </message>
    <message>
        <source>this is not a test file of Palmer; expected %1</source>
        <translation>ceci n’est pas un fichier d’essai de Palmer&#x202f;; attendu&#xa0;: %1</translation>
    </message>
    <message>
        <source>expected a whole number from 1 on</source>
        <translation>attendu&#xa0;: un nombre entier à partir de 1</translation>
    </message>
    <message>
        <source>the file was written by a newer version of Palmer (format %1); this one reads up to format %2: install a newer Palmer</source>
        <translation>le fichier a été écrit par une version plus récente de Palmer (format %1)&#x202f;; celle-ci lit jusqu’au format %2&#xa0;: installez une version plus récente de Palmer</translation>
    </message>
    <message>
        <source>this is a folder; expected the name of a file to save to</source>
        <translation>ceci est un dossier&#x202f;; attendu&#xa0;: le nom du fichier à enregistrer</translation>
    </message>
    <message>
        <source>the folder does not exist; create it or save in another folder</source>
        <translation>le dossier n’existe pas&#x202f;; créez-le ou enregistrez dans un autre dossier</translation>
    </message>
    <message>
        <source>this is a folder; expected a test file</source>
        <translation>ceci est un dossier&#x202f;; attendu&#xa0;: un fichier d’essai</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n’existe pas</translation>
    </message>
    <message>
        <source>the file cannot be read (%1)</source>
        <translation>le fichier ne peut pas être lu (%1)</translation>
    </message>
    <message>
        <source>the file is larger than 1 GiB</source>
        <translation>le fichier dépasse 1&#x202f;Gio</translation>
    </message>
    <message>
        <source>a PDF of more than 4 GB cannot be written; choose less for the report, or divide its tests among several files</source>
        <translation>un PDF de plus de 4&#x202f;Go ne peut pas être écrit&#xa0;: choisir moins de contenu pour le rapport, ou répartir ses essais sur plusieurs fichiers</translation>
    </message>
    <message>
        <source>bi-directional</source>
        <translation>bidirectionnel</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>relevés</translation>
    </message>
    <message>
        <source>Positioning deviations of the %1 axis</source>
        <translation>Écarts de position de l’axe %1</translation>
    </message>
    <message>
        <source>Positional deviations of the %1 axis</source>
        <translation>Écarts de position de l’axe %1</translation>
    </message>
    <message>
        <source>Positioning deviation</source>
        <translation>Écart de position</translation>
    </message>
    <message>
        <source>Positional deviation</source>
        <translation>Écart de position</translation>
    </message>
    <message>
        <source>Target position</source>
        <translation>Point visé</translation>
    </message>
    <message>
        <source>linear cycle</source>
        <comment>1988</comment>
        <translation>cycle linéaire</translation>
    </message>
    <message>
        <source>pilgrim step cycle</source>
        <comment>1988</comment>
        <translation>cycle en pas de pèlerin</translation>
    </message>
    <message>
        <source>standard test cycle</source>
        <translation>cycle d’essai normal</translation>
    </message>
    <message>
        <source>conforms</source>
        <translation>conforme</translation>
    </message>
    <message>
        <source>not proven</source>
        <translation>non prouvé</translation>
    </message>
    <message>
        <source>does not conform</source>
        <translation>non conforme</translation>
    </message>
    <message>
        <source>requirement</source>
        <translation>exigence</translation>
    </message>
    <message>
        <source>recommendation</source>
        <translation>recommandation</translation>
    </message>
    <message>
        <source>note</source>
        <translation>note</translation>
    </message>
    <message>
        <source>simple acceptance</source>
        <translation>acceptation simple</translation>
    </message>
    <message>
        <source>ISO 14253-1: conformity to be proven</source>
        <translation>ISO 14253-1&#xa0;: conformité à prouver</translation>
    </message>
    <message>
        <source>non-conformity to be proven</source>
        <translation>non-conformité à prouver</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiquée</translation>
    </message>
    <message>
        <source>not applied</source>
        <translation>non appliquée</translation>
    </message>
    <message>
        <source>applied by the instrument</source>
        <translation>appliquée par l’instrument</translation>
    </message>
    <message>
        <source>to be applied here, but nothing is corrected</source>
        <translation>à appliquer ici, mais rien n’est corrigé</translation>
    </message>
    <message>
        <source>applied here</source>
        <translation>appliquée ici</translation>
    </message>
    <message>
        <source>Positioning test of axis %1</source>
        <translation>Essai de positionnement de l’axe %1</translation>
    </message>
    <message>
        <source>Circular test in the plane %1</source>
        <translation>Essai de circularité dans le plan %1</translation>
    </message>
    <message>
        <source>Drift test of axis %1</source>
        <translation>Essai de dérive de l’axe %1</translation>
    </message>
    <message>
        <source>step cycle – not an ISO 230-2 acceptance result</source>
        <translation>cycle en pas – résultat non utilisable en référence à l’ISO 230-2</translation>
    </message>
    <message>
        <source>Seen under another edition than that of the test (%1): no verdict.</source>
        <translation>Vu selon une autre édition que celle de l’essai (%1)&#xa0;: pas de verdict.</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linéaire</translation>
    </message>
    <message>
        <source>rotary</source>
        <translation>rotatif</translation>
    </message>
    <message>
        <source>axis travel %1</source>
        <translation>longueur d’axe %1</translation>
    </message>
    <message>
        <source>measurement travel %1</source>
        <translation>course de mesurage %1</translation>
    </message>
    <message>
        <source>m = %1; n = %2 each way</source>
        <translation>m = %1&#x202f;; n = %2 par sens</translation>
    </message>
    <message>
        <source>m = %1; n = %2 ↑, %3 ↓</source>
        <translation>m = %1&#x202f;; n = %2 ↑, %3 ↓</translation>
    </message>
    <message>
        <source>guard band %1 U</source>
        <translation>bande de garde %1 U</translation>
    </message>
    <message>
        <source>The stated factor of a guard band, %1, has no effect.</source>
        <translation>Le facteur de bande de garde indiqué, %1, est sans effet.</translation>
    </message>
    <message>
        <source>Edition</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Date of test</source>
        <translation>Date de l’essai</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Working zone</source>
        <translation>Zone de travail normal</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Cycle</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Points visés</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Écart-type</translation>
    </message>
    <message>
        <source>range method</source>
        <translation>méthode de l’étendue</translation>
    </message>
    <message>
        <source>calculation method</source>
        <translation>méthode de calcul</translation>
    </message>
    <message>
        <source>Correction to 20 °C</source>
        <translation>Correction à 20&#xa0;°C</translation>
    </message>
    <message>
        <source>Correction to 20 °C: %1.</source>
        <translation>Correction à 20&#xa0;°C&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Results per target</source>
        <translation>Résultats par point visé</translation>
    </message>
    <message>
        <source>Environmental variation error (max − min)</source>
        <translation>Erreur de variation environnementale (max − min)</translation>
    </message>
    <message>
        <source>not corrected to 20 °C</source>
        <translation>non corrigé à 20&#xa0;°C</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>No findings.</source>
        <translation>Aucun constat.</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>published</source>
        <translation>publiée</translation>
    </message>
    <message>
        <source>recomputed</source>
        <translation>recalculée</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exacte</translation>
    </message>
    <message>
        <source>certified</source>
        <translation>certifiée</translation>
    </message>
    <message>
        <source>agrees</source>
        <translation>concorde</translation>
    </message>
    <message>
        <source>DOES NOT AGREE</source>
        <translation>NE CONCORDE PAS</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>%1 of %2 values reproduced.</source>
        <translation>%1 valeurs reproduites sur %2.</translation>
    </message>
    <message>
        <source>expected reference data of this program</source>
        <translation>des données de référence de ce programme étaient attendues</translation>
    </message>
    <message>
        <source>findings only: what the edition asks for and the test lacks</source>
        <translation>constatations seules&#xa0;: ce que l’édition demande et qui manque à l’essai</translation>
    </message>
    <message>
        <source>language of tables, findings and errors</source>
        <translation>langue des tableaux, constats et erreurs</translation>
    </message>
    <message>
        <source>this help</source>
        <translation>cette aide</translation>
    </message>
    <message>
        <source>unknown option %1 of the command %2</source>
        <translation>option inconnue %1 de la commande %2</translation>
    </message>
    <message>
        <source>the command %1 needs a file (%2)</source>
        <translation>la commande %1 demande un fichier (%2)</translation>
    </message>
    <message>
        <source>the command %1 takes no file</source>
        <translation>la commande %1 ne prend pas de fichier</translation>
    </message>
    <message>
        <source>version of the program</source>
        <translation>version du programme</translation>
    </message>
    <message>
        <source>COMMAND [OPTION]… [FILE]…</source>
        <translation>COMMANDE [OPTION]… [FICHIER]…</translation>
    </message>
    <message>
        <source>evaluate the tests of its kind under another edition (a view: no verdicts)</source>
        <translation>évaluer les essais de ce type selon une autre édition (une vue&#xa0;: pas de verdict)</translation>
    </message>
    <message>
        <source>results as JSON; of several files one object a line</source>
        <translation>résultats en JSON&#x202f;; pour plusieurs fichiers, un objet par ligne</translation>
    </message>
    <message>
        <source>unknown edition %1; known: %2</source>
        <translation>édition inconnue %1&#x202f;; connues&#xa0;: %2</translation>
    </message>
    <message>
        <source>results of the tests as a table or as JSON</source>
        <translation>résultats des essais en tableau ou en JSON</translation>
    </message>
    <message>
        <source>standard output cannot be written</source>
        <translation>la sortie standard ne peut pas être écrite</translation>
    </message>
    <message>
        <source>a command is missing; palmer-cli --help lists them</source>
        <translation>il manque une commande&#x202f;; palmer-cli --help les énumère</translation>
    </message>
    <message>
        <source>unknown command %1; palmer-cli --help lists them</source>
        <translation>commande inconnue %1&#x202f;; palmer-cli --help les énumère</translation>
    </message>
    <message>
        <source>unknown escape in a text; expected one that JSON knows</source>
        <translation>séquence d’échappement inconnue dans un texte&#x202f;; attendu&#xa0;: une séquence que JSON connaît</translation>
    </message>
    <message>
        <source>number of values found: %1; expected: %2</source>
        <translation>nombre de valeurs trouvées&#xa0;: %1&#x202f;; attendu&#xa0;: %2</translation>
    </message>
    <message>
        <source>the file could not be saved, for want of permission or space; what was there before is unchanged: save it under another name or in another folder</source>
        <translation>le fichier n’a pas pu être enregistré, faute de droits ou de place&#x202f;; l’ancien fichier est inchangé&#xa0;: enregistrez sous un autre nom ou dans un autre dossier</translation>
    </message>
    <message>
        <source>the file cannot be read; check its permissions and the medium it is on</source>
        <translation>le fichier ne peut pas être lu&#x202f;; vérifiez ses droits d’accès et le support sur lequel il se trouve</translation>
    </message>
    <message>
        <source>No value for %1: see what the test lacks.</source>
        <translation>Pas de valeur pour %1&#xa0;: voir ce qui manque à l’essai.</translation>
    </message>
    <message>
        <source>The required result %1 has no value: %2.</source>
        <translation>Le résultat exigé %1 n’a pas de valeur&#xa0;: %2.</translation>
    </message>
    <message>
        <source>The test has no measured points in the evaluated range.</source>
        <translation>L’essai n’a aucun point mesuré dans l’étendue évaluée.</translation>
    </message>
    <message>
        <source>The path %1 covers %2: at least 90° are required.</source>
        <translation>La trajectoire %1 couvre %2&#xa0;: au moins 90° sont exigés.</translation>
    </message>
    <message>
        <source>Only the path %1 was measured: bi-directional results need both senses.</source>
        <translation>Seule la trajectoire %1 a été mesurée&#xa0;: les résultats bidirectionnels demandent les deux sens.</translation>
    </message>
    <message>
        <source>No value for D: it needs full circles in both senses.</source>
        <translation>Pas de valeur pour D&#xa0;: il demande des cercles complets dans les deux sens.</translation>
    </message>
    <message>
        <source>No value for F of a partial arc: the least squares centre is for full circles only.</source>
        <translation>Pas de valeur pour F d’un arc partiel&#xa0;: le centre des moindres carrés ne vaut que pour des cercles complets.</translation>
    </message>
    <message>
        <source>F is taken about the set-up centre: it contains the set-up error, which table A.1 does not expect of full circles.</source>
        <translation>F est rapporté au centre de réglage&#xa0;: il contient l’erreur de réglage, que le tableau A.1 ne prévoit pas pour des cercles complets.</translation>
    </message>
    <message>
        <source>The path %1 has no minimum zone circles: they need four different points that do not lie on a straight line.</source>
        <translation>La trajectoire %1 n’a pas de cercles de zone minimale&#xa0;: il y faut quatre points différents non alignés.</translation>
    </message>
    <message>
        <source>The minimum zone circles are not proven to be the narrowest.</source>
        <translation>Il n’est pas prouvé que les cercles de zone minimale sont les plus étroits.</translation>
    </message>
    <message>
        <source>The plane %1 is not XY, YZ or ZX: seen from the positive end of the third axis its senses are exchanged.</source>
        <translation>Le plan %1 n’est ni XY, ni YZ, ni ZX&#xa0;: vus de l’extrémité positive du troisième axe, ses sens sont inversés.</translation>
    </message>
    <message>
        <source>No value for F and D: the reference length is not calibrated.</source>
        <translation>Pas de valeur pour F et D&#xa0;: la longueur de référence n’est pas étalonnée.</translation>
    </message>
    <message>
        <source>F and D are not corrected to 20 °C, and the test was made at another temperature.</source>
        <translation>F et D ne sont pas ramenés à 20&#xa0;°C, et l’essai a été fait à une autre température.</translation>
    </message>
    <message>
        <source>F and D cannot be corrected to 20 °C: temperatures and coefficients of thermal expansion of machine and instrument are needed.</source>
        <translation>F et D ne peuvent pas être ramenés à 20&#xa0;°C&#xa0;: il y faut les températures et les coefficients de dilatation thermique de la machine et de l’instrument.</translation>
    </message>
    <message>
        <source>Feedback signal: the annex speaks of machines with linear scales; what lies between scale and tool is not seen.</source>
        <translation>Signal de retour&#xa0;: l’annexe parle de machines à règles de mesure linéaires&#x202f;; ce qui se trouve entre la règle et l’outil n’est pas vu.</translation>
    </message>
    <message>
        <source>F and D cannot be had from a feedback signal.</source>
        <translation>F et D ne peuvent pas être tirés d’un signal de retour.</translation>
    </message>
    <message>
        <source>bi-directional circular deviation</source>
        <translation>écart de circularité bidirectionnel</translation>
    </message>
    <message>
        <source>mean bi-directional radial deviation</source>
        <translation>écart radial moyen bidirectionnel</translation>
    </message>
    <message>
        <source>circular deviation</source>
        <translation>écart de circularité</translation>
    </message>
    <message>
        <source>radial deviation, maximum</source>
        <translation>écart radial, maximum</translation>
    </message>
    <message>
        <source>radial deviation, minimum</source>
        <translation>écart radial, minimum</translation>
    </message>
    <message>
        <source>bi-directional circular deviation using feed back signal</source>
        <translation>écart de circularité bidirectionnel par signal de retour</translation>
    </message>
    <message>
        <source>circular deviation using feed back signal</source>
        <translation>écart de circularité par signal de retour</translation>
    </message>
    <message>
        <source>bi-directional circular error</source>
        <translation>erreur de circularité bidirectionnelle</translation>
    </message>
    <message>
        <source>mean bi-directional radial error</source>
        <translation>erreur radiale moyenne bidirectionnelle</translation>
    </message>
    <message>
        <source>circular error</source>
        <translation>erreur de circularité</translation>
    </message>
    <message>
        <source>radial error, maximum</source>
        <translation>erreur radiale, maximum</translation>
    </message>
    <message>
        <source>radial error, minimum</source>
        <translation>erreur radiale, minimum</translation>
    </message>
    <message>
        <source>bi-directional circular error using feed back signal</source>
        <translation>erreur de circularité bidirectionnelle par signal de retour</translation>
    </message>
    <message>
        <source>circular error using feed back signal</source>
        <translation>erreur de circularité par signal de retour</translation>
    </message>
    <message>
        <source>circular hysteresis</source>
        <translation>hystérésis circulaire</translation>
    </message>
    <message>
        <source>axes moved</source>
        <translation>axes en mouvement</translation>
    </message>
    <message>
        <source>contouring feed</source>
        <translation>vitesse d’avance de contournage</translation>
    </message>
    <message>
        <source>start point</source>
        <translation>point de départ</translation>
    </message>
    <message>
        <source>stop point</source>
        <translation>point d’arrivée</translation>
    </message>
    <message>
        <source>data smoothing</source>
        <translation>lissage des données</translation>
    </message>
    <message>
        <source>compensation active during the test</source>
        <translation>compensation active pendant l’essai</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>dates</comment>
        <translation>du %1 au %2</translation>
    </message>
    <message>
        <source>control %1</source>
        <translation>commande %1</translation>
    </message>
    <message>
        <source>year %1</source>
        <translation>année %1</translation>
    </message>
    <message>
        <source>self-test not run</source>
        <translation>autocontrôle non exécuté</translation>
    </message>
    <message>
        <source>self-test against reference data passed</source>
        <translation>autocontrôle sur des données de référence réussi</translation>
    </message>
    <message>
        <source>self-test against reference data NOT passed</source>
        <translation>autocontrôle sur des données de référence NON réussi</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>Laboratoire</translation>
    </message>
    <message>
        <source>Supplier/manufacturer</source>
        <translation>Fournisseur/constructeur</translation>
    </message>
    <message>
        <source>Customer/user</source>
        <translation>Client/utilisateur</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Instrument</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Numéro de série</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificat</translation>
    </message>
    <message>
        <source>Calibrated by</source>
        <translation>Étalonné par</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>Étalonné le</translation>
    </message>
    <message>
        <source>Due</source>
        <translation>Échéance</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Résolution</translation>
    </message>
    <message>
        <source>Traceability of the instruments</source>
        <translation>Traçabilité des instruments</translation>
    </message>
    <message>
        <source>range of the deviations %1</source>
        <translation>étendue des écarts %1</translation>
    </message>
    <message>
        <source>Drift tests</source>
        <translation>Essais de dérive</translation>
    </message>
    <message>
        <source>environmental variation error</source>
        <translation>erreur de variation environnementale</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>arc second</source>
        <translation>seconde d’arc</translation>
    </message>
    <message>
        <source>Differences by the factor of s: %1.</source>
        <translation>Différences dues au facteur de s&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Differences by the definitions of the editions: %1.</source>
        <translation>Différences dues aux définitions des éditions&#xa0;: %1.</translation>
    </message>
    <message>
        <source>procedure %1</source>
        <translation>procédure %1</translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation>Procédure</translation>
    </message>
    <message>
        <source>Tests carried out</source>
        <translation>Essais exécutés</translation>
    </message>
    <message>
        <source>Details of the machine</source>
        <translation>Renseignements sur la machine</translation>
    </message>
    <message>
        <source>Condition of the machine</source>
        <translation>État de la machine</translation>
    </message>
    <message>
        <source>Adjustments made</source>
        <translation>Réglages effectués</translation>
    </message>
    <message>
        <source>replaces %1</source>
        <translation>remplace %1</translation>
    </message>
    <message>
        <source>Revision</source>
        <translation>Révision</translation>
    </message>
    <message>
        <source>Authorised by</source>
        <translation>Autorisé par</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Fingerprint SHA-256</source>
        <translation>Empreinte SHA-256</translation>
    </message>
    <message>
        <source>Statements</source>
        <translation>Mentions</translation>
    </message>
    <message>
        <source>The results relate only to the machine tested in the stated condition.</source>
        <translation>Les résultats ne se rapportent qu’à la machine soumise à l’essai, dans l’état indiqué.</translation>
    </message>
    <message>
        <source>This report may be reproduced only in full.</source>
        <translation>Ce rapport ne peut être reproduit que dans son intégralité.</translation>
    </message>
    <message>
        <source>The fingerprint is that of the test file attached to the PDF of this report.</source>
        <translation>L’empreinte est celle du fichier d’essai joint au PDF de ce rapport.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Signature</translation>
    </message>
    <message>
        <source>End of the report</source>
        <translation>Fin du rapport</translation>
    </message>
    <message>
        <source>Results for the %1 axis</source>
        <translation>Résultats de l’axe %1</translation>
    </message>
    <message>
        <source>Report %1</source>
        <translation>Rapport %1</translation>
    </message>
    <message>
        <source>Fingerprint SHA-256 %1</source>
        <translation>Empreinte SHA-256 %1</translation>
    </message>
    <message>
        <source>page %1 / %2</source>
        <translation>page %1 / %2</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>agreed or maker’s procedure</source>
        <translation>procédure convenue ou du constructeur</translation>
    </message>
    <message>
        <source>dry run</source>
        <translation>essai à blanc préalable</translation>
    </message>
    <message>
        <source>set-up movements only</source>
        <translation>mouvements de réglage seulement</translation>
    </message>
    <message>
        <source>chosen freely</source>
        <translation>choix libre</translation>
    </message>
    <message>
        <source>faces of the polygon</source>
        <translation>faces du polygone</translation>
    </message>
    <message>
        <source>fixed by the instrument</source>
        <translation>imposés par l’instrument</translation>
    </message>
    <message>
        <source>nominal interval %1</source>
        <translation>intervalle nominal %1</translation>
    </message>
    <message>
        <source>period %1</source>
        <translation>période %1</translation>
    </message>
    <message>
        <source>random part of seed %1</source>
        <translation>composante aléatoire (germe %1)</translation>
    </message>
    <message>
        <source>tool offset: %1</source>
        <translation>décalage d’outil&#xa0;: %1</translation>
    </message>
    <message>
        <source>workpiece offset: %1</source>
        <translation>décalage de pièce&#xa0;: %1</translation>
    </message>
    <message>
        <source>Warm-up</source>
        <translation>Mise en température</translation>
    </message>
    <message>
        <source>rapid feed</source>
        <translation>vitesse rapide</translation>
    </message>
    <message>
        <source>programmed feed</source>
        <translation>vitesse programmée</translation>
    </message>
    <message>
        <source>Approach distance</source>
        <translation>Distance d’approche</translation>
    </message>
    <message>
        <source>machine unloaded</source>
        <comment>1988</comment>
        <translation>machine non chargée</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>machine loaded</source>
        <translation>machine chargée</translation>
    </message>
    <message>
        <source>State of the machine</source>
        <translation>État de la machine</translation>
    </message>
    <message>
        <source>complete and in working order</source>
        <translation>complète et en ordre de marche</translation>
    </message>
    <message>
        <source>not complete</source>
        <translation>incomplète</translation>
    </message>
    <message>
        <source>levelled and aligned</source>
        <translation>mise à niveau et alignée</translation>
    </message>
    <message>
        <source>not levelled</source>
        <translation>non mise à niveau</translation>
    </message>
    <message>
        <source>Active compensation</source>
        <translation>Compensation active</translation>
    </message>
    <message>
        <source>Other axes</source>
        <translation>Autres axes</translation>
    </message>
    <message>
        <source>Measuring line</source>
        <translation>Ligne de mesurage</translation>
    </message>
    <message>
        <source>Choice of targets</source>
        <translation>Choix des points visés</translation>
    </message>
    <message>
        <source>Target positions</source>
        <translation>Points visés</translation>
    </message>
    <message>
        <source>Sampling interval</source>
        <translation>Intervalle d’échantillonnage</translation>
    </message>
    <message>
        <source>Zero of displacement</source>
        <translation>Origine du déplacement</translation>
    </message>
    <message>
        <source>Maker’s thermal guidelines</source>
        <translation>Recommandations thermiques du constructeur</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Air</translation>
    </message>
    <message>
        <source>Environment</source>
        <comment>1988</comment>
        <translation>Environnement d’essai</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Environnement</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Air pressure</source>
        <translation>Pression de l’air</translation>
    </message>
    <message>
        <source>Relative humidity</source>
        <translation>Humidité relative</translation>
    </message>
    <message>
        <source>Temperature gradient</source>
        <translation>Gradient de température</translation>
    </message>
    <message>
        <source>α machine</source>
        <translation>α de la machine</translation>
    </message>
    <message>
        <source>α instrument</source>
        <translation>α de l’instrument</translation>
    </message>
    <message>
        <source>Temperature of</source>
        <translation>Température de</translation>
    </message>
    <message>
        <source>Position of the sensor</source>
        <translation>Position du capteur</translation>
    </message>
    <message>
        <source>Temperature sensors</source>
        <translation>Capteurs de température</translation>
    </message>
    <message>
        <source>Test conditions</source>
        <translation>Conditions d’essai</translation>
    </message>
    <message>
        <source>Nominal differential expansion (NDE): %1.</source>
        <translation>Dilatation différentielle nominale (DDN)&#xa0;: %1.</translation>
    </message>
    <message>
        <source>between supplier/manufacturer and user</source>
        <comment>1988</comment>
        <translation>entre le fournisseur et le client</translation>
    </message>
    <message>
        <source>between supplier/manufacturer and user</source>
        <translation>entre le fournisseur/constructeur et l’utilisateur</translation>
    </message>
    <message>
        <source>%1, clause %2</source>
        <translation>%1, article %2</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Agreement</source>
        <translation>Accord</translation>
    </message>
    <message>
        <source>Agreed text</source>
        <translation>Texte convenu</translation>
    </message>
    <message>
        <source>agreed</source>
        <translation>convenu</translation>
    </message>
    <message>
        <source>not agreed</source>
        <translation>non convenu</translation>
    </message>
    <message>
        <source>not applicable</source>
        <translation>sans objet</translation>
    </message>
    <message>
        <source>Points to be agreed</source>
        <translation>Points soumis à accord</translation>
    </message>
    <message>
        <source>Measurement uncertainty</source>
        <translation>Incertitude de mesure</translation>
    </message>
    <message>
        <source>The correction was to be made here, but temperatures or coefficients of expansion are missing: nothing is corrected.</source>
        <translation>La correction devait être faite ici, mais il manque des températures ou des coefficients de dilatation&#xa0;: rien n’est corrigé.</translation>
    </message>
    <message>
        <source>Made here for the expansion of the machine (α = %1, θ = %2); the instrument compensates the air only.</source>
        <translation>Faite ici pour la dilatation de la machine (α = %1, θ = %2)&#x202f;; l’instrument ne compense que l’air.</translation>
    </message>
    <message>
        <source>Made here for the expansion of the machine (α = %1, θ = %2) and of the instrument (α = %3, θ = %4).</source>
        <translation>Faite ici pour la dilatation de la machine (α = %1, θ = %2) et de l’instrument (α = %3, θ = %4).</translation>
    </message>
    <message>
        <source>nominal differential expansion (NDE)</source>
        <translation>dilatation différentielle nominale (DDN)</translation>
    </message>
    <message>
        <source>Added to the readings</source>
        <translation>Ajouté aux relevés</translation>
    </message>
    <message>
        <source>factor %1</source>
        <translation>facteur %1</translation>
    </message>
    <message>
        <source>Results per target position</source>
        <translation>Résultats par point visé</translation>
    </message>
    <message>
        <source>factor %1; bold: the value governing the axis parameter</source>
        <translation>facteur %1&#x202f;; en gras la valeur qui détermine le paramètre de l’axe</translation>
    </message>
    <message>
        <source>positioning deviations</source>
        <translation>écarts de position</translation>
    </message>
    <message>
        <source>positional deviations</source>
        <translation>écarts de position</translation>
    </message>
    <message>
        <source>as read, without the correction to 20 °C</source>
        <translation>tels que relevés, sans la correction à 20&#xa0;°C</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Relevés</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>Excluded readings</source>
        <translation>Relevés écartés</translation>
    </message>
    <message>
        <source>set aside: they have no part in the results</source>
        <translation>ils ne sont pas pris en compte dans les résultats</translation>
    </message>
    <message>
        <source>Comparison of editions</source>
        <translation>Comparaison des éditions</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Result stated by the instrument’s program</source>
        <translation>Résultat donné par le programme de l’instrument</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>t of the progression of the runs</source>
        <translation>t de la progression des passes</translation>
    </message>
    <message>
        <source>Title of the report</source>
        <translation>Titre du rapport</translation>
    </message>
    <message>
        <source>Origin of the data</source>
        <translation>Origine des données</translation>
    </message>
    <message>
        <source>Largest at target %1, smallest at target %2.</source>
        <translation>Maximum au point visé %1, minimum au point visé %2.</translation>
    </message>
    <message>
        <source>Target %1 rules it.</source>
        <translation>Imposé par le point visé %1.</translation>
    </message>
    <message>
        <source>s by the range method: s = W / k(n).</source>
        <translation>s par la méthode de l’étendue&#xa0;: s = W / k(n).</translation>
    </message>
    <message>
        <source>With the correction to 20 °C applied here.</source>
        <translation>Avec la correction à 20&#xa0;°C appliquée ici.</translation>
    </message>
    <message>
        <source>Not corrected to 20 °C.</source>
        <translation>Non corrigé à 20&#xa0;°C.</translation>
    </message>
    <message>
        <source>The scatter of one direction alone is the largest form.</source>
        <translation>La dispersion d’un seul sens est la plus grande des trois formes.</translation>
    </message>
    <message>
        <source>What weighs: |B| %1 (%2), %3 %4 (%5), %6 %7 (%8).</source>
        <translation>Ce qui pèse&#xa0;: |B| %1 (%2), %3 %4 (%5), %6 %7 (%8).</translation>
    </message>
    <message>
        <source>%1, clauses %2 and %3</source>
        <translation>%1, paragraphes %2 et %3</translation>
    </message>
    <message>
        <source>Report No. %1</source>
        <translation>Rapport n° %1</translation>
    </message>
    <message>
        <source>revision %1</source>
        <translation>révision %1</translation>
    </message>
    <message>
        <source>issued %1</source>
        <translation>émis le %1</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lieu</translation>
    </message>
    <message>
        <source>Supplier</source>
        <translation>Fournisseur</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Client</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>n° %1</translation>
    </message>
    <message>
        <source>m = %1; n = %2 %3</source>
        <translation>m = %1&#x202f;; n = %2 %3</translation>
    </message>
    <message>
        <source>m = %1; n = %2 per direction</source>
        <translation>m = %1&#x202f;; n = %2 par sens</translation>
    </message>
    <message>
        <source>Test report</source>
        <translation>Rapport d’essai</translation>
    </message>
    <message>
        <source>Acceptance test report</source>
        <translation>Rapport d’essai de réception</translation>
    </message>
    <message>
        <source>Test %1 of %2</source>
        <translation>Essai %1 de %2</translation>
    </message>
    <message>
        <source>Measurement travel</source>
        <translation>Course de mesurage</translation>
    </message>
    <message>
        <source>Measuring system</source>
        <translation>Système de mesure</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Commande numérique</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>no limit agreed</source>
        <translation>aucune limite convenue</translation>
    </message>
    <message>
        <source>NOT in accordance with the edition</source>
        <translation>essai NON conforme à l’édition</translation>
    </message>
    <message>
        <source>Verdict of the report</source>
        <translation>Verdict du rapport</translation>
    </message>
    <message>
        <source>No limit was agreed: the results have no verdict.</source>
        <translation>Aucune limite n’a été convenue&#xa0;: les résultats sont sans verdict.</translation>
    </message>
    <message>
        <source>All tests carried out in accordance with their editions.</source>
        <translation>Tous les essais ont été exécutés conformément à leur édition.</translation>
    </message>
    <message>
        <source>%1 readings: mean %2, range %3</source>
        <translation>%1 relevés&#xa0;: moyenne %2, étendue %3</translation>
    </message>
    <message>
        <source>of an axis</source>
        <comment>end of the name of a parameter</comment>
        <translation>d’un axe</translation>
    </message>
    <message>
        <source>Targets</source>
        <comment>followed by i</comment>
        <translation>Points</translation>
    </message>
    <message>
        <source>Limit ± U</source>
        <translation>Limite ± U</translation>
    </message>
    <message>
        <source>Limit ± g</source>
        <translation>Limite ± g</translation>
    </message>
    <message>
        <source>ISO 14253-1, conformity has to be proven</source>
        <translation>ISO 14253-1, conformité à prouver</translation>
    </message>
    <message>
        <source>non-conformity has to be proven</source>
        <translation>non-conformité à prouver</translation>
    </message>
    <message>
        <source>s by the range method</source>
        <translation>s par la méthode de l’étendue</translation>
    </message>
    <message>
        <source>s by the calculation method</source>
        <translation>s par la méthode de calcul</translation>
    </message>
    <message>
        <source>verdict based on unrounded values</source>
        <translation>verdict établi sur les valeurs non arrondies</translation>
    </message>
    <message>
        <source>value</source>
        <comment>legend</comment>
        <translation>valeur</translation>
    </message>
    <message>
        <source>limit</source>
        <comment>legend</comment>
        <translation>limite</translation>
    </message>
    <message>
        <source>%1 (%2 against %3)</source>
        <translation>%1 (%2 pour %3)</translation>
    </message>
    <message>
        <source>%1 exceeds its limit: %2 against %3.</source>
        <translation>%1 dépasse sa limite&#xa0;: %2 pour %3.</translation>
    </message>
    <message>
        <source>%1 exceeds its limit by more than the uncertainty: %2 against %3 + %4 = %5.</source>
        <translation>%1 dépasse sa limite d’une valeur supérieure à l’incertitude&#xa0;: %2 pour %3 + %4 = %5.</translation>
    </message>
    <message>
        <source>%1 exceeds its limit by more than the guard band: %2 against %3 + %4 = %5.</source>
        <translation>%1 dépasse sa limite d’une valeur supérieure à la bande de garde&#xa0;: %2 pour %3 + %4 = %5.</translation>
    </message>
    <message>
        <source>Not shown to hold at 20 °C, nothing is proven for %1.</source>
        <translation>Validité à 20&#xa0;°C non établie, rien n’est prouvé pour %1.</translation>
    </message>
    <message>
        <source>Not corrected to 20 °C, nothing is proven for %1.</source>
        <translation>Sans correction à 20&#xa0;°C, rien n’est prouvé pour %1.</translation>
    </message>
    <message>
        <source>Without the measurement uncertainty nothing is proven for %1.</source>
        <translation>Sans l’incertitude de mesure, rien n’est prouvé pour %1.</translation>
    </message>
    <message>
        <source>For %1 non-conformity is not proven: no ground for rejection.</source>
        <translation>Pour %1, la non-conformité n’est pas démontrée&#xa0;: la machine ne peut être refusée à ce titre.</translation>
    </message>
    <message>
        <source>For %1 neither conformity nor non-conformity is proven.</source>
        <translation>Pour %1, ni la conformité ni la non-conformité n’est prouvée.</translation>
    </message>
    <message>
        <source>The limits agreed do not hold for this test: no verdict.</source>
        <translation>Les limites convenues ne valent pas pour cet essai&#xa0;: pas de verdict.</translation>
    </message>
    <message>
        <source>Within its limit: %1.</source>
        <translation>Limite respectée&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Within their limits: %1.</source>
        <translation>Limites respectées&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Verdict of the test</source>
        <translation>Verdict de l’essai</translation>
    </message>
    <message numerus="yes">
        <source>Test NOT in accordance with %1: %n requirement(s) not met</source>
        <translation>
            <numerusform>Essai NON conforme à %1&#xa0;: %n exigence non satisfaite</numerusform>
            <numerusform>Essai NON conforme à %1&#xa0;: %n exigences non satisfaites</numerusform>
        </translation>
    </message>
    <message>
        <source>see page %1</source>
        <translation>voir page %1</translation>
    </message>
    <message>
        <source>means</source>
        <comment>figure</comment>
        <translation>moyennes</translation>
    </message>
    <message>
        <source>means and ±%1s limits</source>
        <translation>moyennes et limites à ± %1s</translation>
    </message>
    <message>
        <source>bi-directional test</source>
        <translation>essai bidirectionnel</translation>
    </message>
    <message>
        <source>unidirectional test</source>
        <translation>essai unidirectionnel</translation>
    </message>
    <message>
        <source>Limits and decision rule</source>
        <translation>Limites et règle de décision</translation>
    </message>
    <message>
        <source>Agreed for</source>
        <translation>Convenue pour</translation>
    </message>
    <message>
        <source>Source</source>
        <comment>of a limit</comment>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Simple acceptance: a limit is met by a value not above it; the uncertainty has no part in it.</source>
        <translation>Acceptation simple&#xa0;: une limite est respectée lorsque la valeur ne la dépasse pas&#x202f;; l’incertitude n’intervient pas.</translation>
    </message>
    <message>
        <source>ISO 14253-1, conformity has to be proven: a limit is met when the value is at least g below it, exceeded when the value is more than g above it, and not proven between; g = %1·U.</source>
        <translation>ISO 14253-1, conformité à prouver&#xa0;: une limite est respectée lorsque la valeur lui est inférieure d’au moins g, dépassée lorsque la valeur la dépasse de plus de g&#x202f;; entre les deux, rien n’est prouvé&#x202f;; g = %1·U.</translation>
    </message>
    <message>
        <source>Non-conformity has to be proven: a limit is met when the value is at least g below it and exceeded when the value is more than g above it; between, non-conformity is not proven: no ground for rejection; g = %1·U.</source>
        <translation>Non-conformité à prouver&#xa0;: une limite est respectée lorsque la valeur lui est inférieure d’au moins g et dépassée lorsque la valeur la dépasse de plus de g&#x202f;; entre les deux, la non-conformité n’est pas démontrée&#xa0;: la machine ne peut être refusée à ce titre&#x202f;; g = %1·U.</translation>
    </message>
    <message>
        <source>The factor 1 is the guard band of the earlier editions of ISO 14253-1.</source>
        <translation>Le facteur 1 est la bande de garde des éditions antérieures de l’ISO 14253-1.</translation>
    </message>
    <message>
        <source>The factor 0.83 (1.65 u) is the later 95 % rule of ISO 14253-1 for one limit.</source>
        <translation>Le facteur 0,83 (1,65 u) est la règle à 95&#xa0;% des éditions ultérieures de l’ISO 14253-1 pour une seule limite.</translation>
    </message>
    <message>
        <source>Signed results are compared by their absolute value; the verdict is based on the unrounded values.</source>
        <translation>Les résultats affectés d’un signe sont comparés par leur valeur absolue&#x202f;; le verdict est établi sur les valeurs non arrondies.</translation>
    </message>
    <message>
        <source>accuracy</source>
        <comment>1988</comment>
        <translation>précision</translation>
    </message>
    <message>
        <source>accuracy</source>
        <translation>exactitude</translation>
    </message>
    <message>
        <source>systematic deviation</source>
        <translation>écart systématique</translation>
    </message>
    <message>
        <source>systematic error</source>
        <translation>écart systématique</translation>
    </message>
    <message>
        <source>range of x̄</source>
        <translation>étendue de x̄</translation>
    </message>
    <message>
        <source>repeatability</source>
        <translation>répétabilité</translation>
    </message>
    <message>
        <source>reversal value</source>
        <translation>réversibilité</translation>
    </message>
    <message>
        <source>reversal error</source>
        <translation>réversibilité</translation>
    </message>
    <message>
        <source>mean reversal value</source>
        <comment>1988</comment>
        <translation>réversibilité moyenne</translation>
    </message>
    <message>
        <source>signed mean</source>
        <translation>moyenne signée</translation>
    </message>
    <message>
        <source>unidirectional</source>
        <translation>unidirectionnelle</translation>
    </message>
    <message>
        <source>unidirectional</source>
        <comment>masculine</comment>
        <translation>unidirectionnel</translation>
    </message>
    <message>
        <source>smaller of R↑, R↓</source>
        <translation>min. de R↑ et R↓</translation>
    </message>
    <message>
        <source>positional uncertainty</source>
        <translation>incertitude de position</translation>
    </message>
    <message>
        <source>positional deviation</source>
        <comment>VDI</comment>
        <translation>écart de position</translation>
    </message>
    <message>
        <source>scatter, largest</source>
        <translation>dispersion maximale</translation>
    </message>
    <message>
        <source>scatter, mean</source>
        <translation>dispersion moyenne</translation>
    </message>
    <message>
        <source>reversal range, largest</source>
        <translation>réversibilité maximale</translation>
    </message>
    <message>
        <source>reversal range, mean</source>
        <translation>réversibilité moyenne</translation>
    </message>
    <message>
        <source>ISO 14253-1</source>
        <translation>ISO 14253-1</translation>
    </message>
    <message>
        <source>rejection proven</source>
        <translation>non-conformité à prouver</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Symbole</translation>
    </message>
    <message>
        <source>ISO %1</source>
        <comment>after a preposition</comment>
        <translation>l’ISO %1</translation>
    </message>
    <message>
        <source>Positioning test of the %1 axis</source>
        <translation>Essai de positionnement de l’axe %1</translation>
    </message>
    <message>
        <source>Circular test in the %1 plane</source>
        <translation>Essai de circularité dans le plan %1</translation>
    </message>
    <message>
        <source>Drift test of the %1 axis</source>
        <translation>Essai de dérive de l’axe %1</translation>
    </message>
    <message>
        <source>which test of the file, from 1; without it the first</source>
        <translation>quel essai du fichier, à partir de 1&#x202f;; sans elle, le premier</translation>
    </message>
    <message>
        <source>which figure; without it that of the test</source>
        <translation>quelle figure&#x202f;; sans elle, celle de l’essai</translation>
    </message>
    <message>
        <source>there is no test %1; the file has %2</source>
        <translation>il n’y a pas d’essai %1&#x202f;; le fichier en a %2</translation>
    </message>
    <message>
        <source>the command %1 needs a file to write (%2)</source>
        <translation>la commande %1 a besoin d’un fichier à écrire (%2)</translation>
    </message>
    <message>
        <source>the command %1 takes one file</source>
        <translation>la commande %1 prend un seul fichier</translation>
    </message>
    <message>
        <source>the test %1 has no figure %2</source>
        <translation>l’essai %1 n’a pas de figure %2</translation>
    </message>
    <message>
        <source>one figure as a picture</source>
        <translation>une figure comme image</translation>
    </message>
    <message>
        <source>language of the report; without it those the file asks for</source>
        <translation>langue du rapport&#x202f;; sans elle, celles que le fichier demande</translation>
    </message>
    <message>
        <source>standard output takes one report; choose --language</source>
        <translation>la sortie standard prend un seul rapport&#x202f;; choisir --language</translation>
    </message>
    <message>
        <source>the printed report as PDF</source>
        <translation>le rapport imprimé en PDF</translation>
    </message>
    <message>
        <source>The limits agreed do not hold for these tests: no verdict.</source>
        <translation>Les limites convenues ne valent pas pour ces essais&#xa0;: pas de verdict.</translation>
    </message>
    <message>
        <source>no verdict</source>
        <translation>sans verdict</translation>
    </message>
    <message>
        <source>Nominal radius</source>
        <translation>Rayon nominal</translation>
    </message>
    <message>
        <source>Contouring feed</source>
        <translation>Vitesse d’avance de contournage</translation>
    </message>
    <message>
        <source>Reference circle</source>
        <translation>Cercle de référence</translation>
    </message>
    <message>
        <source>minimum zone circles (MZC)</source>
        <translation>cercles de zone minimale (MZC)</translation>
    </message>
    <message>
        <source>least squares circle (LSC)</source>
        <translation>cercle des moindres carrés (LSC)</translation>
    </message>
    <message>
        <source>anticlockwise</source>
        <translation>sens antihoraire</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>sens horaire</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trajectoire</translation>
    </message>
    <message>
        <source>%1, %2: %3 points evaluated from %4 to %5</source>
        <translation>%1, %2&#xa0;: %3 points évalués de %4 à %5</translation>
    </message>
    <message>
        <source>Correction of F and D to 20 °C</source>
        <translation>Correction de F et D à 20&#xa0;°C</translation>
    </message>
    <message>
        <source>this is no copy of a test file that was being edited</source>
        <translation>ce n’est pas la copie d’un fichier d’essai en cours de modification</translation>
    </message>
    <message>
        <source>the disk is read-only; save in a folder of another disk</source>
        <translation>le disque est en lecture seule&#x202f;; enregistrer dans un dossier d’un autre disque</translation>
    </message>
    <message>
        <source>the disk is full; what was there before is unchanged: free some space or save on another disk</source>
        <translation>le disque est plein&#x202f;; ce qui y était avant est inchangé&#xa0;: libérer de la place ou enregistrer sur un autre disque</translation>
    </message>
    <message>
        <source>this is no template of Palmer</source>
        <translation>ce n’est pas un modèle de Palmer</translation>
    </message>
    <message>
        <source>this key is unknown</source>
        <translation>cette clé est inconnue</translation>
    </message>
    <message>
        <source>there are no numbers in what was copied</source>
        <translation>il n’y a pas de nombre dans ce qui a été copié</translation>
    </message>
    <message>
        <source>lines of headings left out: %1</source>
        <translation>lignes d’en-tête laissées de côté&#xa0;: %1</translation>
    </message>
    <message>
        <source>the target positions that the block begins with are left out</source>
        <translation>les positions visées au début du tableau sont laissées de côté</translation>
    </message>
    <message>
        <source>a target position in the block is no number: the targets stay</source>
        <translation>une position visée du tableau n’est pas un nombre&#xa0;: les points visés restent</translation>
    </message>
    <message>
        <source>the target positions of the block do not ascend: the targets stay</source>
        <translation>les positions visées du tableau ne sont pas croissantes&#xa0;: les points visés restent</translation>
    </message>
    <message>
        <source>no numbers, kept in red: %1</source>
        <translation>cellules qui ne sont pas des nombres, gardées en rouge&#xa0;: %1</translation>
    </message>
    <message>
        <source>outside the table and not taken: %1</source>
        <translation>hors du tableau et non repris&#xa0;: %1</translation>
    </message>
    <message>
        <source>all readings are zero</source>
        <translation>tous les relevés sont nuls</translation>
    </message>
    <message>
        <source>all readings are very small: is this the unit?</source>
        <translation>tous les relevés sont très petits&#xa0;: est-ce la bonne unité&#x202f;?</translation>
    </message>
    <message>
        <source>the range of a compensation begins before it ends</source>
        <translation>l’étendue d’une compensation commence avant sa fin</translation>
    </message>
    <message>
        <source>the interval of a compensation is positive and gives at most 100 000 points</source>
        <translation>le pas d’une compensation est positif et donne au plus 100&#x202f;000 points</translation>
    </message>
    <message>
        <source>“%1” is no line of a compensation table</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une ligne de table de compensation</translation>
    </message>
    <message>
        <source>the compensation table has no values, no step or no begin</source>
        <translation>la table de compensation n’a pas de valeurs, de pas ou d’origine</translation>
    </message>
    <message>
        <source>a compensation is made of a positioning test; this test is none</source>
        <translation>une compensation se fait à partir d’un essai de positionnement&#x202f;; cet essai n’en est pas un</translation>
    </message>
    <message>
        <source>a compensation needs two targets at least</source>
        <translation>une compensation demande au moins deux points visés</translation>
    </message>
    <message>
        <source>target %1 has no mean; a compensation needs one at every target</source>
        <translation>le point visé %1 n’a pas de moyenne&#x202f;; une compensation en demande une à chaque point</translation>
    </message>
    <message>
        <source>this format knows absolute values of one sign only; choose compensation-csv</source>
        <translation>ce format ne connaît que des valeurs absolues d’un seul signe&#x202f;; choisir compensation-csv</translation>
    </message>
    <message>
        <source>this format has one value a point; combine the directions, and state the reversal value as backlash</source>
        <translation>ce format a une valeur par point&#x202f;; combiner les sens et déclarer la valeur de réversibilité comme jeu</translation>
    </message>
    <message>
        <source>the positions of a compensation table ascend</source>
        <translation>les positions d’une table de compensation sont croissantes</translation>
    </message>
    <message>
        <source>positioning test of axis %1; targets: %2; runs each way: %3</source>
        <translation>essai de positionnement de l’axe %1&#x202f;; points visés&#xa0;: %2&#x202f;; passes par sens&#xa0;: %3</translation>
    </message>
    <message>
        <source>positioning test of axis %1; targets: %2; runs, positive only: %3</source>
        <translation>essai de positionnement de l’axe %1&#x202f;; points visés&#xa0;: %2&#x202f;; passes, sens positif seul&#xa0;: %3</translation>
    </message>
    <message>
        <source>positioning test of axis %1; targets: %2; runs, negative only: %3</source>
        <translation>essai de positionnement de l’axe %1&#x202f;; points visés&#xa0;: %2&#x202f;; passes, sens négatif seul&#xa0;: %3</translation>
    </message>
    <message>
        <source>moves from %1 to %2: check the room before the start</source>
        <translation>déplacement de %1 à %2&#xa0;: vérifier l’espace avant le départ</translation>
    </message>
    <message>
        <source>run %1</source>
        <translation>passe %1</translation>
    </message>
    <message>
        <source>target %1</source>
        <translation>point visé %1</translation>
    </message>
    <message>
        <source>anticlockwise, %1</source>
        <translation>sens antihoraire, %1</translation>
    </message>
    <message>
        <source>clockwise, %1</source>
        <translation>sens horaire, %1</translation>
    </message>
    <message>
        <source>repetitions</source>
        <translation>répétitions</translation>
    </message>
    <message>
        <source>nominal circle</source>
        <translation>cercle nominal</translation>
    </message>
    <message>
        <source>minimum zone, %1</source>
        <translation>zone minimale, %1</translation>
    </message>
    <message>
        <source>least squares, %1</source>
        <translation>moindres carrés, %1</translation>
    </message>
    <message>
        <source>limits of F</source>
        <translation>limites de F</translation>
    </message>
    <message>
        <source>reference centre</source>
        <translation>centre de référence</translation>
    </message>
    <message>
        <source>starting point</source>
        <translation>point de départ</translation>
    </message>
    <message>
        <source>ruling points</source>
        <translation>points de contact</translation>
    </message>
    <message>
        <source>Radial deviation F, %1</source>
        <translation>Écart radial F, %1</translation>
    </message>
    <message>
        <source>Circular deviation G, %1</source>
        <translation>Écart de circularité G, %1</translation>
    </message>
    <message>
        <source>Circular deviation Gf, %1</source>
        <translation>Écart de circularité Gf, %1</translation>
    </message>
    <message>
        <source>Actual path, %1</source>
        <translation>Trajectoire réelle, %1</translation>
    </message>
    <message>
        <source>Actual paths</source>
        <translation>Trajectoires réelles</translation>
    </message>
    <message>
        <source>about the centre of the set-up</source>
        <translation>autour du centre de réglage</translation>
    </message>
    <message>
        <source>about the programmed centre</source>
        <translation>autour du centre programmé</translation>
    </message>
    <message>
        <source>about the centre of the minimum zone of %1</source>
        <translation>autour du centre de la zone minimale de %1</translation>
    </message>
    <message>
        <source>about the centre of the minimum zone of both paths</source>
        <translation>autour du centre de la zone minimale des deux trajectoires</translation>
    </message>
    <message>
        <source>about the centre of the least squares circle of both paths</source>
        <translation>autour du centre du cercle des moindres carrés des deux trajectoires</translation>
    </message>
    <message>
        <source>about the centre of the least squares circle of %1</source>
        <translation>autour du centre du cercle des moindres carrés de %1</translation>
    </message>
    <message>
        <source>magnification %1, %2 per division</source>
        <translation>grossissement %1, %2 par division</translation>
    </message>
    <message>
        <source>Plane: nothing in the file says it; taken as XY.</source>
        <translation>Plan&#xa0;: rien ne le dit dans le fichier&#x202f;; pris comme XY.</translation>
    </message>
    <message>
        <source>Whether the length is calibrated is not stated: F and D need it.</source>
        <translation>Rien ne dit si la longueur est étalonnée&#xa0;: F et D en ont besoin.</translation>
    </message>
    <message>
        <source>document type definitions and entities are refused: no ballbar file has them</source>
        <translation>les définitions de type de document et les entités sont refusées&#xa0;: aucun fichier de ballbar n’en contient</translation>
    </message>
    <message>
        <source>nested deeper than a file of this kind can be</source>
        <translation>imbrication trop profonde pour un fichier de ce type</translation>
    </message>
    <message>
        <source>a text longer than a file of this kind can have</source>
        <translation>texte trop long pour un fichier de ce type</translation>
    </message>
    <message>
        <source>the XML ends too early; the file was cut off</source>
        <translation>le XML s’arrête trop tôt&#x202f;; le fichier est tronqué</translation>
    </message>
    <message>
        <source>this is no XML from here on; the file is damaged</source>
        <translation>ce n’est plus du XML à partir d’ici&#x202f;; le fichier est endommagé</translation>
    </message>
    <message>
        <source>“%1” is no direction of a run; expected CW or CCW</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas le sens d’une passe&#x202f;; CW ou CCW est attendu</translation>
    </message>
    <message>
        <source>“%1” is no reading; expected numbers separated by blanks</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un relevé&#x202f;; des nombres séparés par des blancs sont attendus</translation>
    </message>
    <message>
        <source>there are no readings of a ballbar in it</source>
        <translation>le fichier ne contient aucun relevé de ballbar</translation>
    </message>
    <message>
        <source>the nominal length is missing; state it as nominalRadius</source>
        <translation>la longueur nominale manque&#x202f;; l’indiquer par nominalRadius</translation>
    </message>
    <message>
        <source>the nominal radius is not positive</source>
        <translation>le rayon nominal n’est pas positif</translation>
    </message>
    <message>
        <source>Results of the instrument&apos;s own program: %1; they are shown beside ours.</source>
        <translation>Résultats du logiciel de l’instrument&#xa0;: %1&#x202f;; ils sont montrés à côté des nôtres.</translation>
    </message>
    <message>
        <source>Elements that were not read: %1.</source>
        <translation>Éléments non lus&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1 cannot be %2 for a circular test</source>
        <translation>%1 ne peut pas être %2 pour un essai de circularité</translation>
    </message>
    <message>
        <source>Readings: the file states no unit; about %1 they are read as lengths of the bar in %2.</source>
        <translation>Relevés&#xa0;: le fichier n’indique pas d’unité&#x202f;; autour de %1, ils sont lus comme longueurs de la barre en %2.</translation>
    </message>
    <message>
        <source>Readings: the file states no unit; up to %1 they are read as deviations in %2, positive outwards.</source>
        <translation>Relevés&#xa0;: le fichier n’indique pas d’unité&#x202f;; jusqu’à %1, ils sont lus comme écarts en %2, positifs vers l’extérieur.</translation>
    </message>
    <message>
        <source>start angle, arc or overshoot is beyond sense</source>
        <translation>l’angle de départ, l’arc ou le dépassement n’a pas de valeur plausible</translation>
    </message>
    <message>
        <source>Arc: the file has no angles; %1 at constant feed are assumed.</source>
        <translation>Arc&#xa0;: le fichier ne donne pas d’angles&#x202f;; %1 à vitesse constante sont supposés.</translation>
    </message>
    <message>
        <source>Start angle: taken as %1. A wrong one turns squareness into scale mismatch.</source>
        <translation>Angle de départ&#xa0;: pris à %1. Un angle faux transforme un défaut de perpendicularité en différence d’échelle.</translation>
    </message>
    <message>
        <source>this is a web page; open it in a browser, copy its table and paste it, or save the table as text</source>
        <translation>c’est une page web&#x202f;; l’ouvrir dans un navigateur, copier son tableau et le coller, ou enregistrer le tableau comme texte</translation>
    </message>
    <message>
        <source>“%1” differs from line to line; all readings are read, whatever it says.</source>
        <translation>«&#xa0;%1&#xa0;» diffère d’une ligne à l’autre&#x202f;; tous les relevés sont lus, quoi qu’il indique.</translation>
    </message>
    <message>
        <source>Axis: a line of the file names %1, the headings %2; %1 is taken.</source>
        <translation>Axe&#xa0;: une ligne du fichier nomme %1, les en-têtes %2&#x202f;; %1 est retenu.</translation>
    </message>
    <message>
        <source>A run states no direction and was not read.</source>
        <translation>Une passe n’indique pas son sens et n’a pas été lue.</translation>
    </message>
    <message>
        <source>the readings of this file are there already; import it once</source>
        <translation>les relevés de ce fichier sont déjà présents&#x202f;; n’importer chaque fichier qu’une fois</translation>
    </message>
    <message>
        <source>it names another machine than the files before it; import the files of each machine into a file of their own</source>
        <translation>il nomme une autre machine que les fichiers précédents&#x202f;; importer les fichiers de chaque machine dans un fichier à part</translation>
    </message>
    <message>
        <source>questions about this measurement are open that want an answer each; import it first</source>
        <translation>des questions sur cette mesure attendent chacune une réponse&#x202f;; l’importer d’abord</translation>
    </message>
    <message>
        <source>the template is of the machine with the serial number %1, the file of the one with %2</source>
        <translation>le modèle est celui de la machine de numéro de série %1, le fichier celui de la machine %2</translation>
    </message>
    <message>
        <source>no run of the file states its direction</source>
        <translation>aucune passe du fichier n’indique son sens</translation>
    </message>
    <message>
        <source>Sign: the file says “%1”, which does not tell what is subtracted from what; read as actual − target.</source>
        <translation>Signe&#xa0;: le fichier indique «&#xa0;%1&#xa0;», sans dire ce qui est soustrait de quoi&#x202f;; lu comme réel − visé.</translation>
    </message>
    <message>
        <source>Sign: the file says “%1”; read as positive inwards.</source>
        <translation>Signe&#xa0;: le fichier indique «&#xa0;%1&#xa0;»&#x202f;; lu comme positif vers l’intérieur.</translation>
    </message>
    <message>
        <source>Sign: the file says “%1”; read as positive outwards.</source>
        <translation>Signe&#xa0;: le fichier indique «&#xa0;%1&#xa0;»&#x202f;; lu comme positif vers l’extérieur.</translation>
    </message>
    <message>
        <source>“%1”: half of each diameter is read as the radius.</source>
        <translation>«&#xa0;%1&#xa0;»&#xa0;: la moitié de chaque diamètre est lue comme rayon.</translation>
    </message>
    <message>
        <source>Columns: they are of several days (%1); all runs are read as those of one test.</source>
        <translation>Colonnes&#xa0;: elles sont de plusieurs jours (%1)&#x202f;; toutes les passes sont lues comme celles d’un même essai.</translation>
    </message>
    <message>
        <source>a run of one reading is no circle</source>
        <translation>une passe d’un seul relevé n’est pas un cercle</translation>
    </message>
    <message>
        <source>Understood: paths: %1; points: %2.</source>
        <translation>Compris&#xa0;: trajectoires&#xa0;: %1&#x202f;; points&#xa0;: %2.</translation>
    </message>
    <message>
        <source>table</source>
        <translation>tableau</translation>
    </message>
    <message>
        <source>workbook</source>
        <translation>classeur</translation>
    </message>
    <message>
        <source>Renishaw laser data</source>
        <translation>données laser Renishaw</translation>
    </message>
    <message>
        <source>Renishaw ballbar</source>
        <translation>ballbar Renishaw</translation>
    </message>
    <message>
        <source>Renishaw dynamic capture</source>
        <translation>acquisition dynamique Renishaw</translation>
    </message>
    <message>
        <source>values with indexes (TGT_DATA)</source>
        <translation>valeurs indexées (TGT_DATA)</translation>
    </message>
    <message>
        <source>compensation text</source>
        <translation>texte de compensation</translation>
    </message>
    <message>
        <source>UTF-8</source>
        <translation>UTF-8</translation>
    </message>
    <message>
        <source>UTF-16, little end first</source>
        <translation>UTF-16, petit-boutiste</translation>
    </message>
    <message>
        <source>UTF-16, big end first</source>
        <translation>UTF-16, gros-boutiste</translation>
    </message>
    <message>
        <source>Western Europe (Windows-1252)</source>
        <translation>Europe occidentale (Windows-1252)</translation>
    </message>
    <message>
        <source>Chinese (GB18030, GBK)</source>
        <translation>Chinois (GB18030, GBK)</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>tabulation</translation>
    </message>
    <message>
        <source>semicolon ;</source>
        <translation>point-virgule&#x202f;;</translation>
    </message>
    <message>
        <source>comma ,</source>
        <translation>virgule ,</translation>
    </message>
    <message>
        <source>vertical bar |</source>
        <translation>barre verticale |</translation>
    </message>
    <message>
        <source>blanks</source>
        <translation>blancs</translation>
    </message>
    <message>
        <source>point .</source>
        <translation>point .</translation>
    </message>
    <message>
        <source>positioning test</source>
        <translation>essai de positionnement</translation>
    </message>
    <message>
        <source>circular test</source>
        <translation>essai de circularité</translation>
    </message>
    <message>
        <source>drift test</source>
        <translation>essai de dérive</translation>
    </message>
    <message>
        <source>temperatures over time</source>
        <translation>températures en fonction du temps</translation>
    </message>
    <message>
        <source>targets down, runs across</source>
        <translation>une ligne par point visé</translation>
    </message>
    <message>
        <source>runs down, targets across</source>
        <translation>une ligne par passe</translation>
    </message>
    <message>
        <source>one reading a line</source>
        <translation>un relevé par ligne</translation>
    </message>
    <message>
        <source>x and y</source>
        <translation>x et y</translation>
    </message>
    <message>
        <source>angle and radius</source>
        <translation>angle et rayon</translation>
    </message>
    <message>
        <source>angle and radial deviation</source>
        <translation>angle et écart radial</translation>
    </message>
    <message>
        <source>values over time</source>
        <translation>valeurs en fonction du temps</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>selon le fichier</translation>
    </message>
    <message>
        <source>alternating ↑ ↓</source>
        <translation>passes alternées ↑ ↓</translation>
    </message>
    <message>
        <source>all ↑, then all ↓</source>
        <translation>toutes ↑, puis toutes ↓</translation>
    </message>
    <message>
        <source>all ↑</source>
        <translation>toutes ↑</translation>
    </message>
    <message>
        <source>all ↓</source>
        <translation>toutes ↓</translation>
    </message>
    <message>
        <source>deviations</source>
        <translation>écarts</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>positions</translation>
    </message>
    <message>
        <source>actual − target (ISO)</source>
        <translation>réel − visé (ISO)</translation>
    </message>
    <message>
        <source>target − actual</source>
        <translation>visé − réel</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>µm</source>
        <translation>µm</translation>
    </message>
    <message>
        <source>nm</source>
        <translation>nm</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source>µin</source>
        <translation>µin</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>′</source>
        <translation>′</translation>
    </message>
    <message>
        <source>″</source>
        <translation>″</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
    <message>
        <source>mrad</source>
        <translation>mrad</translation>
    </message>
    <message>
        <source>µrad</source>
        <translation>µrad</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <source>of the measured point</source>
        <translation>du point mesuré</translation>
    </message>
    <message>
        <source>of the programmed path</source>
        <translation>de la trajectoire programmée</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Encoding</source>
        <translation>Codage</translation>
    </message>
    <message>
        <source>Delimiter</source>
        <translation>Séparateur</translation>
    </message>
    <message>
        <source>Decimal mark</source>
        <translation>Séparateur décimal</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Feuille</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Nature</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Disposition</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>Contenu</translation>
    </message>
    <message>
        <source>Unit of positions</source>
        <translation>Unité des points</translation>
    </message>
    <message>
        <source>Unit of times</source>
        <translation>Unité des temps</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Signe</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Nominal radius (mm)</source>
        <translation>Rayon nominal (mm)</translation>
    </message>
    <message>
        <source>Centre, first axis (mm)</source>
        <translation>Centre, premier axe (mm)</translation>
    </message>
    <message>
        <source>Centre, second axis (mm)</source>
        <translation>Centre, second axe (mm)</translation>
    </message>
    <message>
        <source>Feed (mm/min)</source>
        <translation>Vitesse d’avance (mm/min)</translation>
    </message>
    <message>
        <source>Start angle (°)</source>
        <translation>Angle de départ (°)</translation>
    </message>
    <message>
        <source>Arc (°)</source>
        <translation>Arc (°)</translation>
    </message>
    <message>
        <source>Angular overshoot (°)</source>
        <translation>Dépassement angulaire (°)</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Angles</translation>
    </message>
    <message>
        <source>Length calibrated</source>
        <translation>Longueur étalonnée</translation>
    </message>
    <message>
        <source>unknown choice %1; known: %2</source>
        <translation>choix inconnu&#xa0;: %1&#x202f;; connus&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 cannot be %2; known: %3</source>
        <translation>%1 ne peut pas être %2&#x202f;; valeurs connues&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1 cannot be %2; expected a number</source>
        <translation>%1 ne peut pas être %2&#x202f;; un nombre est attendu</translation>
    </message>
    <message>
        <source>there are no points of a circle in it</source>
        <translation>le fichier ne contient aucun point d’un cercle</translation>
    </message>
    <message>
        <source>Points without a number were left out: %1.</source>
        <translation>Points sans nombre, laissés de côté&#xa0;: %1.</translation>
    </message>
    <message>
        <source>these columns do not make a circle; expected x and y, angle and radius, angle and deviation, or radial deviations alone</source>
        <translation>ces colonnes ne font pas un cercle&#x202f;; x et y, angle et rayon, angle et écart ou des écarts radiaux seuls sont attendus</translation>
    </message>
    <message>
        <source>Content: the columns are read as x and y of points of a circle.</source>
        <translation>Contenu&#xa0;: les colonnes sont lues comme x et y des points d’un cercle.</translation>
    </message>
    <message>
        <source>Content: the columns are read as angle and radius.</source>
        <translation>Contenu&#xa0;: les colonnes sont lues comme angle et rayon.</translation>
    </message>
    <message>
        <source>Content: the columns are read as angle and radial deviation.</source>
        <translation>Contenu&#xa0;: les colonnes sont lues comme angle et écart radial.</translation>
    </message>
    <message>
        <source>Unit of x and y: nothing in the file says it; read as %1.</source>
        <translation>Unité de x et y&#xa0;: rien ne le dit dans le fichier&#x202f;; lus en %1.</translation>
    </message>
    <message>
        <source>the points do not lie on a circle</source>
        <translation>les points ne sont pas sur un cercle</translation>
    </message>
    <message>
        <source>Centre: nothing in the file says it; taken at %1; %2.</source>
        <translation>Centre&#xa0;: rien ne le dit dans le fichier&#x202f;; pris en %1&#x202f;; %2.</translation>
    </message>
    <message>
        <source>Nominal radius: nothing in the file says it; taken as %1.</source>
        <translation>Rayon nominal&#xa0;: rien ne le dit dans le fichier&#x202f;; pris à %1.</translation>
    </message>
    <message>
        <source>Unit of the angles: nothing in the file says it; read as %1.</source>
        <translation>Unité des angles&#xa0;: rien ne le dit dans le fichier&#x202f;; lus en %1.</translation>
    </message>
    <message>
        <source>Unit of the radial deviations: nothing in the file says it; read as %1.</source>
        <translation>Unité des écarts radiaux&#xa0;: rien ne le dit dans le fichier&#x202f;; lus en %1.</translation>
    </message>
    <message>
        <source>Nominal radius: nothing in the file says it, and deviations do not show it; state it in mm.</source>
        <translation>Rayon nominal&#xa0;: rien ne l’indique dans le fichier, et les écarts ne le montrent pas&#x202f;; l’indiquer en mm.</translation>
    </message>
    <message>
        <source>Sign: radial deviations are read as positive outwards.</source>
        <translation>Signe&#xa0;: les écarts radiaux sont lus comme positifs vers l’extérieur.</translation>
    </message>
    <message>
        <source>Angles: read as those of the measured point, not of the programmed path (a ballbar).</source>
        <translation>Angles&#xa0;: lus comme ceux du point mesuré, non de la trajectoire programmée (ballbar).</translation>
    </message>
    <message>
        <source>Sense: the angles run against the sense the file names; the points are taken in the opposite order.</source>
        <translation>Sens&#xa0;: les angles vont à l’encontre du sens indiqué par le fichier&#x202f;; les points sont pris dans l’ordre inverse.</translation>
    </message>
    <message>
        <source>this is no character of UTF-16; expected a text file</source>
        <translation>ce n’est pas un caractère UTF-16&#x202f;; un fichier texte est attendu</translation>
    </message>
    <message>
        <source>this is no character of UTF-8 nor of Windows-1252; expected a text file</source>
        <translation>ce n’est un caractère ni d’UTF-8 ni de Windows-1252&#x202f;; un fichier texte est attendu</translation>
    </message>
    <message>
        <source>this system does not know the encoding GB18030; save the text as UTF-8</source>
        <translation>ce système ne connaît pas le codage GB18030&#x202f;; enregistrer le texte en UTF-8</translation>
    </message>
    <message>
        <source>this is no character of GB18030; expected a text file</source>
        <translation>ce n’est pas un caractère de GB18030&#x202f;; un fichier texte est attendu</translation>
    </message>
    <message>
        <source>this is binary data; expected a text file, a workbook or an instrument file that can be read</source>
        <translation>ce sont des données binaires&#x202f;; un fichier texte, un classeur ou un fichier d’instrument lisible est attendu</translation>
    </message>
    <message>
        <source>this is no character of UTF-8; expected a text file in UTF-8</source>
        <translation>ce n’est pas un caractère UTF-8&#x202f;; un fichier texte en UTF-8 est attendu</translation>
    </message>
    <message>
        <source>the file is empty; expected a table of readings or the file of an instrument</source>
        <translation>le fichier est vide&#x202f;; un tableau de relevés ou un fichier d’instrument est attendu</translation>
    </message>
    <message>
        <source>Correction to 20 °C: whether the instrument has applied one is not stated; say it.</source>
        <translation>Correction à 20&#xa0;°C&#xa0;: rien ne dit si l’instrument en a appliqué une&#x202f;; l’indiquer.</translation>
    </message>
    <message>
        <source>there are numbers in it that no machine has; check units and decimal mark</source>
        <translation>le fichier contient des nombres qu’aucune machine ne peut avoir&#x202f;; vérifier les unités et le séparateur décimal</translation>
    </message>
    <message>
        <source>this is a test file or a report, not a measurement; open it instead</source>
        <translation>c’est un fichier d’essai ou un rapport, et non une mesure&#x202f;; l’ouvrir au lieu de l’importer</translation>
    </message>
    <message>
        <source>temperatures need a test that they belong to; import the measurement before them</source>
        <translation>des températures doivent se rapporter à un essai&#x202f;; importer d’abord la mesure</translation>
    </message>
    <message>
        <source>Unit of the positions: nothing in the file says it; read as %1.</source>
        <translation>Unité des positions&#xa0;: rien ne le dit dans le fichier&#x202f;; lues en %1.</translation>
    </message>
    <message>
        <source>%1 cannot be %2 here: the axis moves the other way</source>
        <translation>%1 ne peut pas être %2 ici&#xa0;: ce n’est pas le mouvement de l’axe</translation>
    </message>
    <message>
        <source>there are no target positions in it</source>
        <translation>le fichier ne contient aucun point visé</translation>
    </message>
    <message>
        <source>Lines of text that were not used: %1 (%2).</source>
        <translation>Lignes de texte ignorées&#xa0;: %1 (%2).</translation>
    </message>
    <message>
        <source>“%1” is not a number. The reading stays missing.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre. Le relevé reste manquant.</translation>
    </message>
    <message>
        <source>“%1” is no target position</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un point visé</translation>
    </message>
    <message>
        <source>The unit “%1” is not known.</source>
        <translation>L’unité «&#xa0;%1&#xa0;» est inconnue.</translation>
    </message>
    <message>
        <source>there are readings of targets that are not in the list</source>
        <translation>des relevés se rapportent à des points visés absents de la liste</translation>
    </message>
    <message>
        <source>All readings of run %1 are zero: was it measured at all?</source>
        <translation>Tous les relevés de la passe %1 sont nuls&#xa0;: a-t-elle été mesurée&#x202f;?</translation>
    </message>
    <message>
        <source>Readings missing: %1.</source>
        <translation>Relevés manquants&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The directions have unequal numbers of runs: %1 ↑ and %2 ↓.</source>
        <translation>Les sens n’ont pas le même nombre de passes&#xa0;: %1 ↑ et %2 ↓.</translation>
    </message>
    <message>
        <source>Understood: targets: %1; runs ↑: %2; runs ↓: %3.</source>
        <translation>Compris&#xa0;: points visés&#xa0;: %1&#x202f;; passes ↑&#xa0;: %2&#x202f;; passes ↓&#xa0;: %3.</translation>
    </message>
    <message>
        <source>there are no readings in it; expected target positions and deviations</source>
        <translation>le fichier ne contient aucun relevé&#x202f;; des points visés et des écarts sont attendus</translation>
    </message>
    <message>
        <source>Readings that stand at a target twice in one run: %1; the first is kept.</source>
        <translation>Relevés en double à un point visé d’une même passe&#xa0;: %1&#x202f;; le premier est conservé.</translation>
    </message>
    <message>
        <source>Content: the values run from %1 to %2 as the targets do; they are read as positions, not as deviations.</source>
        <translation>Contenu&#xa0;: les valeurs vont de %1 à %2 comme les points visés&#x202f;; elles sont lues comme positions, non comme écarts.</translation>
    </message>
    <message>
        <source>Content: the values run from %1 to %2; they are read as deviations, not as positions.</source>
        <translation>Contenu&#xa0;: les valeurs vont de %1 à %2&#x202f;; elles sont lues comme écarts, non comme positions.</translation>
    </message>
    <message>
        <source>Unit of the target positions: nothing in the file says it; read as %1.</source>
        <translation>Unité des points visés&#xa0;: rien ne le dit dans le fichier&#x202f;; lus en %1.</translation>
    </message>
    <message>
        <source>Unit of the deviations: nothing in the file says it; read as %1 after their size.</source>
        <translation>Unité des écarts&#xa0;: rien ne le dit dans le fichier&#x202f;; lus en %1 d’après leur grandeur.</translation>
    </message>
    <message>
        <source>Sign: nothing in the file says it; read as actual − target.</source>
        <translation>Signe&#xa0;: rien ne le dit dans le fichier&#x202f;; lu comme «&#xa0;réel − visé&#xa0;».</translation>
    </message>
    <message>
        <source>Layout: the first line is read as the targets, each further one as a run.</source>
        <translation>Disposition&#xa0;: la première ligne est lue comme les points visés, chacune des suivantes comme une passe.</translation>
    </message>
    <message>
        <source>The targets stand in no order; they were sorted.</source>
        <translation>Les points visés ne sont pas dans l’ordre&#x202f;; ils ont été triés.</translation>
    </message>
    <message>
        <source>“%1” is no target position; the line was not read.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un point visé&#x202f;; la ligne n’a pas été lue.</translation>
    </message>
    <message>
        <source>the file does not say which runs are ↑ and which ↓; choose another word for “directions”</source>
        <translation>le fichier n’indique pas quelles passes sont ↑ et lesquelles sont ↓&#x202f;; choisir un autre mot pour «&#xa0;directions&#xa0;»</translation>
    </message>
    <message>
        <source>Directions: nothing in the file says them; the lines are read as ↑ and ↓ in turn.</source>
        <translation>Sens&#xa0;: rien ne le dit dans le fichier&#x202f;; les lignes sont lues comme ↑ et ↓ tour à tour.</translation>
    </message>
    <message>
        <source>Directions: nothing in the file says them; the blocks are read as ↑ and ↓ in turn.</source>
        <translation>Sens&#xa0;: rien ne le dit dans le fichier&#x202f;; les blocs sont lus comme ↑ et ↓ tour à tour.</translation>
    </message>
    <message>
        <source>Directions: nothing in the file says them; the runs are read as ↑ and ↓ in turn.</source>
        <translation>Sens&#xa0;: rien ne le dit dans le fichier&#x202f;; les passes sont lues comme ↑ et ↓ tour à tour.</translation>
    </message>
    <message>
        <source>Directions: nothing in the file says them; the first half of the runs is read as ↑, the second as ↓.</source>
        <translation>Sens&#xa0;: rien ne le dit dans le fichier&#x202f;; la première moitié des passes est lue comme ↑, la seconde comme ↓.</translation>
    </message>
    <message>
        <source>Order of the runs: in the table, ↓ comes before ↑ of the same number; ↑ is put first.</source>
        <translation>Ordre des passes&#xa0;: dans le tableau, ↓ vient avant ↑ de même numéro&#x202f;; ↑ est mise en premier.</translation>
    </message>
    <message>
        <source>Directions: only “%1”, the heading of the targets, names one.</source>
        <translation>Sens&#xa0;: seul l’en-tête des points visés, «&#xa0;%1&#xa0;», en nomme un.</translation>
    </message>
    <message>
        <source>Directions: nothing in the file says them; all runs are read as ↑.</source>
        <translation>Sens&#xa0;: rien ne le dit dans le fichier&#x202f;; toutes les passes sont lues comme ↑.</translation>
    </message>
    <message>
        <source>this is no file of import profiles; expected names with their choices</source>
        <translation>ce n’est pas un fichier de profils d’import&#x202f;; des noms accompagnés de leurs choix sont attendus</translation>
    </message>
    <message>
        <source>This line is not like the others and was not read.</source>
        <translation>Cette ligne n’est pas comme les autres et n’a pas été lue.</translation>
    </message>
    <message>
        <source>there is no table of axis positions and compensation values in it</source>
        <translation>le fichier ne contient pas de table de positions et de valeurs de compensation</translation>
    </message>
    <message>
        <source>Start and end of the head are not those of the table; the table counts.</source>
        <translation>Le début et la fin donnés par l’en-tête ne sont pas ceux de la table&#x202f;; c’est la table qui compte.</translation>
    </message>
    <message>
        <source>This is a compensation table, not a measurement: its values are read with the opposite sign as deviations, to compare.</source>
        <translation>C’est une table de compensation, non une mesure&#xa0;: ses valeurs sont lues avec le signe opposé comme écarts, pour comparer.</translation>
    </message>
    <message>
        <source>Unit of the compensation values: nothing in the file says it; read as %1.</source>
        <translation>Unité des valeurs de compensation&#xa0;: rien ne le dit dans le fichier&#x202f;; lues en %1.</translation>
    </message>
    <message>
        <source>the file ends before “%1”: it was cut off</source>
        <translation>le fichier s’arrête avant «&#xa0;%1&#xa0;»&#xa0;: il est tronqué</translation>
    </message>
    <message>
        <source>the section %1 is missing</source>
        <translation>la section %1 manque</translation>
    </message>
    <message>
        <source>“%1” is not a list of target positions</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une liste de points visés</translation>
    </message>
    <message>
        <source>“%1” is not run, target and deviation; the line was not read.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas formé d’une passe, d’un point visé et d’un écart&#x202f;; la ligne n’a pas été lue.</translation>
    </message>
    <message>
        <source>there is no target %1; the list has %2</source>
        <translation>il n’y a pas de point visé n°&#xa0;%1&#x202f;; la liste en contient %2</translation>
    </message>
    <message>
        <source>Directions: the targets descend along the list; a run in its order moves in the negative direction and is read as ↓.</source>
        <translation>Sens&#xa0;: les points visés décroissent le long de la liste&#x202f;; une passe dans son ordre va dans le sens négatif et est lue comme ↓.</translation>
    </message>
    <message>
        <source>Directions: the order of the targets does not say them; odd runs are read as ↑, even ones as ↓.</source>
        <translation>Sens&#xa0;: l’ordre des points visés ne les indique pas&#x202f;; les passes impaires sont lues comme ↑, les paires comme ↓.</translation>
    </message>
    <message>
        <source>Units of this format: targets in %1, deviations in %2, actual − target.</source>
        <translation>Unités de ce format&#xa0;: points visés en %1, écarts en %2, réel − visé.</translation>
    </message>
    <message>
        <source>“%1” is 0 °C: taken as not connected.</source>
        <translation>«&#xa0;%1&#xa0;» est à 0&#xa0;°C&#xa0;: considéré comme non raccordé.</translation>
    </message>
    <message>
        <source>Temperatures of the file are taken as those at the start of the test.</source>
        <translation>Les températures du fichier sont prises comme celles du début de l’essai.</translation>
    </message>
    <message>
        <source>Unit of the positions: the file says “%1”, but its format has them in %2; say the unit of the numbers.</source>
        <translation>Unité des positions&#xa0;: le fichier indique «&#xa0;%1&#xa0;», mais son format les a en %2&#x202f;; indiquer l’unité des nombres.</translation>
    </message>
    <message>
        <source>Unit of the readings: the file says “%1”, but its format has them in %2; say the unit of the numbers.</source>
        <translation>Unité des relevés&#xa0;: le fichier indique «&#xa0;%1&#xa0;», mais son format les a en %2&#x202f;; indiquer l’unité des nombres.</translation>
    </message>
    <message>
        <source>The section %1 is there once more; it was not read.</source>
        <translation>La section %1 figure une nouvelle fois&#x202f;; elle n’a pas été lue.</translation>
    </message>
    <message>
        <source>Directions: the file says “%1”, which was not used; is what was read right?</source>
        <translation>Sens&#xa0;: le fichier indique «&#xa0;%1&#xa0;», ce qui n’a pas été utilisé&#x202f;; la lecture est-elle juste&#x202f;?</translation>
    </message>
    <message>
        <source>Directions: the file says “%1”; read as ↓.</source>
        <translation>Sens&#xa0;: le fichier indique «&#xa0;%1&#xa0;»&#x202f;; lu comme ↓.</translation>
    </message>
    <message>
        <source>Directions: the file says “%1”; read as ↑.</source>
        <translation>Sens&#xa0;: le fichier indique «&#xa0;%1&#xa0;»&#x202f;; lu comme ↑.</translation>
    </message>
    <message>
        <source>the table holds increments from one position to the next, not values at the positions; save it as an absolute table</source>
        <translation>la table contient des incréments d’une position à la suivante, non des valeurs aux positions&#x202f;; l’enregistrer comme table absolue</translation>
    </message>
    <message>
        <source>the unit of the sample rate “%1” is not known</source>
        <translation>l’unité de la fréquence d’échantillonnage «&#xa0;%1&#xa0;» est inconnue</translation>
    </message>
    <message>
        <source>Kind: the file speaks of “%1”; read as a drift test.</source>
        <translation>Nature&#xa0;: le fichier parle de «&#xa0;%1&#xa0;»&#x202f;; lu comme un essai de dérive.</translation>
    </message>
    <message>
        <source>%1: the file says “%2” in an element that is not known; read as %3.</source>
        <translation>%1&#xa0;: le fichier indique «&#xa0;%2&#xa0;» dans un élément inconnu&#x202f;; lu comme %3.</translation>
    </message>
    <message>
        <source>Arc: readings of the runs: %1 to %2, so one may be of a shorter arc; %3 is assumed for each.</source>
        <translation>Arc&#xa0;: relevés par passe&#xa0;: de %1 à %2, l’une est peut-être d’un arc plus court&#x202f;; %3 est supposé pour chacune.</translation>
    </message>
    <message>
        <source>The section %1 is not known and was not read.</source>
        <translation>La section %1 est inconnue et n’a pas été lue.</translation>
    </message>
    <message>
        <source>the number of samples is missing in the head</source>
        <translation>le nombre d’échantillons manque dans l’en-tête</translation>
    </message>
    <message>
        <source>the sample rate is missing in the head</source>
        <translation>la fréquence d’échantillonnage manque dans l’en-tête</translation>
    </message>
    <message>
        <source>sample %1 is no number: the data are damaged</source>
        <translation>l’échantillon %1 n’est pas un nombre&#xa0;: les données sont endommagées</translation>
    </message>
    <message>
        <source>The file has no end mark behind its samples.</source>
        <translation>Le fichier n’a pas de marque de fin après ses échantillons.</translation>
    </message>
    <message>
        <source>Understood: a drift test; points: %1; duration: %2.</source>
        <translation>Compris&#xa0;: un essai de dérive&#x202f;; points&#xa0;: %1&#x202f;; durée&#xa0;: %2.</translation>
    </message>
    <message>
        <source>one column of numbers is no series; expected times and values</source>
        <translation>une seule colonne de nombres n’est pas une série&#x202f;; des temps et des valeurs sont attendus</translation>
    </message>
    <message>
        <source>Unit of the times: nothing in the file says it; read as %1.</source>
        <translation>Unité des temps&#xa0;: rien ne le dit dans le fichier&#x202f;; lus en %1.</translation>
    </message>
    <message>
        <source>the times do not rise; expected a series over time</source>
        <translation>les temps ne croissent pas&#x202f;; une série temporelle est attendue</translation>
    </message>
    <message>
        <source>Sensor “%1”: read as the temperature of the %2.</source>
        <translation>Capteur «&#xa0;%1&#xa0;»&#xa0;: lu comme température de&#xa0;: %2.</translation>
    </message>
    <message>
        <source>air</source>
        <translation>air</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>machine</translation>
    </message>
    <message>
        <source>Largest change within an hour: %1.</source>
        <translation>Plus grande variation en une heure&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The series is shorter than an hour: no gradient per hour.</source>
        <translation>La série dure moins d’une heure&#xa0;: pas de gradient horaire.</translation>
    </message>
    <message>
        <source>there are no readings in it; expected times and deviations</source>
        <translation>le fichier ne contient aucun relevé&#x202f;; des temps et des écarts sont attendus</translation>
    </message>
    <message>
        <source>more rows or cells than a table of readings can have</source>
        <translation>plus de lignes ou de cellules que n’en peut avoir un tableau de relevés</translation>
    </message>
    <message>
        <source>there is no table of numbers in it; expected target positions and readings, points of a circle, or values over time</source>
        <translation>le fichier ne contient pas de tableau de nombres&#x202f;; des points visés et des relevés, des points d’un cercle ou des valeurs en fonction du temps sont attendus</translation>
    </message>
    <message>
        <source>“%1” is read as a missing reading.</source>
        <translation>«&#xa0;%1&#xa0;» est lu comme un relevé manquant.</translation>
    </message>
    <message>
        <source>“%1” has another decimal mark or thousands separators. The reading stays missing.</source>
        <translation>«&#xa0;%1&#xa0;» a un autre séparateur décimal ou des séparateurs de milliers. Le relevé reste manquant.</translation>
    </message>
    <message>
        <source>Kind: nothing in the file says it; read as a circular test.</source>
        <translation>Nature&#xa0;: rien ne le dit dans le fichier&#x202f;; lu comme un essai de circularité.</translation>
    </message>
    <message>
        <source>Kind: nothing in the file says it; read as a positioning test.</source>
        <translation>Nature&#xa0;: rien ne le dit dans le fichier&#x202f;; lu comme un essai de positionnement.</translation>
    </message>
    <message>
        <source>Kind: the file speaks of “%1”; read as a positioning test.</source>
        <translation>Nature&#xa0;: le fichier parle de «&#xa0;%1&#xa0;»&#x202f;; lu comme un essai de positionnement.</translation>
    </message>
    <message>
        <source>Encoding: the text is not UTF-8; read as Windows-1252.</source>
        <translation>Codage&#xa0;: le texte n’est pas en UTF-8&#x202f;; lu en Windows-1252.</translation>
    </message>
    <message>
        <source>Encoding: the text is not UTF-8; read as Chinese (GB18030).</source>
        <translation>Codage&#xa0;: le texte n’est pas en UTF-8&#x202f;; lu comme du chinois (GB18030).</translation>
    </message>
    <message>
        <source>Encoding: %1, as the file says.</source>
        <translation>Codage&#xa0;: %1, selon le fichier.</translation>
    </message>
    <message>
        <source>Decimal mark: the numbers can be read in several ways; the comma is taken as decimal mark.</source>
        <translation>Séparateur décimal&#xa0;: les nombres peuvent se lire de plusieurs façons&#x202f;; la virgule est retenue.</translation>
    </message>
    <message>
        <source>Decimal mark: the numbers can be read in several ways; the point is taken as decimal mark.</source>
        <translation>Séparateur décimal&#xa0;: les nombres peuvent se lire de plusieurs façons&#x202f;; le point est retenu.</translation>
    </message>
    <message>
        <source>save the test from Ballbar 20 as .b5r (XML), or export its readings as text</source>
        <translation>enregistrer l’essai depuis Ballbar 20 en .b5r (XML), ou exporter ses relevés en texte</translation>
    </message>
    <message>
        <source>export the test from Explore as .rtl, or as CSV</source>
        <translation>exporter l’essai depuis Explore en .rtl ou en CSV</translation>
    </message>
    <message>
        <source>print or export the data table as text or CSV</source>
        <translation>imprimer ou exporter le tableau de données en texte ou en CSV</translation>
    </message>
    <message>
        <source>export the results as text or CSV</source>
        <translation>exporter les résultats en texte ou en CSV</translation>
    </message>
    <message>
        <source>export the data as text or CSV</source>
        <translation>exporter les données en texte ou en CSV</translation>
    </message>
    <message>
        <source>export the measured values as text or CSV</source>
        <translation>exporter les valeurs mesurées en texte ou en CSV</translation>
    </message>
    <message>
        <source>export the measured values as text (ASCII)</source>
        <translation>exporter les valeurs mesurées en texte (ASCII)</translation>
    </message>
    <message>
        <source>export the test as text or CSV</source>
        <translation>exporter l’essai en texte ou en CSV</translation>
    </message>
    <message>
        <source>the format %1 is not documented publicly and cannot be read; %2</source>
        <translation>le format %1 n’est pas documenté publiquement et ne peut pas être lu&#x202f;; %2</translation>
    </message>
    <message>
        <source>the workbook is damaged or was cut off; save it again, or export the sheet as CSV</source>
        <translation>le classeur est endommagé ou tronqué&#x202f;; l’enregistrer de nouveau, ou exporter la feuille en CSV</translation>
    </message>
    <message>
        <source>there is no sheet “%1”; there are: %2</source>
        <translation>il n’y a pas de feuille «&#xa0;%1&#xa0;»&#x202f;; il y a&#xa0;: %2</translation>
    </message>
    <message>
        <source>this archive is no workbook; expected .xlsx or .ods</source>
        <translation>cette archive n’est pas un classeur&#x202f;; un fichier .xlsx ou .ods est attendu</translation>
    </message>
    <message>
        <source>The workbook has %1 sheets; “%2” is read.</source>
        <translation>Le classeur a %1 feuilles&#x202f;; «&#xa0;%2&#xa0;» est lue.</translation>
    </message>
    <message>
        <source>the workbook unpacks to more than a table of readings can be</source>
        <translation>une fois décompressé, le classeur est plus grand que ne peut l’être un tableau de relevés</translation>
    </message>
    <message>
        <source>No uncertainty by the budget: impossible as stated: %1.</source>
        <translation>Pas d’incertitude selon le budget&#xa0;: valeur impossible&#xa0;: %1.</translation>
    </message>
    <message>
        <source>No uncertainty by the budget: not stated: %1.</source>
        <translation>Pas d’incertitude selon le budget&#xa0;: non indiqué&#xa0;: %1.</translation>
    </message>
    <message>
        <source>No uncertainty of %1 by the budget: impossible as stated: %2.</source>
        <translation>Pas d’incertitude de %1 selon le budget&#xa0;: valeur impossible&#xa0;: %2.</translation>
    </message>
    <message>
        <source>No uncertainty of %1 by the budget: not stated: %2.</source>
        <translation>Pas d’incertitude de %1 selon le budget&#xa0;: non indiqué&#xa0;: %2.</translation>
    </message>
    <message>
        <source>The Monte Carlo simulation that is to give the uncertainty was not run.</source>
        <translation>La simulation de Monte-Carlo qui doit donner l’incertitude n’a pas été exécutée.</translation>
    </message>
    <message>
        <source>The Monte Carlo simulation was run before the last edit of the test: its figures are outdated.</source>
        <translation>La simulation de Monte-Carlo précède la dernière modification de l’essai&#xa0;: ses chiffres sont périmés.</translation>
    </message>
    <message>
        <source>The Monte Carlo simulation ended before two places of the uncertainty were stable.</source>
        <translation>La simulation de Monte-Carlo s’est terminée avant que deux chiffres de l’incertitude soient stables.</translation>
    </message>
    <message>
        <source>Measurement errors bias %1 by more than a third of the uncertainty that the Monte Carlo simulation gives: the budget U is used for the verdict.</source>
        <translation>Les erreurs de mesure décalent %1 de plus d’un tiers de l’incertitude que donne la simulation de Monte-Carlo&#xa0;: le verdict est fondé sur l’U du budget.</translation>
    </message>
    <message>
        <source>Measurement errors bias %1 by more than a third of the uncertainty that the Monte Carlo simulation gives.</source>
        <translation>Les erreurs de mesure décalent %1 de plus d’un tiers de l’incertitude que donne la simulation de Monte-Carlo.</translation>
    </message>
    <message>
        <source>%1: budget and Monte Carlo differ by more than 20 %: the simulation follows the extreme points of the path and their noise.</source>
        <translation>%1&#xa0;: budget et Monte-Carlo diffèrent de plus de 20&#xa0;%&#xa0;: la simulation suit les points extrêmes de la trajectoire et leur bruit.</translation>
    </message>
    <message>
        <source>%1: budget and Monte Carlo differ by more than 20 %: an error that all points of a path have in common moves the circle and leaves its width; the budget counts it in full.</source>
        <translation>%1&#xa0;: budget et Monte-Carlo diffèrent de plus de 20&#xa0;%&#xa0;: une erreur commune à tous les points d’une trajectoire change le cercle sans en changer la largeur&#x202f;; le budget la compte entière.</translation>
    </message>
    <message>
        <source>%1: budget and Monte Carlo differ by more than 20 %: the ruling targets lie closer together than the length L = %2 of the budget.</source>
        <translation>%1&#xa0;: budget et Monte-Carlo diffèrent de plus de 20&#xa0;%&#xa0;: les points déterminants sont plus proches l’un de l’autre que la longueur L = %2 du budget.</translation>
    </message>
    <message numerus="yes">
        <source>Readings that are no numbers (%n), hence missing: %1.</source>
        <translation>
            <numerusform>Relevés qui ne sont pas des nombres (%n), donc manquants&#xa0;: %1.</numerusform>
            <numerusform>Relevés qui ne sont pas des nombres (%n), donc manquants&#xa0;: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>resolution of the instrument</source>
        <translation>résolution de l’instrument</translation>
    </message>
    <message>
        <source>2 · %1 / √12</source>
        <translation>2 · %1 / √12</translation>
    </message>
    <message>
        <source>environmental variation, E_VE</source>
        <translation>variation de l’environnement, E_VE</translation>
    </message>
    <message>
        <source>environmental variation error E_VE</source>
        <translation>erreur de variation environnementale E_VE</translation>
    </message>
    <message>
        <source>centring of the set-up</source>
        <translation>centrage du réglage</translation>
    </message>
    <message>
        <source>standard uncertainty of the centring</source>
        <translation>incertitude type du centrage</translation>
    </message>
    <message>
        <source>2 · %1</source>
        <translation>2 · %1</translation>
    </message>
    <message>
        <source>coverage factor of the certificate</source>
        <translation>facteur conventionnel du certificat</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>%1 · 2/%2</source>
        <translation>%1 · 2/%2</translation>
    </message>
    <message>
        <source>instrument, calibration of displacement</source>
        <translation>instrument, étalonnage du déplacement</translation>
    </message>
    <message>
        <source>uncertainty of the calibration of displacement</source>
        <translation>incertitude de l’étalonnage du déplacement</translation>
    </message>
    <message>
        <source>reference length</source>
        <translation>longueur étalon</translation>
    </message>
    <message>
        <source>uncertainty of the reference length</source>
        <translation>incertitude de la longueur étalon</translation>
    </message>
    <message>
        <source>noise of the points</source>
        <translation>bruit des points</translation>
    </message>
    <message>
        <source>standard uncertainty of one point</source>
        <translation>incertitude type d’un point</translation>
    </message>
    <message>
        <source>2 · %1 / √%2</source>
        <translation>2 · %1 / √%2</translation>
    </message>
    <message>
        <source>repeatability, or repeated circles</source>
        <translation>répétabilité, ou cercles répétés</translation>
    </message>
    <message>
        <source>2 · %1, largest s of the repeated circles</source>
        <translation>2 · %1, plus grand s des cercles répétés</translation>
    </message>
    <message>
        <source>correction to 20 °C</source>
        <translation>correction à 20&#xa0;°C</translation>
    </message>
    <message>
        <source>coefficient of expansion α of the machine</source>
        <translation>coefficient de dilatation α de la machine</translation>
    </message>
    <message>
        <source>coefficient of expansion α of the instrument</source>
        <translation>coefficient de dilatation α de l’instrument</translation>
    </message>
    <message>
        <source>standard uncertainty of the temperature of the machine</source>
        <translation>incertitude type de la température de la machine</translation>
    </message>
    <message>
        <source>standard uncertainty of the temperature of the instrument</source>
        <translation>incertitude type de la température de l’instrument</translation>
    </message>
    <message>
        <source>temperature θ of the machine at start and end</source>
        <translation>température θ de la machine au début et à la fin</translation>
    </message>
    <message>
        <source>standard uncertainty of the coefficient of expansion of the machine</source>
        <translation>incertitude type du coefficient de dilatation de la machine</translation>
    </message>
    <message>
        <source>temperature θ of the instrument at start and end</source>
        <translation>température θ de l’instrument au début et à la fin</translation>
    </message>
    <message>
        <source>standard uncertainty of the coefficient of expansion of the instrument</source>
        <translation>incertitude type du coefficient de dilatation de l’instrument</translation>
    </message>
    <message>
        <source>2 · %1, from temperatures and coefficients of expansion</source>
        <translation>2 · %1, des températures et coefficients de dilatation</translation>
    </message>
    <message>
        <source>2 · %1, from temperatures (one sensor for machine and instrument) and coefficients of expansion</source>
        <translation>2 · %1, des températures (un seul capteur pour machine et instrument) et coefficients de dilatation</translation>
    </message>
    <message>
        <source>temperature of the machine</source>
        <translation>température de la machine</translation>
    </message>
    <message>
        <source>coefficient of expansion of the machine</source>
        <translation>coefficient de dilatation de la machine</translation>
    </message>
    <message>
        <source>range R(θ) of the temperature of the machine</source>
        <translation>étendue R(θ) de la température de la machine</translation>
    </message>
    <message>
        <source>range R(α) of the coefficient of expansion of the machine</source>
        <translation>étendue R(α) du coefficient de dilatation de la machine</translation>
    </message>
    <message>
        <source>temperature of the instrument</source>
        <translation>température de l’instrument</translation>
    </message>
    <message>
        <source>coefficient of expansion of the instrument</source>
        <translation>coefficient de dilatation de l’instrument</translation>
    </message>
    <message>
        <source>range R(θ) of the temperature of the instrument</source>
        <translation>étendue R(θ) de la température de l’instrument</translation>
    </message>
    <message>
        <source>range R(α) of the coefficient of expansion of the instrument</source>
        <translation>étendue R(α) du coefficient de dilatation de l’instrument</translation>
    </message>
    <message>
        <source>length L, which must be above 0</source>
        <translation>longueur L, qui doit être supérieure à 0</translation>
    </message>
    <message>
        <source>instrument, calibration certificate</source>
        <translation>instrument, certificat d’étalonnage</translation>
    </message>
    <message>
        <source>instrument, range of its error</source>
        <translation>instrument, étendue de son erreur</translation>
    </message>
    <message>
        <source>fixed part of the instrument</source>
        <translation>part fixe de l’instrument</translation>
    </message>
    <message>
        <source>part per metre of the instrument</source>
        <translation>part par mètre de l’instrument</translation>
    </message>
    <message>
        <source>part per metre of the instrument, on a rotary axis</source>
        <translation>part par mètre de l’instrument, sur un axe rotatif</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1/m · %2&#xa0;m</source>
        <translation>%1/m · %2&#xa0;m</translation>
    </message>
    <message>
        <source>%1/m · %2&#xa0;m · 2/%3</source>
        <translation>%1/m · %2&#xa0;m · 2/%3</translation>
    </message>
    <message>
        <source>%1 · %2/m · %3&#xa0;m</source>
        <translation>%1 · %2/m · %3&#xa0;m</translation>
    </message>
    <message>
        <source>%1 + %2/m · %3&#xa0;m</source>
        <translation>%1 + %2/m · %3&#xa0;m</translation>
    </message>
    <message>
        <source>(%1 + %2/m · %3&#xa0;m) · 2/%4</source>
        <translation>(%1 + %2/m · %3&#xa0;m) · 2/%4</translation>
    </message>
    <message>
        <source>%1 · (%2 + %3/m · %4&#xa0;m)</source>
        <translation>%1 · (%2 + %3/m · %4&#xa0;m)</translation>
    </message>
    <message>
        <source>misalignment</source>
        <translation>défaut d’alignement</translation>
    </message>
    <message>
        <source>range of the misalignment</source>
        <translation>étendue du défaut d’alignement</translation>
    </message>
    <message>
        <source>%1 · (%2)² / %3</source>
        <translation>%1 · (%2)² / %3</translation>
    </message>
    <message>
        <source>instrument without expansion, α = 0</source>
        <translation>instrument sans dilatation, α = 0</translation>
    </message>
    <message>
        <source>%1 · %2 · %3&#xa0;m · %4</source>
        <translation>%1 · %2 · %3&#xa0;m · %4</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>pas un nombre</translation>
    </message>
    <message>
        <source>larger than any number</source>
        <translation>plus grand que tout nombre</translation>
    </message>
    <message>
        <source>two numbers are asked for, such as −10 … 1590</source>
        <translation>deux nombres attendus, p. ex. −10 … 1590</translation>
    </message>
    <message>
        <source>the first number is not the smaller one</source>
        <translation>le premier nombre n’est pas le plus petit</translation>
    </message>
    <message>
        <source>not a date such as 2026-03-12, 12.03.2026 or 12 March 2026</source>
        <translation>pas une date telle que 12/03/2026, 12 mars 2026 ou 2026-03-12</translation>
    </message>
    <message>
        <source>not a time</source>
        <translation>pas une heure</translation>
    </message>
    <message>
        <source>comma and point in one number</source>
        <translation>virgule et point dans un nombre</translation>
    </message>
    <message>
        <source>two commas</source>
        <translation>deux virgules</translation>
    </message>
    <message>
        <source>two points</source>
        <translation>deux points décimaux</translation>
    </message>
    <message>
        <source>About the centre of the minimum zone circles: %1.</source>
        <translation>Par rapport au centre des cercles de zone minimale&#xa0;: %1.</translation>
    </message>
    <message>
        <source>About the centre of the least squares circle: %1.</source>
        <translation>Par rapport au centre du cercle des moindres carrés&#xa0;: %1.</translation>
    </message>
    <message>
        <source>About the centre the instrument was set up at: the set-up error is part of it.</source>
        <translation>Par rapport au centre de réglage de l’instrument&#xa0;: l’erreur de réglage en fait partie.</translation>
    </message>
    <message>
        <source>Both paths about one centre, each with equal weight.</source>
        <translation>Les deux trajectoires autour d’un seul centre, chacune de même poids.</translation>
    </message>
    <message>
        <source>The points of both paths about one centre.</source>
        <translation>Les points des deux trajectoires autour d’un seul centre.</translation>
    </message>
    <message>
        <source>Proven: no narrower pair of circles holds all points.</source>
        <translation>Prouvé&#xa0;: aucune paire de cercles plus étroite ne contient tous les points.</translation>
    </message>
    <message>
        <source>Not proven: a narrower pair of circles may hold all points.</source>
        <translation>Non prouvé&#xa0;: une paire de cercles plus étroite pourrait contenir tous les points.</translation>
    </message>
    <message>
        <source>Farthest from the centre at %1.</source>
        <translation>Au plus loin du centre à %1.</translation>
    </message>
    <message>
        <source>Nearest to the centre at %1.</source>
        <translation>Au plus près du centre à %1.</translation>
    </message>
    <message>
        <source>%1 per sense</source>
        <translation>%1 par sens</translation>
    </message>
    <message>
        <source>anticlockwise</source>
        <comment>short</comment>
        <translation>antihoraire</translation>
    </message>
    <message>
        <source>clockwise</source>
        <comment>short</comment>
        <translation>horaire</translation>
    </message>
    <message>
        <source>minimum zone</source>
        <translation>zone minimale</translation>
    </message>
    <message>
        <source>least squares</source>
        <translation>moindres carrés</translation>
    </message>
    <message>
        <source>Nominal diameter</source>
        <translation>Diamètre nominal</translation>
    </message>
    <message>
        <source>Feed</source>
        <comment>contouring</comment>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Contouring</source>
        <translation>Contournage</translation>
    </message>
    <message>
        <source>Axes moved</source>
        <translation>Axes déplacés</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <comment>axes</comment>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centre</translation>
    </message>
    <message>
        <source>Tool offset</source>
        <translation>Décalage, outil</translation>
    </message>
    <message>
        <source>Workpiece offset</source>
        <translation>Décalage, pièce</translation>
    </message>
    <message>
        <source>Correction C</source>
        <translation>Correction C</translation>
    </message>
    <message>
        <source>Captured range</source>
        <translation>Étendue de capture</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Start, stop</source>
        <translation>Départ, arrêt</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>Compensation</source>
        <translation>Compensation</translation>
    </message>
    <message>
        <source>Circle, G, G(b)</source>
        <translation>Cercle, G, G(b)</translation>
    </message>
    <message>
        <source>Circle, G, H</source>
        <translation>Cercle, G, H</translation>
    </message>
    <message>
        <source>both paths</source>
        <translation>les deux trajectoires</translation>
    </message>
    <message>
        <source>Centre, F</source>
        <translation>Centre, F</translation>
    </message>
    <message>
        <source>set-up of the instrument</source>
        <translation>réglage de l’instrument</translation>
    </message>
    <message>
        <source>Set-up removed</source>
        <translation>Erreur de centrage retirée</translation>
    </message>
    <message>
        <source>full circle</source>
        <translation>cercle complet</translation>
    </message>
    <message>
        <source>arc of %1</source>
        <translation>arc de %1</translation>
    </message>
    <message>
        <source>proven narrowest</source>
        <translation>minimum global</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cercle</translation>
    </message>
    <message>
        <source>clause %1</source>
        <translation>article %1</translation>
    </message>
    <message>
        <source>Test parameters</source>
        <translation>Paramètres de l’essai</translation>
    </message>
    <message>
        <source>Positions in mm, α in µm/(m·°C).</source>
        <translation>Positions en mm, α en µm/(m·°C).</translation>
    </message>
    <message>
        <source>Positions in mm.</source>
        <translation>Positions en mm.</translation>
    </message>
    <message>
        <source>Figure drawn %1.</source>
        <translation>Figure tracée %1.</translation>
    </message>
    <message>
        <source>Sense</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesurée</translation>
    </message>
    <message>
        <source>Evaluated</source>
        <translation>Évaluée</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Measured paths</source>
        <translation>Trajectoires mesurées</translation>
    </message>
    <message>
        <source>points and time of the evaluated range</source>
        <translation>points et durée de l’étendue évaluée</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>centres relative to the programmed one</source>
        <translation>centres par rapport au centre programmé</translation>
    </message>
    <message>
        <source>without correction to 20 °C</source>
        <translation>sans correction à 20&#xa0;°C</translation>
    </message>
    <message>
        <source>Reference circles</source>
        <translation>Cercles de référence</translation>
    </message>
    <message>
        <source>Centring error taken out of the commanded angles: %1.</source>
        <translation>Erreur de centrage retirée des angles programmés&#xa0;: %1.</translation>
    </message>
    <message>
        <source>evaluated</source>
        <translation>évaluée</translation>
    </message>
    <message>
        <source>Repetitions</source>
        <translation>Répétitions</translation>
    </message>
    <message>
        <source>all paths in the order of measurement; further paths of a sense have no part in the results</source>
        <translation>toutes les trajectoires dans l’ordre de mesure&#x202f;; les suivantes d’un même sens n’entrent pas dans les résultats</translation>
    </message>
    <message>
        <source>No parameter of %1.</source>
        <translation>Pas un paramètre de %1.</translation>
    </message>
    <message>
        <source>The same arithmetic.</source>
        <translation>Calcul identique.</translation>
    </message>
    <message>
        <source>The same readings under each edition; verdicts hold for the edition of the test alone.</source>
        <translation>Les mêmes relevés selon chaque édition&#x202f;; les verdicts ne valent que pour l’édition de l’essai.</translation>
    </message>
    <message>
        <source>All tests as under %1.</source>
        <translation>Tous les essais selon %1.</translation>
    </message>
    <message>
        <source>Of another kind, and left out: %1.</source>
        <translation>D’un autre genre, et laissés de côté&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Mean deviation</source>
        <translation>Écart moyen</translation>
    </message>
    <message>
        <source>commanded: of the programmed path; the centring error is taken out</source>
        <translation>programmés&#xa0;: de la trajectoire programmée&#x202f;; l’erreur de centrage est retirée</translation>
    </message>
    <message>
        <source>polar: of the measured points</source>
        <translation>polaires&#xa0;: des points mesurés</translation>
    </message>
    <message>
        <source>Between the runs</source>
        <translation>Entre les passes</translation>
    </message>
    <message>
        <source>instrument re-centred</source>
        <translation>instrument recentré</translation>
    </message>
    <message>
        <source>measured consecutively, without re-centring</source>
        <translation>mesures successives, sans recentrage</translation>
    </message>
    <message>
        <source>F and D at 20 °C: correction %1.</source>
        <translation>F et D à 20&#xa0;°C&#xa0;: correction %1.</translation>
    </message>
    <message>
        <source>Made here for F and D; temperatures are means of those stated.</source>
        <translation>Faite ici pour F et D&#x202f;; moyennes des températures indiquées.</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>longueur non étalonnée</translation>
    </message>
    <message>
        <source>calibrated</source>
        <comment>length</comment>
        <translation>longueur étalonnée</translation>
    </message>
    <message>
        <source>U = %1 (k = %2)</source>
        <translation>U = %1 (k = %2)</translation>
    </message>
    <message>
        <source>Reference length</source>
        <translation>Étalon</translation>
    </message>
    <message>
        <source>Plane, axes</source>
        <translation>Plan, axes</translation>
    </message>
    <message>
        <source>Measured with</source>
        <translation>Mesuré par</translation>
    </message>
    <message>
        <source>feedback signal of the axes</source>
        <translation>signal de retour des axes</translation>
    </message>
    <message>
        <source>Date of the test</source>
        <translation>Date de l’essai</translation>
    </message>
    <message>
        <source>The day the readings were taken: 12.03.2026, 2026-03-12 or in words. The day stands first.</source>
        <translation>Le jour où les relevés ont été pris&#xa0;: 12.03.2026, 2026-03-12 ou en toutes lettres. Le jour vient en premier.</translation>
    </message>
    <message>
        <source>What the report calls the machine, or the letter of the axis under test.</source>
        <translation>Le nom de la machine dans le rapport, ou la lettre de l’axe soumis à l’essai.</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>Constructeur</translation>
    </message>
    <message>
        <source>The maker of the machine, as on its plate.</source>
        <translation>Le constructeur de la machine, selon sa plaque.</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>The type of the machine, as on its plate.</source>
        <translation>Le type de la machine, selon sa plaque.</translation>
    </message>
    <message>
        <source>Tells this machine or this instrument from all others of its type.</source>
        <translation>Distingue cette machine ou cet instrument de tous les autres du même type.</translation>
    </message>
    <message>
        <source>Numerical control</source>
        <translation>Commande numérique</translation>
    </message>
    <message>
        <source>Maker and type of the numerical control, with its version where compensation depends on it.</source>
        <translation>Constructeur et type de la commande numérique, avec sa version si la compensation en dépend.</translation>
    </message>
    <message>
        <source>The measuring instrument. Each test names those it was measured with; the first one is taken for all tests.</source>
        <translation>L’instrument de mesure. Chaque essai nomme ceux avec lesquels il a été mesuré&#x202f;; le premier est pris pour tous les essais.</translation>
    </message>
    <message>
        <source>Calibration certificate</source>
        <translation>Certificat d’étalonnage</translation>
    </message>
    <message>
        <source>Number of the certificate that makes the readings traceable.</source>
        <translation>Numéro du certificat qui rend les relevés traçables.</translation>
    </message>
    <message>
        <source>Calibrated on</source>
        <translation>Étalonné le</translation>
    </message>
    <message>
        <source>The day of the calibration, not of its end of validity.</source>
        <translation>Le jour de l’étalonnage, non celui de sa fin de validité.</translation>
    </message>
    <message>
        <source>Axis travel</source>
        <translation>Longueur d’axe</translation>
    </message>
    <message>
        <source>The whole travel of the axis, not that between the first and the last target: the number of targets and the kind of test follow from it.</source>
        <translation>La longueur entière de l’axe, non la course entre le premier et le dernier point visé&#xa0;: le nombre de points et le genre d’essai en découlent.</translation>
    </message>
    <message>
        <source>Ends of the axis</source>
        <translation>Extrémités de l’axe</translation>
    </message>
    <message>
        <source>Both ends of the travel in coordinates of the axis, as “0 … 1800”: shows whether the first and the last target can be approached from both sides.</source>
        <translation>Les deux extrémités en coordonnées de l’axe, comme «&#xa0;0 … 1800&#xa0;»&#xa0;: montre si le premier et le dernier point visé peuvent être approchés des deux côtés.</translation>
    </message>
    <message>
        <source>Agreed working zone</source>
        <translation>Zone de travail normal convenue</translation>
    </message>
    <message>
        <source>The 2 000 mm (360°) of a long axis that were agreed for the full test. A test whose targets lie inside is judged as that of a short axis.</source>
        <translation>Les 2 000&#xa0;mm (360°) d’un axe long convenus pour le contrôle complet. Un essai dont les points s’y trouvent est jugé comme celui d’un axe court.</translation>
    </message>
    <message>
        <source>Measuring system of the axis</source>
        <translation>Système de mesure de l’axe</translation>
    </message>
    <message>
        <source>How the axis knows its position: linear scale, rotary encoder at the screw, …</source>
        <translation>Comment l’axe connaît sa position&#xa0;: règle linéaire, codeur rotatif sur la vis, …</translation>
    </message>
    <message>
        <source>Freely chosen targets have a random part, so that periodic errors do not stay hidden; the plan proposes them.</source>
        <translation>Les points choisis librement ont une part aléatoire, pour que les écarts périodiques ne restent pas cachés&#x202f;; le plan les propose.</translation>
    </message>
    <message>
        <source>Test cycle</source>
        <translation>Cycle d’essai</translation>
    </message>
    <message>
        <source>Standard: all targets up, all down, again. Step: all approaches at one target, then the next; only by written agreement. Not stated: the report says so.</source>
        <translation>Normal&#xa0;: tous les points en montant, tous en descendant, et ainsi de suite. En pas&#xa0;: toutes les approches d’un point, puis le suivant&#x202f;; seulement par accord écrit. Non indiqué&#xa0;: le rapport le dit.</translation>
    </message>
    <message>
        <source>Feed rate</source>
        <translation>Vitesse d’avance</translation>
    </message>
    <message>
        <source>The feed between the targets, as programmed; or rapid.</source>
        <translation>L’avance entre les points, telle que programmée&#x202f;; ou rapide.</translation>
    </message>
    <message>
        <source>Dwell at target</source>
        <translation>Arrêt au point visé</translation>
    </message>
    <message>
        <source>How long the axis rests before the reading is taken.</source>
        <translation>Combien de temps l’axe s’arrête avant que le relevé soit pris.</translation>
    </message>
    <message>
        <source>How far the axis goes beyond a target before it comes back to it: beyond the first and the last one it needs that room.</source>
        <translation>De combien l’axe dépasse un point visé avant d’y revenir&#xa0;: au-delà du premier et du dernier, il lui faut cette place.</translation>
    </message>
    <message>
        <source>Temperatures</source>
        <translation>Températures</translation>
    </message>
    <message>
        <source>Start and end of the test for each sensor, and where it was. The mean of machine and instrument is what the correction to 20 °C uses.</source>
        <translation>Début et fin de l’essai pour chaque capteur, et son emplacement. La moyenne de la machine et celle de l’instrument servent à la correction à 20&#xa0;°C.</translation>
    </message>
    <message>
        <source>Expansion coefficient α</source>
        <translation>Coefficient de dilatation α</translation>
    </message>
    <message>
        <source>Of the measuring system of the machine and of the instrument, in µm/(m·°C): steel about 11.5, glass scales about 8. Needed to correct to 20 °C. An instrument that compensates the air only: 0.</source>
        <translation>Du système de mesure de la machine et de l’instrument, en µm/(m·°C)&#xa0;: acier environ 11,5, règles en verre environ 8. Nécessaire pour corriger à 20&#xa0;°C. Un instrument qui ne compense que l’air&#xa0;: 0.</translation>
    </message>
    <message>
        <source>By the instrument: its material compensation was on, nothing is added. Applied here: Palmer adds the nominal differential expansion. Never both: that costs 35 µm/m at 3 °C.</source>
        <translation>Par l’instrument&#xa0;: sa compensation de matériau était active, rien n’est ajouté. Appliquée ici&#xa0;: Palmer ajoute la dilatation différentielle nominale. Jamais les deux&#xa0;: cela coûte 35&#xa0;µm/m pour 3&#xa0;°C.</translation>
    </message>
    <message>
        <source>At the place of the test and not reduced to sea level: the wavelength of a laser depends on it.</source>
        <translation>Au lieu de l’essai et non ramenée au niveau de la mer&#xa0;: la longueur d’onde d’un laser en dépend.</translation>
    </message>
    <message>
        <source>Relative humidity at the machine.</source>
        <translation>Humidité relative près de la machine.</translation>
    </message>
    <message>
        <source>Largest change of the air temperature in one hour, in the 12 hours before the test and during it.</source>
        <translation>Plus grande variation de la température de l’air en une heure, dans les 12 heures avant l’essai et pendant celui-ci.</translation>
    </message>
    <message>
        <source>Agreed, the maker&apos;s, a dry run, or the movements needed to set up the instrument alone.</source>
        <translation>Convenue, celle du constructeur, un essai à blanc préalable, ou les seuls mouvements de mise en place de l’instrument.</translation>
    </message>
    <message>
        <source>Which compensation of the control was on: pitch error, reversal, temperature; or none.</source>
        <translation>Quelle compensation de la commande était active&#xa0;: pas de vis, réversibilité, température&#x202f;; ou aucune.</translation>
    </message>
    <message>
        <source>Axes not under test</source>
        <translation>Axes non concernés</translation>
    </message>
    <message>
        <source>Where the other axes stood: squareness and pitch of the axis move the readings with them.</source>
        <translation>Où se trouvaient les autres axes&#xa0;: la perpendicularité et le tangage de l’axe déplacent les relevés avec eux.</translation>
    </message>
    <message>
        <source>Offset to the tool reference</source>
        <translation>Décalage par rapport à la référence de l’outil</translation>
    </message>
    <message>
        <source>X, Y, Z from the tool reference to the measuring line. 0 is a statement, empty is none.</source>
        <translation>X, Y, Z de la référence de l’outil à la ligne de mesure. 0 est une indication, vide n’en est pas une.</translation>
    </message>
    <message>
        <source>Offset to the workpiece reference</source>
        <translation>Décalage par rapport à la référence de la pièce</translation>
    </message>
    <message>
        <source>X, Y, Z from the workpiece reference to the measuring line. 0 is a statement, empty is none.</source>
        <translation>X, Y, Z de la référence de la pièce à la ligne de mesure. 0 est une indication, vide n’en est pas une.</translation>
    </message>
    <message>
        <source>The machine was completely assembled and in working order; guards may be absent.</source>
        <translation>La machine était complètement assemblée et en ordre de marche&#x202f;; les protecteurs peuvent manquer.</translation>
    </message>
    <message>
        <source>Levelled and aligned</source>
        <translation>Mise à niveau et alignée</translation>
    </message>
    <message>
        <source>Levelling and geometric alignment were done before the test.</source>
        <translation>La mise à niveau et l’alignement géométrique ont été faits avant l’essai.</translation>
    </message>
    <message>
        <source>The test was made without workpiece.</source>
        <translation>L’essai a été fait sans pièce.</translation>
    </message>
    <message>
        <source>The two axes that were moved. Sense and angle run from the first towards the second.</source>
        <translation>Les deux axes déplacés. Le sens et l’angle vont du premier vers le second.</translation>
    </message>
    <message>
        <source>Required results</source>
        <translation>Résultats demandés</translation>
    </message>
    <message>
        <source>The results that supplier and user ask for: G, G(b), F, D. Bi-directional ones need a path of each sense.</source>
        <translation>Les résultats demandés par le fournisseur et l’utilisateur&#xa0;: G, G(b), F, D. Les résultats bidirectionnels exigent une trajectoire dans chaque sens.</translation>
    </message>
    <message>
        <source>Centre of the circle</source>
        <translation>Centre du cercle</translation>
    </message>
    <message>
        <source>X, Y, Z of the centre in coordinates of the machine.</source>
        <translation>X, Y, Z du centre en coordonnées de la machine.</translation>
    </message>
    <message>
        <source>Start point</source>
        <translation>Point de départ</translation>
    </message>
    <message>
        <source>Where the path began, as an angle or an axis.</source>
        <translation>Où la trajectoire a commencé, par un angle ou un axe.</translation>
    </message>
    <message>
        <source>Stop point</source>
        <translation>Point d’arrivée</translation>
    </message>
    <message>
        <source>Where the path ended.</source>
        <translation>Où la trajectoire s’est terminée.</translation>
    </message>
    <message>
        <source>Data smoothing</source>
        <translation>Lissage des données</translation>
    </message>
    <message>
        <source>Filters of the instrument or its program that the data went through; or none.</source>
        <translation>Filtres de l’instrument ou de son logiciel appliqués aux données&#x202f;; ou aucun.</translation>
    </message>
    <message>
        <source>Re-centred between the runs</source>
        <translation>Recentré entre les passes</translation>
    </message>
    <message>
        <source>Bi-directional results need both paths measured one after the other without re-centring.</source>
        <translation>Les résultats bidirectionnels demandent les deux trajectoires mesurées l’une après l’autre sans recentrage.</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>What was agreed, with the edition it was agreed for and where it stands. Under another edition there is no verdict.</source>
        <translation>Ce qui a été convenu, avec l’édition concernée et l’endroit où c’est écrit. Selon une autre édition, il n’y a pas de verdict.</translation>
    </message>
    <message>
        <source>Decision rule</source>
        <translation>Règle de décision</translation>
    </message>
    <message>
        <source>How a value near its limit is judged, whose risk the uncertainty is: ISO 14253-1 asks the maker to prove conformity, the other rule asks the user to prove the contrary.</source>
        <translation>Comment une valeur proche de sa limite est jugée, à qui revient le risque de l’incertitude&#xa0;: l’ISO 14253-1 demande au constructeur de prouver la conformité, l’autre règle demande à l’utilisateur de prouver le contraire.</translation>
    </message>
    <message>
        <source>Guard band</source>
        <translation>Bande de garde</translation>
    </message>
    <message>
        <source>How many times the expanded uncertainty U the value has to stay away from the limit; 1 as a rule.</source>
        <translation>À combien de fois l’incertitude étendue U la valeur doit rester de la limite&#x202f;; 1 en règle générale.</translation>
    </message>
    <message>
        <source>What the edition leaves to supplier and user. “Not agreed” is printed as it is, “not applicable” asks for nothing.</source>
        <translation>Ce que l’édition laisse au fournisseur et à l’utilisateur. «&#xa0;Non convenu&#xa0;» est imprimé tel quel, «&#xa0;sans objet&#xa0;» ne demande rien.</translation>
    </message>
    <message>
        <source>r from the centre of the minimum zone circles of one path, or of its least squares circle where that was chosen; the report says which</source>
        <translation>r depuis le centre des cercles de zone minimale d’une trajectoire, ou de son cercle des moindres carrés s’il a été choisi&#x202f;; le rapport dit lequel</translation>
    </message>
    <message>
        <source>the same for the points of both paths about one common centre; not the larger of two G</source>
        <translation>de même pour les points des deux trajectoires autour d’un centre commun&#x202f;; non le plus grand des deux G</translation>
    </message>
    <message>
        <source>r from the chosen centre: least squares circle (full circles) or set-up; C corrects to 20 °C</source>
        <translation>r depuis le centre choisi&#xa0;: cercle des moindres carrés (cercles complets) ou réglage&#x202f;; C corrige à 20&#xa0;°C</translation>
    </message>
    <message>
        <source>likewise</source>
        <translation>de même</translation>
    </message>
    <message>
        <source>R_LSC of the least squares circle of both full paths, each of equal weight</source>
        <translation>R_LSC du cercle des moindres carrés des deux trajectoires complètes, à poids égal</translation>
    </message>
    <message>
        <source>over all angles about the common centre</source>
        <translation>sur tous les angles autour du centre commun</translation>
    </message>
    <message>
        <source>of the feedback signal of the axes</source>
        <translation>du signal de retour des axes</translation>
    </message>
    <message>
        <source>of the feedback signal of the axes, both paths</source>
        <translation>du signal de retour des axes, les deux trajectoires</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Formule</translation>
    </message>
    <message>
        <source>Clause</source>
        <translation>Article</translation>
    </message>
    <message>
        <source>Parameters of the axis</source>
        <translation>Paramètres de l’axe</translation>
    </message>
    <message>
        <source>Quantities at a target</source>
        <translation>Grandeurs en un point visé</translation>
    </message>
    <message>
        <source>x_ij is actual position minus target position; %1 counts targets, %2 runs; ↑ and ↓ are approaches in the positive and the negative direction. A clause that is not known is not printed.</source>
        <translation>x_ij est la position réelle moins le point visé&#x202f;; %1 compte les points, %2 les passes&#x202f;; ↑ et ↓ sont les approches dans le sens positif et négatif. Un article inconnu n’est pas imprimé.</translation>
    </message>
    <message>
        <source>The indices name the axes in the order in which the path crosses their positive ends: counterclockwise XY, clockwise YX. Figure 6 of the standard contradicts its clause 3.8; Palmer follows the clause.</source>
        <translation>Les indices nomment les axes dans l’ordre où la trajectoire croise leurs extrémités positives&#xa0;: antihoraire XY, horaire YX. La figure 6 de la norme contredit son paragraphe 3.8&#x202f;; Palmer suit le paragraphe.</translation>
    </message>
    <message>
        <source>Workflow</source>
        <translation>Déroulement</translation>
    </message>
    <message>
        <source>Start</source>
        <comment>the first step of the work</comment>
        <translation>Commencer</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planifier</translation>
    </message>
    <message>
        <source>“Plan…” proposes targets from travel, period and seed, prints them with an empty table and writes the part program.</source>
        <translation>«&#xa0;Plan…&#xa0;» propose des points d’après la course, la période et le germe, les imprime avec un tableau vide et écrit le programme pièce.</translation>
    </message>
    <message>
        <source>Enter or import</source>
        <translation>Saisir ou importer</translation>
    </message>
    <message>
        <source>Type, paste from a spreadsheet with comma or point, or import. Enter walks the measuring cycle as the machine does.</source>
        <translation>Saisir, coller depuis un tableur avec virgule ou point, ou importer. Entrée suit le cycle de mesure comme la machine.</translation>
    </message>
    <message>
        <source>See at once</source>
        <translation>Voir aussitôt</translation>
    </message>
    <message>
        <source>Figure, results and findings follow every key. A click on a result explains it with the numbers put in and the clause.</source>
        <translation>La figure, les résultats et les constats suivent chaque touche. Un clic sur un résultat l’explique avec les nombres et le paragraphe.</translation>
    </message>
    <message>
        <source>Describe</source>
        <translation>Décrire</translation>
    </message>
    <message>
        <source>Machine, instruments, conditions, agreed points. What the edition requires is marked and counted; F8 walks what is missing. Nothing of it blocks the printing. Templates keep what is always the same.</source>
        <translation>Machine, instruments, conditions, points convenus. Ce que l’édition exige est marqué et compté&#x202f;; F8 parcourt ce qui manque. Rien n’empêche d’imprimer. Les modèles gardent ce qui est toujours pareil.</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>“Compare…” sets editions side by side with the reason of each difference, and tests over one another: as found and as left.</source>
        <translation>«&#xa0;Comparer…&#xa0;» met les éditions côte à côte avec la raison de chaque différence, et superpose des essais&#xa0;: avant et après réglage.</translation>
    </message>
    <message>
        <source>Decide</source>
        <translation>Décider</translation>
    </message>
    <message>
        <source>Limits with their edition, the uncertainty, the decision rule: then there is a verdict. It is based on unrounded numbers.</source>
        <translation>Les limites avec leur édition, l’incertitude, la règle de décision&#xa0;: alors il y a un verdict. Il est établi sur les nombres non arrondis.</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Imprimer</translation>
    </message>
    <message>
        <source>“Report…” shows the pages as they are printed, in French, in English or both.</source>
        <translation>«&#xa0;Rapport…&#xa0;» montre les pages telles qu’elles s’impriment, en français, en anglais ou les deux.</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Champs</translation>
    </message>
    <message>
        <source>An empty field means “not stated”; 0 is a statement. Numbers are read with a point or a comma. What cannot be read stays in red, and the value before it is kept.</source>
        <translation>Un champ vide signifie «&#xa0;non indiqué&#xa0;»&#x202f;; 0 est une indication. Les nombres se lisent avec point ou virgule. Ce qui ne peut pas être lu reste en rouge, et la valeur précédente est gardée.</translation>
    </message>
    <message>
        <source>Nominal interval</source>
        <translation>Intervalle nominal</translation>
    </message>
    <message>
        <source>Random part</source>
        <translation>Part aléatoire</translation>
    </message>
    <message>
        <source>P = (N + r)·p, p = %1</source>
        <translation>P = (N + r)·p, p = %1</translation>
    </message>
    <message>
        <source>± %1, new for every target</source>
        <translation>± %1, nouvelle pour chaque point</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Germe</translation>
    </message>
    <message>
        <source>Runs each way</source>
        <translation>Passes par sens</translation>
    </message>
    <message>
        <source>Dwell at each target</source>
        <translation>Temps d’arrêt à chaque point</translation>
    </message>
    <message>
        <source>Plan of measurement, axis %1</source>
        <translation>Plan de mesure, axe %1</translation>
    </message>
    <message>
        <source>The axis moves from %1 to %2.</source>
        <translation>L’axe se déplace de %1 à %2.</translation>
    </message>
    <message>
        <source>Readings, in the order they are taken</source>
        <translation>Relevés, dans l’ordre où ils sont pris</translation>
    </message>
    <message>
        <source>at 20 °C</source>
        <translation>à 20&#xa0;°C</translation>
    </message>
    <message>
        <source>Results in the %1 plane</source>
        <translation>Résultats dans le plan %1</translation>
    </message>
    <message>
        <source>bi-directional</source>
        <comment>circular deviation</comment>
        <translation>bidirectionnel</translation>
    </message>
    <message>
        <source>mean radial</source>
        <comment>deviation</comment>
        <translation>radial moyen</translation>
    </message>
    <message>
        <source>bi-directional, feed back</source>
        <translation>bidirectionnel, signal de retour</translation>
    </message>
    <message>
        <source>bi-directional</source>
        <comment>circular error</comment>
        <translation>bidirectionnelle</translation>
    </message>
    <message>
        <source>mean radial</source>
        <comment>error</comment>
        <translation>radiale moyenne</translation>
    </message>
    <message>
        <source>Contributors as public drafts of annex A name them; combined by propagation after the GUM.</source>
        <translation>Composantes telles que les nomment des projets publics de l’annexe A&#x202f;; composées par propagation selon le GUM.</translation>
    </message>
    <message>
        <source>Contributors of ISO 230-4:2005, 4.6; combined by propagation after the GUM.</source>
        <translation>Composantes de l’ISO 230-4:2005, 4.6&#x202f;; composées par propagation selon le GUM.</translation>
    </message>
    <message>
        <source>Component</source>
        <comment>of a budget</comment>
        <translation>Composante</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Données</translation>
    </message>
    <message>
        <source>Share</source>
        <comment>of a budget</comment>
        <translation>Part</translation>
    </message>
    <message>
        <source>0 to %1</source>
        <translation>de 0 à %1</translation>
    </message>
    <message>
        <source>Budget (GUM)</source>
        <translation>Budget (GUM)</translation>
    </message>
    <message>
        <source>Monte Carlo (GUM-S1)</source>
        <translation>Monte-Carlo (GUM-S1)</translation>
    </message>
    <message>
        <source>Shift of the mean</source>
        <translation>Décalage de la moyenne</translation>
    </message>
    <message>
        <source>The methods differ by more than 20 % for %1.</source>
        <translation>Les méthodes diffèrent de plus de 20&#xa0;% pour %1.</translation>
    </message>
    <message>
        <source>The methods differ by more than 20 % for %1; reason: see the findings.</source>
        <translation>Les méthodes diffèrent de plus de 20&#xa0;% pour %1&#x202f;; raison&#xa0;: voir les constats.</translation>
    </message>
    <message>
        <source>The U of the Monte Carlo simulation is used for the verdict.</source>
        <translation>Le verdict est fondé sur l’U de la simulation de Monte-Carlo.</translation>
    </message>
    <message>
        <source>The U of the Monte Carlo simulation is used for the verdict; for %1, which it shifts by more than a third of its U, that of the budget.</source>
        <translation>Le verdict est fondé sur l’U de la simulation de Monte-Carlo&#x202f;; pour %1, qu’elle décale de plus d’un tiers de son U, sur celle du budget.</translation>
    </message>
    <message>
        <source>The budget U is used for the verdict.</source>
        <translation>Le verdict est fondé sur l’U du budget.</translation>
    </message>
    <message>
        <source>Improve first: %1 (%2 % of the budget).</source>
        <translation>À améliorer d’abord&#xa0;: %1 (%2&#xa0;% du budget).</translation>
    </message>
    <message>
        <source>Uncertainty budget</source>
        <translation>Budget d’incertitude</translation>
    </message>
    <message>
        <source>Annex %1</source>
        <translation>Annexe %1</translation>
    </message>
    <message>
        <source>palmer-cli evaluates machine-tool tests: positioning of axes (ISO 230-2), circular tests (ISO 230-4).</source>
        <translation>palmer-cli évalue des essais de machines-outils&#xa0;: positionnement d’axes (ISO 230-2), essais de circularité (ISO 230-4).</translation>
    </message>
    <message>
        <source>the file to write</source>
        <translation>le fichier à écrire</translation>
    </message>
    <message>
        <source>of CSV; without it the point</source>
        <translation>du CSV&#x202f;; sans elle, le point</translation>
    </message>
    <message>
        <source>first position of the compensation; without it the first target</source>
        <translation>première position de la compensation&#x202f;; sans elle, le premier point visé</translation>
    </message>
    <message>
        <source>last position of the compensation; without it the last target</source>
        <translation>dernière position de la compensation&#x202f;; sans elle, le dernier point visé</translation>
    </message>
    <message>
        <source>interval of the compensation; without it the targets</source>
        <translation>pas de la compensation&#x202f;; sans lui, les points visés</translation>
    </message>
    <message>
        <source>compensation of each direction; without it of their mean</source>
        <translation>compensation de chaque sens&#x202f;; sans elle, de leur moyenne</translation>
    </message>
    <message>
        <source>compensation-csv: each value is the step from the one before</source>
        <translation>compensation-csv&#xa0;: chaque valeur est l’incrément par rapport à la précédente</translation>
    </message>
    <message>
        <source>siemens: index of the measuring system; without it 0, the first</source>
        <translation>siemens&#xa0;: indice du système de mesure&#x202f;; sans lui 0, le premier</translation>
    </message>
    <message>
        <source>predicted with the compensation applied:</source>
        <translation>prévu après application de la compensation&#xa0;:</translation>
    </message>
    <message>
        <source>diameter the feed was specified for</source>
        <translation>diamètre pour lequel l’avance est spécifiée</translation>
    </message>
    <message>
        <source>contouring feed specified for it</source>
        <translation>vitesse d’avance de contournage spécifiée pour ce diamètre</translation>
    </message>
    <message>
        <source>diameter of the test</source>
        <translation>diamètre de l’essai</translation>
    </message>
    <message>
        <source>the command %1 needs the option --%2 %3</source>
        <translation>la commande %1 demande l’option --%2 %3</translation>
    </message>
    <message>
        <source>there is no feed for numbers this large or small</source>
        <translation>il n’y a pas d’avance pour des nombres aussi grands ou petits</translation>
    </message>
    <message>
        <source>contouring feed for a circle of another diameter (ISO 230-4, annex C)</source>
        <translation>vitesse d’avance de contournage pour un cercle d’un autre diamètre (ISO 230-4, annexe C)</translation>
    </message>
    <message>
        <source>the test file to write</source>
        <translation>le fichier d’essai à écrire</translation>
    </message>
    <message>
        <source>the choices kept under this name</source>
        <translation>les choix conservés sous ce nom</translation>
    </message>
    <message>
        <source>keep the bytes of the files in the test file</source>
        <translation>garder les fichiers d’origine dans le fichier d’essai</translation>
    </message>
    <message>
        <source>unknown profile %1; known: %2</source>
        <translation>profil inconnu&#xa0;: %1&#x202f;; connus&#xa0;: %2</translation>
    </message>
    <message>
        <source>“%1” is no choice; expected key=value</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un choix&#x202f;; clé=valeur est attendu</translation>
    </message>
    <message>
        <source>files of instruments and tables into a test file; remarks on stderr</source>
        <translation>fichiers d’instruments et tableaux vers un fichier d’essai&#x202f;; remarques sur stderr</translation>
    </message>
    <message>
        <source>--%1 takes a whole number from %2 on, not %3</source>
        <translation>--%1 demande un nombre entier à partir de %2, pas %3</translation>
    </message>
    <message>
        <source>Monte Carlo: %1 of %2 trials</source>
        <translation>Monte-Carlo&#xa0;: %1 tirages sur %2</translation>
    </message>
    <message>
        <source>Monte Carlo: %1 trials</source>
        <translation>Monte-Carlo&#xa0;: %1 tirages</translation>
    </message>
    <message>
        <source>how the uncertainty is found that decides, whatever the file says</source>
        <translation>méthode qui donne l’incertitude, quoi que dise le fichier</translation>
    </message>
    <message>
        <source>seed of the Monte Carlo simulation</source>
        <translation>germe de la simulation de Monte-Carlo</translation>
    </message>
    <message>
        <source>trials of the simulation; without it until two places are stable</source>
        <translation>tirages de la simulation&#x202f;; sans cette option, jusqu’à deux chiffres stables</translation>
    </message>
    <message>
        <source>threads of the simulation; the figures are the same</source>
        <translation>fils d’exécution de la simulation&#x202f;; les chiffres restent les mêmes</translation>
    </message>
    <message>
        <source>a rotary axis</source>
        <translation>un axe rotatif</translation>
    </message>
    <message>
        <source>targets per metre</source>
        <translation>points visés par mètre</translation>
    </message>
    <message>
        <source>period of the cyclic errors (pitch), where it is known</source>
        <translation>période des écarts cycliques (pas), si elle est connue</translation>
    </message>
    <message>
        <source>decimals of the positions</source>
        <translation>décimales des positions</translation>
    </message>
    <message>
        <source>start of the random numbers: the same gives the same targets</source>
        <translation>début des nombres aléatoires&#xa0;: le même donne les mêmes points</translation>
    </message>
    <message>
        <source>whose rule chooses the targets; without it ISO 230-2:2014</source>
        <translation>dont la règle choisit les points&#x202f;; sans elle ISO 230-2:2014</translation>
    </message>
    <message>
        <source>the measuring cycle</source>
        <translation>le cycle de mesure</translation>
    </message>
    <message>
        <source>runs each way; without it as the standard asks</source>
        <translation>passes par sens&#x202f;; sans elle, selon la norme</translation>
    </message>
    <message>
        <source>feed rate, mm/min or °/min; without it rapid feed</source>
        <translation>vitesse d’avance, mm/min ou °/min&#x202f;; sans elle, vitesse rapide</translation>
    </message>
    <message>
        <source>rest at each target, s; without it 5</source>
        <translation>arrêt à chaque point, s&#x202f;; sans elle 5</translation>
    </message>
    <message>
        <source>distance beyond the ends, mm or degrees; without it 1</source>
        <translation>distance au-delà des extrémités, mm ou degrés&#x202f;; sans elle 1</translation>
    </message>
    <message>
        <source>the file to write: the plan as text, as .pdf or as .palmer to fill in; or the part program</source>
        <translation>le fichier à écrire&#xa0;: le plan en texte, en .pdf ou en .palmer à remplir&#x202f;; ou le programme pièce</translation>
    </message>
    <message>
        <source>the command %1 needs --%2</source>
        <translation>la commande %1 a besoin de --%2</translation>
    </message>
    <message>
        <source>these numbers give no plan: too many targets, or too few decimals to tell them apart</source>
        <translation>ces nombres ne donnent aucun plan&#xa0;: trop de points, ou trop peu de décimales pour les distinguer</translation>
    </message>
    <message>
        <source>s from the range in %1, from the squares in %2.</source>
        <translation>s tiré de l’étendue dans %1, des carrés dans %2.</translation>
    </message>
    <message>
        <source>Factor of s: %1 in %2, %3 in %4.</source>
        <translation>Facteur de s&#xa0;: %1 dans %2, %3 dans %4.</translation>
    </message>
    <message>
        <source>Computed otherwise in %1 than in %2.</source>
        <translation>Calculé autrement dans %1 que dans %2.</translation>
    </message>
    <message>
        <source>No angles: the points are put at equal steps from %1 to %2.</source>
        <translation>Pas d’angles&#xa0;: les points sont placés à pas égaux de %1 à %2.</translation>
    </message>
    <message>
        <source>a target needs a position</source>
        <translation>un point visé a besoin d’une position</translation>
    </message>
    <message>
        <source>not above the target before, %1</source>
        <translation>pas au-dessus du point précédent, %1</translation>
    </message>
    <message>
        <source>not below the next target, %1</source>
        <translation>pas au-dessous du point suivant, %1</translation>
    </message>
    <message>
        <source>limit ± %1</source>
        <translation>limite ± %1</translation>
    </message>
    <message>
        <source>limit</source>
        <comment>of a figure</comment>
        <translation>limite</translation>
    </message>
    <message>
        <source>Drift of the %1 axis</source>
        <translation>Dérive de l’axe %1</translation>
    </message>
    <message>
        <source>Drift of “%1”</source>
        <translation>Dérive de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Time of day</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Deviation at rest</source>
        <translation>Écart au repos</translation>
    </message>
    <message>
        <source>deviation at rest, largest range within the duration of the test %1</source>
        <translation>écart au repos, plus grande étendue sur la durée de l’essai %1</translation>
    </message>
    <message>
        <source>deviation at rest, range %1</source>
        <translation>écart au repos, étendue %1</translation>
    </message>
    <message>
        <source>evaluated %1</source>
        <translation>évalué %1</translation>
    </message>
    <message>
        <source>mean of the trials %1</source>
        <translation>moyenne des tirages %1</translation>
    </message>
    <message>
        <source>95.45 %: %1 to %2</source>
        <translation>95,45&#x202f;%&#xa0;: %1 à %2</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Radial deviation</source>
        <translation>Écart radial</translation>
    </message>
    <message>
        <source>As its certificate states it: a fixed part and a part that grows with the length, brought to k = 2. Or the full width of the range its error lies in.</source>
        <translation>Comme l’indique son certificat&#xa0;: une part fixe et une part qui croît avec la longueur, ramenées à k = 2. Ou l’étendue totale de son erreur.</translation>
    </message>
    <message>
        <source>Misalignment</source>
        <translation>Défaut d’alignement</translation>
    </message>
    <message>
        <source>The largest distance by which the measuring line may have left the axis over the travel, in mm: it enters as a cosine error.</source>
        <translation>La plus grande distance, en mm, dont la ligne de mesure peut s’être écartée de l’axe sur la course&#xa0;: elle compte comme erreur de cosinus.</translation>
    </message>
    <message>
        <source>Range of the temperature</source>
        <translation>Étendue de la température</translation>
    </message>
    <message>
        <source>The full width in which the mean temperature of machine or instrument is sure to lie: sensors, their places, changes between start and end.</source>
        <translation>L’étendue totale dans laquelle se trouve sûrement la température moyenne de la machine ou de l’instrument&#xa0;: capteurs, emplacements, variations entre début et fin.</translation>
    </message>
    <message>
        <source>Range of the expansion coefficient</source>
        <translation>Étendue du coefficient de dilatation</translation>
    </message>
    <message>
        <source>The full width in which α is sure to lie. 3.4 µm/(m·°C) gives U(α) = 2 µm/(m·°C), which ISO 230-2 calls the typical minimum.</source>
        <translation>L’étendue totale dans laquelle se trouve sûrement α. 3,4&#xa0;µm/(m·°C) donne U(α) = 2&#xa0;µm/(m·°C), que l’ISO 230-2 appelle le minimum usuel.</translation>
    </message>
    <message>
        <source>Environmental variation E_VE</source>
        <translation>Variation environnementale E_VE</translation>
    </message>
    <message>
        <source>The largest less the smallest reading of a drift test at rest, over the time of the test. Typed in, or taken from a drift test of the file.</source>
        <translation>Le plus grand moins le plus petit relevé d’un essai de dérive au repos, sur la durée de l’essai. Saisie, ou reprise d’un essai de dérive du fichier.</translation>
    </message>
    <message>
        <source>Length L</source>
        <translation>Longueur L</translation>
    </message>
    <message>
        <source>What the contributions grow with; empty: the measurement travel.</source>
        <translation>Ce avec quoi croissent les contributions&#x202f;; vide&#xa0;: la course de mesurage.</translation>
    </message>
    <message>
        <source>Calibration of displacement</source>
        <translation>Étalonnage du déplacement</translation>
    </message>
    <message>
        <source>Expanded uncertainty of the instrument&apos;s displacement, from its certificate. A simulation draws one error a trial for all points: F and D move by it, G does not. The budget counts it in G, too.</source>
        <translation>Incertitude étendue du déplacement de l’instrument, d’après son certificat. Une simulation tire une seule erreur par essai pour tous les points&#xa0;: F et D s’en trouvent décalés, pas G. Le bilan la compte aussi dans G.</translation>
    </message>
    <message>
        <source>Noise of a point</source>
        <translation>Bruit d’un point</translation>
    </message>
    <message>
        <source>Standard uncertainty of a single point, from readings at rest. G grows with it and with the number of points.</source>
        <translation>Incertitude type d’un seul point, d’après des relevés au repos. G croît avec lui et avec le nombre de points.</translation>
    </message>
    <message>
        <source>Repeatability</source>
        <translation>Répétabilité</translation>
    </message>
    <message>
        <source>Standard uncertainty of the result from repeated circles; empty: from the repetitions of the file. A simulation adds one draw a trial to each result, G among them, and moves no point by it.</source>
        <translation>Incertitude type du résultat d’après des cercles répétés&#x202f;; vide&#xa0;: d’après les répétitions du fichier. Une simulation ajoute un tirage par essai à chaque résultat, G compris, sans déplacer aucun point.</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Tirages</translation>
    </message>
    <message>
        <source>Seed</source>
        <comment>of a simulation</comment>
        <translation>Germe</translation>
    </message>
    <message>
        <source>The same seed gives the same figures, on any computer.</source>
        <translation>Le même germe donne les mêmes chiffres, sur tout ordinateur.</translation>
    </message>
    <message>
        <source>Expanded uncertainty</source>
        <translation>Incertitude étendue</translation>
    </message>
    <message>
        <source>U of the result with k = 2, as the laboratory determined it.</source>
        <translation>U du résultat avec k = 2, telle que le laboratoire l’a déterminée.</translation>
    </message>
    <message>
        <source>Temperatures over time</source>
        <translation>Températures au cours du temps</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Température</translation>
    </message>
    <message>
        <source>Compensation of the %1 axis</source>
        <translation>Compensation de l’axe %1</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesuré</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>prévu</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Ici</translation>
    </message>
    <message>
        <source>Value here</source>
        <translation>Valeur recalculée</translation>
    </message>
    <message>
        <source>Here − stated</source>
        <translation>Recalculé − indiqué</translation>
    </message>
    <message>
        <source>The instrument’s program states %1 (%2); the result here differs by %3.</source>
        <translation>Le programme de l’instrument indique %1 (%2)&#x202f;; le résultat obtenu ici s’en écarte de %3.</translation>
    </message>
    <message>
        <source>A new test, an import, a file, an example. A file holds one report: a machine, its instruments and any number of tests. A further test takes over what is stated of the one in view, but nothing that was measured and no limits.</source>
        <translation>Un nouvel essai, une importation, un fichier, un exemple. Un fichier contient un rapport&#xa0;: une machine, ses instruments et autant d’essais qu’on veut. Un essai ajouté reprend ce qui est indiqué pour celui qui est affiché, mais aucune valeur mesurée ni aucune limite.</translation>
    </message>
    <message>
        <source>Centre %1</source>
        <translation>Centre %1</translation>
    </message>
    <message>
        <source>Radius, mean scale</source>
        <translation>Rayon, échelle moyenne</translation>
    </message>
    <message>
        <source>Scale mismatch %1</source>
        <translation>Différence d’échelle %1</translation>
    </message>
    <message>
        <source>Squareness %1</source>
        <translation>Perpendicularité %1</translation>
    </message>
    <message>
        <source>Servo mismatch %1</source>
        <translation>Défaut de servo %1</translation>
    </message>
    <message>
        <source>Backlash %1</source>
        <translation>Jeu à l’inversion %1</translation>
    </message>
    <message>
        <source>Lateral play %1</source>
        <translation>Jeu latéral %1</translation>
    </message>
    <message>
        <source>Straightness %1</source>
        <translation>Rectitude %1</translation>
    </message>
    <message>
        <source>Reversal spike %1</source>
        <translation>Pic de réversibilité %1</translation>
    </message>
    <message>
        <source>Periodic deviation %1</source>
        <translation>Écart périodique %1</translation>
    </message>
    <message>
        <source>Common lag %1</source>
        <translation>Retard commun %1</translation>
    </message>
    <message>
        <source>(Common lag %1)²</source>
        <translation>(Retard commun %1)²</translation>
    </message>
    <message>
        <source>Difference of following errors %1, in µm</source>
        <translation>Différence des erreurs de poursuite %1, en µm</translation>
    </message>
    <message>
        <source>Mismatch of the lags %1</source>
        <translation>Différence des retards %1</translation>
    </message>
    <message>
        <source>Drift of the radius</source>
        <translation>Dérive du rayon</translation>
    </message>
    <message>
        <source>One sense only: squareness and servo mismatch cannot be told apart.</source>
        <translation>Un seul sens&#xa0;: la perpendicularité et le défaut de servo ne peuvent être distingués.</translation>
    </message>
    <message>
        <source>Feedback signal: what the machine does beyond its scales is not seen.</source>
        <translation>Signal de retour&#xa0;: ce que la machine fait au-delà de ses règles n’est pas vu.</translation>
    </message>
    <message>
        <source>The contouring feed is not stated: the servo mismatch has no value.</source>
        <translation>L’avance de contournage n’est pas indiquée&#xa0;: le défaut de servo n’a pas de valeur.</translation>
    </message>
    <message>
        <source>The path lies %1 behind the commanded angles.</source>
        <translation>La trajectoire est en retard de %1 sur les angles commandés.</translation>
    </message>
    <message>
        <source>The pause between the arcs is not known: with the drift a step of the radius between the senses is fitted, and lateral play is less certain for it.</source>
        <translation>La pause entre les arcs n’est pas connue&#xa0;: avec la dérive, un saut du rayon entre les sens est ajusté, ce qui rend le jeu latéral moins certain.</translation>
    </message>
    <message>
        <source>Lateral play of both axes, opposite and alike: a radius that differs by δ between the senses looks the same (−0.78 δ and +0.78 δ).</source>
        <translation>Jeux latéraux des deux axes, opposés et de même grandeur&#xa0;: un rayon qui diffère de δ entre les sens a le même aspect (−0,78&#xa0;δ et +0,78&#xa0;δ).</translation>
    </message>
    <message>
        <source>Two feeds: nothing checks that the lag grows with the square of the feed; a third one would.</source>
        <translation>Deux avances&#xa0;: rien ne vérifie que le retard croît comme le carré de l’avance&#x202f;; une troisième le ferait.</translation>
    </message>
    <message>
        <source>%1 travels farther than %2: %1 is long or %2 short.</source>
        <translation>%1 parcourt plus que %2&#xa0;: %1 est long ou %2 court.</translation>
    </message>
    <message>
        <source>%1 travels less far than %2: %1 is short or %2 long.</source>
        <translation>%1 parcourt moins que %2&#xa0;: %1 est court ou %2 long.</translation>
    </message>
    <message>
        <source>Compare the scales, the pitch compensation and the temperatures of %1 and %2.</source>
        <translation>Comparer les règles, la compensation de pas et les températures de %1 et %2.</translation>
    </message>
    <message>
        <source>The angle from +%1 to +%2 is larger than 90°.</source>
        <translation>L’angle de +%1 à +%2 dépasse 90°.</translation>
    </message>
    <message>
        <source>The angle from +%1 to +%2 is smaller than 90°.</source>
        <translation>L’angle de +%1 à +%2 est inférieur à 90°.</translation>
    </message>
    <message>
        <source>Check guideways and levelling, then the squareness compensation.</source>
        <translation>Vérifier les guidages et la mise de niveau, puis la compensation de perpendicularité.</translation>
    </message>
    <message>
        <source>%1 follows later than %2.</source>
        <translation>%1 suit plus tard que %2.</translation>
    </message>
    <message>
        <source>%2 follows later than %1.</source>
        <translation>%2 suit plus tard que %1.</translation>
    </message>
    <message>
        <source>Match the position gains (Kv) of %1 and %2; the effect grows with the feed.</source>
        <translation>Égaliser les gains de position (Kv) de %1 et %2&#x202f;; l’effet croît avec l’avance.</translation>
    </message>
    <message>
        <source>%1 loses motion at each reversal.</source>
        <translation>%1 perd de la course à chaque inversion.</translation>
    </message>
    <message>
        <source>%1 moves too far at each reversal: its backlash is compensated too much.</source>
        <translation>%1 va trop loin à chaque inversion&#xa0;: son jeu est surcompensé.</translation>
    </message>
    <message>
        <source>Check screw, bearings and coupling of %1, then its backlash compensation.</source>
        <translation>Vérifier la vis, les paliers et l’accouplement de %1, puis sa compensation de jeu.</translation>
    </message>
    <message>
        <source>Reduce the backlash compensation of %1.</source>
        <translation>Réduire la compensation de jeu de %1.</translation>
    </message>
    <message>
        <source>%1 steps aside at each reversal: towards +%2 while it moves towards +.</source>
        <translation>%1 se déporte à chaque inversion&#xa0;: vers +%2 quand il va vers +.</translation>
    </message>
    <message>
        <source>%1 steps aside at each reversal: towards −%2 while it moves towards +.</source>
        <translation>%1 se déporte à chaque inversion&#xa0;: vers −%2 quand il va vers +.</translation>
    </message>
    <message>
        <source>Check gibs, guide shoes and preload of %1.</source>
        <translation>Vérifier les réglettes, les patins et la précharge de %1.</translation>
    </message>
    <message>
        <source>%1 runs on a bow: its ends lie towards +%2.</source>
        <translation>%1 décrit un arc&#xa0;: ses extrémités sont vers +%2.</translation>
    </message>
    <message>
        <source>%1 runs on a bow: its ends lie towards −%2.</source>
        <translation>%1 décrit un arc&#xa0;: ses extrémités sont vers −%2.</translation>
    </message>
    <message>
        <source>Check guideway, supports and levelling of %1.</source>
        <translation>Vérifier le guidage, les appuis et la mise de niveau de %1.</translation>
    </message>
    <message>
        <source>%1 sticks when it reverses: the path bulges outwards and comes back.</source>
        <translation>%1 colle à l’inversion&#xa0;: la trajectoire fait une pointe vers l’extérieur puis revient.</translation>
    </message>
    <message>
        <source>%1 jumps when it reverses: the path dents inwards and comes back.</source>
        <translation>%1 saute à l’inversion&#xa0;: la trajectoire fait une pointe vers l’intérieur puis revient.</translation>
    </message>
    <message>
        <source>Check lubrication and friction of %1, then its friction compensation.</source>
        <translation>Vérifier le graissage et le frottement de %1, puis sa compensation de frottement.</translation>
    </message>
    <message>
        <source>Reduce the friction compensation of %1.</source>
        <translation>Réduire la compensation de frottement de %1.</translation>
    </message>
    <message>
        <source>%1 deviates periodically along its travel.</source>
        <translation>%1 s’écarte périodiquement le long de sa course.</translation>
    </message>
    <message>
        <source>The pitch tells whether the screw, the rack or the measuring system of %1 is at fault.</source>
        <translation>Le pas indique si la vis, la crémaillère ou le système de mesure de %1 est en cause.</translation>
    </message>
    <message>
        <source>%1 and %2 lag: the circle shrinks with the feed.</source>
        <translation>%1 et %2 sont en retard&#xa0;: le cercle rétrécit avec l’avance.</translation>
    </message>
    <message>
        <source>%1 and %2 overshoot: the circle grows with the feed.</source>
        <translation>%1 et %2 vont trop loin&#xa0;: le cercle grandit avec l’avance.</translation>
    </message>
    <message>
        <source>Check the feed-forward and the position gains of %1 and %2.</source>
        <translation>Vérifier l’anticipation et les gains de position de %1 et %2.</translation>
    </message>
    <message>
        <source>%1 loses more of its stroke with the feed than %2.</source>
        <translation>%1 perd plus de sa course avec l’avance que %2.</translation>
    </message>
    <message>
        <source>%2 loses more of its stroke with the feed than %1.</source>
        <translation>%2 perd plus de sa course avec l’avance que %1.</translation>
    </message>
    <message>
        <source>The circle grows during the test.</source>
        <translation>Le cercle grandit pendant l’essai.</translation>
    </message>
    <message>
        <source>The circle shrinks during the test.</source>
        <translation>Le cercle rétrécit pendant l’essai.</translation>
    </message>
    <message>
        <source>Check warm-up and temperatures of machine and instrument.</source>
        <translation>Vérifier la mise en température et les températures de la machine et de l’instrument.</translation>
    </message>
    <message>
        <source>These arcs hardly tell it.</source>
        <translation>Ces arcs ne la déterminent guère.</translation>
    </message>
    <message>
        <source>These arcs do not tell it from other sources.</source>
        <translation>Ces arcs ne la distinguent pas d’autres sources.</translation>
    </message>
    <message>
        <source>Taken out before any deviation is stated.</source>
        <translation>Retiré avant l’indication de tout écart.</translation>
    </message>
    <message>
        <source>Diagnosis (an interpretation)</source>
        <translation>Diagnostic (interprétation)</translation>
    </message>
    <message>
        <source>Parameters told apart</source>
        <translation>Paramètres séparés</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Rest, standard deviation</source>
        <translation>Reste, écart-type</translation>
    </message>
    <message>
        <source>Part of G(b)</source>
        <translation>Part de G(b)</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Signification</translation>
    </message>
    <message>
        <source>circular: the plane, first and second axis</source>
        <translation>circular&#xa0;: le plan, premier et second axe</translation>
    </message>
    <message>
        <source>circular: nominal radius, mm</source>
        <translation>circular&#xa0;: rayon nominal, mm</translation>
    </message>
    <message>
        <source>circular: contouring feed, mm/min; several times: a test each</source>
        <translation>circular&#xa0;: avance de contournage, mm/min&#x202f;; répétée&#xa0;: un essai pour chacune</translation>
    </message>
    <message>
        <source>circular: points in each sense</source>
        <translation>circular&#xa0;: points dans chaque sens</translation>
    </message>
    <message>
        <source>circular: what is measured</source>
        <translation>circular&#xa0;: ce qui est mesuré</translation>
    </message>
    <message>
        <source>circular: the arc, degrees; without it 0:360</source>
        <translation>circular&#xa0;: l’arc, degrés&#x202f;; sans elle 0:360</translation>
    </message>
    <message>
        <source>circular: pause between the senses, in turns</source>
        <translation>circular&#xa0;: pause entre les sens, en tours</translation>
    </message>
    <message>
        <source>positioning: name of the axis</source>
        <translation>positioning&#xa0;: nom de l’axe</translation>
    </message>
    <message>
        <source>positioning: from the first target to the last, mm</source>
        <translation>positioning&#xa0;: de la première position visée à la dernière, mm</translation>
    </message>
    <message>
        <source>positioning: number of targets</source>
        <translation>positioning&#xa0;: nombre de positions visées</translation>
    </message>
    <message>
        <source>positioning: runs each way</source>
        <translation>positioning&#xa0;: passes dans chaque sens</translation>
    </message>
    <message>
        <source>standard deviation of the noise, µm; without it 0</source>
        <translation>écart-type du bruit, µm&#x202f;; sans elle 0</translation>
    </message>
    <message>
        <source>of neighbouring readings, 0 to below 1</source>
        <translation>corrélation de relevés voisins, de 0 à moins de 1</translation>
    </message>
    <message>
        <source>step of the readings, µm; 0: none</source>
        <translation>pas des relevés, µm&#x202f;; 0&#xa0;: aucun</translation>
    </message>
    <message>
        <source>start of the random numbers: the same gives the same measurement</source>
        <translation>germe des nombres aléatoires&#xa0;: le même donne le même mesurage</translation>
    </message>
    <message>
        <source>writes there what the measurement was made from</source>
        <translation>y écrit ce dont le mesurage a été fait</translation>
    </message>
    <message>
        <source>Made by computation, not measured</source>
        <translation>Fait par calcul, non mesuré</translation>
    </message>
    <message>
        <source>the command %1 takes one word: %2</source>
        <translation>la commande %1 prend un mot&#xa0;: %2</translation>
    </message>
    <message>
        <source>a measurement with known truth</source>
        <translation>un mesurage dont la vérité est connue</translation>
    </message>
    <message>
        <source>Condition of the fit</source>
        <translation>Conditionnement</translation>
    </message>
    <message>
        <source>Source</source>
        <comment>diagnosis</comment>
        <translation>Source</translation>
    </message>
    <message>
        <source>API laser data</source>
        <translation>données laser API</translation>
    </message>
    <message>
        <source>the numbers are right</source>
        <translation>les nombres sont justes</translation>
    </message>
    <message>
        <source>leave out</source>
        <translation>laisser de côté</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
    <message>
        <source>Process variable</source>
        <translation>Variable de procédé</translation>
    </message>
    <message>
        <source>Data not read</source>
        <translation>Données non lues</translation>
    </message>
    <message>
        <source>Large deviations</source>
        <translation>Grands écarts</translation>
    </message>
    <message>
        <source>Spread between runs</source>
        <translation>Étendue entre passes</translation>
    </message>
    <message>
        <source>Deviations equal to targets</source>
        <translation>Écarts égaux aux points visés</translation>
    </message>
    <message>
        <source>Readings that are all equal</source>
        <translation>Relevés tous égaux</translation>
    </message>
    <message>
        <source>Unequal numbers of runs</source>
        <translation>Nombres de passes inégaux</translation>
    </message>
    <message>
        <source>Columns: the headings do not say which hold readings; column %1 and those like it are read.</source>
        <translation>Colonnes&#xa0;: les en-têtes n’indiquent pas lesquelles contiennent des relevés&#x202f;; la colonne %1 et les colonnes semblables sont lues.</translation>
    </message>
    <message>
        <source>Deviations up to %1: are unit, content and decimal mark right?</source>
        <translation>Écarts jusqu’à %1&#xa0;: l’unité, le contenu et le séparateur décimal sont-ils justes&#x202f;?</translation>
    </message>
    <message>
        <source>The deviations of run %1 equal the targets: is it a run at all?</source>
        <translation>Les écarts de la passe %1 sont égaux aux positions visées&#xa0;: est-ce bien une passe&#x202f;?</translation>
    </message>
    <message>
        <source>Run %1 spreads a hundred times as far as the others: is it one of them?</source>
        <translation>La passe %1 est cent fois plus dispersée que les autres&#xa0;: en fait-elle bien partie&#x202f;?</translation>
    </message>
    <message>
        <source>All readings are zero: was anything measured at all?</source>
        <translation>Tous les relevés sont nuls&#xa0;: a-t-on mesuré quelque chose&#x202f;?</translation>
    </message>
    <message>
        <source>Directions: letters, abbreviations or titles say them; look whether ↑ and ↓ are right.</source>
        <translation>Sens&#xa0;: indiqués par des lettres, des abréviations ou des titres&#x202f;; vérifier que ↑ et ↓ sont justes.</translation>
    </message>
    <message>
        <source>Directions: the file has means of both directions only; they are read as ↑.</source>
        <translation>Sens&#xa0;: le fichier ne contient que des moyennes des deux sens&#x202f;; elles sont lues comme ↑.</translation>
    </message>
    <message>
        <source>The file holds means of runs, not the runs: R and A say little.</source>
        <translation>Le fichier contient des moyennes de passes et non les passes elles-mêmes&#xa0;: R et A sont peu significatifs.</translation>
    </message>
    <message>
        <source>Sign: it changed between the versions of the program; read as actual − target.</source>
        <translation>Signe&#xa0;: il a changé d’une version du programme à l’autre&#x202f;; lu comme «&#xa0;réel − visé&#xa0;».</translation>
    </message>
    <message>
        <source>Columns: the headings do not say which hold readings; “%1” and those like it are read as runs.</source>
        <translation>Colonnes&#xa0;: les en-têtes n’indiquent pas lesquelles contiennent des relevés&#x202f;; «&#xa0;%1&#xa0;» et les colonnes semblables sont lues comme des passes.</translation>
    </message>
    <message>
        <source>Columns: some hold positions and some deviations; the deviations are read.</source>
        <translation>Colonnes&#xa0;: certaines contiennent des positions, d’autres des écarts&#x202f;; les écarts sont lus.</translation>
    </message>
    <message>
        <source>Columns: column %1 has numbers and no heading; it is not read.</source>
        <translation>Colonnes&#xa0;: la colonne %1 contient des nombres, mais n’a pas d’en-tête&#x202f;; elle n’est pas lue.</translation>
    </message>
    <message>
        <source>Columns: the headings name readings of different kinds; those like “%1” are read, the others are not.</source>
        <translation>Colonnes&#xa0;: les en-têtes annoncent des relevés de natures différentes&#x202f;; ceux du type «&#xa0;%1&#xa0;» sont lus, les autres non.</translation>
    </message>
    <message>
        <source>Columns: the readings have different units; those in %1 are read.</source>
        <translation>Colonnes&#xa0;: les relevés ont des unités différentes&#x202f;; ceux en %1 sont lus.</translation>
    </message>
    <message>
        <source>Columns: “%1” names no direction as the others do; it is not read.</source>
        <translation>Colonnes&#xa0;: «&#xa0;%1&#xa0;» n’indique pas de sens, contrairement aux autres&#x202f;; elle n’est pas lue.</translation>
    </message>
    <message>
        <source>Columns: “%1” and “%2” are headed alike; only the first is read as targets.</source>
        <translation>Colonnes&#xa0;: «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» ont des en-têtes semblables&#x202f;; seule la première est lue comme points visés.</translation>
    </message>
    <message>
        <source>The target %1 is out of the order of all others; look whether a cell of its line is missing.</source>
        <translation>Le point visé %1 ne suit pas l’ordre de tous les autres&#x202f;; vérifiez s’il manque une cellule dans sa ligne.</translation>
    </message>
    <message>
        <source>Columns: “%1” may be a run like the others; it is not read.</source>
        <translation>Colonnes&#xa0;: «&#xa0;%1&#xa0;» est peut-être une passe comme les autres&#x202f;; elle n’est pas lue.</translation>
    </message>
    <message>
        <source>Columns: some readings name no run as the others do; they are not read.</source>
        <translation>Colonnes&#xa0;: certains relevés n’indiquent pas leur passe, contrairement aux autres&#x202f;; ils ne sont pas lus.</translation>
    </message>
    <message>
        <source>Columns: the deviations are not the differences of actual and target positions; the deviations are read.</source>
        <translation>Colonnes&#xa0;: les écarts ne sont pas les différences entre positions réelles et positions visées&#x202f;; les écarts sont lus.</translation>
    </message>
    <message>
        <source>the columns of the targets and of the readings are not known; give the columns their roles</source>
        <translation>les colonnes des points visés et des relevés ne sont pas connues&#x202f;; donner leur rôle aux colonnes</translation>
    </message>
    <message>
        <source>columns of different roles cannot be read as runs of one test; ignore one of them</source>
        <translation>des colonnes de rôles différents ne peuvent pas être lues comme les passes d’un même essai&#x202f;; en ignorer une</translation>
    </message>
    <message>
        <source>Columns that are not read: %1.</source>
        <translation>Colonnes qui ne sont pas lues&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Axis: the table has several (%1); %2 is read, the others are a test of their own.</source>
        <translation>Axe&#xa0;: le tableau en a plusieurs (%1)&#x202f;; %2 est lu, chacun des autres fait l’objet d’un essai à part.</translation>
    </message>
    <message>
        <source>this is an angular measurement of a linear axis (pitch, yaw), no positioning test; measure the axis with linear optics</source>
        <translation>c’est une mesure angulaire d’un axe linéaire (tangage, lacet), et non un essai de positionnement&#x202f;; mesurer l’axe avec une optique linéaire</translation>
    </message>
    <message>
        <source>--zone reaches beyond the axis, which goes from %1 to %2</source>
        <translation>--zone dépasse l’axe, qui va de %1 à %2</translation>
    </message>
    <message>
        <source>the files do not state the model of the machines; choose the type with --type</source>
        <translation>les fichiers n’indiquent pas le modèle des machines&#x202f;; choisir le type avec --type</translation>
    </message>
    <message>
        <source>The head says one direction, the rows run both ways; the rows are followed.</source>
        <translation>L’en-tête indique un seul sens, les lignes vont dans les deux&#x202f;; ce sont les lignes qui comptent.</translation>
    </message>
    <message>
        <source>Plane: the file names %1 and the axes %2; %2 is taken.</source>
        <translation>Plan&#xa0;: le fichier indique %1 et les axes %2&#x202f;; %2 est retenu.</translation>
    </message>
    <message>
        <source>Statements that were read: %1 (%2).</source>
        <translation>Indications lues&#xa0;: %1 (%2).</translation>
    </message>
    <message>
        <source>The date %1 is not one that is known; it stays as text in the remarks.</source>
        <translation>La date %1 n’est pas une date connue&#x202f;; elle reste sous forme de texte dans les remarques.</translation>
    </message>
    <message>
        <source>The date %1 can be read in several ways; it stays as text in the remarks.</source>
        <translation>La date %1 peut se lire de plusieurs façons&#x202f;; elle reste sous forme de texte dans les remarques.</translation>
    </message>
    <message>
        <source>The line “%1” is not read: it holds no readings.</source>
        <translation>La ligne «&#xa0;%1&#xa0;» n’est pas lue&#xa0;: elle ne contient pas de relevés.</translation>
    </message>
    <message>
        <source>“%1” names no run; the line was not read.</source>
        <translation>«&#xa0;%1&#xa0;» n’indique pas de passe&#x202f;; la ligne n’a pas été lue.</translation>
    </message>
    <message>
        <source>The unit of this line is not that of the others: %1.</source>
        <translation>L’unité de cette ligne n’est pas celle des autres&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Columns: several hold deviations; “%1” is read, the others are a test of their own.</source>
        <translation>Colonnes&#xa0;: plusieurs contiennent des écarts&#x202f;; «&#xa0;%1&#xa0;» est lue, chacune des autres fait l’objet d’un essai à part.</translation>
    </message>
    <message>
        <source>Process variable: the file has %1; “%2” is read.</source>
        <translation>Variable de procédé&#xa0;: le fichier en a %1&#x202f;; «&#xa0;%2&#xa0;» est lue.</translation>
    </message>
    <message>
        <source>a line is longer than 1 MiB; expected a table of readings</source>
        <translation>une ligne dépasse 1&#xa0;Mio&#x202f;; un tableau de relevés est attendu</translation>
    </message>
    <message>
        <source>Kind: nothing in the file says it; read as a drift test.</source>
        <translation>Nature&#xa0;: rien ne le dit dans le fichier&#x202f;; lu comme un essai de dérive.</translation>
    </message>
    <message>
        <source>workbooks of Excel 97 (.xls) cannot be read; save this one as .xlsx, .ods or CSV</source>
        <translation>les classeurs Excel 97 (.xls) ne peuvent pas être lus&#x202f;; enregistrer celui-ci au format .xlsx, .ods ou CSV</translation>
    </message>
    <message>
        <source>the workbook is locked with a password; save it without one</source>
        <translation>le classeur est protégé par un mot de passe&#x202f;; l’enregistrer sans mot de passe</translation>
    </message>
    <message>
        <source>The workbook has %1 sheets; “%2” is read, which is hidden.</source>
        <translation>Le classeur a %1 feuilles&#x202f;; celle qui est lue, «&#xa0;%2&#xa0;», est masquée.</translation>
    </message>
    <message>
        <source>Hidden sheets: %1.</source>
        <translation>Feuilles masquées&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The workbook has %1 sheets, several with a measurement; “%2” is read.</source>
        <translation>Le classeur a %1 feuilles, dont plusieurs avec une mesure&#x202f;; «&#xa0;%2&#xa0;» est lue.</translation>
    </message>
    <message>
        <source>Decimal mark: numbers that stand there as text can be read in several ways.</source>
        <translation>Séparateur décimal&#xa0;: des nombres écrits sous forme de texte peuvent se lire de plusieurs façons.</translation>
    </message>
    <message>
        <source>Proposed: --set %1.</source>
        <translation>Proposé&#xa0;: --set %1.</translation>
    </message>
    <message>
        <source>Answers for --set %1=…: %2.</source>
        <translation>Réponses pour --set %1=…&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Answer with --set %1=….</source>
        <translation>Répondez par --set %1=….</translation>
    </message>
    <message>
        <source>take what is assumed where the file does not say it; doubts want an answer each</source>
        <translation>prendre ce qui est supposé là où le fichier ne le dit pas&#x202f;; chaque doute demande sa réponse</translation>
    </message>
    <message>
        <source>readings set aside keep value and reason, not taken: %1</source>
        <translation>relevés écartés gardant valeur et motif, non remplacés&#xa0;: %1</translation>
    </message>
    <message>
        <source>the budget with the actual targets is for positioning tests</source>
        <translation>le budget avec les points réels est réservé aux essais de positionnement</translation>
    </message>
    <message>
        <source>expected a whole number from 1 to 1 000 000 000</source>
        <translation>un nombre entier de 1 à 1&#x202f;000&#x202f;000&#x202f;000 est attendu</translation>
    </message>
    <message>
        <source>%1: budget and Monte Carlo differ by more than 20 %: the results of the trials are not normally distributed, half of their 95.45 % interval is not 2u.</source>
        <translation>%1&#xa0;: budget et Monte-Carlo diffèrent de plus de 20&#xa0;%&#xa0;: les résultats des tirages ne suivent pas une loi normale, la moitié de leur intervalle à 95,45&#xa0;% n’est pas 2u.</translation>
    </message>
    <message>
        <source>%1: budget and Monte Carlo differ by more than 20 %; no single reason that is known explains it.</source>
        <translation>%1&#xa0;: budget et Monte-Carlo diffèrent de plus de 20&#xa0;%&#x202f;; aucune raison connue ne l’explique à elle seule.</translation>
    </message>
    <message>
        <source>%1: budget and Monte Carlo differ by more than 20 %: the mean over all targets is less uncertain than the single target used in the budget.</source>
        <translation>%1&#xa0;: budget et Monte-Carlo diffèrent de plus de 20&#xa0;%&#xa0;: la moyenne sur tous les points est moins incertaine que le seul point retenu dans le budget.</translation>
    </message>
    <message>
        <source>%1: budget and Monte Carlo differ by more than 20 %: the ruling targets lie closer together than the length L = %2 of the budget, and the results of the trials are not normally distributed.</source>
        <translation>%1&#xa0;: budget et Monte-Carlo diffèrent de plus de 20&#xa0;%&#xa0;: les points déterminants sont plus proches l’un de l’autre que la longueur L = %2 du budget, et les résultats des tirages ne suivent pas une loi normale.</translation>
    </message>
    <message>
        <source>%1: budget and Monte Carlo differ by more than 20 %: the drift that the simulation adds to the readings widens the s of the ruling targets by more than 20 %.</source>
        <translation>%1&#xa0;: budget et Monte-Carlo diffèrent de plus de 20&#xa0;%&#xa0;: la dérive que la simulation ajoute aux relevés augmente de plus de 20&#xa0;% le s des points déterminants.</translation>
    </message>
    <message>
        <source>%1: budget and Monte Carlo differ by more than 20 %: other targets come within U of those that rule; from trial to trial another one rules.</source>
        <translation>%1&#xa0;: budget et Monte-Carlo diffèrent de plus de 20&#xa0;%&#xa0;: d’autres points sont à moins de U des points déterminants&#x202f;; d’un tirage à l’autre, un autre point détermine le résultat.</translation>
    </message>
    <message>
        <source>Of the systematic part S = %1 of its uncertainty the actual targets carry %2.</source>
        <translation>De la part systématique S = %1 de son incertitude, les points réels portent %2.</translation>
    </message>
    <message>
        <source>How many times the test is evaluated anew with other errors; empty: as many as two digits of the uncertainty need. Fewer than 220 000 are shown and never decide.</source>
        <translation>Combien de fois l’essai est évalué à nouveau avec d’autres erreurs&#x202f;; vide&#xa0;: autant que l’exigent deux chiffres de l’incertitude. Moins de 220&#x202f;000 tirages sont affichés et ne fondent jamais un verdict.</translation>
    </message>
    <message>
        <source>Where U comes from a simulation, g = %1·(U + 2s): our safety rule, s the standard deviation of U over the blocks of trials.</source>
        <translation>Lorsque U provient d’une simulation, g = %1·(U + 2s)&#xa0;: notre règle de sûreté, s étant l’écart-type de U sur les blocs de tirages.</translation>
    </message>
    <message>
        <source>U in %1</source>
        <translation>U en %1</translation>
    </message>
    <message>
        <source>With the actual targets (Palmer&apos;s method)</source>
        <translation>Avec les points réels (méthode Palmer)</translation>
    </message>
    <message>
        <source>95.45 %</source>
        <translation>95,45&#xa0;%</translation>
    </message>
    <message>
        <source>With the actual targets: in place of S = %1 what the positions that rule really carry of it, the readings tilted by ±S over L and evaluated anew; an explanation, unless it is chosen to decide.</source>
        <translation>Avec les points réels&#xa0;: au lieu de S = %1, ce qu’en portent réellement les positions déterminantes, les relevés étant inclinés de ±S sur L et évalués à nouveau&#x202f;; à titre d’explication, sauf si cette méthode est retenue pour le verdict.</translation>
    </message>
    <message>
        <source>Over the blocks of trials twice the standard deviation of mean, u, both ends and U is below the tolerance of u, half a unit of its second digit.</source>
        <translation>Sur les blocs de tirages, le double de l’écart-type de la moyenne, de u, des deux bornes et de U est inférieur à la tolérance sur u, une demi-unité de son deuxième chiffre.</translation>
    </message>
    <message>
        <source>The U of the budget with the actual targets is used for the verdict.</source>
        <translation>Le verdict est fondé sur l’U du budget avec les points réels.</translation>
    </message>
    <message>
        <source>Too few trials to decide: the budget U is used for the verdict.</source>
        <translation>Trop peu de tirages pour un verdict&#xa0;: il est fondé sur l’U du budget.</translation>
    </message>
    <message>
        <source>U (95.45 %)</source>
        <translation>U (95,45&#xa0;%)</translation>
    </message>
    <message>
        <source>95.45 % for %1; k = 2 for the others</source>
        <translation>95,45&#xa0;% pour %1&#x202f;; k = 2 pour les autres</translation>
    </message>
    <message>
        <source>--%1 takes a whole number up to %2, not %3</source>
        <translation>--%1 attend un nombre entier jusqu’à %2, et non %3</translation>
    </message>
    <message>
        <source>%1: budget and Monte Carlo differ by more than 20 %: the simulation lets the fixed part of the instrument&apos;s uncertainty grow with the length, the budget counts it in full.</source>
        <translation>%1&#xa0;: budget et Monte-Carlo diffèrent de plus de 20&#xa0;%&#xa0;: la simulation fait croître avec la longueur la part fixe de l’incertitude de l’instrument, le budget la compte en entier.</translation>
    </message>
    <message>
        <source>%1: budget and Monte Carlo differ by more than 20 %: readings that the errors tilt one way or the other move the governing targets, which the budget does not follow.</source>
        <translation>%1&#xa0;: budget et Monte-Carlo diffèrent de plus de 20&#xa0;%&#xa0;: inclinés dans un sens ou dans l’autre par les erreurs, les relevés donnent d’autres points déterminants, ce que le budget ne suit pas.</translation>
    </message>
    <message>
        <source>%1 is held against the limits of %2 and of %3: its row shows that of %2, which has the worse verdict.</source>
        <translation>%1 est comparé aux limites de %2 et de %3&#xa0;: sa ligne montre celle de %2, dont le verdict est le moins bon.</translation>
    </message>
    <message>
        <source>%1 is held against the limits of %2 and of %3: its row shows that of %2, which is the tighter one.</source>
        <translation>%1 est comparé aux limites de %2 et de %3&#xa0;: sa ligne montre celle de %2, la plus serrée.</translation>
    </message>
    <message>
        <source>The angles of arc %1 (%2) run against its sense or jump back: anticlockwise they grow, clockwise they fall. Its name may be wrong.</source>
        <translation>Les angles de l’arc %1 (%2) vont à l’encontre de son sens ou reviennent en arrière&#xa0;: ils croissent dans le sens antihoraire, décroissent dans le sens horaire. Son nom peut être faux.</translation>
    </message>
    <message>
        <source>No least squares circle was found for the points: what rests on it has no value.</source>
        <translation>Aucun cercle des moindres carrés n’a été trouvé pour les points&#xa0;: ce qui repose sur lui n’a pas de valeur.</translation>
    </message>
    <message>
        <source>limit of %1</source>
        <translation>limite de %1</translation>
    </message>
    <message>
        <source>%1 is below its lower limit by more than the uncertainty: %2 against %3 − %4 = %5.</source>
        <translation>%1 est au-dessous de sa limite inférieure de plus de l’incertitude&#xa0;: %2 contre %3 − %4 = %5.</translation>
    </message>
    <message>
        <source>%1 is below its lower limit by more than the guard band: %2 against %3 − %4 = %5.</source>
        <translation>%1 est au-dessous de sa limite inférieure de plus de la bande de garde&#xa0;: %2 contre %3 − %4 = %5.</translation>
    </message>
    <message>
        <source>%1 is below its lower limit: %2 against %3.</source>
        <translation>%1 est au-dessous de sa limite inférieure&#xa0;: %2 contre %3.</translation>
    </message>
    <message>
        <source>The limits of Fmax and Fmin hold with their signs, that of Fmin as a lower limit: for it, above and below change places.</source>
        <translation>Les limites de Fmax et de Fmin s’entendent avec leur signe, celle de Fmin comme limite inférieure&#xa0;: pour elle, au-dessus et au-dessous s’échangent.</translation>
    </message>
    <message>
        <source>this text has %1 characters; expected no more than %2</source>
        <translation>ce texte compte %1 caractères&#x202f;; attendu&#xa0;: %2 au plus</translation>
    </message>
    <message>
        <source>expected a reading between −%1 and %1 mm (rotary axis: degrees)</source>
        <translation>attendu&#xa0;: un relevé compris entre −%1 et %1&#xa0;mm (axe rotatif&#xa0;: degrés)</translation>
    </message>
    <message>
        <source>the heading says “%1”, which these numbers are not read in</source>
        <translation>l’en-tête indique «&#xa0;%1&#xa0;», unité dans laquelle ces nombres ne sont pas lus</translation>
    </message>
    <message>
        <source>read in %1, as the heading says</source>
        <translation>lu en %1, comme l’indique l’en-tête</translation>
    </message>
    <message>
        <source>expected a temperature of %2 or more</source>
        <translation>attendu&#xa0;: une température d’au moins %2</translation>
    </message>
    <message>
        <source>expected a coefficient of expansion between −%1 and %1 µm/(m·°C)</source>
        <translation>attendu&#xa0;: un coefficient de dilatation compris entre −%1 et %1&#xa0;µm/(m·°C)</translation>
    </message>
    <message>
        <source>a reading beyond any machine</source>
        <translation>un relevé hors de portée de toute machine</translation>
    </message>
    <message>
        <source>there are characters in it that are none of UTF-16 or UTF-32; expected a test file in UTF-8</source>
        <translation>il contient des caractères qui ne sont ni de l’UTF-16 ni de l’UTF-32&#x202f;; un fichier d’essai en UTF-8 est attendu</translation>
    </message>
    <message>
        <source>the test file would be larger than %1 MiB and could not be opened again; divide its tests between several files</source>
        <translation>le fichier d’essai dépasserait %1&#xa0;Mio et ne pourrait plus être ouvert&#x202f;; répartir ses essais entre plusieurs fichiers</translation>
    </message>
    <message>
        <source>the file is larger than %1 MiB</source>
        <translation>le fichier dépasse %1&#xa0;Mio</translation>
    </message>
    <message>
        <source>this is a device or a pipe; expected a file on a disk</source>
        <translation>c’est un périphérique ou un tube&#x202f;; un fichier sur un disque est attendu</translation>
    </message>
    <message>
        <source>this is the name of a test file, and what was measured would be lost; choose another ending</source>
        <translation>c’est le nom d’un fichier d’essai, et les relevés seraient perdus&#x202f;; choisir une autre extension</translation>
    </message>
    <message>
        <source>%1 is a file to read and would be lost; choose another name for what is written</source>
        <translation>%1 est un fichier à lire et serait perdu&#x202f;; choisir un autre nom pour ce qui est écrit</translation>
    </message>
    <message>
        <source>%1 has the ending of another kind of file; expected %2 (--force writes it all the same)</source>
        <translation>%1 porte l’extension d’un autre type de fichier&#x202f;; %2 est attendu (--force l’écrit malgré tout)</translation>
    </message>
    <message>
        <source>write even to a name with the ending of another kind of file</source>
        <translation>écrire même sous un nom qui porte l’extension d’un autre type de fichier</translation>
    </message>
    <message>
        <source>the compensation of a SINUMERIK is 0 at the reference point of the axis: say where that is</source>
        <translation>la compensation d’une SINUMERIK est nulle au point de référence de l’axe&#xa0;: indiquez où il se trouve</translation>
    </message>
    <message>
        <source>axeserr.dat knows mm only; this axis is rotary</source>
        <translation>axeserr.dat ne connaît que les mm&#x202f;; cet axe est rotatif</translation>
    </message>
    <message>
        <source>the interval of a table of a full turn divides 360°</source>
        <translation>le pas d’une table d’un tour complet divise 360°</translation>
    </message>
    <message>
        <source>LinuxCNC loads 256 points at most, this table has %1; choose an interval of %2 or more</source>
        <translation>LinuxCNC charge 256 points au plus, cette table en a %1&#x202f;; choisissez un pas de %2 ou plus</translation>
    </message>
    <message>
        <source>Nothing was measured outside %1 … %2: the values at these ends hold there.</source>
        <translation>Rien n’a été mesuré hors de %1 … %2&#xa0;: les valeurs de ces extrémités y sont maintenues.</translation>
    </message>
    <message>
        <source>Set COMP_FILE_TYPE = 0; the joint counts in mm; BACKLASH has no effect beside a COMP_FILE.</source>
        <translation>Réglez COMP_FILE_TYPE = 0&#x202f;; l’axe (joint) est en mm&#x202f;; BACKLASH est sans effet à côté d’un COMP_FILE.</translation>
    </message>
    <message>
        <source>Set COMP_FILE_TYPE = 0; the joint counts in degrees; BACKLASH has no effect beside a COMP_FILE.</source>
        <translation>Réglez COMP_FILE_TYPE = 0&#x202f;; l’axe (joint) est en degrés&#x202f;; BACKLASH est sans effet à côté d’un COMP_FILE.</translation>
    </message>
    <message>
        <source>MD38000 has to be %1 at least; MD32700 is 0 while the table is loaded.</source>
        <translation>MD38000 doit valoir au moins %1&#x202f;; MD32700 vaut 0 pendant le chargement de la table.</translation>
    </message>
    <message>
        <source>The reference point %1 lies where nothing was measured; the value at the nearest end was taken for it.</source>
        <translation>Le point de référence %1 se trouve là où rien n’a été mesuré&#x202f;; la valeur de l’extrémité la plus proche en tient lieu.</translation>
    </message>
    <message>
        <source>The values are nominal − actual, the formula of the maker&apos;s manual. Its example of a backlash has the other sign: check one point at the machine.</source>
        <translation>Les valeurs sont nominal − réel, selon la formule du manuel du constructeur. Son exemple de jeu à l’inversion a le signe contraire&#xa0;: vérifiez un point sur la machine.</translation>
    </message>
    <message>
        <source>a part program cannot move the axis “%1”: it knows the letters X, Y, Z, U, V, W, A, B and C</source>
        <translation>un programme pièce ne peut déplacer l’axe «&#xa0;%1&#xa0;»&#xa0;: il connaît les lettres X, Y, Z, U, V, W, A, B et C</translation>
    </message>
    <message>
        <source>in this dialect the axis %1 has no name of its own: %1 before a position would be axis %2 at another place; give the letter that the control knows it by</source>
        <translation>dans ce dialecte, l’axe %1 n’a pas de nom propre&#xa0;: %1 devant une position serait l’axe %2 à un autre endroit&#x202f;; donnez la lettre sous laquelle la commande le connaît</translation>
    </message>
    <message>
        <source>a part program needs targets and runs</source>
        <translation>un programme pièce a besoin de points visés et de passes</translation>
    </message>
    <message>
        <source>the dwell of a part program cannot be %1</source>
        <translation>la temporisation d’un programme pièce ne peut être de %1</translation>
    </message>
    <message>
        <source>the approach distance of a part program is above 0</source>
        <translation>la distance d’approche d’un programme pièce est supérieure à 0</translation>
    </message>
    <message>
        <source>the feed rate of a part program is above 0</source>
        <translation>la vitesse d’avance d’un programme pièce est supérieure à 0</translation>
    </message>
    <message>
        <source>positions in the active datum: set it before the start; for a compensation table at the machine datum</source>
        <translation>positions dans l’origine active&#xa0;: à régler avant le départ&#x202f;; pour une table de compensation, sur l’origine machine</translation>
    </message>
    <message>
        <source>positions in work offset %1: set it before the start; for a compensation table to the machine zero</source>
        <translation>positions dans le décalage d’origine %1&#xa0;: à régler avant le départ&#x202f;; pour une table de compensation, sur le zéro machine</translation>
    </message>
    <message>
        <source>the axis of this test has no name; the table needs the one that the control knows</source>
        <translation>l’axe de cet essai n’a pas de nom&#x202f;; la table a besoin de celui que connaît la commande</translation>
    </message>
    <message>
        <source>the axis “%1” cannot be one of a SINUMERIK: a name is a letter with letters and digits behind it</source>
        <translation>l’axe «&#xa0;%1&#xa0;» ne peut être celui d’une SINUMERIK&#xa0;: un nom est une lettre suivie de lettres et de chiffres</translation>
    </message>
    <message>
        <source>a SINUMERIK has the measuring systems 0 and 1 of an axis; there is no %1</source>
        <translation>une SINUMERIK a les systèmes de mesure 0 et 1 d’un axe&#x202f;; il n’y a pas de %1</translation>
    </message>
    <message>
        <source>axeserr.dat knows the axes X, Y and Z only, not “%1”</source>
        <translation>axeserr.dat ne connaît que les axes X, Y et Z, non «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>its values are taken for COMP_FILE_TYPE %1; the file does not say it</source>
        <translation>ses valeurs sont prises pour COMP_FILE_TYPE %1&#x202f;; le fichier ne le dit pas</translation>
    </message>
    <message>
        <source>the rules of this compensation table (%1) are not read here</source>
        <translation>les règles de cette table de compensation (%1) ne sont pas prises en charge</translation>
    </message>
    <message>
        <source>this is no compensation table of a control that is known here</source>
        <translation>ce n’est pas la table de compensation d’une commande prise en charge</translation>
    </message>
    <message>
        <source>this is a compensation table (%1), not a measurement; compare it with a test: export --compare, or “Compensation table…” in the window</source>
        <translation>c’est une table de compensation (%1), et non une mesure&#x202f;; la comparer à un essai&#xa0;: export --compare, ou «&#xa0;Table de compensation…&#xa0;» dans la fenêtre</translation>
    </message>
    <message>
        <source>point %1 of the compensation table has no value: the control would keep an older one</source>
        <translation>le point %1 de la table de compensation n’a pas de valeur&#xa0;: la commande en garderait une ancienne</translation>
    </message>
    <message>
        <source>other tables in the file that were not used: %1</source>
        <translation>autres tables du fichier non utilisées&#xa0;: %1</translation>
    </message>
    <message>
        <source>no table in it compensates an axis upon itself</source>
        <translation>aucune de ses tables ne compense un axe sur lui-même</translation>
    </message>
    <message>
        <source>its values are taken to have the sign of those of $AA_ENC_COMP</source>
        <translation>ses valeurs sont supposées avoir le signe de celles de $AA_ENC_COMP</translation>
    </message>
    <message>
        <source>“%1” is no three numbers: LinuxCNC stops here and loads nothing</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une ligne de trois nombres&#xa0;: LinuxCNC s’arrête ici et ne charge rien</translation>
    </message>
    <message>
        <source>LinuxCNC stops reading at line %1</source>
        <translation>LinuxCNC arrête la lecture à la ligne %1</translation>
    </message>
    <message>
        <source>lines that LinuxCNC does not load, beyond 256 or not ascending: %1</source>
        <translation>lignes que LinuxCNC ne charge pas, au-delà de 256 ou non croissantes&#xa0;: %1</translation>
    </message>
    <message>
        <source>its values are taken as nominal − actual, the formula of the maker&apos;s manual</source>
        <translation>ses valeurs sont prises comme nominal − réel, selon la formule du manuel du constructeur</translation>
    </message>
    <message>
        <source>its values are taken as corrections, added to the command: their sign is not public</source>
        <translation>ses valeurs sont prises comme corrections, ajoutées à la consigne&#xa0;: leur signe n’est pas public</translation>
    </message>
    <message>
        <source>compensation-csv, weihong: values with the sign of the deviations; without it corrections, added to the command</source>
        <translation>compensation-csv, weihong&#xa0;: valeurs du signe des écarts&#x202f;; sans elle, corrections à ajouter à la consigne</translation>
    </message>
    <message>
        <source>siemens: the reference point of the axis, where the values are 0; owed</source>
        <translation>siemens&#xa0;: point de référence de l’axe, où les valeurs sont nulles&#x202f;; à indiquer</translation>
    </message>
    <message>
        <source>a compensation table of a control, to compare with the one written</source>
        <translation>table de compensation d’une commande, à comparer à celle qui est écrite</translation>
    </message>
    <message numerus="yes">
        <source>compared with a table of %1, axis %4: %n point(s) from %2 to %3</source>
        <translation>
            <numerusform>comparé à une table de %1, axe %4&#xa0;: %n point de %2 à %3</numerusform>
            <numerusform>comparé à une table de %1, axe %4&#xa0;: %n points de %2 à %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>compared with a table of %1: %n point(s) from %2 to %3</source>
        <translation>
            <numerusform>comparé à une table de %1&#xa0;: %n point de %2 à %3</numerusform>
            <numerusform>comparé à une table de %1&#xa0;: %n points de %2 à %3</numerusform>
        </translation>
    </message>
    <message>
        <source>largest difference, written − compared: %1 at %2 %3</source>
        <translation>plus grande différence, écrite − comparée&#xa0;: %1 à %2 %3</translation>
    </message>
    <message>
        <source>predicted with the compared table applied instead:</source>
        <translation>prévision avec la table comparée à sa place&#xa0;:</translation>
    </message>
    <message>
        <source>the compensation of a SINUMERIK is 0 at the reference point of the axis: say where that is (%1)</source>
        <translation>la compensation d’une SINUMERIK est nulle au point de référence de l’axe&#xa0;: indiquez où il se trouve (%1)</translation>
    </message>
    <message>
        <source>(practice; text not available)</source>
        <translation>(usage&#x202f;; texte non disponible)</translation>
    </message>
    <message>
        <source>Laboratory practice, not stated%2: %1.</source>
        <translation>Usage de laboratoire, non indiqué%2&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Not declared%2: %1.</source>
        <translation>Non déclaré%2&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Not stated in the report%2: %1.</source>
        <translation>Non indiqué dans le rapport%2&#xa0;: %1.</translation>
    </message>
    <message>
        <source>To be agreed, not agreed%2: %1.</source>
        <translation>Soumis à accord, non convenu%2&#xa0;: %1.</translation>
    </message>
    <message>
        <source>To be agreed, not declared%2: %1.</source>
        <translation>Soumis à accord, non déclaré%2&#xa0;: %1.</translation>
    </message>
    <message>
        <source>To be agreed (clause %3), not agreed%2: %1.</source>
        <translation>Soumis à accord (article %3), non convenu%2&#xa0;: %1.</translation>
    </message>
    <message>
        <source>To be agreed (clause %3), not declared%2: %1.</source>
        <translation>Soumis à accord (article %3), non déclaré%2&#xa0;: %1.</translation>
    </message>
    <message>
        <source>No limit of the gradient was agreed.</source>
        <translation>Aucune limite du gradient n’a été convenue.</translation>
    </message>
    <message>
        <source>Feed %1, agreed %2.</source>
        <translation>Avance %1, convenue %2.</translation>
    </message>
    <message>
        <source>ends of the axis</source>
        <translation>extrémités de l’axe</translation>
    </message>
    <message>
        <source>approach distance</source>
        <translation>distance d’approche</translation>
    </message>
    <message>
        <source>Gradient %1, agreed limit %2.</source>
        <translation>Gradient %1, limite convenue %2.</translation>
    </message>
    <message>
        <source>Machine at %1, results not corrected to 20 °C.</source>
        <translation>Machine à %1, résultats non corrigés à 20&#xa0;°C.</translation>
    </message>
    <message>
        <source>Instrument at %1, results not corrected to 20 °C.</source>
        <translation>Instrument à %1, résultats non corrigés à 20&#xa0;°C.</translation>
    </message>
    <message>
        <source>Approaches in the positive direction: %1, in the negative: %2; the text speaks of five.</source>
        <translation>Approches dans le sens positif&#xa0;: %1, dans le sens négatif&#xa0;: %2&#x202f;; le texte en prévoit cinq.</translation>
    </message>
    <message numerus="yes">
        <source>Readings set aside (%n): %1. The text provides for none.</source>
        <translation>
            <numerusform>Relevé écarté (%n)&#xa0;: %1. Le texte n’en prévoit pas.</numerusform>
            <numerusform>Relevés écartés (%n)&#xa0;: %1. Le texte n’en prévoit pas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Readings set aside (%n): %1.</source>
        <translation>
            <numerusform>Relevé écarté (%n)&#xa0;: %1.</numerusform>
            <numerusform>Relevés écartés (%n)&#xa0;: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Step cycle without written agreement; strict reference for acceptance is the standard cycle.</source>
        <translation>Cycle en pas sans accord écrit&#x202f;; la référence stricte pour la réception est le cycle d’essai normal.</translation>
    </message>
    <message>
        <source>Step cycle without written agreement.</source>
        <translation>Cycle en pas sans accord écrit.</translation>
    </message>
    <message>
        <source>Step cycle by written agreement: %1.</source>
        <translation>Cycle en pas par accord écrit&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Worked example of ISO 230-2:1988 (table 2): the position of the first target and ten readings are substitutes with the published mean and s. Compare the mean reversal value (published: %1), R↑ (%2), R↓ (%3), R (%4), A (%5) and the values per target, never the single readings.</source>
        <translation>Exemple traité de l’ISO 230-2:1988 (tableau 2)&#xa0;: la position du premier point visé et dix relevés sont des valeurs de remplacement ayant la moyenne et le s publiés. Comparer l’erreur moyenne de réversibilité (publiée&#xa0;: %1), R↑ (%2), R↓ (%3), R (%4), A (%5) et les valeurs par point visé, jamais les relevés isolés.</translation>
    </message>
    <message>
        <source>The air was at %1; 20 ± 0.5 °C is asked for where it can be controlled.</source>
        <translation>Air à %1&#x202f;; 20&#xa0;°C ± 0,5&#xa0;°C exigés là où la température peut être réglée.</translation>
    </message>
    <message>
        <source>temperature of the environment</source>
        <translation>température de l’environnement</translation>
    </message>
    <message>
        <source>thermal stability before the test</source>
        <translation>stabilité thermique avant l’essai</translation>
    </message>
    <message>
        <source>Machine or instruments were not thermally stable.</source>
        <translation>Machine ou instruments non stabilisés thermiquement.</translation>
    </message>
    <message>
        <source>protection from draughts and radiation</source>
        <translation>protection contre les courants d’air et les rayonnements</translation>
    </message>
    <message>
        <source>Not protected from draughts or radiation.</source>
        <translation>Pas de protection contre les courants d’air ou les rayonnements.</translation>
    </message>
    <message>
        <source>compensation by the instrument</source>
        <translation>compensation par l’instrument</translation>
    </message>
    <message>
        <source>The instrument&apos;s compensation was switched off.</source>
        <translation>La compensation de l’instrument était hors service.</translation>
    </message>
    <message>
        <source>temperature gradient over 12 h and its agreed limit</source>
        <translation>gradient de température sur 12&#xa0;h et sa limite convenue</translation>
    </message>
    <message>
        <source>The machine was not complete or not in working order.</source>
        <translation>Machine incomplète ou pas en ordre de marche.</translation>
    </message>
    <message>
        <source>levelling, alignment and functional checks</source>
        <translation>nivellement, alignement et contrôles fonctionnels</translation>
    </message>
    <message>
        <source>Levelling, alignment or functional checks were not done.</source>
        <translation>Nivellement, alignement ou contrôles fonctionnels non effectués.</translation>
    </message>
    <message>
        <source>The machine was loaded.</source>
        <comment>1988</comment>
        <translation>La machine était chargée.</translation>
    </message>
    <message>
        <source>warm-up: by whom specified</source>
        <translation>mise en température&#xa0;: prescrite par qui</translation>
    </message>
    <message>
        <source>Dry run without agreed warm-up: only set-up movements are allowed.</source>
        <translation>Essai à blanc sans mise en température convenue&#xa0;: seuls les déplacements de réglage sont admis.</translation>
    </message>
    <message>
        <source>rest at each target</source>
        <translation>repos à chaque point visé</translation>
    </message>
    <message>
        <source>No rest at the targets.</source>
        <translation>Pas de repos aux points visés.</translation>
    </message>
    <message>
        <source>agreed feed</source>
        <translation>vitesse d’avance convenue</translation>
    </message>
    <message>
        <source>Neither rapid nor at an agreed feed.</source>
        <translation>Ni vitesse rapide ni vitesse convenue.</translation>
    </message>
    <message>
        <source>choice of targets, cyclic pitch</source>
        <translation>choix des points visés, pas cyclique</translation>
    </message>
    <message>
        <source>position of the measuring device</source>
        <translation>position du dispositif de mesure</translation>
    </message>
    <message>
        <source>position of the temperature sensor, type of compensation</source>
        <translation>position du capteur de température, type de compensation</translation>
    </message>
    <message>
        <source>axis travel</source>
        <translation>longueur d’axe</translation>
    </message>
    <message>
        <source>elements of the measuring device</source>
        <translation>éléments du dispositif de mesure</translation>
    </message>
    <message>
        <source>agreed working zone</source>
        <translation>zone de travail normal convenue</translation>
    </message>
    <message>
        <source>No working zone was agreed.</source>
        <translation>Aucune zone de travail normal n’a été convenue.</translation>
    </message>
    <message>
        <source>continuous measuring device or not</source>
        <translation>dispositif à échelle continue ou non</translation>
    </message>
    <message>
        <source>Fewer than three further targets.</source>
        <translation>Moins de trois points visés supplémentaires.</translation>
    </message>
    <message>
        <source>number of faces</source>
        <translation>nombre de faces</translation>
    </message>
    <message>
        <source>nature of the measuring device</source>
        <translation>nature du dispositif de mesure</translation>
    </message>
    <message>
        <source>measurement uncertainty</source>
        <translation>incertitude de mesure</translation>
    </message>
    <message>
        <source>temperatures of machine and instrument</source>
        <translation>températures de la machine et de l’instrument</translation>
    </message>
    <message>
        <source>use of compensation</source>
        <translation>emploi de la compensation</translation>
    </message>
    <message>
        <source>levelling and alignment</source>
        <translation>nivellement et alignement</translation>
    </message>
    <message>
        <source>Levelling or alignment was not done.</source>
        <translation>Nivellement ou alignement non effectué.</translation>
    </message>
    <message>
        <source>The machine was loaded.</source>
        <translation>La machine n’était pas à vide.</translation>
    </message>
    <message>
        <source>The feed between targets was not agreed.</source>
        <translation>Vitesse entre points visés non convenue.</translation>
    </message>
    <message>
        <source>position of the temperature sensors, expansion coefficients</source>
        <translation>position des capteurs de température, coefficients de dilatation</translation>
    </message>
    <message>
        <source>offset of the measuring line to the tool and workpiece reference</source>
        <translation>décalage de la ligne de mesurage par rapport aux références d’outil et de pièce</translation>
    </message>
    <message>
        <source>temperature of the air</source>
        <translation>température de l’air</translation>
    </message>
    <message>
        <source>location of the 2 m working zone</source>
        <translation>emplacement de la zone de travail normal de 2&#xa0;m</translation>
    </message>
    <message>
        <source>location of the working zone of 2 000 mm or 360°</source>
        <translation>emplacement de la zone de travail normal de 2&#x202f;000&#xa0;mm ou 360°</translation>
    </message>
    <message>
        <source>All targets have the same phase of the pitch %1.</source>
        <translation>Tous les points visés ont la même phase du pas %1.</translation>
    </message>
    <message>
        <source>Steps between targets from %1 to %2.</source>
        <translation>Intervalles de %1 à %2 entre points visés.</translation>
    </message>
    <message>
        <source>The axis goes on for %1 before the first target and %2 behind the last, more than two mean steps of %3.</source>
        <translation>L’axe continue sur %1 avant le premier point visé et sur %2 après le dernier, plus de deux intervalles moyens de %3.</translation>
    </message>
    <message>
        <source>The axis goes on for %1 beyond the first and the last target, more than four mean steps of %2.</source>
        <translation>L’axe continue sur %1 au-delà du premier et du dernier point visé, plus de quatre intervalles moyens de %2.</translation>
    </message>
    <message>
        <source>even spacing of the targets up to the ends of the axis</source>
        <translation>répartition régulière des points visés jusqu’aux extrémités de l’axe</translation>
    </message>
    <message>
        <source>The test covers %1 % of the travel of the axis.</source>
        <translation>L’essai couvre %1&#xa0;% de la course de l’axe.</translation>
    </message>
    <message>
        <source>%1: the limit is %2 times the value; is its unit right?</source>
        <translation>%1&#xa0;: la limite vaut %2 fois la valeur&#x202f;; l’unité est-elle bonne&#x202f;?</translation>
    </message>
    <message>
        <source>The air was at %1; 20 °C is asked for where it can be controlled.</source>
        <translation>Air à %1&#x202f;; 20&#xa0;°C exigés là où la température peut être réglée.</translation>
    </message>
    <message>
        <source>The instrument was re-centred between the runs.</source>
        <translation>L’instrument a été recentré entre les trajectoires.</translation>
    </message>
    <message>
        <source>Paths of rotary axes are outside the scope.</source>
        <translation>Les trajectoires d’axes rotatifs sont hors du domaine.</translation>
    </message>
    <message>
        <source>Other paths were measured between the two.</source>
        <translation>D’autres trajectoires ont été mesurées entre les deux.</translation>
    </message>
    <message>
        <source>Feed %1; %2 keeps the acceleration.</source>
        <translation>Avance %1&#x202f;; %2 conserve l’accélération.</translation>
    </message>
    <message>
        <source>levelling and functional checks</source>
        <translation>nivellement et contrôles fonctionnels</translation>
    </message>
    <message>
        <source>Levelling or functional checks were not done.</source>
        <translation>Nivellement ou contrôles fonctionnels non effectués.</translation>
    </message>
    <message>
        <source>calibrated reference length</source>
        <translation>longueur de référence étalonnée</translation>
    </message>
    <message>
        <source>what the evaluated range leaves out</source>
        <translation>ce que la plage évaluée laisse de côté</translation>
    </message>
    <message>
        <source>set-up error</source>
        <translation>erreur de réglage</translation>
    </message>
    <message>
        <source>test uncertainty</source>
        <translation>incertitude d’essai</translation>
    </message>
    <message>
        <source>name of the machine</source>
        <translation>nom de la machine</translation>
    </message>
    <message>
        <source>location of the measuring instrument</source>
        <translation>position de l’instrument de mesure</translation>
    </message>
    <message>
        <source>temperatures of machine, instrument and air</source>
        <translation>températures de la machine, de l’instrument et de l’air</translation>
    </message>
    <message>
        <source>type of compensation</source>
        <translation>type de compensation</translation>
    </message>
    <message>
        <source>load of the machine</source>
        <translation>charge de la machine</translation>
    </message>
    <message>
        <source>temperatures at start and end</source>
        <translation>températures au début et à la fin</translation>
    </message>
    <message>
        <source>what a temperature sensor measures</source>
        <translation>ce que mesure un capteur de température</translation>
    </message>
    <message>
        <source>end of validity of each calibration</source>
        <translation>fin de validité de chaque étalonnage</translation>
    </message>
    <message numerus="yes">
        <source>Accordance with %1 not shown: %n requirement(s) not declared</source>
        <translation>
            <numerusform>Conformité à %1 non établie&#xa0;: %n exigence non déclarée</numerusform>
            <numerusform>Conformité à %1 non établie&#xa0;: %n exigences non déclarées</numerusform>
        </translation>
    </message>
    <message>
        <source>Test carried out in accordance with %1</source>
        <translation>Essai exécuté conformément à %1</translation>
    </message>
    <message>
        <source>; step cycle by written agreement</source>
        <translation>&#x202f;; cycle en pas par accord écrit</translation>
    </message>
    <message>
        <source>(clauses 1 to 4.3.1 checked)</source>
        <translation>(articles 1 à 4.3.1 vérifiés)</translation>
    </message>
    <message>
        <source>(clauses 1 to 4.3.2 checked)</source>
        <translation>(articles 1 à 4.3.2 vérifiés)</translation>
    </message>
    <message numerus="yes">
        <source>%n not declared</source>
        <translation>
            <numerusform>%n non déclarée</numerusform>
            <numerusform>%n non déclarées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not declared</source>
        <comment>departures from practice</comment>
        <translation>
            <numerusform>%n non déclaré</numerusform>
            <numerusform>%n non déclarés</numerusform>
        </translation>
    </message>
    <message>
        <source>The text of %1 was not available: its requirements were not checked</source>
        <translation>Le texte de %1 n’était pas disponible&#xa0;: ses exigences n’ont pas été vérifiées</translation>
    </message>
    <message>
        <source>; no departure from practice found</source>
        <translation>&#x202f;; aucun écart à l’usage constaté</translation>
    </message>
    <message numerus="yes">
        <source>%n departure(s) from practice</source>
        <translation>
            <numerusform>%n écart à l’usage</numerusform>
            <numerusform>%n écarts à l’usage</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n required statement(s) missing</source>
        <translation>
            <numerusform>%n information requise manque</numerusform>
            <numerusform>%n informations requises manquent</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other required statement(s) missing</source>
        <translation>
            <numerusform>%n autre information requise manque</numerusform>
            <numerusform>%n autres informations requises manquent</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recommendation(s)</source>
        <translation>
            <numerusform>%n recommandation</numerusform>
            <numerusform>%n recommandations</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n note</numerusform>
            <numerusform>%n notes</numerusform>
        </translation>
    </message>
    <message>
        <source>Findings of the test in all: %1.</source>
        <translation>Constats de l’essai au total&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1: the requirements of clauses 1 to 4.3.1 are met; the rest of 4.3 and clauses 5 to 7 were not available and not checked; number of targets and approaches by practice</source>
        <translation>%1&#xa0;: exigences des articles 1 à 4.3.1 satisfaites&#x202f;; la suite de 4.3 et les articles 5 à 7, non disponibles, n’ont pas été vérifiés&#x202f;; nombre de points visés et d’approches selon l’usage</translation>
    </message>
    <message>
        <source>%1: the requirements of clauses 1 to 4.3.2 are met; the rest of 4.3 and clauses 5 to 7 were not available and not checked</source>
        <translation>%1&#xa0;: exigences des articles 1 à 4.3.2 satisfaites&#x202f;; la suite de 4.3 et les articles 5 à 7, non disponibles, n’ont pas été vérifiés</translation>
    </message>
    <message>
        <source>; the laboratory declares the rest met (%1)</source>
        <translation>&#x202f;; le laboratoire déclare le reste satisfait (%1)</translation>
    </message>
    <message>
        <source>text of the edition not available</source>
        <translation>texte de l’édition non disponible</translation>
    </message>
    <message>
        <source>accordance not shown</source>
        <translation>conformité non établie</translation>
    </message>
    <message>
        <source>in accordance in part</source>
        <translation>conforme en partie</translation>
    </message>
    <message>
        <source>In accordance: %1</source>
        <translation>Conformes à leur édition&#xa0;: %1</translation>
    </message>
    <message>
        <source>; in part: %1</source>
        <translation>&#x202f;; en partie&#xa0;: %1</translation>
    </message>
    <message>
        <source>; not shown: %1</source>
        <translation>&#x202f;; non établi&#xa0;: %1</translation>
    </message>
    <message>
        <source>; not: %1</source>
        <translation>&#x202f;; non conformes&#xa0;: %1</translation>
    </message>
    <message>
        <source>; not checked: %1</source>
        <translation>&#x202f;; non vérifiés&#xa0;: %1</translation>
    </message>
    <message>
        <source>not declared</source>
        <translation>non déclaré</translation>
    </message>
    <message>
        <source>Asked by the text of %1</source>
        <translation>Demandé par le texte de %1</translation>
    </message>
    <message>
        <source>Practice (text not available)</source>
        <translation>Usage (texte non disponible)</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <comment>source of findings</comment>
        <translation>Laboratoire</translation>
    </message>
    <message>
        <source>Foreword %1</source>
        <translation>Avant-propos %1</translation>
    </message>
    <message>
        <source>Table %1</source>
        <translation>Tableau %1</translation>
    </message>
    <message>
        <source>expected one of machine, instrument, laboratory, limits and conditions, not two</source>
        <translation>un seul attendu parmi machine, instrument, laboratory, limits et conditions, pas deux</translation>
    </message>
    <message>
        <source>No sensor is of the air: no gradient per hour.</source>
        <translation>Aucun capteur ne mesure l’air&#xa0;: pas de gradient horaire.</translation>
    </message>
    <message>
        <source>%1: the guard band reaches the limit; no value can meet it.</source>
        <translation>%1&#xa0;: la bande de garde atteint la limite&#x202f;; aucune valeur ne peut la respecter.</translation>
    </message>
    <message>
        <source>%1: U is more than half the limit.</source>
        <translation>%1&#xa0;: U dépasse la moitié de la limite.</translation>
    </message>
    <message>
        <source>%1: the instrument&apos;s program states %2, here %3: edition, correction or readings differ.</source>
        <translation>%1&#xa0;: le programme de l’instrument indique %2, ici %3&#xa0;: édition, correction ou relevés diffèrent.</translation>
    </message>
    <message>
        <source>Purpose of the test not stated.</source>
        <translation>But de l’essai non indiqué.</translation>
    </message>
    <message>
        <source>As found or as left: not stated.</source>
        <translation>Avant ou après réglage&#xa0;: non indiqué.</translation>
    </message>
    <message>
        <source>Adjustments not stated.</source>
        <translation>Réglages non indiqués.</translation>
    </message>
    <message>
        <source>Calibration of %1 not valid on the date of the test.</source>
        <translation>Étalonnage non valide à la date de l’essai&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Dates contradict each other: %1, %2.</source>
        <translation>Dates contradictoires&#xa0;: %1, %2.</translation>
    </message>
    <message>
        <source>as the maker specifies</source>
        <translation>selon le constructeur</translation>
    </message>
    <message>
        <source>as agreed</source>
        <translation>comme convenu</translation>
    </message>
    <message>
        <source>polygon of %1 faces</source>
        <translation>polygone à %1 faces</translation>
    </message>
    <message>
        <source>switched on</source>
        <comment>compensation</comment>
        <translation>en service</translation>
    </message>
    <message>
        <source>switched off</source>
        <comment>compensation</comment>
        <translation>hors service</translation>
    </message>
    <message>
        <source>the instrument has none</source>
        <translation>l’instrument n’en a pas</translation>
    </message>
    <message>
        <source>type test</source>
        <translation>essai de type</translation>
    </message>
    <message>
        <source>acceptance</source>
        <comment>purpose</comment>
        <translation>réception</translation>
    </message>
    <message>
        <source>comparison</source>
        <comment>purpose</comment>
        <translation>comparaison</translation>
    </message>
    <message>
        <source>periodic check</source>
        <translation>vérification périodique</translation>
    </message>
    <message>
        <source>compensation</source>
        <comment>purpose</comment>
        <translation>mesures pour la compensation</translation>
    </message>
    <message>
        <source>after repair</source>
        <translation>après réparation</translation>
    </message>
    <message>
        <source>after collision</source>
        <translation>après collision</translation>
    </message>
    <message>
        <source>other purpose</source>
        <translation>autre but</translation>
    </message>
    <message>
        <source>Purpose of the test</source>
        <translation>But de l’essai</translation>
    </message>
    <message>
        <source>Room temperature</source>
        <translation>Température du local</translation>
    </message>
    <message>
        <source>can be controlled</source>
        <translation>réglable</translation>
    </message>
    <message>
        <source>cannot be controlled</source>
        <translation>non réglable</translation>
    </message>
    <message>
        <source>Before the test</source>
        <translation>Avant l’essai</translation>
    </message>
    <message>
        <source>machine and instruments thermally stable</source>
        <translation>machine et instruments stabilisés thermiquement</translation>
    </message>
    <message>
        <source>machine or instruments not thermally stable</source>
        <translation>machine ou instruments non stabilisés thermiquement</translation>
    </message>
    <message>
        <source>Compensation by the instrument</source>
        <translation>Compensation par l’instrument</translation>
    </message>
    <message>
        <source>Element of the scale</source>
        <translation>Élément de la règle</translation>
    </message>
    <message>
        <source>continuous</source>
        <comment>scale</comment>
        <translation>règle continue</translation>
    </message>
    <message>
        <source>over the %1 h before the test and during it</source>
        <translation>sur les %1&#xa0;h avant l’essai et pendant celui-ci</translation>
    </message>
    <message>
        <source>diameter %1</source>
        <translation>diamètre %1</translation>
    </message>
    <message>
        <source>feed %1</source>
        <comment>contouring</comment>
        <translation>avance %1</translation>
    </message>
    <message>
        <source>Specified circle</source>
        <translation>Cercle spécifié</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Partie non évaluée</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Règle</translation>
    </message>
    <message>
        <source>that of ISO 230-2:2006: ISO 230-2:1988 has none for an unknown or long cyclic pitch</source>
        <translation>celle de l’ISO 230-2:2006&#xa0;: l’ISO 230-2:1988 n’en a pas pour un pas cyclique inconnu ou long</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>avant réglage</translation>
    </message>
    <message>
        <source>as left</source>
        <translation>après réglage</translation>
    </message>
    <message>
        <source>for information, not part of the verdict</source>
        <translation>pour information, hors verdict</translation>
    </message>
    <message>
        <source>limits not proven</source>
        <translation>respect&#xa0;des&#xa0;limites non&#xa0;prouvé</translation>
    </message>
    <message>
        <source>limits exceeded</source>
        <translation>limites dépassées</translation>
    </message>
    <message>
        <source>test not checked</source>
        <translation>essai non vérifié</translation>
    </message>
    <message>
        <source>limits met</source>
        <translation>limites respectées</translation>
    </message>
    <message>
        <source>Calibration due</source>
        <translation>Fin de validité de l’étalonnage</translation>
    </message>
    <message>
        <source>The day the calibration ends. A test made after it is noted.</source>
        <translation>Le jour où l’étalonnage cesse d’être valide. Un essai fait après ce jour est signalé.</translation>
    </message>
    <message>
        <source>Length of one element of the axis&apos;s measuring device; 0: continuous. A long axis has a target in each element, of a continuous one every 250 mm.</source>
        <translation>Longueur d’un élément du dispositif de mesure de l’axe&#x202f;; 0&#xa0;: continu. Un axe long a un point visé dans chaque élément, un dispositif continu en a un tous les 250&#xa0;mm.</translation>
    </message>
    <message>
        <source>Faces of the polygon</source>
        <translation>Faces du polygone</translation>
    </message>
    <message>
        <source>How many faces the polygon has: as many targets are asked for.</source>
        <translation>Nombre de faces du polygone&#xa0;: il faut autant de points visés.</translation>
    </message>
    <message>
        <source>Continuous measuring device</source>
        <translation>Dispositif à échelle continue</translation>
    </message>
    <message>
        <source>Whether a rotary device with a continuous scale of suitable accuracy was at hand: then three further targets are chosen freely.</source>
        <translation>Si un dispositif rotatif à échelle continue d’exactitude suffisante était disponible&#xa0;: trois points visés de plus sont alors choisis librement.</translation>
    </message>
    <message>
        <source>Acceptance, periodic check, comparison, … The step cycle is no reference for acceptance.</source>
        <translation>Réception, vérification périodique, comparaison, … Le cycle en pas n’est pas une référence pour la réception.</translation>
    </message>
    <message>
        <source>As found or as left</source>
        <translation>Avant ou après réglage</translation>
    </message>
    <message>
        <source>Before or after an adjustment. The verdict of the report rests on all tests except those as found.</source>
        <translation>Avant ou après un réglage. Le verdict du rapport repose sur tous les essais sauf ceux faits avant réglage.</translation>
    </message>
    <message>
        <source>What was on the machine during the test; none is a statement.</source>
        <translation>Ce qui se trouvait sur la machine pendant l’essai&#x202f;; «&#xa0;aucune&#xa0;» est une indication.</translation>
    </message>
    <message>
        <source>Measuring device</source>
        <translation>Dispositif de mesure</translation>
    </message>
    <message>
        <source>Where the measuring device stood, in words; both offsets complete say it as well.</source>
        <translation>Où se trouvait le dispositif de mesure, en toutes lettres&#x202f;; les deux décalages complets le disent aussi.</translation>
    </message>
    <message>
        <source>Room temperature can be controlled</source>
        <translation>Température de la salle réglable</translation>
    </message>
    <message>
        <source>Where it can, 20 °C are asked for (1988: ± 0.5 °C; the same bound is taken for circles, whose text has none).</source>
        <translation>Si elle l’est, 20&#xa0;°C sont exigés (1988&#xa0;: ±&#xa0;0,5&#xa0;°C&#x202f;; la même borne est prise pour les cercles, dont le texte n’en a pas).</translation>
    </message>
    <message>
        <source>Thermally stable before the test</source>
        <translation>Stabilité thermique avant l’essai</translation>
    </message>
    <message>
        <source>Machine and instruments were long enough in their environment to be thermally stable.</source>
        <translation>La machine et les instruments étaient dans leur environnement depuis assez longtemps pour être stabilisés thermiquement.</translation>
    </message>
    <message>
        <source>Soaking time</source>
        <translation>Durée de stabilisation</translation>
    </message>
    <message>
        <source>How long machine and instruments stood in their environment before the test: 12 h. Whether that made them stable is declared beside it.</source>
        <translation>Depuis combien de temps la machine et les instruments se trouvaient dans leur environnement avant l’essai&#xa0;: 12&#xa0;h. La stabilité qui en résulte se déclare à côté.</translation>
    </message>
    <message>
        <source>Shielded from draughts and radiation</source>
        <translation>À l’abri des courants d’air et du rayonnement</translation>
    </message>
    <message>
        <source>Machine and instruments were protected from draughts and from radiation, of the sun or of heaters.</source>
        <translation>La machine et les instruments étaient protégés des courants d’air et du rayonnement, du soleil ou de chauffages.</translation>
    </message>
    <message>
        <source>Whether the instrument&apos;s compensation for the air and the machine&apos;s temperature was switched on; nothing is asked of one that has none.</source>
        <translation>Si la compensation de l’instrument pour l’air et la température de la machine était en service&#x202f;; rien n’est demandé à un instrument qui n’en a pas.</translation>
    </message>
    <message>
        <source>Gradient: hours before the test</source>
        <translation>Gradient&#xa0;: heures avant l’essai</translation>
    </message>
    <message>
        <source>How many hours before the test the gradient covers: 12 are asked for.</source>
        <translation>Combien d’heures avant l’essai le gradient couvre&#xa0;: 12 sont exigées.</translation>
    </message>
    <message>
        <source>What the evaluated range leaves out</source>
        <translation>Ce que la plage évaluée laisse de côté</translation>
    </message>
    <message>
        <source>Feed-in, feed-out, overshoot: all other points of the path are to be used.</source>
        <translation>Entrée, sortie, dépassement&#xa0;: tous les autres points de la trajectoire sont à utiliser.</translation>
    </message>
    <message>
        <source>Whether the reference length of the instrument is calibrated: F and D need it.</source>
        <translation>Si la longueur de référence de l’instrument est étalonnée&#xa0;: F et D en ont besoin.</translation>
    </message>
    <message>
        <source>Set-up error</source>
        <translation>Erreur de réglage</translation>
    </message>
    <message>
        <source>Standard uncertainty of the centring; of an arc F contains the set-up error.</source>
        <translation>Incertitude-type du centrage&#x202f;; le F d’un arc contient l’erreur de réglage.</translation>
    </message>
    <message>
        <source>U beside every result: by a budget, a simulation, or as the laboratory states it.</source>
        <translation>U à côté de chaque résultat&#xa0;: par un budget, une simulation, ou indiquée par le laboratoire.</translation>
    </message>
    <message>
        <source>the results (results.json) that the report carried are missing</source>
        <translation>les résultats (results.json) que portait le rapport manquent</translation>
    </message>
    <message>
        <source>the results (results.json) are written in another form</source>
        <translation>les résultats (results.json) sont écrits sous une autre forme</translation>
    </message>
    <message>
        <source>the results (results.json) cannot be read</source>
        <translation>les résultats (results.json) sont illisibles</translation>
    </message>
    <message>
        <source>this PDF is damaged and cannot be read; ask for it again where it came from</source>
        <translation>ce PDF est endommagé et illisible&#x202f;; redemandez-le à son expéditeur</translation>
    </message>
    <message>
        <source>this PDF is no report of Palmer with its test file inside: there is nothing to open or to verify</source>
        <translation>ce PDF n’est pas un rapport de Palmer avec son fichier d’essai&#xa0;: il n’y a rien à ouvrir ni à vérifier</translation>
    </message>
    <message>
        <source>this PDF is encrypted; save it without password and open that</source>
        <translation>ce PDF est chiffré&#x202f;; enregistrez-le sans mot de passe et ouvrez cette copie</translation>
    </message>
    <message>
        <source>this PDF carries more than one test file, and which of them the report was made from is not known</source>
        <translation>ce PDF contient plusieurs fichiers d’essai, et on ne sait pas duquel le rapport est issu</translation>
    </message>
    <message>
        <source>this PDF unpacks to more than %1 MiB and is not read</source>
        <translation>ce PDF dépasse %1&#xa0;Mio une fois décompressé et n’est pas lu</translation>
    </message>
    <message>
        <source>valid</source>
        <translation>valable</translation>
    </message>
    <message>
        <source>NOT valid: changed after it was signed</source>
        <translation>NON valable&#xa0;: modifié après la signature</translation>
    </message>
    <message>
        <source>could not be checked</source>
        <translation>n’a pas pu être contrôlée</translation>
    </message>
    <message>
        <source>The numbers follow from the attached data. Where the data come from is not verified.</source>
        <translation>Les nombres découlent des données jointes. La provenance des données n’est pas vérifiée.</translation>
    </message>
    <message>
        <source>page %1: %2</source>
        <translation>page %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>what is said, and of what</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>printed “%1”, follows “%2”</source>
        <translation>imprimé «&#xa0;%1&#xa0;», découle «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>covers the whole file</source>
        <translation>couvre tout le fichier</translation>
    </message>
    <message>
        <source>does not cover the whole file: something was appended after it</source>
        <translation>ne couvre pas tout le fichier&#xa0;: quelque chose a été ajouté ensuite</translation>
    </message>
    <message>
        <source>certificate of an authority known here</source>
        <translation>certificat d’une autorité connue ici</translation>
    </message>
    <message>
        <source>certificate of no authority known here</source>
        <translation>certificat d’aucune autorité connue ici</translation>
    </message>
    <message>
        <source>Signature of %1, %2</source>
        <translation>Signature de %1, %2</translation>
    </message>
    <message>
        <source>The fingerprint on the pages is not that of the attached file.</source>
        <translation>L’empreinte imprimée sur les pages n’est pas celle du fichier joint.</translation>
    </message>
    <message>
        <source>… and %1 more; --json has them all</source>
        <translation>… et %1 de plus&#x202f;; --json les donne toutes</translation>
    </message>
    <message>
        <source>made by %1; fingerprint of the attached file %2</source>
        <translation>établi par %1&#x202f;; empreinte du fichier joint %2</translation>
    </message>
    <message>
        <source>The whole PDF is the same, byte for byte.</source>
        <translation>Le PDF entier est identique, octet par octet.</translation>
    </message>
    <message>
        <source>The PDF as it was made is unchanged; something was appended to it.</source>
        <translation>Le PDF tel qu’il a été établi est inchangé&#x202f;; quelque chose y a été ajouté.</translation>
    </message>
    <message>
        <source>The PDF was rewritten: texts, attached files and drawn pages are the same, the bytes are not.</source>
        <translation>Le PDF a été réécrit&#xa0;: ses textes, ses fichiers joints et l’aspect de ses pages sont les mêmes, mais non ses octets.</translation>
    </message>
    <message>
        <source>FILE is a test file (.palmer), a report of Palmer (PDF) or a measurement file that can be imported; - is standard input.</source>
        <translation>FILE est un fichier d’essai (.palmer), un rapport de Palmer (PDF) ou un fichier de mesure importable&#x202f;; - est l’entrée standard.</translation>
    </message>
    <message>
        <source>the test file inside the PDF keeps the bytes of the instrument files that it was imported from; without it only their names and fingerprints</source>
        <translation>le fichier d’essai joint au PDF garde le contenu des fichiers de l’instrument importés&#x202f;; sinon leurs noms et empreintes seulement</translation>
    </message>
    <message>
        <source>the outcome as JSON; of several files one object a line</source>
        <translation>le résultat en JSON&#x202f;; pour plusieurs fichiers, un objet par ligne</translation>
    </message>
    <message>
        <source>take the test file out of the report, byte for byte, and no more</source>
        <translation>extraire le fichier d’essai du rapport, octet par octet, sans plus</translation>
    </message>
    <message>
        <source>this is no PDF; a report of Palmer is verified</source>
        <translation>ce n’est pas un PDF&#x202f;; on vérifie un rapport de Palmer</translation>
    </message>
    <message>
        <source>the option --%1 takes one report</source>
        <translation>l’option --%1 prend un seul rapport</translation>
    </message>
    <message>
        <source>whether every printed number of a report follows from the test file inside it</source>
        <translation>si chaque nombre imprimé d’un rapport découle du fichier d’essai qu’il contient</translation>
    </message>
    <message>
        <source>a file was attached that the report did not carry</source>
        <translation>un fichier a été joint que le rapport ne portait pas</translation>
    </message>
    <message>
        <source>an annotation was put on the page</source>
        <translation>une annotation a été posée sur la page</translation>
    </message>
    <message>
        <source>a form field was put on the page</source>
        <translation>un champ de formulaire a été posé sur la page</translation>
    </message>
    <message>
        <source>the PDF does something that a report does not (action, layer, script)</source>
        <translation>le PDF fait ce qu’un rapport ne fait pas (action, calque, script)</translation>
    </message>
    <message>
        <source>pages of the PDF: %1; pages that follow from the data: %2</source>
        <translation>pages du PDF&#xa0;: %1&#x202f;; pages qui découlent des données&#xa0;: %2</translation>
    </message>
    <message>
        <source>the page has another size, or not all of it is shown</source>
        <translation>la page a un autre format, ou n’est pas montrée en entier</translation>
    </message>
    <message>
        <source>the page is drawn otherwise than it follows from the data</source>
        <translation>la page est dessinée autrement que ce qui découle des données</translation>
    </message>
    <message>
        <source>a signature covers what is printed</source>
        <translation>une signature recouvre ce qui est imprimé</translation>
    </message>
    <message>
        <source>a signature is not valid: the file was changed after it</source>
        <translation>une signature n’est pas valable&#xa0;: le fichier a été modifié ensuite</translation>
    </message>
    <message>
        <source>the attached test file has another name</source>
        <translation>le fichier d’essai joint porte un autre nom</translation>
    </message>
    <message>
        <source>the pages of this PDF cannot be read; ask for it again where it came from</source>
        <translation>les pages de ce PDF sont illisibles&#x202f;; redemandez-le à son expéditeur</translation>
    </message>
    <message>
        <source>the pages of this PDF have more than %1 drawing operators: too long to verify here</source>
        <translation>les pages de ce PDF comptent plus de %1 opérateurs graphiques&#xa0;: trop long à vérifier ici</translation>
    </message>
    <message numerus="yes">
        <source>%n difference(s): the report does not follow from the attached data.</source>
        <translation>
            <numerusform>%n écart&#xa0;: le rapport ne découle pas des données jointes.</numerusform>
            <numerusform>%n écarts&#xa0;: le rapport ne découle pas des données jointes.</numerusform>
        </translation>
    </message>
    <message>
        <source>the name of a file is empty</source>
        <translation>le nom d’un fichier est vide</translation>
    </message>
    <message>
        <source>the option %1 needs a value (%2)</source>
        <translation>l’option %1 demande une valeur (%2)</translation>
    </message>
    <message>
        <source>the option %1 takes no value</source>
        <translation>l’option %1 ne prend pas de valeur</translation>
    </message>
    <message>
        <source>the edition %1 may be one of these: %2</source>
        <translation>l’édition %1 peut être l’une de celles-ci&#xa0;: %2</translation>
    </message>
    <message>
        <source>there is no test in the file</source>
        <translation>le fichier ne contient aucun essai</translation>
    </message>
    <message>
        <source>not enough memory for this</source>
        <translation>mémoire insuffisante pour cette opération</translation>
    </message>
    <message>
        <source>palmer opens the window of Palmer: tests of machine tools, positioning of axes (ISO 230-2), circular tests (ISO 230-4).</source>
        <translation>palmer ouvre la fenêtre de Palmer&#xa0;: essais de machines-outils, positionnement des axes (ISO 230-2), essais de circularité (ISO 230-4).</translation>
    </message>
    <message>
        <source>palmer [FILE]…</source>
        <translation>palmer [FICHIER]…</translation>
    </message>
    <message>
        <source>unknown option %1; palmer --help lists them</source>
        <translation>option inconnue %1&#x202f;; palmer --help les énumère</translation>
    </message>
    <message>
        <source>no display is there to open a window on; palmer-cli works without one</source>
        <translation>aucun écran n’est disponible pour ouvrir une fenêtre&#x202f;; palmer-cli s’en passe</translation>
    </message>
    <message>
        <source>limit of %1: %2</source>
        <translation>limite de %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>(beyond the figure: %1)</source>
        <translation>(hors de la figure&#xa0;: %1)</translation>
    </message>
    <message>
        <source>limit beyond the scale: %1</source>
        <translation>limite hors de l’échelle&#xa0;: %1</translation>
    </message>
    <message>
        <source>limits beyond the scale: %1</source>
        <translation>limites hors de l’échelle&#xa0;: %1</translation>
    </message>
    <message>
        <source>reversal range (VDI: Umkehrspanne) at a position</source>
        <translation>réversibilité (VDI&#xa0;: Umkehrspanne) en une position</translation>
    </message>
    <message>
        <source>positional scatter (VDI: Positionsstreubreite) at a position</source>
        <translation>dispersion de position (VDI&#xa0;: Positionsstreubreite) en une position</translation>
    </message>
    <message>
        <source>in accordance with the edition</source>
        <translation>selon l’édition</translation>
    </message>
    <message>
        <source>Test</source>
        <comment>part of a verdict</comment>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Evaluated range</source>
        <translation>Étendue évaluée</translation>
    </message>
    <message>
        <source>Responsibility for the report</source>
        <translation>Responsabilité du rapport</translation>
    </message>
    <message>
        <source>Authorised by: name, function</source>
        <translation>Autorisé par&#xa0;: nom, fonction</translation>
    </message>
    <message>
        <source>n = 1: the means are the readings</source>
        <translation>n&#xa0;=&#xa0;1&#xa0;: les moyennes sont les relevés</translation>
    </message>
    <message>
        <source>bold: the value governing the axis parameter</source>
        <translation>en gras la valeur qui détermine le paramètre de l’axe</translation>
    </message>
    <message numerus="yes">
        <source>Summary of %n test(s)</source>
        <translation>
            <numerusform>Récapitulation de %n essai</numerusform>
            <numerusform>Récapitulation de %n essais</numerusform>
        </translation>
    </message>
    <message>
        <source>Dates of the tests</source>
        <translation>Dates des essais</translation>
    </message>
    <message>
        <source>Instruments</source>
        <translation>Instruments</translation>
    </message>
    <message>
        <source>about the centre of the set-up: with the set-up error</source>
        <translation>autour du centre de réglage&#xa0;: contient l’erreur de réglage</translation>
    </message>
    <message>
        <source>Limits</source>
        <comment>part of a verdict</comment>
        <translation>Limites</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sans limite</translation>
    </message>
    <message>
        <source>mean reversal value</source>
        <translation>valeur moyenne de réversibilité</translation>
    </message>
    <message>
        <source>mean reversal error</source>
        <translation>erreur moyenne de réversibilité</translation>
    </message>
    <message>
        <source>unidirectional accuracy</source>
        <comment>1988</comment>
        <translation>précision unidirectionnelle</translation>
    </message>
    <message>
        <source>Characters</source>
        <translation>Caractères</translation>
    </message>
    <message>
        <source>not in the font of the report: %1; drawn from another font where one is installed, else as boxes</source>
        <translation>absents de la police du rapport&#xa0;: %1&#x202f;; tracés avec une autre police s’il y en a une, sinon par des cases</translation>
    </message>
    <message>
        <source>As for test %1: %2.</source>
        <translation>Comme pour l’essai %1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>unidirectional accuracy</source>
        <translation>exactitude unidirectionnelle</translation>
    </message>
    <message>
        <source>unidirectional repeatability</source>
        <translation>répétabilité unidirectionnelle</translation>
    </message>
    <message>
        <source>%1 axis</source>
        <translation>Axe %1</translation>
    </message>
    <message>
        <source>%1 circle, R %2</source>
        <translation>Cercle %1, R %2</translation>
    </message>
    <message numerus="yes">
        <source>%n requirement(s) not met</source>
        <translation>
            <numerusform>%n exigence non satisfaite</numerusform>
            <numerusform>%n exigences non satisfaites</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n requirement(s) not declared</source>
        <translation>
            <numerusform>%n exigence non déclarée</numerusform>
            <numerusform>%n exigences non déclarées</numerusform>
        </translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Page</translation>
    </message>
    <message>
        <source>limit %1 not evaluable: %2</source>
        <translation>limite %1 non évaluable&#xa0;: %2</translation>
    </message>
    <message>
        <source>limit %1: %2</source>
        <translation>limite %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Adjustment:</source>
        <translation>Réglage&#xa0;:</translation>
    </message>
    <message>
        <source>1 limit</source>
        <translation>1 limite</translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 limits</source>
        <translation>
            <numerusform>%n limite sur %1</numerusform>
            <numerusform>%n limites sur %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Met: %n of %1 limits.</source>
        <translation>
            <numerusform>Respectée&#xa0;: %n limite sur %1.</numerusform>
            <numerusform>Respectées&#xa0;: %n limites sur %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>machine in its final condition, as left</source>
        <translation>machine dans l’état final, après réglage</translation>
    </message>
    <message>
        <source>in accordance with %1</source>
        <translation>selon %1</translation>
    </message>
    <message>
        <source>Tests</source>
        <comment>part of a verdict</comment>
        <translation>Essais</translation>
    </message>
    <message>
        <source>guard band about the limit</source>
        <translation>bande de garde autour de la limite</translation>
    </message>
    <message>
        <source>requirement not met</source>
        <translation>exigence non satisfaite</translation>
    </message>
    <message>
        <source>The verdict of the report is the worst of the verdicts of the tests.</source>
        <translation>Le verdict du rapport est le plus défavorable des verdicts des essais.</translation>
    </message>
    <message>
        <source>The verdict of the report is the worst of the verdicts of the tests in the final condition; test %1, as found, does not enter.</source>
        <translation>Le verdict du rapport est le plus défavorable des verdicts des essais dans l’état final&#x202f;; l’essai %1, avant réglage, n’y entre pas.</translation>
    </message>
    <message>
        <source>The verdict of the report is the worst of the verdicts of the tests in the final condition; tests %1, as found, do not enter.</source>
        <translation>Le verdict du rapport est le plus défavorable des verdicts des essais dans l’état final&#x202f;; les essais %1, avant réglage, n’y entrent pas.</translation>
    </message>
    <message>
        <source>Limited quantities</source>
        <translation>Grandeurs limitées</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <comment>enumeration</comment>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>met</source>
        <comment>a limit</comment>
        <translation>respectée</translation>
    </message>
    <message>
        <source>exceeded</source>
        <comment>a limit</comment>
        <translation>dépassée</translation>
    </message>
    <message>
        <source>none agreed</source>
        <comment>limits</comment>
        <translation>aucune convenue</translation>
    </message>
    <message>
        <source>met</source>
        <comment>limits</comment>
        <translation>respectées</translation>
    </message>
    <message>
        <source>not proven</source>
        <comment>limits</comment>
        <translation>respect non prouvé</translation>
    </message>
    <message>
        <source>exceeded</source>
        <comment>limits</comment>
        <translation>dépassées</translation>
    </message>
    <message>
        <source>unidirectional systematic deviation</source>
        <translation>écart systématique unidirectionnel</translation>
    </message>
    <message>
        <source>unidirectional systematic error</source>
        <translation>écart systématique unidirectionnel</translation>
    </message>
    <message>
        <source>“%1” is no path of a test file, as machine.name or tests[0].limits.A.value</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un chemin d’un fichier d’essai, comme machine.name ou tests[0].limits.A.value</translation>
    </message>
    <message>
        <source>%1 of what? Write %2 or %3</source>
        <translation>%1 de quoi&#x202f;? Écrivez %2 ou %3</translation>
    </message>
    <message>
        <source>the unit of “%1” does not fit here; write %2 or %3</source>
        <translation>l’unité de «&#xa0;%1&#xa0;» ne convient pas ici&#x202f;; écrivez %2 ou %3</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rôle</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>Accordance</source>
        <translation>Conformité à l’édition</translation>
    </message>
    <message>
        <source>in accordance</source>
        <translation>conforme à l’édition</translation>
    </message>
    <message>
        <source>findings as JSON; of several files one object a line</source>
        <translation>constats en JSON&#x202f;; pour plusieurs fichiers, un objet par ligne</translation>
    </message>
    <message>
        <source>one table of all files: a row per parameter with value, U, limit and both statements</source>
        <translation>un seul tableau pour tous les fichiers&#xa0;: une ligne par paramètre, avec valeur, U, limite et les deux énoncés</translation>
    </message>
    <message>
        <source>--%1 and --%2 do not go together</source>
        <translation>--%1 et --%2 s’excluent</translation>
    </message>
    <message>
        <source>which test of the file, from 1; without it all</source>
        <translation>essai du fichier, à partir de 1&#x202f;; par défaut tous</translation>
    </message>
    <message>
        <source>the command %1 takes a file and a parameter</source>
        <translation>la commande %1 prend un fichier et un paramètre</translation>
    </message>
    <message>
        <source>unknown parameter %1; known: %2</source>
        <translation>paramètre inconnu %1&#x202f;; connus&#xa0;: %2</translation>
    </message>
    <message>
        <source>Test %1</source>
        <translation>Essai %1</translation>
    </message>
    <message>
        <source>how a value follows from the readings: formula with the numbers put in, clause, ruling targets</source>
        <translation>comment une valeur découle des relevés&#xa0;: formule avec les nombres, paragraphe, points visés déterminants</translation>
    </message>
    <message>
        <source>the picture to write, or its points; the ending says which; of several files the folder they go into</source>
        <translation>l’image à écrire, ou ses points&#x202f;; l’extension l’indique&#x202f;; pour plusieurs fichiers, le dossier qui les reçoit</translation>
    </message>
    <message>
        <source>the pictures of several files go into a folder; choose their kind with --%1 svg, png, pdf or csv</source>
        <translation>les images de plusieurs fichiers vont dans un dossier&#x202f;; choisir leur type par --%1 svg, png, pdf ou csv</translation>
    </message>
    <message>
        <source>there is no test file or report in the folder</source>
        <translation>le dossier ne contient ni fichier d’essai ni rapport</translation>
    </message>
    <message>
        <source>the folder cannot be read</source>
        <translation>le dossier ne peut être lu</translation>
    </message>
    <message>
        <source>files worked on at a time; without it one per processor</source>
        <translation>nombre de fichiers traités à la fois&#x202f;; par défaut un par processeur</translation>
    </message>
    <message>
        <source>--name %1 leads out of the folder that -o names</source>
        <translation>--name %1 sort du dossier indiqué par -o</translation>
    </message>
    <message>
        <source>%1 and %2 would both be written as %3; call the command for each</source>
        <translation>%1 et %2 seraient tous deux écrits sous %3&#x202f;; appeler la commande pour chacun</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>le dossier %1 ne peut être créé</translation>
    </message>
    <message>
        <source>--set %1: %2</source>
        <translation>--set %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>take machine, instrument, laboratory, limits or conditions from a template; may stand several times</source>
        <translation>reprend machine, instrument, laboratoire, limites ou conditions d’un modèle&#x202f;; peut figurer plusieurs fois</translation>
    </message>
    <message>
        <source>editions to print side by side, without verdicts</source>
        <translation>éditions à imprimer côte à côte, sans verdict</translation>
    </message>
    <message>
        <source>the PDF to write; of two languages OUT.fr.pdf and OUT.en.pdf; of several files the folder they go into</source>
        <translation>le PDF à écrire&#x202f;; pour deux langues OUT.fr.pdf et OUT.en.pdf&#x202f;; pour plusieurs fichiers, le dossier qui les reçoit</translation>
    </message>
    <message>
        <source>the reports of several files go into a folder; %1 is none</source>
        <translation>les rapports de plusieurs fichiers vont dans un dossier&#x202f;; %1 n’en est pas un</translation>
    </message>
    <message>
        <source>as --json, always one object a line, of one file too</source>
        <translation>comme --json, toujours un objet par ligne, même pour un seul fichier</translation>
    </message>
    <message>
        <source>a choice of the import (unit=um, decimalMark=comma, axis=X, columns=target,run+,run-, …), or a field of the test file by its path (machine.name=DMU 50, limits.A.value=20um: of every test, tests[0].title=…), numbers with any unit that fits (500 mm, 2 m/min, 22.5 °C); may stand several times</source>
        <translation>un choix de l’import (unit=um, decimalMark=comma, axis=X, columns=target,run+,run-, …), ou un champ du fichier d’essai par son chemin (machine.name=DMU 50, limits.A.value=20um&#xa0;: de chaque essai, tests[0].title=…), les nombres avec toute unité qui convient (500&#xa0;mm, 2&#xa0;m/min, 22,5&#xa0;°C)&#x202f;; peut figurer plusieurs fois</translation>
    </message>
    <message>
        <source>%1 and %2 would both be written as %3; choose another name</source>
        <translation>%1 et %2 seraient tous deux écrits sous %3&#x202f;; choisir un autre nom</translation>
    </message>
    <message>
        <source>the work on this file broke off, perhaps for want of memory; try it alone</source>
        <translation>le traitement de ce fichier s’est interrompu, peut-être faute de mémoire&#x202f;; l’essayer seul</translation>
    </message>
    <message>
        <source>--set %1 is a choice of the import, and this is a test file; its fields have paths, as tests[0].title</source>
        <translation>--set %1 est un choix de l’import, et ceci est un fichier d’essai&#x202f;; ses champs ont des chemins, comme tests[0].title</translation>
    </message>
    <message>
        <source>this file is no register of tests and is left as it is; choose another name for the register</source>
        <translation>ce fichier n’est pas un registre d’essais et reste tel quel&#x202f;; choisir un autre nom pour le registre</translation>
    </message>
    <message>
        <source>the register cannot be read; check its permissions</source>
        <translation>le registre ne peut pas être lu&#x202f;; vérifier ses droits d’accès</translation>
    </message>
    <message>
        <source>the register is locked by another program; try again when it is done</source>
        <translation>le registre est verrouillé par un autre programme&#x202f;; réessayer quand celui-ci aura terminé</translation>
    </message>
    <message>
        <source>this is a folder; expected the file of a register</source>
        <translation>c’est un dossier&#x202f;; le fichier d’un registre est attendu</translation>
    </message>
    <message>
        <source>the folder of the register cannot be made</source>
        <translation>le dossier du registre ne peut pas être créé</translation>
    </message>
    <message>
        <source>the register cannot be opened; check the permissions of its folder</source>
        <translation>le registre ne peut pas être ouvert&#x202f;; vérifier les droits d’accès de son dossier</translation>
    </message>
    <message>
        <source>the address of a server reads postgresql://user@host:port/name</source>
        <translation>l’adresse d’un serveur s’écrit postgresql://utilisateur@hôte:port/nom</translation>
    </message>
    <message>
        <source>the server of the register does not answer, or refuses: %1</source>
        <translation>le serveur du registre ne répond pas ou refuse&#xa0;: %1</translation>
    </message>
    <message>
        <source>the driver %1 of Qt for this register is not installed</source>
        <translation>le pilote %1 de Qt pour ce registre n’est pas installé</translation>
    </message>
    <message>
        <source>the server of the register is gone; nothing is lost, scan again when it is back</source>
        <translation>le serveur du registre ne répond plus&#x202f;; rien n’est perdu, relancer le parcours quand il sera de retour</translation>
    </message>
    <message>
        <source>the register cannot be written, for want of space perhaps; what it held is unchanged: make room and scan again</source>
        <translation>le registre ne peut pas être écrit, faute de place peut-être&#x202f;; son contenu est inchangé&#xa0;: libérer de la place et relancer le parcours</translation>
    </message>
    <message>
        <source>the register cannot be written; check the permissions of its folder</source>
        <translation>le registre ne peut pas être écrit&#x202f;; vérifier les droits d’accès de son dossier</translation>
    </message>
    <message>
        <source>the file of the register is damaged; remove it and scan again, the test files hold everything</source>
        <translation>le fichier du registre est endommagé&#x202f;; le supprimer et relancer le parcours, les fichiers d’essai contiennent tout</translation>
    </message>
    <message>
        <source>the database of the register says: %1</source>
        <translation>message de la base de données du registre&#xa0;: %1</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>But</translation>
    </message>
    <message>
        <source>a newer version of Palmer made this register; use that one, or have the register made anew from the files (register scan --rebuild)</source>
        <translation>ce registre a été créé par une version plus récente de Palmer&#x202f;; utiliser celle-ci ou refaire le registre à partir des fichiers (register scan --rebuild)</translation>
    </message>
    <message>
        <source>adjustment</source>
        <comment>intervention</comment>
        <translation>réglage</translation>
    </message>
    <message>
        <source>compensation</source>
        <comment>intervention</comment>
        <translation>compensation</translation>
    </message>
    <message>
        <source>repair</source>
        <comment>intervention</comment>
        <translation>réparation</translation>
    </message>
    <message>
        <source>collision</source>
        <comment>intervention</comment>
        <translation>collision</translation>
    </message>
    <message>
        <source>feed %1</source>
        <translation>avance %1</translation>
    </message>
    <message>
        <source>no feed stated</source>
        <translation>avance non indiquée</translation>
    </message>
    <message>
        <source>travel or radius %1</source>
        <translation>course ou rayon %1</translation>
    </message>
    <message>
        <source>no targets</source>
        <translation>pas de points visés</translation>
    </message>
    <message>
        <source>correction to 20 °C: %1</source>
        <translation>correction à 20&#xa0;°C&#xa0;: %1</translation>
    </message>
    <message>
        <source>feedback signal</source>
        <translation>signal de retour</translation>
    </message>
    <message>
        <source>fewer than %1 tests since the last intervention</source>
        <translation>moins de %1 essais depuis la dernière intervention</translation>
    </message>
    <message>
        <source>no trend shown</source>
        <translation>pas de tendance</translation>
    </message>
    <message>
        <source>the bound is at the limit already</source>
        <translation>la borne est déjà à la limite</translation>
    </message>
    <message>
        <source>not before %1; nothing is said beyond</source>
        <translation>pas avant %1&#x202f;; rien n’est dit au-delà</translation>
    </message>
    <message>
        <source>not before %1</source>
        <translation>pas avant %1</translation>
    </message>
    <message>
        <source>Nothing is said beyond %1, twice the observed time.</source>
        <translation>Rien n’est dit après %1, le double de la durée observée.</translation>
    </message>
    <message>
        <source>A U is stated without its parts: it is taken as shared by the tests with the same instrument.</source>
        <translation>Une U est donnée sans ses composantes&#xa0;: elle est considérée comme commune aux essais faits avec le même instrument.</translation>
    </message>
    <message numerus="yes">
        <source>%n test(s) without a date are left out.</source>
        <translation>
            <numerusform>%n essai sans date n’est pas pris en compte.</numerusform>
            <numerusform>%n essais sans date ne sont pas pris en compte.</numerusform>
        </translation>
    </message>
    <message>
        <source>since</source>
        <translation>depuis</translation>
    </message>
    <message>
        <source>tests</source>
        <translation>essais</translation>
    </message>
    <message>
        <source>%1 in %2 years</source>
        <translation>%1 en %2 ans</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>pente</translation>
    </message>
    <message>
        <source>%1 %2/year, u %3</source>
        <translation>%1&#xa0;%2/an, u %3</translation>
    </message>
    <message>
        <source>line at the last test</source>
        <translation>droite au dernier essai</translation>
    </message>
    <message>
        <source>scatter s</source>
        <translation>dispersion s</translation>
    </message>
    <message>
        <source>%1: trend of %2, axis or plane %3</source>
        <translation>%1&#xa0;: tendance de %2, axe ou plan %3</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>Tendance</translation>
    </message>
    <message>
        <source>Another series: %1</source>
        <translation>Autre série&#xa0;: %1</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>ce fichier ou dossier n’existe pas</translation>
    </message>
    <message>
        <source>a register holds only names in UTF-8, and this one is not; rename it</source>
        <translation>un registre ne contient que des noms en UTF-8, et celui-ci n’en est pas un&#x202f;; le renommer</translation>
    </message>
    <message>
        <source>the register; without it that of the user</source>
        <translation>le registre&#x202f;; sans cette option, celui de l’utilisateur</translation>
    </message>
    <message>
        <source>list, trend, type: the axis, or the plane of circles</source>
        <translation>list, trend, type&#xa0;: l’axe, ou le plan des cercles</translation>
    </message>
    <message>
        <source>list: the kind of test</source>
        <translation>list&#xa0;: la nature de l’essai</translation>
    </message>
    <message>
        <source>list: tests from that day on (YYYY-MM-DD)</source>
        <translation>list&#xa0;: essais à partir de ce jour (AAAA-MM-JJ)</translation>
    </message>
    <message>
        <source>list: tests up to that day</source>
        <translation>list&#xa0;: essais jusqu’à ce jour</translation>
    </message>
    <message>
        <source>list: how the tests stand to their limits</source>
        <translation>list&#xa0;: situation des essais par rapport à leurs limites</translation>
    </message>
    <message>
        <source>list: tests after which another, or the certificate of an instrument, is due up to that day</source>
        <translation>list&#xa0;: essais après lesquels un autre essai, ou le certificat d’un instrument, arrive à échéance jusqu’à ce jour</translation>
    </message>
    <message>
        <source>list: months between tests, of machines that have no interval of their own</source>
        <translation>list&#xa0;: mois entre les essais, pour les machines sans périodicité propre</translation>
    </message>
    <message>
        <source>list: each of the words somewhere in names, title, date, edition, instruments or file</source>
        <translation>list&#xa0;: chacun des mots quelque part dans les noms, le titre, la date, l’édition, les instruments ou le fichier</translation>
    </message>
    <message>
        <source>list: for programs, a row per parameter</source>
        <translation>list&#xa0;: pour les programmes, une ligne par grandeur</translation>
    </message>
    <message>
        <source>list, trend, type, scan: as JSON, one object a line</source>
        <translation>list, trend, type, scan&#xa0;: en JSON, un objet par ligne</translation>
    </message>
    <message>
        <source>list: the files that cannot be read or are not found, with their reason</source>
        <translation>list&#xa0;: les fichiers illisibles ou introuvables, avec la raison</translation>
    </message>
    <message>
        <source>trend: the parameter; may stand several times; without it the main ones; type: the parameter</source>
        <translation>trend&#xa0;: la grandeur&#x202f;; peut être répétée&#x202f;; sans cette option, les principales&#x202f;; type&#xa0;: la grandeur</translation>
    </message>
    <message>
        <source>trend, type: all tests evaluated anew under one edition</source>
        <translation>trend, type&#xa0;: tous les essais évalués à nouveau selon une seule édition</translation>
    </message>
    <message>
        <source>scan: go on and scan again when something changes, until it is ended</source>
        <translation>scan&#xa0;: continuer et relancer le parcours à chaque changement, jusqu’à l’arrêt du programme</translation>
    </message>
    <message>
        <source>register scan needs a folder</source>
        <translation>register scan demande un dossier</translation>
    </message>
    <message>
        <source>the file is not found any more</source>
        <translation>le fichier est introuvable</translation>
    </message>
    <message>
        <source>not identified: no serial number</source>
        <translation>non identifiée&#xa0;: pas de numéro de série</translation>
    </message>
    <message>
        <source>register %1 takes no file</source>
        <translation>register %1 ne prend pas de fichier</translation>
    </message>
    <message>
        <source>no machine of the register is called “%1”</source>
        <translation>aucune machine du registre ne s’appelle «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>these tests have no parameter %1; they have: %2</source>
        <translation>ces essais n’ont pas de grandeur %1&#x202f;; ils ont&#xa0;: %2</translation>
    </message>
    <message>
        <source>the machine has no test of %1</source>
        <translation>la machine n’a pas d’essai de %1</translation>
    </message>
    <message>
        <source>History of %1</source>
        <translation>Historique&#xa0;: %1</translation>
    </message>
    <message>
        <source>a machine without name</source>
        <translation>machine sans nom</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Results over time, %1</source>
        <translation>Évolution des essais, %1</translation>
    </message>
    <message>
        <source>Results over time</source>
        <translation>Évolution des essais</translation>
    </message>
    <message>
        <source>Maker, type</source>
        <translation>Constructeur, type</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>synthetic path</source>
        <translation>tracé synthétique</translation>
    </message>
    <message>
        <source>measured, anticlockwise %1</source>
        <translation>mesuré, sens antihoraire %1</translation>
    </message>
    <message>
        <source>measured, clockwise %1</source>
        <translation>mesuré, sens horaire %1</translation>
    </message>
    <message>
        <source>Measured and synthetic path</source>
        <translation>Tracé mesuré et tracé synthétique</translation>
    </message>
    <message>
        <source>about the fitted centre and radius</source>
        <translation>autour du centre et du rayon ajustés</translation>
    </message>
    <message>
        <source>synthetic: %1</source>
        <translation>synthétique&#xa0;: %1</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Reste</translation>
    </message>
    <message>
        <source>rest</source>
        <comment>what no source explains</comment>
        <translation>reste</translation>
    </message>
    <message>
        <source>Spectrum of the rest</source>
        <translation>Spectre du reste</translation>
    </message>
    <message>
        <source>waves a turn</source>
        <translation>ondes par tour</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>amplitude</translation>
    </message>
    <message>
        <source>Circles at several feeds</source>
        <translation>Cercles à plusieurs avances</translation>
    </message>
    <message>
        <source>each about its own fitted centre</source>
        <translation>chacun autour de son propre centre ajusté</translation>
    </message>
    <message>
        <source>source 1</source>
        <translation>source 1</translation>
    </message>
    <message>
        <source>sources 1 to %1</source>
        <translation>sources 1 à %1</translation>
    </message>
    <message>
        <source>synthetic, %1</source>
        <comment>sources 1 to 4</comment>
        <translation>synthétique, %1</translation>
    </message>
    <message>
        <source>%1 per division</source>
        <translation>%1 par division</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustement</translation>
    </message>
    <message>
        <source>Senses</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>both together</source>
        <translation>les deux ensemble</translation>
    </message>
    <message>
        <source>Told apart</source>
        <translation>Séparés</translation>
    </message>
    <message>
        <source>Rest, std. deviation</source>
        <translation>Reste, écart-type</translation>
    </message>
    <message>
        <source>Fitted centre</source>
        <translation>Centre ajusté</translation>
    </message>
    <message>
        <source>Fitted radius</source>
        <translation>Rayon ajusté</translation>
    </message>
    <message>
        <source>What weighs</source>
        <translation>Ce qui pèse</translation>
    </message>
    <message>
        <source>No source stands out of the noise.</source>
        <translation>Aucune source ne dépasse le bruit.</translation>
    </message>
    <message>
        <source>Source 1 makes most of the path by itself.</source>
        <translation>La source 1 explique à elle seule l’essentiel du tracé.</translation>
    </message>
    <message>
        <source>Sources 1 to %1 make most of the path.</source>
        <translation>Les sources 1 à %1 expliquent l’essentiel du tracé.</translation>
    </message>
    <message>
        <source>%1, measured</source>
        <translation>%1, mesuré</translation>
    </message>
    <message>
        <source>%1 without them</source>
        <translation>%1 sans elles</translation>
    </message>
    <message>
        <source>The parts do not add up: they do not reach their maximum at the same angle.</source>
        <translation>Les parts ne s’additionnent pas&#xa0;: elles n’atteignent pas leur maximum au même angle.</translation>
    </message>
    <message>
        <source>Meaning, and what to look at on the machine</source>
        <translation>Sens, et que regarder sur la machine</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Sources</translation>
    </message>
    <message>
        <source>the part of %1 is what the source would make alone; bars from 0 to %2, full where traced</source>
        <translation>la part de %1 est ce que la source donnerait seule&#x202f;; barres de 0 à %2, pleines pour les sources tracées</translation>
    </message>
    <message>
        <source>Stated by the instrument’s program</source>
        <translation>Indiqué par le programme de l’instrument</translation>
    </message>
    <message>
        <source>Positive here means</source>
        <translation>Sens d’une valeur positive ici</translation>
    </message>
    <message>
        <source>Beside the instrument’s own diagnosis</source>
        <translation>À côté du diagnostic de l’instrument</translation>
    </message>
    <message>
        <source>its file states no sign convention: opposite signs throughout may mean the opposite one</source>
        <translation>son fichier n’indique pas de convention de signe&#xa0;: des signes tous opposés peuvent venir de la convention opposée</translation>
    </message>
    <message>
        <source>measured minus all sources, over the angle; colours as above</source>
        <translation>mesuré moins toutes les sources, selon l’angle&#x202f;; couleurs comme ci-dessus</translation>
    </message>
    <message>
        <source>The rest holds vibration, noise and what is none of these sources. Centre and radius, taken out before the path is drawn, have no part in G(b).</source>
        <translation>Le reste contient les vibrations, le bruit et ce qui n’est aucune de ces sources. Centre et rayon, retirés avant le tracé, n’ont pas d’effet sur G(b).</translation>
    </message>
    <message>
        <source>Diagnosis of the circle (interpretation)</source>
        <translation>Diagnostic du cercle (interprétation)</translation>
    </message>
    <message>
        <source>not a result of ISO 230-4</source>
        <translation>pas un résultat de l’ISO 230-4</translation>
    </message>
    <message>
        <source>The evaluated points are too few for a diagnosis.</source>
        <translation>Les points évalués sont trop peu nombreux pour un diagnostic.</translation>
    </message>
    <message>
        <source>These arcs tell the sum alone, not how it is shared out.</source>
        <translation>Ces arcs ne donnent que la somme, pas sa répartition.</translation>
    </message>
    <message>
        <source>A full circle in both senses tells more of them apart.</source>
        <translation>Un cercle complet dans les deux sens en sépare davantage.</translation>
    </message>
    <message>
        <source>These arcs do not tell it from: %1.</source>
        <translation>Ces arcs ne la distinguent pas de&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Condition</source>
        <comment>of a fit</comment>
        <translation>Conditionnement</translation>
    </message>
    <message>
        <source>source 1 alone</source>
        <translation>source 1 seule</translation>
    </message>
    <message>
        <source>sources 1 to %1 alone</source>
        <translation>sources 1 à %1 seules</translation>
    </message>
    <message>
        <source>%1 without it</source>
        <translation>%1 sans elle</translation>
    </message>
    <message>
        <source>one wave a turn is %1 Hz</source>
        <translation>une onde par tour fait %1 Hz</translation>
    </message>
    <message>
        <source>%1 is held against the limits of %2 and of %3, which are equal: its row shows that of %2.</source>
        <translation>%1 est comparé aux limites de %2 et de %3, qui sont égales&#xa0;: sa ligne montre celle de %2.</translation>
    </message>
    <message>
        <source>The Monte Carlo simulation that is to give the uncertainty cannot be run: it takes all results at once, and of some the budget lacks an input.</source>
        <translation>La simulation de Monte-Carlo qui doit donner l’incertitude ne peut pas être exécutée&#xa0;: elle porte sur tous les résultats à la fois, et il manque une donnée au budget de certains.</translation>
    </message>
    <message>
        <source>All tests</source>
        <translation>Tous les essais</translation>
    </message>
    <message>
        <source>Results ± U</source>
        <translation>Résultats ±&#xa0;U</translation>
    </message>
    <message>
        <source>as found; bar: ± U</source>
        <translation>avant réglage&#x202f;; barre&#xa0;: ±&#xa0;U</translation>
    </message>
    <message>
        <source>another series, not joined</source>
        <translation>autre série, non reliée</translation>
    </message>
    <message>
        <source>agreed limit</source>
        <translation>limite convenue</translation>
    </message>
    <message>
        <source>intervention</source>
        <translation>intervention</translation>
    </message>
    <message>
        <source>language of tables and errors; report: of the report, also both</source>
        <translation>langue des tableaux et des erreurs&#x202f;; report&#xa0;: du rapport, les deux aussi</translation>
    </message>
    <message>
        <source>this part of register needs --%1</source>
        <translation>cette partie de register demande --%1</translation>
    </message>
    <message>
        <source>a picture shows one parameter: choose it with --parameter</source>
        <translation>une image montre une seule grandeur&#xa0;: la choisir avec --parameter</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>parameter of an axis</comment>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>too few tests</source>
        <translation>trop peu d’essais</translation>
    </message>
    <message>
        <source>not before %1 *</source>
        <translation>pas avant %1 *</translation>
    </message>
    <message>
        <source>at the limit</source>
        <translation>à la limite</translation>
    </message>
    <message>
        <source>there is no register yet; palmer-cli register scan makes it</source>
        <translation>il n’y a pas encore de registre&#x202f;; palmer-cli register scan le crée</translation>
    </message>
    <message>
        <source>line, bounds of 95 %</source>
        <translation>droite, bornes à 95&#xa0;%</translation>
    </message>
    <message>
        <source>Test %1: %2</source>
        <translation>Essai&#xa0;%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>Périodicité</translation>
    </message>
    <message>
        <source>Made on</source>
        <translation>Établi le</translation>
    </message>
    <message>
        <source>To watch first</source>
        <translation>À surveiller d’abord</translation>
    </message>
    <message>
        <source>too few tests: nothing is said</source>
        <translation>trop peu d’essais&#xa0;: rien n’est affirmé</translation>
    </message>
    <message>
        <source>no limit within twice the observed time</source>
        <translation>aucune limite dans le double de la durée observée</translation>
    </message>
    <message>
        <source>%1 at the last test</source>
        <translation>%1 au dernier essai</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>Ensuite</translation>
    </message>
    <message>
        <source>Trends</source>
        <translation>Tendances</translation>
    </message>
    <message>
        <source>Campaigns</source>
        <translation>Campagnes</translation>
    </message>
    <message>
        <source>the first quantity of each axis; all are listed below</source>
        <translation>première grandeur de chaque axe&#x202f;; toutes figurent ci-dessous</translation>
    </message>
    <message>
        <source>Condition</source>
        <comment>of a test</comment>
        <translation>Conditions</translation>
    </message>
    <message>
        <source>Stated</source>
        <comment>condition</comment>
        <translation>Indication</translation>
    </message>
    <message>
        <source>Tests %1: %2</source>
        <translation>Essais&#xa0;%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>all</source>
        <comment>tests</comment>
        <translation>tous</translation>
    </message>
    <message>
        <source>Before and after adjustment</source>
        <translation>Avant et après réglage</translation>
    </message>
    <message>
        <source>c: factor of s</source>
        <translation>c&#xa0;: facteur de s</translation>
    </message>
    <message numerus="yes">
        <source>all readings are to be printed, on about %n more page(s): that takes time and memory; without “allReadings” under “include” the report says how many it leaves out</source>
        <translation>
            <numerusform>tous les relevés sont à imprimer, sur environ %n page de plus&#xa0;: cela demande du temps et de la mémoire&#x202f;; sans «&#xa0;allReadings&#xa0;» sous «&#xa0;include&#xa0;», le rapport dit combien il en omet</numerusform>
            <numerusform>tous les relevés sont à imprimer, sur environ %n pages de plus&#xa0;: cela demande du temps et de la mémoire&#x202f;; sans «&#xa0;allReadings&#xa0;» sous «&#xa0;include&#xa0;», le rapport dit combien il en omet</numerusform>
        </translation>
    </message>
    <message>
        <source>Not stated</source>
        <comment>conditions</comment>
        <translation>Non indiqué</translation>
    </message>
    <message>
        <source>a name to save to has to be UTF-8, and this one is not; choose another</source>
        <translation>un nom de fichier à écrire doit être en UTF-8, et celui-ci ne l’est pas&#x202f;; en choisir un autre</translation>
    </message>
    <message>
        <source>the option %1 stands twice; it takes one value</source>
        <translation>l’option %1 figure deux fois&#x202f;; elle prend une seule valeur</translation>
    </message>
    <message>
        <source>%1 has no effect here; it goes with: %2</source>
        <translation>%1 est sans effet ici&#x202f;; elle va avec&#xa0;: %2</translation>
    </message>
    <message>
        <source>no test of the file is of the kind of %1</source>
        <translation>aucun essai du fichier n’est du type de %1</translation>
    </message>
    <message>
        <source>the kind of picture; without it the ending of OUT says which</source>
        <translation>le type d’image&#x202f;; sans elle, c’est l’extension de OUT qui le dit</translation>
    </message>
    <message>
        <source>%1 says another kind of picture than --%2 %3</source>
        <translation>%1 dit un autre type d’image que --%2 %3</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>the choices of the import, for --set</source>
        <translation>les choix de l’import, pour --set</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a choice and its words</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Every other key is the path of a field of the test file, as its schema has it: machine.name, limits.A.value (of every test), tests[0].title. Limits, deviations and resolutions say their unit: 20um, 5arcsec. Other numbers may have any unit that fits: 500 mm, 2 m/min, 22.5 °C; without one they are in the unit of the file.</source>
        <translation>Toute autre clé est le chemin d’un champ du fichier d’essai, tel que le schéma le donne&#xa0;: machine.name, limits.A.value (de chaque essai), tests[0].title. Limites, écarts et résolutions disent leur unité&#xa0;: 20um, 5arcsec. Les autres nombres admettent toute unité qui convient&#xa0;: 500&#xa0;mm, 2&#xa0;m/min, 22,5&#xa0;°C&#x202f;; sans unité, ils sont dans celle du fichier.</translation>
    </message>
    <message>
        <source>there is no report in the folder</source>
        <translation>il n’y a pas de rapport dans le dossier</translation>
    </message>
    <message>
        <source>evaluate tests of machine tools and print the report</source>
        <translation>évaluer les essais de machines-outils et imprimer le rapport</translation>
    </message>
    <message>
        <source>SYNOPSIS</source>
        <comment>section of a manual page</comment>
        <translation>SYNOPSIS</translation>
    </message>
    <message>
        <source>DESCRIPTION</source>
        <comment>section of a manual page</comment>
        <translation>DESCRIPTION</translation>
    </message>
    <message>
        <source>COMMANDS</source>
        <comment>section of a manual page</comment>
        <translation>COMMANDES</translation>
    </message>
    <message>
        <source>KEYS OF --set</source>
        <comment>section of a manual page</comment>
        <translation>CLÉS DE --set</translation>
    </message>
    <message>
        <source>EXIT STATUS</source>
        <comment>section of a manual page</comment>
        <translation>CODE DE RETOUR</translation>
    </message>
    <message>
        <source>done</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>wrong usage</source>
        <translation>usage incorrect</translation>
    </message>
    <message>
        <source>a file cannot be read, written or understood</source>
        <translation>un fichier ne peut pas être lu, écrit ou compris</translation>
    </message>
    <message>
        <source>ENVIRONMENT</source>
        <comment>section of a manual page</comment>
        <translation>ENVIRONNEMENT</translation>
    </message>
    <message>
        <source>the language, French or English, without --language</source>
        <translation>la langue, français ou anglais, sans --language</translation>
    </message>
    <message>
        <source>columns of help and tables; without it those of the terminal</source>
        <translation>colonnes de l’aide et des tableaux&#x202f;; sans elle, celles du terminal</translation>
    </message>
    <message>
        <source>nothing is printed in colour, with it or without</source>
        <translation>rien n’est affiché en couleur, avec ou sans elle</translation>
    </message>
    <message>
        <source>SEE ALSO</source>
        <comment>section of a manual page</comment>
        <translation>VOIR AUSSI</translation>
    </message>
    <message>
        <source>%1 cannot be %2; expected %3</source>
        <translation>%1 ne peut être %2&#x202f;; attendu&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1 cannot be %2: the comma may stand before thousands or before decimals; write it without</source>
        <translation>%1 ne peut être %2&#xa0;: la virgule peut séparer les milliers ou les décimales&#x202f;; l’écrire sans</translation>
    </message>
    <message>
        <source>%1 cannot be %2; expected a number from %3 to %4</source>
        <translation>%1 ne peut être %2&#x202f;; attendu&#xa0;: un nombre de %3 à %4</translation>
    </message>
    <message>
        <source>%1 cannot be %2; expected a number greater than %3</source>
        <translation>%1 ne peut être %2&#x202f;; attendu&#xa0;: un nombre supérieur à %3</translation>
    </message>
    <message>
        <source>%1 cannot be %2; expected a whole number from %3 to %4</source>
        <translation>%1 ne peut être %2&#x202f;; attendu&#xa0;: un nombre entier de %3 à %4</translation>
    </message>
    <message>
        <source>--%1 has no effect here: no test of the file has a budget</source>
        <translation>--%1 est sans effet ici&#xa0;: aucun essai du fichier n’a de budget</translation>
    </message>
    <message>
        <source>--set %1 has no effect here: what is read has no such choice (--help KEYS lists all)</source>
        <translation>--set %1 est sans effet ici&#xa0;: ce qui est lu n’a pas ce choix (--help KEYS les donne tous)</translation>
    </message>
    <message>
        <source>--%1 has no effect here: this is a test file, which needs no choices of the import</source>
        <translation>--%1 est sans effet ici&#xa0;: c’est un fichier d’essai, qui n’a pas besoin des choix de l’import</translation>
    </message>
    <message>
        <source>NAME</source>
        <comment>section of a manual page</comment>
        <translation>NOM</translation>
    </message>
    <message>
        <source>FILE is a test file (.palmer), a report of Palmer (PDF) or a measurement file that can be imported. palmer-cli does the same work without a window.</source>
        <translation>FICHIER est un fichier d’essai (.palmer), un rapport de Palmer (PDF) ou un fichier de mesure qui peut être importé. palmer-cli fait le même travail sans fenêtre.</translation>
    </message>
    <message>
        <source>this is no PNG or SVG picture; the report is printed without it</source>
        <translation>ce n’est ni une image PNG ni une image SVG&#x202f;; le rapport est imprimé sans elle</translation>
    </message>
    <message>
        <source>The logo or the mark of the laboratory is no PNG or SVG picture: the report is printed without it.</source>
        <translation>Le logo ou la marque du laboratoire n’est pas une image PNG ou SVG&#xa0;: le rapport est imprimé sans cette image.</translation>
    </message>
    <message>
        <source>the device is full; save to a file or to another device</source>
        <translation>le périphérique est plein&#x202f;; enregistrer dans un fichier ou sur un autre périphérique</translation>
    </message>
    <message>
        <source>nobody reads from this pipe; start its reader first, or save to a file</source>
        <translation>personne ne lit ce tube&#x202f;; lancer d’abord son lecteur, ou enregistrer dans un fichier</translation>
    </message>
    <message>
        <source>the device could not be written, for want of permission or because it is none that takes a file; save to a file</source>
        <translation>l’écriture sur le périphérique a échoué, faute de droits ou parce qu’il ne peut recevoir de fichier&#x202f;; enregistrer dans un fichier</translation>
    </message>
    <message>
        <source>Results and verdicts follow from the attached data; other texts and pictures of %1 are not compared. Where the data come from is not verified.</source>
        <translation>Les résultats et les verdicts découlent des données jointes&#x202f;; les autres textes et les images de %1 ne sont pas comparés. La provenance des données n’est pas vérifiée.</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) that this version prints otherwise: not compared</source>
        <translation>
            <numerusform>%n endroit imprimé autrement par cette version&#xa0;: non comparé</numerusform>
            <numerusform>%n endroits imprimés autrement par cette version&#xa0;: non comparés</numerusform>
        </translation>
    </message>
    <message>
        <source>line %1 of what was pasted is no limit; expected a symbol and a number</source>
        <translation>la ligne %1 de ce qui a été collé n’est pas une limite&#x202f;; attendu&#xa0;: un symbole et un nombre</translation>
    </message>
    <message>
        <source>line %1 of what was pasted has several numbers; expected the limit alone</source>
        <translation>la ligne %1 de ce qui a été collé contient plusieurs nombres&#x202f;; attendu&#xa0;: la limite seule</translation>
    </message>
    <message>
        <source>line %1 of what was pasted begins with no symbol of this edition</source>
        <translation>la ligne %1 de ce qui a été collé ne commence par aucun symbole de cette édition</translation>
    </message>
    <message>
        <source>line %1 of what was pasted is one limit more than there are rows</source>
        <translation>la ligne %1 de ce qui a été collé est une limite de plus qu’il n’y a de lignes</translation>
    </message>
    <message>
        <source>the unit in line %1 of what was pasted is not one of this axis</source>
        <translation>l’unité de la ligne %1 de ce qui a été collé n’est pas une unité de cet axe</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>from one value to another</comment>
        <translation>de %1 à %2</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <comment>the differential expansion over a length</comment>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>unknown language %1; known: fr, en</source>
        <translation>langue inconnue %1&#x202f;; connues&#xa0;: fr, en</translation>
    </message>
    <message>
        <source>the diagnosis is printed only where “include” asks for it; take the word out of this list</source>
        <translation>le diagnostic n’est imprimé que si «&#xa0;include&#xa0;» le demande&#x202f;; retirez ce mot de la liste</translation>
    </message>
    <message>
        <source>the address of a server takes host=FOLDER and sslmode=disable, allow, prefer, require, verify-ca or verify-full after the question mark, and nothing else</source>
        <translation>après le point d’interrogation, l’adresse d’un serveur admet host=DOSSIER et sslmode=disable, allow, prefer, require, verify-ca ou verify-full, et rien d’autre</translation>
    </message>
    <message>
        <source>History %1</source>
        <translation>Historique %1</translation>
    </message>
    <message>
        <source>History No. %1</source>
        <translation>Historique n°&#xa0;%1</translation>
    </message>
    <message>
        <source>Tests: %1, campaigns: %2</source>
        <translation>Essais&#xa0;: %1, campagnes&#xa0;: %2</translation>
    </message>
    <message>
        <source>the part of G(b) is what the source would make alone, at the feed where that is most</source>
        <translation>la part de G(b) est ce que la source ferait seule, à l’avance où c’est le plus</translation>
    </message>
    <message>
        <source>all feeds together</source>
        <translation>toutes les avances ensemble</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Cercles</translation>
    </message>
    <message>
        <source>Each circle is drawn about its own fitted centre. What grows with the square of the feed is a lag; what stays is radius, scale or squareness.</source>
        <translation>Chaque cercle est tracé autour de son propre centre ajusté. Ce qui croît avec le carré de l’avance est un retard&#x202f;; ce qui demeure est rayon, échelle ou perpendicularité.</translation>
    </message>
    <message>
        <source>Diagnosis of plane %1 at several feeds (interpretation)</source>
        <translation>Diagnostic du plan %1 à plusieurs avances (interprétation)</translation>
    </message>
    <message>
        <source>report: the number of the history; without it one of year and serial number</source>
        <translation>report&#xa0;: le numéro de l’historique&#x202f;; sans lui, un numéro fait de l’année et du numéro de série</translation>
    </message>
    <message>
        <source>the number of a history has at most %1 characters</source>
        <translation>le numéro d’un historique a au plus %1 caractères</translation>
    </message>
    <message>
        <source>%1 * not reached within twice the observed time: nothing is said beyond.</source>
        <translation>%1 * non atteinte dans le double de la durée observée&#xa0;: rien n’est dit au-delà.</translation>
    </message>
    <message numerus="yes">
        <source>%n not met</source>
        <translation>
            <numerusform>%n non satisfaite</numerusform>
            <numerusform>%n non satisfaites</numerusform>
        </translation>
    </message>
    <message>
        <source>Folders</source>
        <translation>Dossiers</translation>
    </message>
    <message>
        <source>The register lists the tests of the files and reports in folders and below them. The files stay the only record: Palmer never writes into them, and the register can be made anew from them at any time.</source>
        <translation>Le registre recense les essais des fichiers et des rapports contenus dans des dossiers et leurs sous-dossiers. Les fichiers restent la seule preuve&#xa0;: Palmer n’y écrit jamais, et le registre peut en être refait à tout moment.</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>Machines</translation>
    </message>
    <message>
        <source>Compare curves</source>
        <translation>Comparer les courbes</translation>
    </message>
    <message>
        <source>Several chosen tests of one axis are laid over one another, with the difference of two on their common travel.</source>
        <translation>Plusieurs essais choisis d’un même axe sont superposés, avec la différence de deux d’entre eux sur leur course commune.</translation>
    </message>
    <message>
        <source>History report</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Prints what is to be watched first, the trends, the campaigns and all tests of a machine with their files.</source>
        <translation>Imprime ce qui est à surveiller d’abord, les tendances, les campagnes et tous les essais d’une machine avec leurs fichiers.</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Registre</translation>
    </message>
    <message>
        <source>Results and readings per target position</source>
        <translation>Résultats et relevés par point visé</translation>
    </message>
    <message>
        <source>With the actual targets: S = %1, otherwise as for test %2.</source>
        <translation>Avec les points réels&#xa0;: S = %1, pour le reste comme à l’essai %2.</translation>
    </message>
    <message>
        <source>Sense: no word says which column is clockwise; all are read as the angles run. A column can be given + (counterclockwise) or - (clockwise).</source>
        <translation>Sens&#xa0;: aucun mot ne dit quelle colonne est horaire&#x202f;; toutes sont lues dans le sens des angles. Une colonne peut recevoir + (antihoraire) ou - (horaire).</translation>
    </message>
    <message>
        <source>Columns: the headings name several tests (%1); those of “%2” are read, the others are tests of their own.</source>
        <translation>Colonnes&#xa0;: les titres nomment plusieurs essais (%1)&#x202f;; celles de «&#xa0;%2&#xa0;» sont lues, les autres forment des essais à part.</translation>
    </message>
    <message>
        <source>Columns: “%1” and “%2” are read as paths of one test.</source>
        <translation>Colonnes&#xa0;: «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» sont lues comme des trajectoires d’un même essai.</translation>
    </message>
    <message>
        <source>Angular overshoot: the points run over %1; all are evaluated.</source>
        <translation>Dépassement angulaire&#xa0;: les points couvrent %1&#x202f;; tous sont évalués.</translation>
    </message>
    <message>
        <source>Angular overshoot: %1 is stated, but the points run over %2; nothing is cut off.</source>
        <translation>Dépassement angulaire&#xa0;: %1 est indiqué, mais les points couvrent %2&#x202f;; rien n’est coupé.</translation>
    </message>
    <message>
        <source>Centre and nominal radius: those of the commanded positions, %1; %2 and %3.</source>
        <translation>Centre et rayon nominal&#xa0;: ceux des positions programmées, %1&#x202f;; %2 et %3.</translation>
    </message>
    <message>
        <source>Runs without readings: %1.</source>
        <translation>Passes sans relevé&#xa0;: %1.</translation>
    </message>
    <message>
        <source>the unit “%1” of the nominal length is not known; state the length in mm as nominalRadius</source>
        <translation>l’unité «&#xa0;%1&#xa0;» de la longueur nominale n’est pas connue&#x202f;; indiquer la longueur en mm par nominalRadius</translation>
    </message>
    <message>
        <source>Sign: the positions beside the deviations tell that these are target − actual; read so.</source>
        <translation>Signe&#xa0;: d’après les positions voisines, les écarts sont «&#xa0;visé − réel&#xa0;»&#x202f;; lus ainsi.</translation>
    </message>
    <message>
        <source>Sign: the file says “%1”; read as target − actual.</source>
        <translation>Signe&#xa0;: le fichier indique «&#xa0;%1&#xa0;»&#x202f;; lu comme «&#xa0;visé − réel&#xa0;».</translation>
    </message>
    <message>
        <source>Sign: the file says “%1”; read as actual − target.</source>
        <translation>Signe&#xa0;: le fichier indique «&#xa0;%1&#xa0;»&#x202f;; lu comme «&#xa0;réel − visé&#xa0;».</translation>
    </message>
    <message>
        <source>Layout: the targets of the block that begins here are others than those of the first block; it is read as runs of its own.</source>
        <translation>Disposition&#xa0;: les points visés du bloc qui commence ici ne sont pas ceux du premier bloc&#x202f;; il est lu comme des passes à part.</translation>
    </message>
    <message>
        <source>Layout: targets stand twice in a run; the readings there are read as runs of their own.</source>
        <translation>Disposition&#xa0;: des points visés figurent deux fois dans une passe&#x202f;; les relevés correspondants sont lus comme des passes à part.</translation>
    </message>
    <message>
        <source>Layout: the block that begins here does not say which runs it holds; it is read as further runs of the same test.</source>
        <translation>Disposition&#xa0;: le bloc qui commence ici ne dit pas quelles passes il contient&#x202f;; il est lu comme d’autres passes du même essai.</translation>
    </message>
    <message>
        <source>Order of the runs: that of their numbers, not that of the table.</source>
        <translation>Ordre des passes&#xa0;: celui de leurs numéros, non celui du tableau.</translation>
    </message>
    <message>
        <source>“%1” has another decimal mark than other numbers of the table, or thousands separators; write all with one decimal mark</source>
        <translation>«&#xa0;%1&#xa0;» a un autre séparateur décimal que d’autres nombres du tableau, ou des séparateurs de milliers&#x202f;; écrire tous les nombres avec un seul séparateur décimal</translation>
    </message>
    <message>
        <source>the values of its formulas are not in the file; open the workbook in a spreadsheet program and save it</source>
        <translation>les valeurs de ses formules ne figurent pas dans le fichier&#x202f;; ouvrir le classeur dans un tableur et l’enregistrer</translation>
    </message>
    <message>
        <source>the other way round than the file says</source>
        <translation>à l’inverse de ce qu’indique le fichier</translation>
    </message>
    <message>
        <source>Directions: %1 in their column is ↑, %2 is ↓, by the order of the targets.</source>
        <translation>Sens&#xa0;: %1 dans leur colonne désigne ↑ et %2 ↓, d’après l’ordre des points visés.</translation>
    </message>
    <message>
        <source>Directions: nothing says which of the entries in their column is ↑, or the order of the targets contradicts it; %1 is read as ↑, %2 as ↓.</source>
        <translation>Sens&#xa0;: rien ne dit laquelle des indications de leur colonne désigne ↑, ou l’ordre des points visés le contredit&#x202f;; %1 est lu comme ↑, %2 comme ↓.</translation>
    </message>
    <message>
        <source>Lines of one test</source>
        <translation>Lignes d’un seul essai</translation>
    </message>
    <message>
        <source>Lines: those of the table differ in “%1” (%2); those of “%3” are read, the others are a test of their own.</source>
        <translation>Lignes&#xa0;: celles du tableau diffèrent par «&#xa0;%1&#xa0;» (%2)&#x202f;; celles de «&#xa0;%3&#xa0;» sont lues, les autres forment un essai à part.</translation>
    </message>
    <message>
        <source>Columns: “%1” runs from %2 to %3; all readings are read as those of one test.</source>
        <translation>Colonnes&#xa0;: «&#xa0;%1&#xa0;» va de %2 à %3&#x202f;; tous les relevés sont lus comme ceux d’un seul essai.</translation>
    </message>
    <message>
        <source>Unit: “%1” does not say to which columns it belongs; say the unit of the readings.</source>
        <translation>Unité&#xa0;: «&#xa0;%1&#xa0;» ne dit pas à quelles colonnes ces unités appartiennent&#x202f;; indiquer l’unité des relevés.</translation>
    </message>
    <message>
        <source>Directions: “%1” names some, but is not read as the headings of the columns.</source>
        <translation>Sens&#xa0;: «&#xa0;%1&#xa0;» en nomme, mais n’est pas lu comme en-têtes des colonnes.</translation>
    </message>
    <message>
        <source>Columns: “%1” is headed as readings, but holds words; it is not read.</source>
        <translation>Colonnes&#xa0;: «&#xa0;%1&#xa0;» annonce des relevés, mais contient des mots&#x202f;; elle n’est pas lue.</translation>
    </message>
    <message>
        <source>The workbook has %1 sheets, several with rows of numbers; “%2” is read, the others are not.</source>
        <translation>Le classeur a %1 feuilles, dont plusieurs avec des lignes de nombres&#x202f;; «&#xa0;%2&#xa0;» est lue, les autres ne le sont pas.</translation>
    </message>
    <message>
        <source>a file of this name (%1) is a compensation table, perhaps cut off, and no measurement; if it is one, rename it, for example to .txt</source>
        <translation>un fichier de ce nom (%1) est une table de compensation, peut-être tronquée, et non une mesure&#x202f;; si c’en est bien une, le renommer, par exemple en .txt</translation>
    </message>
    <message>
        <source>read like the others</source>
        <translation>lire comme les autres</translation>
    </message>
    <message>
        <source>Hidden rows and columns</source>
        <translation>Lignes et colonnes masquées</translation>
    </message>
    <message>
        <source>Palmer is installed without its library for PDF files and workbooks, or with that of another version: install it again</source>
        <translation>Palmer est installé sans sa bibliothèque pour les fichiers PDF et les classeurs, ou avec celle d’une autre version&#xa0;: l’installer de nouveau</translation>
    </message>
    <message>
        <source>Columns: “%1” is headed as target positions, but holds none; it is not read.</source>
        <translation>Colonnes&#xa0;: «&#xa0;%1&#xa0;» annonce des points visés, mais n’en contient pas&#x202f;; elle n’est pas lue.</translation>
    </message>
    <message>
        <source>Unit: a line says “%1”, the headings %2; read in %2.</source>
        <translation>Unité&#xa0;: une ligne dit «&#xa0;%1&#xa0;», les en-têtes %2&#x202f;; lu en %2.</translation>
    </message>
    <message>
        <source>Unit: the heading “%1” names another unit than the cells of its column; read in %2, as the cells say.</source>
        <translation>Unité&#xa0;: l’en-tête «&#xa0;%1&#xa0;» n’indique pas la même unité que les cellules de sa colonne&#x202f;; celle des cellules est retenue, %2.</translation>
    </message>
    <message>
        <source>Unit: a number has none, where the others of its column have one; read in %1.</source>
        <translation>Unité&#xa0;: un nombre n’en porte pas, contrairement aux autres de sa colonne&#x202f;; lu en %1.</translation>
    </message>
    <message>
        <source>Columns: the readings behind “%1” are taken to stand at its positions.</source>
        <translation>Colonnes&#xa0;: les relevés qui suivent «&#xa0;%1&#xa0;» sont lus aux positions de cette colonne.</translation>
    </message>
    <message>
        <source>Correction C to 20 °C</source>
        <translation>Correction C à 20&#xa0;°C</translation>
    </message>
    <message>
        <source>%1 has these indexes for the second time; the line was not read.</source>
        <translation>%1 porte ces indices pour la deuxième fois&#x202f;; la ligne n’a pas été lue.</translation>
    </message>
    <message>
        <source>The lines are numbered %1 and then %2: some are missing, or one is there twice.</source>
        <translation>Les lignes passent du numéro %1 au numéro %2&#xa0;: il en manque, ou l’une d’elles est présente deux fois.</translation>
    </message>
    <message>
        <source>Columns: the lines end before “%1”; either nothing was entered there, or the headings do not stand above their columns.</source>
        <translation>Colonnes&#xa0;: les lignes s’arrêtent avant «&#xa0;%1&#xa0;»&#x202f;; soit rien n’y a été saisi, soit les titres ne sont pas au-dessus de leurs colonnes.</translation>
    </message>
    <message>
        <source>unidir. accuracy</source>
        <comment>1988</comment>
        <translation>précision unidir.</translation>
    </message>
    <message>
        <source>unidir. accuracy</source>
        <translation>exactitude unidir.</translation>
    </message>
    <message>
        <source>unidir. systematic dev.</source>
        <translation>écart syst. unidir.</translation>
    </message>
    <message>
        <source>unidir. systematic error</source>
        <translation>erreur syst. unidir.</translation>
    </message>
    <message>
        <source>unidir. repeatability</source>
        <translation>répétabilité unidir.</translation>
    </message>
    <message>
        <source>The results have no verdict.</source>
        <translation>Les résultats sont sans verdict.</translation>
    </message>
    <message>
        <source>The limit of %1 is negative; no value can meet it.</source>
        <translation>La limite de %1 est négative&#x202f;; aucune valeur ne peut la respecter.</translation>
    </message>
    <message>
        <source>Not seen: its 95 % interval contains zero.</source>
        <translation>Non décelé&#xa0;: son intervalle à 95&#xa0;% contient zéro.</translation>
    </message>
    <message>
        <source>The stated axis travel of %1 is contradicted by the targets, which lie over %2: this is judged.</source>
        <translation>La longueur d’axe indiquée de %1 est contredite par les points visés, qui s’étendent sur %2&#xa0;: c’est cette étendue qui est jugée.</translation>
    </message>
    <message>
        <source>The stated axis travel of %1 is contradicted by the stated ends of the axis, which lie %2 apart.</source>
        <translation>La longueur d’axe indiquée de %1 est contredite par les extrémités indiquées de l’axe, distantes de %2.</translation>
    </message>
    <message>
        <source>The stated ends of the axis are contradicted by targets beyond them.</source>
        <translation>Les extrémités indiquées de l’axe sont contredites par des points visés situés au-delà.</translation>
    </message>
    <message>
        <source>The path %1 has no measured points in the evaluated range.</source>
        <translation>La trajectoire %1 n’a aucun point mesuré dans l’étendue évaluée.</translation>
    </message>
    <message>
        <source>Of the path %1 too few points are evaluated (%2): bi-directional results need both senses.</source>
        <translation>Trop peu de points de la trajectoire %1 sont évalués (%2)&#xa0;: les résultats bidirectionnels demandent les deux sens.</translation>
    </message>
    <message>
        <source>title, author, bookmarks or texts for screen readers in the PDF are not those that follow from the data</source>
        <translation>le titre, l’auteur, les signets ou les textes pour lecteurs d’écran du PDF ne sont pas ceux qui découlent des données</translation>
    </message>
    <message>
        <source>No value for H: it needs full circles in both senses.</source>
        <translation>Pas de valeur pour H&#xa0;: il demande des cercles complets dans les deux sens.</translation>
    </message>
    <message>
        <source>The drift test “%1” gives no E_VE for this budget: none of its channels is that of the axis, or it has fewer than two readings.</source>
        <translation>L’essai de dérive «&#xa0;%1&#xa0;» ne donne pas d’E_VE à ce budget&#xa0;: aucune de ses voies n’est celle de l’axe, ou il a moins de deux relevés.</translation>
    </message>
    <message>
        <source>only one direction was measured: there is no compensation of each direction</source>
        <translation>un seul sens a été mesuré&#xa0;: pas de compensation par sens</translation>
    </message>
    <message>
        <source>Only the positive direction was measured: its values stand for the negative one, too.</source>
        <translation>Seul le sens positif a été mesuré&#xa0;: ses valeurs valent aussi pour le sens négatif.</translation>
    </message>
    <message>
        <source>Only the negative direction was measured: its values stand for the positive one, too.</source>
        <translation>Seul le sens négatif a été mesuré&#xa0;: ses valeurs valent aussi pour le sens positif.</translation>
    </message>
    <message>
        <source>Quarter turns</source>
        <translation>Quarts de tour</translation>
    </message>
    <message>
        <source>all multiples of 90° within the travel</source>
        <translation>tous les multiples de 90° compris dans la course</translation>
    </message>
    <message>
        <source>Further targets</source>
        <translation>Points visés supplémentaires</translation>
    </message>
    <message>
        <source>one in each %1 of the travel, at random</source>
        <translation>un par tranche de %1 de la course, au hasard</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>gon</source>
        <translation>gon</translation>
    </message>
    <message>
        <source>%1 cannot be %2 here: the file has its numbers in %3</source>
        <translation>%1 ne peut pas être %2 ici&#xa0;: les nombres du fichier sont en %3</translation>
    </message>
    <message>
        <source>Motion: the file holds angles and does not say of which axis; read as those of a rotary axis. Pitch and yaw of a linear axis are no positioning test.</source>
        <translation>Mouvement&#xa0;: le fichier contient des angles et ne dit pas de quel axe&#x202f;; lus comme ceux d’un axe de rotation. Le tangage et le lacet d’un axe linéaire ne sont pas un essai de positionnement.</translation>
    </message>
    <message>
        <source>Readings that differ from another at the same target in the same run: %1; the first was read.</source>
        <translation>Relevés qui diffèrent d’un autre au même point visé de la même passe&#xa0;: %1&#x202f;; le premier a été lu.</translation>
    </message>
    <message>
        <source>Unit: the file says %1 for the readings and %2 for the targets. Angles along a linear axis (pitch, yaw) are no positioning test; where a heading is wrong, say the unit.</source>
        <translation>Unité&#xa0;: le fichier indique %1 pour les relevés et %2 pour les points visés. Des angles le long d’un axe linéaire (tangage, lacet) ne sont pas un essai de positionnement&#x202f;; si un titre de colonne est faux, indiquer l’unité.</translation>
    </message>
    <message>
        <source>Unit of the positions: the file says “%1”, which cannot be read as it stands; say the unit of the numbers.</source>
        <translation>Unité des positions&#xa0;: le fichier indique «&#xa0;%1&#xa0;», qui ne peut être lu tel quel&#x202f;; indiquer l’unité des nombres.</translation>
    </message>
    <message>
        <source>Unit of the times: the file says “%1”, which cannot be read as it stands; say the unit of the numbers.</source>
        <translation>Unité des temps&#xa0;: le fichier indique «&#xa0;%1&#xa0;», qui ne peut être lu tel quel&#x202f;; indiquer l’unité des nombres.</translation>
    </message>
    <message>
        <source>Unit of the readings: the file says “%1”, which cannot be read as it stands; say the unit of the numbers.</source>
        <translation>Unité des relevés&#xa0;: le fichier indique «&#xa0;%1&#xa0;», qui ne peut être lu tel quel&#x202f;; indiquer l’unité des nombres.</translation>
    </message>
    <message>
        <source>Directions: the file says clockwise or counterclockwise, not which of them is positive; clockwise is read as ↑.</source>
        <translation>Sens&#xa0;: le fichier indique le sens horaire ou antihoraire, mais non lequel est positif&#x202f;; le sens horaire est lu comme ↑.</translation>
    </message>
    <message>
        <source>State: as left, as “%1” says.</source>
        <translation>État&#xa0;: après réglage, selon «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>State: as found, as “%1” says.</source>
        <translation>État&#xa0;: avant réglage, selon «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>Columns: “%1” is headed as directions, but its cells name none that is known; it is not read.</source>
        <translation>Colonnes&#xa0;: «&#xa0;%1&#xa0;» annonce des sens, mais ses cellules n’en nomment aucun de connu&#x202f;; elle n’est pas lue.</translation>
    </message>
    <message>
        <source>Directions: the file says “%1”; ↑ and ↓ are read as the runs are called.</source>
        <translation>Sens&#xa0;: le fichier dit «&#xa0;%1&#xa0;»&#x202f;; ↑ et ↓ sont lus selon le nom des passes.</translation>
    </message>
    <message>
        <source>as the file says, the points in the opposite order</source>
        <translation>selon le fichier, les points dans l’ordre inverse</translation>
    </message>
    <message>
        <source>as the angles run</source>
        <translation>dans l’ordre des angles</translation>
    </message>
    <message>
        <source>the angles count clockwise</source>
        <translation>les angles sont comptés dans le sens horaire</translation>
    </message>
    <message>
        <source>Columns: the headings do not say which holds the angles; “%1” is read as such.</source>
        <translation>Colonnes&#xa0;: les en-têtes ne disent pas laquelle contient les angles&#x202f;; «&#xa0;%1&#xa0;» est lue comme telle.</translation>
    </message>
    <message>
        <source>Sense: the file says “%1”; the points are read as their angles run.</source>
        <translation>Sens&#xa0;: le fichier dit «&#xa0;%1&#xa0;»&#x202f;; les points sont lus dans l’ordre de leurs angles.</translation>
    </message>
    <message>
        <source>Columns: “%1” says something else than “%2”, which is read.</source>
        <translation>Colonnes&#xa0;: «&#xa0;%1&#xa0;» dit autre chose que «&#xa0;%2&#xa0;», qui est lue.</translation>
    </message>
    <message>
        <source>Unit: the lines above the blocks of numbers name several; all are read in one.</source>
        <translation>Unité&#xa0;: les lignes au-dessus des blocs de nombres en nomment plusieurs&#x202f;; tous sont lus dans une seule.</translation>
    </message>
    <message>
        <source>Lines: those above the blocks of numbers name several tests (%1); the blocks of “%2” are read.</source>
        <translation>Lignes&#xa0;: celles au-dessus des blocs de nombres nomment plusieurs essais (%1)&#x202f;; les blocs de «&#xa0;%2&#xa0;» sont lus.</translation>
    </message>
    <message>
        <source>Columns that look like readings and are not read: %1.</source>
        <translation>Colonnes qui ressemblent à des relevés et ne sont pas lues&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Columns: “%1” is read as the heading of the columns without one behind it, too.</source>
        <translation>Colonnes&#xa0;: «&#xa0;%1&#xa0;» est lu aussi comme le titre des colonnes sans titre qui suivent.</translation>
    </message>
    <message>
        <source>“%1” has values that no room and no machine has: %2. Are the sensor and the unit right?</source>
        <translation>«&#xa0;%1&#xa0;» a des valeurs qu’aucun local ni aucune machine n’atteint&#xa0;: %2. Le capteur et l’unité sont-ils les bons&#x202f;?</translation>
    </message>
    <message>
        <source>Times: the lines are counted; they are %1 apart.</source>
        <translation>Temps&#xa0;: les lignes sont comptées, à %1 d’intervalle.</translation>
    </message>
    <message>
        <source>“%1” ends the table within a number: the file seems to be cut short.</source>
        <translation>«&#xa0;%1&#xa0;» termine le tableau au milieu d’un nombre&#xa0;: le fichier semble tronqué.</translation>
    </message>
    <message>
        <source>“%1” ends the table within a line: the file seems to be cut short.</source>
        <translation>«&#xa0;%1&#xa0;» termine le tableau au milieu d’une ligne&#xa0;: le fichier semble tronqué.</translation>
    </message>
    <message>
        <source>Line %1 says “%2”: are the readings right as they stand?</source>
        <translation>La ligne %1 dit «&#xa0;%2&#xa0;»&#xa0;: les relevés sont-ils justes tels quels&#x202f;?</translation>
    </message>
    <message>
        <source>Statements on the readings</source>
        <translation>Indications sur les relevés</translation>
    </message>
    <message>
        <source>Temperatures of a sensor</source>
        <translation>Températures d’un capteur</translation>
    </message>
    <message>
        <source>Temperatures in “%1” are not read, only those in °C, °F or K.</source>
        <translation>Les températures en «&#xa0;%1&#xa0;» ne sont pas lues, seulement celles en °C, °F ou K.</translation>
    </message>
    <message>
        <source>expected the number of a run, from 1 to %1</source>
        <translation>attendu&#xa0;: un numéro de passe de 1 à %1</translation>
    </message>
    <message>
        <source>expected the number of a target, from 1 to %1</source>
        <translation>attendu&#xa0;: un numéro de point visé de 1 à %1</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) without a number: without angles every point is needed</source>
        <translation>
            <numerusform>%n ligne sans nombre&#xa0;: sans angles, il faut tous les points</numerusform>
            <numerusform>%n lignes sans nombre&#xa0;: sans angles, il faut tous les points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>two targets are the same with %n decimal(s): %1</source>
        <translation>
            <numerusform>deux points visés sont les mêmes avec %n décimale&#xa0;: %1</numerusform>
            <numerusform>deux points visés sont les mêmes avec %n décimales&#xa0;: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Distribution of %1 in %n trial(s)</source>
        <translation>
            <numerusform>Répartition de %1 sur %n tirage</numerusform>
            <numerusform>Répartition de %1 sur %n tirages</numerusform>
        </translation>
    </message>
    <message>
        <source>Targets named in the head: %1, in the list: %2; the list counts.</source>
        <translation>Points visés annoncés dans l’en-tête&#xa0;: %1, dans la liste&#xa0;: %2&#x202f;; c’est la liste qui compte.</translation>
    </message>
    <message>
        <source>Cycles named in the head: %1, in the readings: %2; the readings count.</source>
        <translation>Cycles annoncés dans l’en-tête&#xa0;: %1, dans les relevés&#xa0;: %2&#x202f;; ce sont les relevés qui comptent.</translation>
    </message>
    <message>
        <source>targets named in the head: %1, in the list, in no order: %2: it is damaged</source>
        <translation>points visés annoncés dans l’en-tête&#xa0;: %1, dans la liste, en désordre&#xa0;: %2&#xa0;: elle est endommagée</translation>
    </message>
    <message>
        <source>Runs named in the head: %1, in the rows: %2; the rows count.</source>
        <translation>Passes annoncées dans l’en-tête&#xa0;: %1, dans les lignes&#xa0;: %2&#x202f;; ce sont les lignes qui comptent.</translation>
    </message>
    <message>
        <source>the file was cut off: samples announced: %1, there: %2</source>
        <translation>le fichier est tronqué&#xa0;: échantillons annoncés&#xa0;: %1, présents&#xa0;: %2</translation>
    </message>
    <message>
        <source>Samples announced in the head: %1, there: %2; those beyond were not read.</source>
        <translation>Échantillons annoncés dans l’en-tête&#xa0;: %1, présents&#xa0;: %2&#x202f;; les suivants n’ont pas été lus.</translation>
    </message>
    <message numerus="yes">
        <source>%1 names %n column(s), the table has %2</source>
        <translation>
            <numerusform>%1 nomme %n colonne, le tableau en a %2</numerusform>
            <numerusform>%1 nomme %n colonnes, le tableau en a %2</numerusform>
        </translation>
    </message>
    <message>
        <source>targets: %1, runs: %2: that is no positioning test; look at the kind and the columns</source>
        <translation>points visés&#xa0;: %1, passes&#xa0;: %2&#xa0;: ce n’est pas un essai de positionnement&#x202f;; vérifier la nature et les colonnes</translation>
    </message>
    <message numerus="yes">
        <source>Rows or columns of the sheet are hidden; what stands there is left out (%n number(s)).</source>
        <translation>
            <numerusform>Des lignes ou des colonnes de la feuille sont masquées&#x202f;; leur contenu n’est pas repris (%n nombre).</numerusform>
            <numerusform>Des lignes ou des colonnes de la feuille sont masquées&#x202f;; leur contenu n’est pas repris (%n nombres).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rows or columns of the sheet are hidden; what stands there is read like the rest (%n number(s)).</source>
        <translation>
            <numerusform>Des lignes ou des colonnes de la feuille sont masquées&#x202f;; leur contenu est lu comme le reste (%n nombre).</numerusform>
            <numerusform>Des lignes ou des colonnes de la feuille sont masquées&#x202f;; leur contenu est lu comme le reste (%n nombres).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The value(s) of %n formula(s) are not in the file and were not read; open the workbook in a spreadsheet program and save it.</source>
        <translation>
            <numerusform>La valeur de %n formule ne figure pas dans le fichier et n’a pas été lue&#x202f;; ouvrir le classeur dans un tableur et l’enregistrer.</numerusform>
            <numerusform>Les valeurs de %n formules ne figurent pas dans le fichier et n’ont pas été lues&#x202f;; ouvrir le classeur dans un tableur et l’enregistrer.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The Monte Carlo simulation has %n trial(s): fewer than %1 (JCGM 101, 7.2) never decide. The budget U is used for the verdict.</source>
        <translation>
            <numerusform>La simulation de Monte-Carlo compte %n tirage&#xa0;: moins de %1 (JCGM 101, 7.2) ne fondent jamais un verdict. Le verdict est fondé sur l’U du budget.</numerusform>
            <numerusform>La simulation de Monte-Carlo compte %n tirages&#xa0;: moins de %1 (JCGM 101, 7.2) ne fondent jamais un verdict. Le verdict est fondé sur l’U du budget.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The Monte Carlo simulation has %n trial(s): fewer than %1 (JCGM 101, 7.2) are shown and never decide.</source>
        <translation>
            <numerusform>La simulation de Monte-Carlo compte %n tirage&#xa0;: moins de %1 (JCGM 101, 7.2) sont affichés et ne fondent jamais un verdict.</numerusform>
            <numerusform>La simulation de Monte-Carlo compte %n tirages&#xa0;: moins de %1 (JCGM 101, 7.2) sont affichés et ne fondent jamais un verdict.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s) over %1: a long axis has a target in each element of its measuring system or every 250 mm.</source>
        <translation>
            <numerusform>%n point visé sur %1&#xa0;: un axe long a un point visé dans chaque élément de son système de mesure ou tous les 250&#xa0;mm.</numerusform>
            <numerusform>%n points visés sur %1&#xa0;: un axe long a un point visé dans chaque élément de son système de mesure ou tous les 250&#xa0;mm.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s) over %1: at least 5 per metre are required, %2 here.</source>
        <translation>
            <numerusform>%n point visé sur %1&#xa0;: au moins 5 par mètre sont exigés, soit %2 ici.</numerusform>
            <numerusform>%n points visés sur %1&#xa0;: au moins 5 par mètre sont exigés, soit %2 ici.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s) without any reading: %1.</source>
        <translation>
            <numerusform>%n point visé sans aucun relevé&#xa0;: %1.</numerusform>
            <numerusform>%n points visés sans aucun relevé&#xa0;: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s) over %1: practice asks for at least %2.</source>
        <translation>
            <numerusform>%n point visé sur %1&#xa0;: l’usage en demande au moins %2.</numerusform>
            <numerusform>%n points visés sur %1&#xa0;: l’usage en demande au moins %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s) over %1: practice asks for at least 8 per turn, up to 1 800°.</source>
        <translation>
            <numerusform>%n point visé sur %1&#xa0;: l’usage en demande au moins 8 par tour, jusqu’à 1&#x202f;800°.</numerusform>
            <numerusform>%n points visés sur %1&#xa0;: l’usage en demande au moins 8 par tour, jusqu’à 1&#x202f;800°.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n target(s), %1 faces.</source>
        <translation>
            <numerusform>%n point visé, %1 faces.</numerusform>
            <numerusform>%n points visés, %1 faces.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n month(s)</source>
        <translation>
            <numerusform>%n mois</numerusform>
            <numerusform>%n mois</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Mean over %n target(s): none rules it alone.</source>
        <translation>
            <numerusform>Moyenne sur %n point visé&#xa0;: aucun ne l’impose seul.</numerusform>
            <numerusform>Moyenne sur %n points visés&#xa0;: aucun ne l’impose seul.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n row(s), for a report prints no more than %1 of them unasked. The test file holds all readings. To print the rows as well, choose “All readings” for the report, or write “allReadings” under “include” in the test file.</source>
        <translation>
            <numerusform>Omise&#xa0;: %n ligne, car un rapport n’en imprime pas plus de %1 sans qu’on le demande. Le fichier d’essai contient tous les relevés. Pour imprimer aussi cette ligne, choisir «&#xa0;Tous les relevés&#xa0;» pour le rapport, ou écrire «&#xa0;allReadings&#xa0;» sous «&#xa0;include&#xa0;» dans le fichier d’essai.</numerusform>
            <numerusform>Omises&#xa0;: %n lignes, car un rapport n’en imprime pas plus de %1 sans qu’on le demande. Le fichier d’essai contient tous les relevés. Pour imprimer aussi ces lignes, choisir «&#xa0;Tous les relevés&#xa0;» pour le rapport, ou écrire «&#xa0;allReadings&#xa0;» sous «&#xa0;include&#xa0;» dans le fichier d’essai.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Monte Carlo: %n trial(s) of the whole evaluation, seed %1; U is half of the shortest interval that holds 95.45 % of the results, the shift their mean less the evaluated value.</source>
        <translation>
            <numerusform>Monte-Carlo&#xa0;: %n tirage de l’évaluation complète, germe %1&#x202f;; U est la moitié du plus court intervalle qui contient 95,45&#xa0;% des résultats, le décalage leur moyenne moins la valeur évaluée.</numerusform>
            <numerusform>Monte-Carlo&#xa0;: %n tirages de l’évaluation complète, germe %1&#x202f;; U est la moitié du plus court intervalle qui contient 95,45&#xa0;% des résultats, le décalage leur moyenne moins la valeur évaluée.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Monte Carlo: %n trial(s), seed %1, otherwise as for test %2.</source>
        <translation>
            <numerusform>Monte-Carlo&#xa0;: %n tirage, germe %1, pour le reste comme à l’essai %2.</numerusform>
            <numerusform>Monte-Carlo&#xa0;: %n tirages, germe %1, pour le reste comme à l’essai %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Files: %1, of them read now: %2, unreadable: %3, not found: %4. Machines in the register: %5, tests: %6.</source>
        <translation>Fichiers&#xa0;: %1, dont lus maintenant&#xa0;: %2, illisibles&#xa0;: %3, introuvables&#xa0;: %4. Machines dans le registre&#xa0;: %5, essais&#xa0;: %6.</translation>
    </message>
    <message>
        <source>temperatures at the start</source>
        <translation>températures au début</translation>
    </message>
    <message>
        <source>temperatures at the end</source>
        <translation>températures à la fin</translation>
    </message>
    <message>
        <source>coefficient of thermal expansion of the machine</source>
        <translation>coefficient de dilatation thermique de la machine</translation>
    </message>
    <message>
        <source>coefficient of thermal expansion of the instrument</source>
        <translation>coefficient de dilatation thermique de l’instrument</translation>
    </message>
    <message>
        <source>offset of the measuring line to the tool reference</source>
        <translation>décalage de la ligne de mesurage par rapport à la référence d’outil</translation>
    </message>
    <message>
        <source>offset of the measuring line to the workpiece reference</source>
        <translation>décalage de la ligne de mesurage par rapport à la référence de pièce</translation>
    </message>
    <message>
        <source>temperature gradient over 12 h</source>
        <translation>gradient de température sur 12&#xa0;h</translation>
    </message>
    <message>
        <source>agreed limit of the temperature gradient</source>
        <translation>limite convenue du gradient de température</translation>
    </message>
    <message>
        <source>position of the temperature sensors, expansion coefficient of the machine</source>
        <translation>position des capteurs de température, coefficient de dilatation de la machine</translation>
    </message>
    <message>
        <source>position of the temperature sensors, expansion coefficient of the instrument</source>
        <translation>position des capteurs de température, coefficient de dilatation de l’instrument</translation>
    </message>
    <message>
        <source>choice of targets</source>
        <translation>choix des points visés</translation>
    </message>
    <message>
        <source>cyclic pitch</source>
        <translation>pas cyclique</translation>
    </message>
    <message>
        <source>temperatures of machine and air</source>
        <translation>températures de la machine et de l’air</translation>
    </message>
    <message>
        <source>temperatures of instrument and air</source>
        <translation>températures de l’instrument et de l’air</translation>
    </message>
    <message>
        <source>role not stated</source>
        <translation>rôle non indiqué</translation>
    </message>
    <message>
        <source>the plane cannot be %1; expected two different axes, for example XY</source>
        <translation>le plan ne peut pas être %1&#x202f;; deux axes différents sont attendus, par exemple XY</translation>
    </message>
    <message>
        <source>%1 cannot be %2 for a positioning test</source>
        <translation>%1 ne peut pas être %2 pour un essai de positionnement</translation>
    </message>
    <message>
        <source>%1 cannot be %2 for values over time</source>
        <translation>%1 ne peut pas être %2 pour des valeurs en fonction du temps</translation>
    </message>
    <message>
        <source>Sense: “%1” is neither clockwise nor counterclockwise to the program; those points are read as their angles run.</source>
        <translation>Sens&#xa0;: «&#xa0;%1&#xa0;» n’est pour le programme ni horaire ni antihoraire&#x202f;; ces points sont lus dans l’ordre de leurs angles.</translation>
    </message>
    <message>
        <source>Directions: “%1” is read as ↑, the opposite of the other word of its column.</source>
        <translation>Sens&#xa0;: «&#xa0;%1&#xa0;» est lu comme ↑, le contraire de l’autre mot de la colonne.</translation>
    </message>
    <message>
        <source>Directions: “%1” is read as ↓, the opposite of the other word of its column.</source>
        <translation>Sens&#xa0;: «&#xa0;%1&#xa0;» est lu comme ↓, le contraire de l’autre mot de la colonne.</translation>
    </message>
    <message>
        <source>Radial deviations up to %1 on a circle of radius %2: are unit and radius right?</source>
        <translation>Écarts radiaux jusqu’à %1 sur un cercle de rayon %2&#xa0;: l’unité et le rayon sont-ils justes&#x202f;?</translation>
    </message>
    <message>
        <source>mdeg</source>
        <translation>mdeg</translation>
    </message>
    <message>
        <source>Further statements</source>
        <translation>Autres indications</translation>
    </message>
    <message>
        <source>factor of the guard band</source>
        <translation>facteur de la bande de garde</translation>
    </message>
    <message>
        <source>coverage factor of the calibration of displacement</source>
        <translation>facteur conventionnel de l’étalonnage du déplacement</translation>
    </message>
    <message>
        <source>coverage factor of the reference length</source>
        <translation>facteur conventionnel de la longueur de référence</translation>
    </message>
    <message>
        <source>length L</source>
        <translation>longueur L</translation>
    </message>
    <message>
        <source>expected null or one of the words: %1</source>
        <translation>attendu&#xa0;: null ou l’un des mots suivants&#xa0;: %1</translation>
    </message>
    <message>
        <source>Order of the runs: nothing in the table says it; ↑ and ↓ are put in turn, the cycle stays not stated.</source>
        <translation>Ordre des passes&#xa0;: rien dans le tableau ne l’indique&#x202f;; ↑ et ↓ sont lues en alternance, le cycle reste non indiqué.</translation>
    </message>
    <message>
        <source>Runs %1 and %2 were made in the same direction, one after the other: the stated cycle alternates.</source>
        <translation>Séries %1 et %2 effectuées l’une après l’autre dans le même sens&#xa0;: le cycle indiqué les alterne.</translation>
    </message>
    <message>
        <source>not stated</source>
        <comment>cycle</comment>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>CSV of Palmer</source>
        <translation>CSV de Palmer</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>courbe</translation>
    </message>
    <message>
        <source>this CSV does not state its “%1”; export it again</source>
        <translation>ce CSV n’indique pas son «&#xa0;%1&#xa0;»&#x202f;; l’exporter de nouveau</translation>
    </message>
    <message>
        <source>“%1” contradicts the unit stated above, %2</source>
        <translation>«&#xa0;%1&#xa0;» contredit l’unité indiquée plus haut, %2</translation>
    </message>
    <message>
        <source>“%1” contradicts the direction stated above, %2</source>
        <translation>«&#xa0;%1&#xa0;» contredit le sens indiqué plus haut, %2</translation>
    </message>
    <message>
        <source>“%1” is no number</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre</translation>
    </message>
    <message>
        <source>the heading “%1” is missing</source>
        <translation>l’en-tête «&#xa0;%1&#xa0;» manque</translation>
    </message>
    <message>
        <source>Zone, to be agreed</source>
        <translation>Zone à convenir</translation>
    </message>
    <message>
        <source>Full test of a zone of the long axis</source>
        <translation>Essai complet d’une zone de l’axe long</translation>
    </message>
    <message>
        <source>travel of the axis, mm; of rotary axes degrees. With --range what is measured of it</source>
        <translation>course de l’axe, mm&#x202f;; d’un axe rotatif, degrés. Avec --range, ce qui en est mesuré</translation>
    </message>
    <message>
        <source>where the travel begins</source>
        <translation>où commence la course</translation>
    </message>
    <message>
        <source>the ends of the axis; without it those of the travel</source>
        <translation>les extrémités de l’axe&#x202f;; sans cette option, celles de la course</translation>
    </message>
    <message>
        <source>the zone that has the full test of an axis of more than 2 000 mm (360°); without it in the middle</source>
        <translation>la zone qui reçoit l’essai complet d’un axe de plus de 2&#x202f;000&#xa0;mm (360°)&#x202f;; sans cette option, au milieu</translation>
    </message>
    <message>
        <source>writes the part program in this dialect instead of the plan; of a long axis a second one, of its zone, into OUT-zone</source>
        <translation>écrit le programme pièce dans ce dialecte à la place du plan&#x202f;; pour un axe long, un second, celui de sa zone, dans OUT-zone</translation>
    </message>
    <message>
        <source>between the ends of the axis (--range) is no room for the travel and for the approach distance before and behind it</source>
        <translation>entre les extrémités de l’axe (--range), il n’y a pas la place pour la course et pour la distance d’approche avant et après</translation>
    </message>
    <message numerus="yes">
        <source>Not simulated: %n reading(s); the method Monte Carlo (--uncertainty monteCarlo) does it.</source>
        <translation>
            <numerusform>Non simulé&#xa0;: %n relevé&#x202f;; la méthode Monte-Carlo (--uncertainty monteCarlo) le fait.</numerusform>
            <numerusform>Non simulés&#xa0;: %n relevés&#x202f;; la méthode Monte-Carlo (--uncertainty monteCarlo) le fait.</numerusform>
        </translation>
    </message>
    <message>
        <source>Contribution</source>
        <translation>Contribution</translation>
    </message>
    <message>
        <source>Machine complete, in working order</source>
        <translation>Machine complète, en ordre de marche</translation>
    </message>
    <message>
        <source>Machine unloaded</source>
        <translation>Machine à vide</translation>
    </message>
    <message>
        <source>Range of α, machine: %1</source>
        <translation>Étendue α machine&#xa0;: %1</translation>
    </message>
    <message>
        <source>gives U(α) = 2 µm/(m·°C), the typical minimum of ISO 230-2</source>
        <translation>donne U(α) = 2&#xa0;µm/(m·°C), le minimum usuel selon l’ISO 230-2</translation>
    </message>
    <message>
        <source>Laser interferometer: α 0</source>
        <translation>Interféromètre laser&#xa0;: α 0</translation>
    </message>
    <message>
        <source>light has no material that expands</source>
        <translation>la lumière n’a pas de matière qui se dilate</translation>
    </message>
    <message>
        <source>Resolution: %1</source>
        <translation>Résolution&#xa0;: %1</translation>
    </message>
    <message>
        <source>as stated for the instrument %1</source>
        <translation>indiquée pour l’instrument %1</translation>
    </message>
    <message>
        <source>u of α, machine: %1</source>
        <translation>u de α machine&#xa0;: %1</translation>
    </message>
    <message>
        <source>half of U(α) = 2 µm/(m·°C), the typical minimum of ISO 230-2</source>
        <translation>moitié de U(α) = 2&#xa0;µm/(m·°C), le minimum usuel selon l’ISO 230-2</translation>
    </message>
    <message>
        <source>drift test %1</source>
        <translation>essai de dérive %1</translation>
    </message>
    <message>
        <source>E_VE: %1</source>
        <translation>E_VE&#xa0;: %1</translation>
    </message>
    <message>
        <source>only of a positioning test targets are planned</source>
        <translation>les points visés ne se planifient que pour un essai de positionnement</translation>
    </message>
    <message>
        <source>plans the targets of a positioning test, writes the part program; with FILE as its test states axis and cycle</source>
        <translation>planifie les points visés d’un essai de positionnement, écrit le programme pièce&#x202f;; avec FILE, d’après l’axe et le cycle de son essai</translation>
    </message>
    <message>
        <source>Kind of feed</source>
        <translation>Type d’avance</translation>
    </message>
    <message>
        <source>--typical takes no parameter</source>
        <translation>--typical ne prend pas de paramètre</translation>
    </message>
    <message>
        <source>what the budget of the uncertainty may take where nothing is stated, and where it comes from, as --set takes it</source>
        <translation>ce que le bilan d’incertitude peut prendre là où rien n’est déclaré, et d’où cela vient, tel que --set le prend</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tableau</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source>Kind: an arc of %2 and radius %3 (points: %1) is hardly a circular test; is it one?</source>
        <translation>Type&#xa0;: un arc de %2 et de rayon %3 (points&#xa0;: %1) n’est guère un essai de circularité&#x202f;; en est-ce un&#x202f;?</translation>
    </message>
    <message>
        <source>Layout: readings missing: %1 of %2; are these runs and targets those of one test?</source>
        <translation>Disposition&#xa0;: relevés manquants&#xa0;: %1 sur %2&#x202f;; ces passes et ces points visés sont-ils ceux d’un même essai&#x202f;?</translation>
    </message>
    <message>
        <source>Sign: the file speaks of a correction, whose sign is that of target − actual; read as actual − target.</source>
        <translation>Signe&#xa0;: le fichier parle d’une correction, dont le signe est celui de visé − réel&#x202f;; lu comme réel − visé.</translation>
    </message>
    <message>
        <source>State: the table has readings as found and as left; those as left are read, the others are a test of their own.</source>
        <translation>État&#xa0;: le tableau a des relevés avant et après réglage&#x202f;; ceux d’après sont lus, les autres sont un essai à part.</translation>
    </message>
    <message>
        <source>State: the table has readings as found and as left; those as found are read, the others are a test of their own.</source>
        <translation>État&#xa0;: le tableau a des relevés avant et après réglage&#x202f;; ceux d’avant sont lus, les autres sont un essai à part.</translation>
    </message>
    <message>
        <source>Columns: nothing says what they hold, and their numbers are of different size (about %1 to %2); give each its role.</source>
        <translation>Colonnes&#xa0;: rien ne dit ce qu’elles contiennent, et leurs nombres diffèrent en grandeur (environ %1 à %2)&#x202f;; donner un rôle à chacune.</translation>
    </message>
    <message>
        <source>%1 cannot be %2; the file has %3 of them</source>
        <translation>%1 ne peut pas être %2&#x202f;; le fichier en a %3</translation>
    </message>
    <message>
        <source>Table: the file has several, in the lines %1; number %2 is read.</source>
        <translation>Tableau&#xa0;: le fichier en a plusieurs, aux lignes %1&#x202f;; le numéro %2 est lu.</translation>
    </message>
    <message>
        <source>%1 cannot be %2; expected lines as 38-58</source>
        <translation>%1 ne peut pas être %2&#x202f;; des lignes sont attendues, comme 38-58</translation>
    </message>
    <message>
        <source>Doubtful; where what was read is right: --set %1.</source>
        <translation>Douteux&#x202f;; si ce qui a été lu est juste&#xa0;: --set %1.</translation>
    </message>
    <message>
        <source>Columns: %1. Roles as read: --set columns=%2; known: %3.</source>
        <translation>Colonnes&#xa0;: %1. Rôles tels que lus&#xa0;: --set columns=%2&#x202f;; connus&#xa0;: %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n question(s) are open: nothing was imported; answer with --set, or take what is assumed with --accept</source>
        <translation>
            <numerusform>%n question est ouverte&#xa0;: rien n’a été importé&#x202f;; répondre par --set, ou prendre ce qui est supposé par --accept</numerusform>
            <numerusform>%n questions sont ouvertes&#xa0;: rien n’a été importé&#x202f;; répondre par --set, ou prendre ce qui est supposé par --accept</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n question(s) are open: nothing was imported; each wants its own answer with --set</source>
        <translation>
            <numerusform>%n question est ouverte&#xa0;: rien n’a été importé&#x202f;; elle demande sa propre réponse par --set</numerusform>
            <numerusform>%n questions sont ouvertes&#xa0;: rien n’a été importé&#x202f;; chacune demande sa propre réponse par --set</numerusform>
        </translation>
    </message>
    <message>
        <source>no typical value is known for its tests</source>
        <translation>aucune valeur usuelle n’est connue pour ses essais</translation>
    </message>
    <message>
        <source>its tests have no results to explain</source>
        <translation>ses essais n’ont pas de résultats à expliquer</translation>
    </message>
    <message>
        <source>“%1” does not say the sign of its deviations; read as actual − target.</source>
        <translation>«&#xa0;%1&#xa0;» ne dit pas le signe de ses écarts&#x202f;; lu comme «&#xa0;réel − visé&#xa0;».</translation>
    </message>
    <message>
        <source>“%1” does not say the sign of its deviations, and a table of the wrong sign doubles them: confirm that they are actual − target, or import it with the other sign</source>
        <translation>«&#xa0;%1&#xa0;» ne dit pas le signe de ses écarts, et une table de signe contraire les double&#xa0;: confirmez qu’il s’agit de «&#xa0;réel − visé&#xa0;», ou importez le fichier avec l’autre signe</translation>
    </message>
    <message>
        <source>“%1” does not say the sign of its deviations, and a table of the wrong sign doubles them: %2 if they are actual − target, else import it with %3</source>
        <translation>«&#xa0;%1&#xa0;» ne dit pas le signe de ses écarts, et une table de signe contraire les double&#xa0;: %2 s’il s’agit de «&#xa0;réel − visé&#xa0;», sinon importez le fichier avec %3</translation>
    </message>
    <message>
        <source>--confirm-sign has no effect here: the sign of the deviations is not in doubt</source>
        <translation>--confirm-sign est sans effet ici&#xa0;: le signe des écarts ne fait pas de doute</translation>
    </message>
    <message>
        <source>the deviations are actual − target, though the file they come from does not say it</source>
        <translation>les écarts sont «&#xa0;réel − visé&#xa0;», bien que le fichier d’origine ne le dise pas</translation>
    </message>
    <message>
        <source>put by target and direction, as the headings say</source>
        <translation>placés par point visé et par sens, comme le disent les en-têtes</translation>
    </message>
    <message>
        <source>the unit of the readings is not one of this axis</source>
        <translation>l’unité des relevés n’est pas une unité de cet axe</translation>
    </message>
    <message>
        <source>Columns: the first counts the lines and is not read; the times are those of the next.</source>
        <translation>Colonnes&#xa0;: la première compte les lignes et n’est pas lue&#x202f;; les temps sont ceux de la suivante.</translation>
    </message>
    <message>
        <source>radial deviations alone</source>
        <translation>écarts radiaux seuls</translation>
    </message>
    <message>
        <source>colon between blanks</source>
        <translation>deux-points entre blancs</translation>
    </message>
    <message>
        <source>no reference data (.json) there</source>
        <translation>aucune donnée de référence (.json) à cet endroit</translation>
    </message>
    <message>
        <source>%1, %2: %3 expected, %4 computed</source>
        <translation>%1, %2&#xa0;: %3 attendu, %4 calculé</translation>
    </message>
    <message>
        <source>Compiler</source>
        <translation>Compilateur</translation>
    </message>
    <message>
        <source>Contributions to the budget</source>
        <translation>Contributions au budget</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Données</translation>
    </message>
    <message>
        <source>Diagnosis</source>
        <translation>Diagnostic</translation>
    </message>
    <message>
        <source>E_VE, progression of the runs</source>
        <translation>E_VE, progression des passes</translation>
    </message>
    <message>
        <source>Largest difference</source>
        <translation>Plus grande différence</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Processeur</translation>
    </message>
    <message>
        <source>SHA-256 of the program</source>
        <translation>SHA-256 du programme</translation>
    </message>
    <message>
        <source>U after the simulation</source>
        <translation>U retenue après la simulation</translation>
    </message>
    <message>
        <source>U of the budget</source>
        <translation>U du budget</translation>
    </message>
    <message>
        <source>U with the actual targets</source>
        <translation>U avec les points réels</translation>
    </message>
    <message>
        <source>Validation of %1</source>
        <translation>Validation de %1</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Values per target</source>
        <translation>Valeurs par point visé</translation>
    </message>
    <message>
        <source>Verdicts</source>
        <translation>Verdicts</translation>
    </message>
    <message>
        <source>compares the evaluation with reference data, built in or of a folder</source>
        <translation>compare l’évaluation à des données de référence, intégrées ou d’un dossier</translation>
    </message>
    <message>
        <source>every value as JSON, with its origin, tolerance and difference</source>
        <translation>chaque valeur en JSON, avec son origine, sa tolérance et sa différence</translation>
    </message>
    <message>
        <source>second implementation</source>
        <translation>seconde implémentation</translation>
    </message>
    <message>
        <source>the validation document of this build, with the processor it ran on</source>
        <translation>le document de validation de cette version compilée, avec le processeur utilisé</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>Monte-Carlo</translation>
    </message>
    <message>
        <source>scan: make the register anew; until that is done others read it as it was</source>
        <translation>scan&#xa0;: refaire le registre&#x202f;; jusque-là, les autres le lisent tel qu’il était</translation>
    </message>
    <message>
        <source>expected: %1</source>
        <translation>attendu&#xa0;: %1</translation>
    </message>
    <message>
        <source>list, trend, report: name or serial number of the machine, its number in the list, or what names, maker, type or place contain</source>
        <translation>list, trend, report&#xa0;: nom ou numéro de série de la machine, son numéro dans la liste, ou ce que contiennent nom, constructeur, type ou lieu</translation>
    </message>
    <message>
        <source>test: %1</source>
        <translation>essai&#xa0;: %1</translation>
    </message>
    <message>
        <source>“%1” and “%2” are one machine already</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» sont déjà une seule machine</translation>
    </message>
    <message>
        <source>%1 machines may be meant by “%2”: %3; say the number before its name</source>
        <translation>«&#xa0;%2&#xa0;» peut désigner %1 machines&#xa0;: %3&#x202f;; indiquez le numéro placé devant son nom</translation>
    </message>
    <message>
        <source>scan: take out files that are not found any more; with --force also where a folder would lose more than half of its tests</source>
        <translation>scan&#xa0;: retirer les fichiers introuvables&#x202f;; avec --force, aussi là où un dossier perdrait plus de la moitié de ses essais</translation>
    </message>
    <message>
        <source>this is no list of machines of a register, or a newer one</source>
        <translation>ce n’est pas une liste de machines d’un registre, ou une plus récente</translation>
    </message>
    <message>
        <source>All files of the register can be read.</source>
        <translation>Tous les fichiers du registre sont lisibles.</translation>
    </message>
    <message>
        <source>the folder cannot be written; kept in %1</source>
        <translation>impossible d’écrire dans le dossier&#x202f;; conservé dans %1</translation>
    </message>
    <message>
        <source>an older version of Palmer made this register, and you may not write to it: it can be read again when somebody who may has scanned with this one</source>
        <translation>ce registre vient d’une version antérieure de Palmer, et vous n’avez pas le droit d’y écrire&#xa0;: il sera de nouveau lisible quand une personne qui en a le droit aura lancé une lecture avec cette version-ci</translation>
    </message>
    <message>
        <source>%1; kept in %2</source>
        <translation>%1&#x202f;; conservé dans %2</translation>
    </message>
    <message>
        <source>certificate: %1</source>
        <translation>certificat&#xa0;: %1</translation>
    </message>
    <message>
        <source>next test before %1 (%2)</source>
        <translation>prochain essai avant le %1 (%2)</translation>
    </message>
    <message>
        <source>At least four tests since the last intervention make a line, weighted with what their uncertainties share. “Not before” is the day its upper bound of 95 % reaches the limit: for the level, not for the next test. Tests of another edition, feed, correction, travel, zone, radius, compensation, offset or number of runs are another series and never joined; the legend says what differs.</source>
        <translation>Il faut au moins quatre essais depuis la dernière intervention pour une droite, pondérée selon ce que leurs incertitudes ont en commun. «&#xa0;Pas avant&#xa0;» est le jour où sa borne haute à 95&#xa0;% atteint la limite&#xa0;: pour le niveau, non pour le prochain essai. Les essais d’une autre édition, d’une autre avance, d’une autre correction, course ou zone, d’un autre rayon, d’une autre compensation, d’un autre décalage ou d’un autre nombre de passes forment une autre série, jamais reliée&#x202f;; la légende dit ce qui diffère.</translation>
    </message>
    <message>
        <source>list: of CSV for spreadsheets, with a byte-order mark</source>
        <translation>list&#xa0;: du CSV pour tableurs, avec indicateur d’ordre des octets</translation>
    </message>
    <message>
        <source>of CSV for spreadsheets, with a byte-order mark</source>
        <translation>du CSV pour tableurs, avec indicateur d’ordre des octets</translation>
    </message>
    <message>
        <source>Report No.</source>
        <translation>Rapport n°</translation>
    </message>
    <message>
        <source>A machine is known by maker and serial number; capitals and additional blanks are the only differences that do not count. Without serial number it is “not identified”, known by name, maker and type. “Join with another…” makes two machines one, “Separate from another…” takes it back. With an interval each axis and plane has its day of the next test. All is kept in palmer-machines.json in the folder of the files. The mark of a certificate counts the days until one expires.</source>
        <translation>Une machine est reconnue à son constructeur et à son numéro de série&#x202f;; seules les majuscules et les espaces superflus ne comptent pas. Sans numéro de série elle est «&#xa0;non identifiée&#xa0;» et reconnue à son nom, à son constructeur et à son type. «&#xa0;Réunir à une autre…&#xa0;» fait de deux machines une seule, «&#xa0;Séparer d’une autre…&#xa0;» y revient. Avec une périodicité, chaque axe et chaque plan a sa date du prochain essai. Tout est conservé dans palmer-machines.json, dans le dossier des fichiers. Le repère d’un certificat compte les jours jusqu’à son échéance.</translation>
    </message>
    <message>
        <source>No test of the register fits.</source>
        <translation>Aucun essai du registre ne correspond.</translation>
    </message>
    <message>
        <source>runs in either direction</source>
        <translation>passes dans chaque sens</translation>
    </message>
    <message>
        <source>more than half of its tests are not found, as on a drive that is not connected; nothing was taken out, --force does it</source>
        <translation>plus de la moitié de ses essais sont introuvables, comme sur un lecteur non connecté&#x202f;; rien n’a été retiré, --force le fait</translation>
    </message>
    <message>
        <source>Not seen: too small to be told from the rest.</source>
        <translation>Non décelé&#xa0;: trop petit pour être distingué du reste.</translation>
    </message>
    <message>
        <source>Not certain: its 99.9 % interval contains zero.</source>
        <translation>Non certain&#xa0;: son intervalle à 99,9&#xa0;% contient zéro.</translation>
    </message>
    <message>
        <source>a wave of %1 periods per turn</source>
        <translation>une onde de %1 périodes par tour</translation>
    </message>
    <message>
        <source>The reversals, each fitted alone, contradict each other.</source>
        <translation>Les inversions, ajustées une à une, se contredisent.</translation>
    </message>
    <message>
        <source>an outlier at %1</source>
        <translation>une valeur aberrante à %1</translation>
    </message>
    <message>
        <source>Radii that differ between the senses explain it as well.</source>
        <translation>Des rayons différents selon le sens l’expliquent aussi bien.</translation>
    </message>
    <message>
        <source>The noise model does not fit: intervals are not valid, and values are indications. Seen in the rest: %1.</source>
        <translation>Le modèle de bruit ne convient pas&#xa0;: les intervalles ne sont pas valables et les valeurs ne sont qu’indicatives. Vu dans le reste&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The reversal steps lie %1 ± %2 off the axes: check the start angle. Spikes and periodic deviations are not shown until this is settled.</source>
        <translation>Les sauts d’inversion sont décalés de %1 ± %2 par rapport aux axes&#xa0;: vérifier l’angle de départ. Les pics de réversibilité et les écarts périodiques ne sont pas affichés tant que ce point n’est pas réglé.</translation>
    </message>
    <message>
        <source>noise of another kind than white with a short memory</source>
        <translation>un bruit qui n’est ni blanc ni à mémoire courte</translation>
    </message>
    <message>
        <source>Not a result of ISO 230-4, and no part of the verdict: the path taken apart into known faults of machines. ± is the 95 % interval of the fit alone. The part of G(b) is what the source would make alone; parts do not add up.</source>
        <translation>Ni un résultat de l’ISO&#xa0;230-4, ni un élément du verdict&#xa0;: le tracé est décomposé en défauts connus des machines. ± est l’intervalle à 95&#xa0;% de l’ajustement seul. La part de G(b) est ce que la source donnerait seule&#x202f;; les parts ne s’additionnent pas.</translation>
    </message>
    <message>
        <source>a step of the radius between the senses</source>
        <translation>un saut du rayon entre les sens</translation>
    </message>
    <message>
        <source>A periodic deviation of %1 with a pitch of %2 explains it as well.</source>
        <translation>Un écart périodique de %1 au pas de %2 l’explique aussi bien.</translation>
    </message>
    <message>
        <source>This diagnosis is no result of the test and no part of the verdict. It takes the measured path apart into known faults of machines; ± is the 95 % interval of the fit alone, without the uncertainty of the instrument.</source>
        <translation>Ce diagnostic n’est pas un résultat d’essai et n’entre pas dans le verdict. Il décompose le tracé mesuré en défauts connus des machines&#x202f;; ± est l’intervalle à 95&#xa0;% de l’ajustement seul, sans l’incertitude de l’instrument.</translation>
    </message>
    <message>
        <source>Only one reversal is in the data.</source>
        <translation>Les données ne contiennent qu’une seule inversion.</translation>
    </message>
    <message>
        <source>Known of these sources is their sum: %1 = %2 %3.</source>
        <translation>De ces sources, seule la somme est connue&#xa0;: %1 = %2 %3.</translation>
    </message>
    <message>
        <source>noise that grows towards slow waves (1/f)</source>
        <translation>un bruit qui croît vers les ondes lentes (1/f)</translation>
    </message>
    <message>
        <source>a slow wave or drift</source>
        <translation>une onde lente ou une dérive</translation>
    </message>
    <message>
        <source>The reversal steps lie %1 ± %2 off the axes: the measuring system is turned against them. Spikes and periodic deviations are not shown until this is settled.</source>
        <translation>Les sauts d’inversion sont décalés de %1 ± %2 par rapport aux axes&#xa0;: le système de mesure est tourné par rapport à ceux-ci. Les pics de réversibilité et les écarts périodiques ne sont pas affichés tant que ce point n’est pas réglé.</translation>
    </message>
    <message>
        <source>noise that differs between angles or senses</source>
        <translation>un bruit inégal selon l’angle ou le sens</translation>
    </message>
    <message>
        <source>each circle by itself, with its 95 % interval</source>
        <translation>chaque cercle seul, avec son intervalle à 95&#xa0;%</translation>
    </message>
    <message>
        <source>An indication, without an interval:</source>
        <translation>Indication, sans intervalle&#xa0;:</translation>
    </message>
    <message>
        <source>Even and odd sectors of 15° contradict each other.</source>
        <translation>Les secteurs de 15° pairs et impairs se contredisent.</translation>
    </message>
    <message>
        <source>A few readings make it: robust weights give another value.</source>
        <translation>Quelques relevés en sont la cause&#xa0;: des poids robustes donnent une autre valeur.</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>intervalle à 95&#xa0;%</translation>
    </message>
    <message>
        <source>Expanded uncertainties are evaluated according to the GUM (JCGM 100) and stated with the coverage factor k = 2, a coverage probability of about 95 %; simulated ones (JCGM 101) are half of the shortest interval that holds 95.45 %.</source>
        <translation>Les incertitudes étendues sont évaluées selon le GUM (JCGM 100) et indiquées avec le facteur conventionnel k = 2, soit une probabilité de couverture d’environ 95&#xa0;%&#x202f;; celles obtenues par simulation (JCGM 101) sont la moitié du plus petit intervalle contenant 95,45&#xa0;%.</translation>
    </message>
    <message>
        <source>who authorises the report</source>
        <translation>la personne qui autorise le rapport</translation>
    </message>
    <message>
        <source>what to write: readings and results, a digital calibration certificate, a compensation table, or the part program of the test&apos;s own targets</source>
        <translation>ce qu’il faut écrire&#xa0;: relevés et résultats, certificat d’étalonnage numérique, table de compensation ou programme pièce des points visés de l’essai</translation>
    </message>
    <message>
        <source>expected a country as two capital letters (ISO 3166-1), as FR</source>
        <translation>pays attendu en deux lettres capitales (ISO 3166-1), comme FR</translation>
    </message>
    <message>
        <source>a digital calibration certificate must also state: %1</source>
        <translation>un certificat d’étalonnage numérique doit aussi indiquer&#xa0;: %1</translation>
    </message>
    <message>
        <source>accreditation %1</source>
        <translation>accréditation %1</translation>
    </message>
    <message>
        <source>the digital calibration certificate in the PDF is not the one that follows from the data</source>
        <translation>le certificat d’étalonnage numérique joint au PDF n’est pas celui qui découle des données</translation>
    </message>
    <message>
        <source>a test</source>
        <translation>un essai</translation>
    </message>
    <message>
        <source>Scope</source>
        <translation>Portée</translation>
    </message>
    <message>
        <source>certificate %1</source>
        <translation>certificat %1</translation>
    </message>
    <message>
        <source>readings and results, a digital calibration certificate, a compensation table with what it would bring, or the part program of a test</source>
        <translation>relevés et résultats, certificat d’étalonnage numérique, table de compensation avec ce qu’elle apporterait, ou programme pièce d’un essai</translation>
    </message>
    <message>
        <source>Reason of the revision</source>
        <translation>Motif de la révision</translation>
    </message>
    <message>
        <source>calibrated by %1</source>
        <translation>étalonné par %1</translation>
    </message>
    <message>
        <source>Deviations from the method</source>
        <translation>Écarts par rapport à la méthode</translation>
    </message>
    <message>
        <source>the PDF also carries the results as a digital calibration certificate</source>
        <translation>le PDF contient aussi les résultats sous forme de certificat d’étalonnage numérique</translation>
    </message>
    <message>
        <source>no results</source>
        <translation>aucun résultat</translation>
    </message>
    <message>
        <source>place of the tests</source>
        <translation>lieu des essais</translation>
    </message>
    <message>
        <source>number of the report</source>
        <translation>numéro du rapport</translation>
    </message>
    <message>
        <source>who calibrated each instrument</source>
        <translation>organisme d’étalonnage de chaque instrument</translation>
    </message>
    <message>
        <source>condition of the machine</source>
        <translation>état de la machine</translation>
    </message>
    <message>
        <source>customer with address</source>
        <translation>client, avec son adresse</translation>
    </message>
    <message>
        <source>date of issue</source>
        <translation>date d’émission</translation>
    </message>
    <message>
        <source>address of the laboratory</source>
        <translation>adresse du laboratoire</translation>
    </message>
    <message>
        <source>name of the laboratory</source>
        <translation>nom du laboratoire</translation>
    </message>
    <message>
        <source>country of the laboratory</source>
        <translation>pays du laboratoire</translation>
    </message>
    <message>
        <source>traceable to %1</source>
        <translation>raccordé à %1</translation>
    </message>
    <message>
        <source>Who ordered the tests, with the address.</source>
        <translation>Qui a commandé les essais, avec son adresse.</translation>
    </message>
    <message>
        <source>Street, postcode, town and country, as they stand on the certificate.</source>
        <translation>Rue, code postal, ville et pays, tels qu’ils figurent sur le certificat.</translation>
    </message>
    <message>
        <source>As it was found: new, in production, after a repair, with what was adjusted before the test.</source>
        <translation>L’état trouvé&#xa0;: neuve, en production, après réparation, avec les réglages effectués avant l’essai.</translation>
    </message>
    <message>
        <source>Where the tests were made.</source>
        <translation>L’endroit où les essais ont été effectués.</translation>
    </message>
    <message>
        <source>How U is evaluated: by a budget, a simulation, as the laboratory states it, or not at all.</source>
        <translation>La manière d’évaluer U&#xa0;: par un bilan, par simulation, telle que le laboratoire l’indique, ou pas du tout.</translation>
    </message>
    <message>
        <source>Who releases the report and answers for it.</source>
        <translation>La personne qui délivre le rapport et en répond.</translation>
    </message>
    <message>
        <source>The laboratory that calibrated the instrument, with its accreditation.</source>
        <translation>Le laboratoire qui a étalonné l’instrument, avec son accréditation.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Tells this report from all others of the laboratory.</source>
        <translation>Distingue ce rapport de tous les autres du laboratoire.</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numéro</translation>
    </message>
    <message>
        <source>What the revision changes.</source>
        <translation>Ce que la révision change.</translation>
    </message>
    <message>
        <source>by more than the guard band: %1.</source>
        <translation>au-delà de la bande de garde&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Furthest beyond its limit of %1: %2.</source>
        <translation>Le plus au-delà de sa limite de %1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Closest to its limit of %1: %2.</source>
        <translation>Au plus près de sa limite de %1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>No limit agreed</source>
        <translation>Sans limite convenue</translation>
    </message>
    <message>
        <source>Cycle, targets</source>
        <translation>Cycle, points visés</translation>
    </message>
    <message>
        <source>Title of the test</source>
        <translation>Titre de l’essai</translation>
    </message>
    <message>
        <source>Element of the scale (0: continuous)</source>
        <translation>Élément de l’échelle (0&#xa0;: continue)</translation>
    </message>
    <message>
        <source>Reference length calibrated</source>
        <translation>Longueur de référence étalonnée</translation>
    </message>
    <message>
        <source>Specified diameter</source>
        <translation>Diamètre spécifié</translation>
    </message>
    <message>
        <source>Specified feed</source>
        <translation>Vitesse d’avance spécifiée</translation>
    </message>
    <message>
        <source>Period of the error</source>
        <translation>Période de l’erreur périodique</translation>
    </message>
    <message>
        <source>Faces of the polygon, number</source>
        <translation>Nombre de faces du polygone</translation>
    </message>
    <message>
        <source>Kind of warm-up</source>
        <translation>Mise en température</translation>
    </message>
    <message>
        <source>Warm-up, details</source>
        <translation>Mise en température, détails</translation>
    </message>
    <message>
        <source>Specified by</source>
        <translation>Prescrite par</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positions</translation>
    </message>
    <message>
        <source>Centre of the circle, X</source>
        <translation>Centre du cercle, X</translation>
    </message>
    <message>
        <source>Centre of the circle, Y</source>
        <translation>Centre du cercle, Y</translation>
    </message>
    <message>
        <source>Centre of the circle, Z</source>
        <translation>Centre du cercle, Z</translation>
    </message>
    <message>
        <source>Offset to tool, X</source>
        <translation>Décalage outil, X</translation>
    </message>
    <message>
        <source>Offset to tool, Y</source>
        <translation>Décalage outil, Y</translation>
    </message>
    <message>
        <source>Offset to tool, Z</source>
        <translation>Décalage outil, Z</translation>
    </message>
    <message>
        <source>Offset to workpiece, X</source>
        <translation>Décalage pièce, X</translation>
    </message>
    <message>
        <source>Offset to workpiece, Y</source>
        <translation>Décalage pièce, Y</translation>
    </message>
    <message>
        <source>Offset to workpiece, Z</source>
        <translation>Décalage pièce, Z</translation>
    </message>
    <message>
        <source>To declare</source>
        <translation>À déclarer</translation>
    </message>
    <message>
        <source>Thermally stable</source>
        <translation>Stabilité thermique</translation>
    </message>
    <message>
        <source>Declaration</source>
        <translation>Déclaration</translation>
    </message>
    <message>
        <source>Rest of the requirements declared met by</source>
        <translation>Reste des exigences déclaré satisfait par</translation>
    </message>
    <message>
        <source>Declared on</source>
        <translation>Déclaré le</translation>
    </message>
    <message>
        <source>Text of the declaration</source>
        <translation>Texte de la déclaration</translation>
    </message>
    <message>
        <source>Remarks on the test</source>
        <translation>Remarques sur l’essai</translation>
    </message>
    <message>
        <source>Hours before</source>
        <translation>Heures avant</translation>
    </message>
    <message>
        <source>the explanations as JSON</source>
        <translation>les explications en JSON</translation>
    </message>
    <message>
        <source>the feed as JSON, with all digits</source>
        <translation>l’avance en JSON, avec tous les chiffres</translation>
    </message>
    <message>
        <source>choices, remarks and questions as JSON on standard output</source>
        <translation>choix, remarques et questions en JSON sur la sortie standard</translation>
    </message>
    <message>
        <source>there is no schema %1; palmer-cli schema lists them</source>
        <translation>il n’y a pas de schéma %1&#x202f;; palmer-cli schema en donne la liste</translation>
    </message>
    <message>
        <source>the JSON Schema of what a command writes as JSON; without NAME what there is</source>
        <translation>le schéma JSON de ce qu’une commande écrit en JSON&#x202f;; sans NAME, la liste des schémas</translation>
    </message>
    <message>
        <source>the plan as JSON; without -o on standard output</source>
        <translation>le plan en JSON&#x202f;; sans -o sur la sortie standard</translation>
    </message>
    <message>
        <source>expected nothing here, for “from” takes it from a test</source>
        <translation>rien n’est attendu ici, car «&#xa0;from&#xa0;» le prend d’un essai</translation>
    </message>
    <message>
        <source>expected a number, a list of the least and the largest value, or null</source>
        <translation>attendu&#xa0;: un nombre, une liste de la plus petite et de la plus grande valeur, ou null</translation>
    </message>
    <message>
        <source>expected the least value before the largest</source>
        <translation>attendu&#xa0;: la plus petite valeur avant la plus grande</translation>
    </message>
    <message>
        <source>Acceptance sheet</source>
        <translation>Fiche de réception</translation>
    </message>
    <message>
        <source>Checks</source>
        <comment>of the acceptance sheet</comment>
        <translation>Contrôles</translation>
    </message>
    <message>
        <source>row %1</source>
        <comment>of the acceptance sheet</comment>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>Object</source>
        <comment>of the acceptance sheet</comment>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Row %1 of the acceptance sheet is not measured: this report has no test “%2”.</source>
        <translation>Ligne %1 de la fiche de réception non mesurée&#xa0;: ce rapport n’a pas d’essai «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>Row %1 of the acceptance sheet is not measured: test “%2” has no result “%3”.</source>
        <translation>Ligne %1 de la fiche de réception non mesurée&#xa0;: l’essai «&#xa0;%2&#xa0;» n’a pas de résultat «&#xa0;%3&#xa0;».</translation>
    </message>
    <message>
        <source>Row %1 of the acceptance sheet is not measured: test “%2” has no value of “%3”.</source>
        <translation>Ligne %1 de la fiche de réception non mesurée&#xa0;: l’essai «&#xa0;%2&#xa0;» n’a pas de valeur de «&#xa0;%3&#xa0;».</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source>What is checked on a machine beside its tests: geometry, run-out, level. Each row has a number, an object, a tolerance, a measured value with its U (k = 2) and a unit. Objects and tolerances are those of the parties: Palmer ships none.</source>
        <translation>Ce qui est contrôlé sur une machine en plus de ses essais&#xa0;: géométrie, battements, nivellement. Chaque ligne porte un numéro, un objet, une tolérance, une valeur mesurée avec son U (k&#xa0;=&#xa0;2) et une unité. Objets et tolérances sont ceux des parties&#xa0;: Palmer n’en fournit aucun.</translation>
    </message>
    <message>
        <source>One number limits the magnitude of the value; two, the least and the largest, its signed value. Units are printed as typed and never converted.</source>
        <translation>Un nombre limite la valeur absolue&#x202f;; deux nombres, le plus petit et le plus grand, la valeur affectée de son signe. Les unités sont imprimées telles que saisies et jamais converties.</translation>
    </message>
    <message>
        <source>A row from a test</source>
        <translation>Une ligne reprise d’un essai</translation>
    </message>
    <message>
        <source>A row may name a parameter of a test of the report: value, U, limit and unit then are those of the test, and change with it.</source>
        <translation>Une ligne peut nommer une grandeur d’un essai du rapport&#xa0;: valeur, U, limite et unité sont alors celles de l’essai et changent avec lui.</translation>
    </message>
    <message>
        <source>One decision rule holds for all rows. The verdict of the report is the worst of those of sheet and tests. A row without a value is “not measured”: as long as there is one, the sheet is not proven. A row that does not apply needs a reason.</source>
        <translation>Une seule règle de décision vaut pour toutes les lignes. Le verdict du rapport est le plus défavorable de ceux de la fiche et des essais. Une ligne sans valeur est «&#xa0;non mesurée&#xa0;»&#xa0;: tant qu’il en reste une, la fiche n’est pas prouvée. Une ligne sans objet doit en donner la raison.</translation>
    </message>
    <message numerus="yes">
        <source>%n check(s)</source>
        <translation>
            <numerusform>%n contrôle</numerusform>
            <numerusform>%n contrôles</numerusform>
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
        <source>test %1</source>
        <translation>essai %1</translation>
    </message>
    <message>
        <source>tests %1</source>
        <translation>essais %1</translation>
    </message>
    <message>
        <source>not measured</source>
        <comment>a row of the sheet</comment>
        <translation>non mesurée</translation>
    </message>
    <message>
        <source>no tolerance</source>
        <translation>sans tolérance</translation>
    </message>
    <message>
        <source>not applicable</source>
        <comment>a row of the sheet</comment>
        <translation>sans objet</translation>
    </message>
    <message>
        <source>No.</source>
        <comment>number of a row</comment>
        <translation>N°</translation>
    </message>
    <message>
        <source>Measured</source>
        <comment>value</comment>
        <translation>Mesuré</translation>
    </message>
    <message>
        <source>Sheet</source>
        <comment>part of a verdict</comment>
        <translation>Fiche</translation>
    </message>
    <message numerus="yes">
        <source>all %n row(s) met</source>
        <translation>
            <numerusform>la seule ligne respectée</numerusform>
            <numerusform>les %n lignes respectées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 rows met</source>
        <translation>
            <numerusform>%n ligne sur %1 respectée</numerusform>
            <numerusform>%n lignes sur %1 respectées</numerusform>
        </translation>
    </message>
    <message>
        <source>none</source>
        <comment>tests</comment>
        <translation>aucun</translation>
    </message>
    <message>
        <source>measured</source>
        <comment>legend</comment>
        <translation>mesuré</translation>
    </message>
    <message>
        <source>tolerance</source>
        <comment>legend</comment>
        <translation>tolérance</translation>
    </message>
    <message>
        <source>Decision rule: %1</source>
        <translation>Règle de décision&#xa0;: %1</translation>
    </message>
    <message>
        <source>The verdict of the report is the worst of those of sheet and tests; a row that is not measured forbids “all met”. Objects and tolerances are those of the parties.</source>
        <translation>Le verdict du rapport est le plus défavorable de ceux de la fiche et des essais&#x202f;; une ligne non mesurée interdit «&#xa0;toutes respectées&#xa0;». Objets et tolérances sont ceux des parties.</translation>
    </message>
    <message>
        <source>Verdict of the tests</source>
        <translation>Verdict des essais</translation>
    </message>
    <message>
        <source>%1 for %2</source>
        <comment>measured, tolerance</comment>
        <translation>%1 pour %2</translation>
    </message>
    <message>
        <source>Exceeded at the last test</source>
        <translation>Dépassé au dernier essai</translation>
    </message>
    <message>
        <source>End of the history</source>
        <translation>Fin de l’historique</translation>
    </message>
    <message>
        <source>none</source>
        <comment>number of tests</comment>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Certificate</source>
        <comment>of a circle</comment>
        <translation>Preuve</translation>
    </message>
    <message>
        <source>did you mean %1?</source>
        <translation>vouliez-vous dire %1&#x202f;?</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Exemples</translation>
    </message>
    <message>
        <source>Exit codes</source>
        <translation>Codes de retour</translation>
    </message>
    <message>
        <source>this report was made from another state of the test file next to it: fingerprint %1, now %2</source>
        <translation>ce rapport a été établi à partir d’un autre état du fichier d’essai voisin&#xa0;: empreinte %1, maintenant %2</translation>
    </message>
    <message>
        <source>an example</source>
        <translation>un exemple</translation>
    </message>
    <message>
        <source>FILES</source>
        <comment>section of a manual page</comment>
        <translation>FICHIERS</translation>
    </message>
    <message>
        <source>the register, without --register</source>
        <translation>le registre, sans --register</translation>
    </message>
    <message>
        <source>the choices kept for --profile</source>
        <translation>les choix conservés pour --profile</translation>
    </message>
    <message>
        <source>in a folder of the register: machines that are one, intervals</source>
        <translation>dans un dossier du registre&#xa0;: machines qui n’en font qu’une, périodicités</translation>
    </message>
    <message>
        <source>with several files: what each is called in the folder, from {machine}, {serialNumber}, {number} of the report, {axis}, {date} and {file}; of equal names the later get -2, -3</source>
        <translation>pour plusieurs fichiers&#xa0;: nom de chacun dans le dossier, formé de {machine}, {serialNumber}, {number} du rapport, {axis}, {date} et {file}&#x202f;; à noms égaux, les suivants reçoivent -2, -3</translation>
    </message>
    <message>
        <source>this is a pipe that nobody writes to</source>
        <translation>personne n’écrit dans ce tube</translation>
    </message>
    <message>
        <source>unknown profile %1: none is kept here</source>
        <translation>profil inconnu&#xa0;: %1&#x202f;; aucun n’est conservé ici</translation>
    </message>
    <message>
        <source>unknown parameter %1: the tests have none</source>
        <translation>paramètre inconnu&#xa0;: %1&#x202f;; les essais n’en ont aucun</translation>
    </message>
    <message>
        <source>%1 does not know “%2”; it knows: %3</source>
        <translation>%1 ne connaît pas «&#xa0;%2&#xa0;»&#x202f;; connus&#xa0;: %3</translation>
    </message>
    <message>
        <source>EXAMPLES</source>
        <comment>section of a manual page</comment>
        <translation>EXEMPLES</translation>
    </message>
    <message>
        <source>the register</source>
        <translation>le registre</translation>
    </message>
    <message>
        <source>type: share of the type that lies below the tolerance limit</source>
        <translation>type&#xa0;: part du type située sous la limite de tolérance</translation>
    </message>
    <message>
        <source>type: confidence of the tolerance limit</source>
        <translation>type&#xa0;: niveau de confiance de la limite de tolérance</translation>
    </message>
    <message>
        <source>type: distribution of the chosen tolerance limit; both are shown</source>
        <translation>type&#xa0;: loi de la limite de tolérance retenue&#x202f;; les deux sont affichées</translation>
    </message>
    <message>
        <source>Type test of %1: %2 of %3</source>
        <translation>Essai de type de %1&#xa0;: %2 de %3</translation>
    </message>
    <message>
        <source>Interpretation, not a result of ISO 230-2 or ISO 230-4. The machines are those in the register, no random sample.</source>
        <translation>Interprétation, pas un résultat de l’ISO 230-2 ni de l’ISO 230-4. Les machines sont celles du registre, non un échantillon aléatoire.</translation>
    </message>
    <message>
        <source>Machines without a comparable test</source>
        <translation>Machines sans essai comparable</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>douteuse</translation>
    </message>
    <message>
        <source>not contradicted</source>
        <translation>non contredite</translation>
    </message>
    <message>
        <source>Tolerance limit</source>
        <translation>Limite de tolérance</translation>
    </message>
    <message>
        <source>none: it takes three machines with a comparable test</source>
        <translation>aucune&#xa0;: il faut trois machines ayant un essai comparable</translation>
    </message>
    <message>
        <source>Mean, s</source>
        <translation>Moyenne, s</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Médiane</translation>
    </message>
    <message>
        <source>Content, confidence</source>
        <translation>Part couverte, niveau de confiance</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>retenue</translation>
    </message>
    <message>
        <source>Tolerance limit, log-normal</source>
        <translation>Limite de tolérance, log-normale</translation>
    </message>
    <message>
        <source>Tolerance limit, normal</source>
        <translation>Limite de tolérance, normale</translation>
    </message>
    <message>
        <source>Largest value</source>
        <translation>Plus grande valeur</translation>
    </message>
    <message>
        <source>%1 with a confidence of %2</source>
        <translation>%1 au niveau de confiance de %2</translation>
    </message>
    <message>
        <source>Normality of the values</source>
        <translation>Normalité des valeurs</translation>
    </message>
    <message>
        <source>Normality of the logarithms</source>
        <translation>Normalité des logarithmes</translation>
    </message>
    <message>
        <source>Normal score</source>
        <translation>Score normal</translation>
    </message>
    <message>
        <source>Differs in</source>
        <translation>Diffère par</translation>
    </message>
    <message>
        <source>no machine of the register is of the type “%1”</source>
        <translation>aucune machine du registre n’est du type «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>several makers have the type “%1”; say “%2 %1”</source>
        <translation>plusieurs constructeurs ont le type «&#xa0;%1&#xa0;»&#x202f;; indiquez «&#xa0;%2 %1&#xa0;»</translation>
    </message>
    <message>
        <source>the machines of the type “%1” have no test with %2</source>
        <translation>les machines du type «&#xa0;%1&#xa0;» n’ont aucun essai donnant %2</translation>
    </message>
    <message>
        <source>%1 has a sign: a type test takes parameters without one</source>
        <translation>%1 est affectée d’un signe&#xa0;: un essai de type porte sur des grandeurs sans signe</translation>
    </message>
    <message>
        <source>this text is too long</source>
        <translation>ce texte est trop long</translation>
    </message>
    <message>
        <source>a tolerance is not negative; two values, the least and the largest, are a range</source>
        <translation>une tolérance n’est pas négative&#x202f;; deux valeurs, la plus petite et la plus grande, font un intervalle</translation>
    </message>
    <message>
        <source>the test gives it; remove the row to type its numbers</source>
        <translation>l’essai la fournit&#x202f;; supprimer la ligne pour saisir ses nombres</translation>
    </message>
    <message>
        <source>another row has this number</source>
        <translation>une autre ligne porte ce numéro</translation>
    </message>
    <message>
        <source>an uncertainty is not negative</source>
        <translation>une incertitude n’est pas négative</translation>
    </message>
    <message>
        <source>line %1 of what was pasted: “%2” cannot stand in this column</source>
        <translation>ligne %1 du bloc collé&#xa0;: «&#xa0;%2&#xa0;» ne peut pas figurer dans cette colonne</translation>
    </message>
    <message>
        <source>Difference of the mean deviations</source>
        <translation>Différence des écarts moyens</translation>
    </message>
    <message>
        <source>after − before</source>
        <translation>après − avant</translation>
    </message>
    <message>
        <source>x̄ bi-directional ± U for all points</source>
        <translation>x̄ bidirectionnel ± U pour tous les points</translation>
    </message>
    <message>
        <source>x̄ bi-directional</source>
        <translation>x̄ bidirectionnel</translation>
    </message>
    <message>
        <source>The two tests are of different kinds: they are not compared.</source>
        <translation>Les deux essais sont de nature différente&#xa0;: ils ne sont pas comparés.</translation>
    </message>
    <message>
        <source>The two tests are of different axes or planes: they are not compared.</source>
        <translation>Les deux essais portent sur des axes ou des plans différents&#xa0;: ils ne sont pas comparés.</translation>
    </message>
    <message>
        <source>The two tests were made in different directions: they are not compared.</source>
        <translation>Les deux essais ont été faits dans des sens différents&#xa0;: ils ne sont pas comparés.</translation>
    </message>
    <message>
        <source>The two circles differ in radius or signal: they are not compared.</source>
        <translation>Les deux cercles diffèrent par le rayon ou le signal&#xa0;: ils ne sont pas comparés.</translation>
    </message>
    <message>
        <source>Tests without an edition have no results to be compared.</source>
        <translation>Des essais sans édition n’ont pas de résultats à comparer.</translation>
    </message>
    <message>
        <source>Both laboratories used the same instrument: its error is in both results, and E_n would not see it.</source>
        <translation>Les deux laboratoires ont utilisé le même instrument&#xa0;: son erreur est dans les deux résultats et E_n ne la verrait pas.</translation>
    </message>
    <message>
        <source>Fewer than 5 common targets: nothing is said of the parameters.</source>
        <translation>Moins de 5 points visés communs&#xa0;: rien n’est dit des grandeurs.</translation>
    </message>
    <message>
        <source>One cycle alone shows no repeatability: nothing is said of a change.</source>
        <translation>Un seul cycle ne montre aucune répétabilité&#xa0;: rien n’est dit d’un changement.</translation>
    </message>
    <message>
        <source>The repeatability of the circles is not known: nothing is said of a change.</source>
        <translation>La répétabilité des cercles n’est pas connue&#xa0;: rien n’est dit d’un changement.</translation>
    </message>
    <message>
        <source>No uncertainty is known in both tests: nothing is said of a change.</source>
        <translation>L’incertitude n’est pas connue pour les deux essais&#xa0;: rien n’est dit d’un changement.</translation>
    </message>
    <message>
        <source>the instrument</source>
        <comment>shared error</comment>
        <translation>l’instrument</translation>
    </message>
    <message>
        <source>temperature sensors of the machine</source>
        <comment>shared error</comment>
        <translation>capteurs de température de la machine</translation>
    </message>
    <message>
        <source>α of the machine</source>
        <comment>shared error</comment>
        <translation>α de la machine</translation>
    </message>
    <message>
        <source>temperature sensors of the instrument</source>
        <comment>shared error</comment>
        <translation>capteurs de température de l’instrument</translation>
    </message>
    <message>
        <source>α of the instrument</source>
        <comment>shared error</comment>
        <translation>α de l’instrument</translation>
    </message>
    <message>
        <source>misalignment</source>
        <comment>shared error</comment>
        <translation>défaut d’alignement</translation>
    </message>
    <message>
        <source>before</source>
        <comment>of two tests</comment>
        <translation>avant</translation>
    </message>
    <message>
        <source>after</source>
        <comment>of two tests</comment>
        <translation>après</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Différence</translation>
    </message>
    <message>
        <source>Statement</source>
        <translation>Énoncé</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Passes</translation>
    </message>
    <message>
        <source>no change proven</source>
        <translation>non prouvé</translation>
    </message>
    <message>
        <source>changed</source>
        <comment>a value</comment>
        <translation>changé</translation>
    </message>
    <message>
        <source>changed, better</source>
        <translation>changé, mieux</translation>
    </message>
    <message>
        <source>changed, worse</source>
        <translation>changé, moins bien</translation>
    </message>
    <message>
        <source>unchanged within t</source>
        <translation>inchangé à t près</translation>
    </message>
    <message>
        <source>changed by more than t</source>
        <translation>changé de plus de t</translation>
    </message>
    <message>
        <source>the results agree</source>
        <translation>les résultats concordent</translation>
    </message>
    <message>
        <source>the results disagree</source>
        <translation>les résultats divergent</translation>
    </message>
    <message>
        <source>Comparison of two tests</source>
        <translation>Comparaison de deux essais</translation>
    </message>
    <message>
        <source>Difference of two results of the standard; the comparison itself is an interpretation, not a result of it.</source>
        <translation>Différence de deux résultats de la norme&#x202f;; la comparaison elle-même est une interprétation et non un résultat de celle-ci.</translation>
    </message>
    <message>
        <source>By what is stated, the second test was made before the first.</source>
        <translation>D’après ce qui est indiqué, le second essai a été effectué avant le premier.</translation>
    </message>
    <message>
        <source>Differences of the conditions</source>
        <translation>Conditions qui diffèrent</translation>
    </message>
    <message>
        <source>everything else is stated alike in both tests</source>
        <translation>tout le reste est indiqué de même dans les deux essais</translation>
    </message>
    <message>
        <source>Agreed tolerance t of a change: %1.</source>
        <translation>Tolérance t convenue pour un changement&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1 common targets; the first %2 cycles of each test</source>
        <translation>%1 points visés communs&#x202f;; les %2 premiers cycles de chaque essai</translation>
    </message>
    <message>
        <source>%1 common targets; the first cycle of each test</source>
        <translation>%1 points visés communs&#x202f;; le premier cycle de chaque essai</translation>
    </message>
    <message>
        <source>Differences of the parameters</source>
        <translation>Différences des grandeurs</translation>
    </message>
    <message>
        <source>No error of measurement is known to be shared.</source>
        <translation>Aucune erreur de mesure commune n’est connue.</translation>
    </message>
    <message>
        <source>Shared by both tests: %1; all other errors are those of each.</source>
        <translation>Communs aux deux essais&#xa0;: %1&#x202f;; toutes les autres erreurs sont propres à chacun.</translation>
    </message>
    <message>
        <source>%1, not in the other test: %2</source>
        <translation>%1, absents de l’autre essai&#xa0;: %2</translation>
    </message>
    <message>
        <source>Readings without a value</source>
        <translation>Lectures sans valeur</translation>
    </message>
    <message>
        <source>“Changed” where the difference exceeds its U, always between these two sessions.</source>
        <translation>«&#xa0;Changé&#xa0;» lorsque la différence dépasse son U, toujours entre ces deux séances.</translation>
    </message>
    <message>
        <source>Of simulated pairs without a change, up to 12 % show one of A, E, M, R and B changed.</source>
        <translation>Parmi des couples simulés sans changement, jusqu’à 12&#xa0;% montrent A, E, M, R ou B changé.</translation>
    </message>
    <message>
        <source>U of the difference: root of the sum of the squares of both U, each with its repeatability (JCGM 100); nothing shared is known.</source>
        <translation>U de la différence&#xa0;: racine de la somme des carrés des deux U, chacun avec sa répétabilité (JCGM 100)&#x202f;; rien de commun n’est connu.</translation>
    </message>
    <message>
        <source>between targets of the first test: linear; less the mean of all</source>
        <translation>entre les points visés du premier essai&#xa0;: linéaire&#x202f;; moins la moyenne de tous</translation>
    </message>
    <message>
        <source>at the common targets, less the mean of all</source>
        <translation>aux points visés communs, moins la moyenne de tous</translation>
    </message>
    <message>
        <source>Two tests</source>
        <translation>Deux essais</translation>
    </message>
    <message>
        <source>As found and as left, before and after, two machines, two laboratories: two tests of one axis or plane are compared at their common targets, with as many cycles as both have. Everything else that differs is listed above the result. It is an interpretation, no result of the standard.</source>
        <translation>Avant et après réglage, deux machines, deux laboratoires&#xa0;: deux essais d’un axe ou d’un plan sont comparés à leurs points visés communs, avec autant de cycles qu’en ont les deux. Tout ce qui diffère par ailleurs est énuméré au-dessus du résultat. C’est une interprétation, non un résultat de la norme.</translation>
    </message>
    <message>
        <source>U of the difference</source>
        <translation>U de la différence</translation>
    </message>
    <message>
        <source>One simulation of both tests draws whole cycles anew and the errors of the budget, those that both share (the same instrument, α of the machine, the sensors) once for both. The U of each test would say too much of what is shared, and nothing of other cycles.</source>
        <translation>Une simulation des deux essais tire à nouveau des cycles entiers et les erreurs du budget, celles qui sont communes (le même instrument, α de la machine, les capteurs) une seule fois pour les deux. L’U de chaque essai en dirait trop de ce qui est commun, et rien d’autres cycles.</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Énoncés</translation>
    </message>
    <message>
        <source>“Changed” where the difference exceeds its U, between these two sessions; else “no change proven”. With an agreed tolerance: unchanged within it, changed by more, or not proven. Laboratories are judged by E_n.</source>
        <translation>«&#xa0;Changé&#xa0;» lorsque la différence dépasse son U, entre ces deux séances&#x202f;; sinon «&#xa0;non prouvé&#xa0;». Avec une tolérance convenue&#xa0;: inchangé à celle-ci près, changé de plus, ou non prouvé. Les laboratoires sont jugés par E_n.</translation>
    </message>
    <message>
        <source>which test of A, and of B, from 1; without it the first of A that has its like in B</source>
        <translation>quel essai de A, et de B, à partir de 1&#x202f;; sinon le premier de A qui a son pareil dans B</translation>
    </message>
    <message>
        <source>two laboratories measured one machine: E_n, only α of the machine is shared</source>
        <translation>deux laboratoires ont mesuré une même machine&#xa0;: E_n, seul α de la machine est commun</translation>
    </message>
    <message>
        <source>agreed tolerance of a change, µm (rotary: arc seconds): unchanged within it</source>
        <translation>tolérance convenue pour un changement, µm (rotatif&#xa0;: secondes d’arc)&#xa0;: inchangé à celle-ci près</translation>
    </message>
    <message>
        <source>the instrument stood as it had been aligned: the misalignment is shared</source>
        <translation>l’instrument est resté tel qu’aligné&#xa0;: le défaut d’alignement est commun</translation>
    </message>
    <message>
        <source>the comparison as JSON</source>
        <translation>la comparaison en JSON</translation>
    </message>
    <message>
        <source>no test of the first file has its like in the second: same axis or plane, directions and radius; --test names two</source>
        <translation>aucun essai du premier fichier n’a son pareil dans le second&#xa0;: même axe ou plan, mêmes sens et rayon&#x202f;; --test en nomme deux</translation>
    </message>
    <message>
        <source>what has changed from test A to test B: differences with their uncertainty</source>
        <translation>ce qui a changé de l’essai A à l’essai B&#xa0;: différences avec leur incertitude</translation>
    </message>
    <message>
        <source>only the certificate: verdict, results, conditions, what the text of the edition asks, signatures</source>
        <translation>le certificat seul&#xa0;: verdict, résultats, conditions, ce que demande le texte de l’édition, signatures</translation>
    </message>
    <message>
        <source>End of the certificate. The annex from page %1 on is part of this report.</source>
        <translation>Fin du certificat. L’annexe, à partir de la page %1, fait partie de ce rapport.</translation>
    </message>
    <message>
        <source>Responsibility and signatures</source>
        <translation>Responsabilité et signatures</translation>
    </message>
    <message>
        <source>Program and test file</source>
        <translation>Programme et fichier d’essai</translation>
    </message>
    <message>
        <source>Annex</source>
        <translation>Annexe</translation>
    </message>
    <message>
        <source>Findings of test %1</source>
        <translation>Constats de l’essai %1</translation>
    </message>
    <message>
        <source>what the text of %1 asks for and this test does not have</source>
        <translation>ce que le texte de %1 demande et que cet essai n’a pas</translation>
    </message>
    <message>
        <source>Findings of practice, laboratory and program</source>
        <translation>Constats d’usage, de laboratoire et du programme</translation>
    </message>
    <message>
        <source>limits: %1</source>
        <translation>limites&#xa0;: %1</translation>
    </message>
    <message>
        <source>U: expanded uncertainty</source>
        <translation>U&#xa0;: incertitude étendue</translation>
    </message>
    <message>
        <source>coverage factor k = 2, coverage probability of about 95 %</source>
        <translation>facteur conventionnel k&#xa0;=&#xa0;2, probabilité de couverture d’environ 95&#xa0;%</translation>
    </message>
    <message>
        <source>stated by the laboratory</source>
        <translation>indiquée par le laboratoire</translation>
    </message>
    <message>
        <source>from the budget in the annex</source>
        <translation>d’après le budget en annexe</translation>
    </message>
    <message>
        <source>Decision rule: %1. A limit is met by a value not above it; the verdict is based on unrounded values.</source>
        <translation>Règle de décision&#xa0;: %1. Une limite est respectée par une valeur qui ne la dépasse pas&#x202f;; verdict établi sur les valeurs non arrondies.</translation>
    </message>
    <message>
        <source>Decision rule: %1. A limit is met where value + %2 ≤ limit, exceeded where value − %2 &gt; limit, otherwise not proven; the verdict is based on unrounded values.</source>
        <translation>Règle de décision&#xa0;: %1. Une limite est respectée si valeur&#xa0;+&#xa0;%2&#xa0;≤&#xa0;limite, dépassée si valeur&#xa0;−&#xa0;%2&#xa0;&gt;&#xa0;limite, sinon le respect n’est pas prouvé&#x202f;; verdict établi sur les valeurs non arrondies.</translation>
    </message>
    <message>
        <source>Decision rule: %1. A limit is met where value + %2 ≤ limit, exceeded where value − %2 &gt; limit; between, non-conformity is not proven; the verdict is based on unrounded values.</source>
        <translation>Règle de décision&#xa0;: %1. Une limite est respectée si valeur&#xa0;+&#xa0;%2&#xa0;≤&#xa0;limite, dépassée si valeur&#xa0;−&#xa0;%2&#xa0;&gt;&#xa0;limite&#x202f;; entre les deux, la non-conformité n’est pas prouvée&#x202f;; verdict établi sur les valeurs non arrondies.</translation>
    </message>
    <message>
        <source>limit ± %1, one scale per row</source>
        <translation>limite ± %1, une échelle par ligne</translation>
    </message>
    <message>
        <source>edition of the test: %1; the others without verdict</source>
        <translation>édition de l’essai&#xa0;: %1&#x202f;; les autres sans verdict</translation>
    </message>
    <message>
        <source>Twice the standard deviation of U over the blocks of trials: at most %1.</source>
        <translation>Deux fois l’écart-type de U d’un bloc de tirages à l’autre&#xa0;: au plus %1.</translation>
    </message>
    <message>
        <source>expected the id of another test of this file, no drift test; “%1” is none</source>
        <translation>l’identifiant d’un autre essai de ce fichier est attendu, sans essai de dérive&#x202f;; «&#xa0;%1&#xa0;» n’en est pas un</translation>
    </message>
    <message>
        <source>Diff. ± U</source>
        <translation>Écart ± U</translation>
    </message>
    <message>
        <source>Decision</source>
        <comment>on two tests</comment>
        <translation>Décision</translation>
    </message>
    <message>
        <source>Different</source>
        <translation>Différent</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Changé</translation>
    </message>
    <message>
        <source>%1: %2 → %3, difference %4 ± %5</source>
        <translation>%1&#xa0;: %2 → %3, différence %4 ± %5</translation>
    </message>
    <message>
        <source>Alike: %1.</source>
        <translation>Identiques&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Stated: the instrument stood as it had been aligned for the other test.</source>
        <translation>Déclaré&#xa0;: l’instrument est resté tel qu’aligné pour l’autre essai.</translation>
    </message>
    <message>
        <source>no test of the file states what it is compared with (“comparedWith”); --test names two</source>
        <translation>aucun essai du fichier ne déclare à quoi il est comparé («&#xa0;comparedWith&#xa0;»)&#x202f;; --test en nomme deux</translation>
    </message>
    <message>
        <source>the command %1 takes one or two files</source>
        <translation>la commande %1 attend un ou deux fichiers</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>parameters that changed</comment>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>expected nothing here, for “channels” has the readings</source>
        <translation>rien n’est attendu ici, car «&#xa0;channels&#xa0;» contient les relevés</translation>
    </message>
    <message>
        <source>expected times that ascend</source>
        <translation>des temps croissants sont attendus</translation>
    </message>
    <message>
        <source>Understood: a drift test; channels: %1; temperatures: %2; points: %3; duration: %4.</source>
        <translation>Compris&#xa0;: un essai de dérive&#x202f;; voies&#xa0;: %1&#x202f;; températures&#xa0;: %2&#x202f;; points&#xa0;: %3&#x202f;; durée&#xa0;: %4.</translation>
    </message>
    <message>
        <source>E_VE of the drift test “%1” is a lower bound: its record is shorter than the test, or has a gap of more than a tenth of it.</source>
        <translation>L’E_VE de l’essai de dérive «&#xa0;%1&#xa0;» est une borne inférieure&#xa0;: son relevé est plus court que l’essai, ou a une lacune de plus d’un dixième de sa durée.</translation>
    </message>
    <message>
        <source>Against the last</source>
        <translation>Depuis le dernier</translation>
    </message>
    <message>
        <source>%1 of the machines of the type</source>
        <translation>%1 des machines du type</translation>
    </message>
    <message>
        <source>Logarithms over normal scores</source>
        <translation>Logarithmes selon les scores normaux</translation>
    </message>
    <message>
        <source>Values over normal scores</source>
        <translation>Valeurs selon les scores normaux</translation>
    </message>
    <message>
        <source>Duration of the test</source>
        <translation>Durée de l’essai</translation>
    </message>
    <message>
        <source>Thermal behaviour</source>
        <translation>Comportement thermique</translation>
    </message>
    <message>
        <source>Used by</source>
        <translation>Sert à</translation>
    </message>
    <message>
        <source>At the beginning</source>
        <translation>Au début</translation>
    </message>
    <message>
        <source>in balance with its temperatures, as stated</source>
        <translation>en équilibre avec ses températures, selon la déclaration</translation>
    </message>
    <message>
        <source>resolution %1</source>
        <translation>résolution %1</translation>
    </message>
    <message>
        <source>as recorded, duration of the test not stated</source>
        <translation>relevé entier, durée de l’essai non déclarée</translation>
    </message>
    <message>
        <source>test of %1</source>
        <translation>essai de %1</translation>
    </message>
    <message>
        <source>half the duration, %1</source>
        <translation>demi-durée, %1</translation>
    </message>
    <message>
        <source>without drift</source>
        <translation>sans dérive</translation>
    </message>
    <message>
        <source>whole record, %1</source>
        <translation>tout le relevé, %1</translation>
    </message>
    <message>
        <source>steps of time differ: no response</source>
        <translation>pas de temps inégaux&#xa0;: pas de réponse</translation>
    </message>
    <message>
        <source>gap in the temperature: no response</source>
        <translation>lacune dans la température&#xa0;: pas de réponse</translation>
    </message>
    <message>
        <source>too few values: no response</source>
        <translation>trop peu de valeurs&#xa0;: pas de réponse</translation>
    </message>
    <message>
        <source>no response proven</source>
        <translation>aucune réponse prouvée</translation>
    </message>
    <message>
        <source>not to be told from a straight drift</source>
        <translation>ne se distingue pas d’une dérive rectiligne</translation>
    </message>
    <message>
        <source>temperature too noisy</source>
        <translation>température trop bruitée</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Dérive</translation>
    </message>
    <message>
        <source>response of %1 to “%2”</source>
        <translation>réponse de %1 à «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Duration of the window T</source>
        <translation>Durée de la fenêtre T</translation>
    </message>
    <message>
        <source>Channel</source>
        <comment>of a drift test</comment>
        <translation>Voie</translation>
    </message>
    <message>
        <source>Share of U²(%1)</source>
        <translation>Part de U²(%1)</translation>
    </message>
    <message>
        <source>E_VE of %1, whole record</source>
        <translation>E_VE de %1, tout le relevé</translation>
    </message>
    <message>
        <source>Ranges of the record: %1</source>
        <translation>Étendues du relevé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Response to the temperature</source>
        <translation>Réponse à la température</translation>
    </message>
    <message>
        <source>What the drift explains</source>
        <translation>Ce que la dérive explique</translation>
    </message>
    <message>
        <source>trend: OUT.csv, json, svg, png or pdf; type: OUT.json, svg, png or pdf; report: OUT.pdf, of two languages OUT.fr.pdf and OUT.en.pdf</source>
        <translation>trend&#xa0;: OUT.csv, json, svg, png ou pdf&#x202f;; type&#xa0;: OUT.json, svg, png ou pdf&#x202f;; report&#xa0;: OUT.pdf, en deux langues OUT.fr.pdf et OUT.en.pdf</translation>
    </message>
    <message>
        <source>a picture shows one parameter of one axis: choose it with --parameter and --axis</source>
        <translation>une image montre une grandeur d’un axe&#xa0;: la choisir avec --parameter et --axis</translation>
    </message>
    <message>
        <source>an influence, in the units of the diagnosis (µm, µm/m, µrad, ms); after @ the pitch of cyclic in mm (10), the width of reversalSpike in degrees (1.5), the expansion of temperature in µm/(m·°C) (11.7), the frequency of vibration in Hz (10). drift: response:X=µm/°C@min (40), straight:X=µm/h, temperature=°C@h, the swing of the air and its period (12)</source>
        <translation>une influence, dans les unités du diagnostic (µm, µm/m, µrad, ms)&#x202f;; après @ le pas de cyclic en mm (10), la largeur de reversalSpike en degrés (1,5), la dilatation de temperature en µm/(m·°C) (11,7), la fréquence de vibration en Hz (10). drift&#xa0;: response:X=µm/°C@min (40), straight:X=µm/h, temperature=°C@h, l’oscillation de l’air et sa période (12)</translation>
    </message>
    <message>
        <source>drift: length of the record, h</source>
        <translation>drift&#xa0;: durée du relevé, h</translation>
    </message>
    <message>
        <source>drift: time between two values, s</source>
        <translation>drift&#xa0;: temps entre deux valeurs, s</translation>
    </message>
    <message>
        <source>Type test</source>
        <translation>Essai de type</translation>
    </message>
    <message>
        <source>Drift test</source>
        <translation>Essai de dérive</translation>
    </message>
    <message>
        <source>Several sensors at rest over hours, with the temperatures beside them: a table of times, deviations and temperatures is read as one drift test. The channel of an axis has its name.</source>
        <translation>Plusieurs capteurs au repos pendant des heures, avec les températures&#xa0;: un tableau de temps, d’écarts et de températures est lu comme un seul essai de dérive. La voie d’un axe porte son nom.</translation>
    </message>
    <message>
        <source>E_VE over the duration of a test</source>
        <translation>E_VE sur la durée d’un essai</translation>
    </message>
    <message>
        <source>The largest range within any window as long as the test. Only a test whose duration is stated takes it so; others take the range of the whole record. A record that is too short gives a lower bound, which is said.</source>
        <translation>La plus grande étendue dans une fenêtre de la durée de l’essai. Seul un essai dont la durée est déclarée la prend ainsi&#x202f;; les autres prennent l’étendue de tout le relevé. Un relevé trop court donne une borne inférieure, ce qui est dit.</translation>
    </message>
    <message>
        <source>How many µm a channel moves per °C, and how fast: x = a + b·t + k·y, τ·dy/dt = θ − y, with intervals of 95 % for noise that may be correlated. Where the data cannot carry it, a sentence says why. It is an interpretation, no result of the standard.</source>
        <translation>De combien de µm une voie se déplace par&#xa0;°C, et à quelle vitesse&#xa0;: x = a + b·t + k·y, τ·dy/dt = θ − y, avec des intervalles à 95&#xa0;% pour un bruit qui peut être corrélé. Quand les données ne le permettent pas, une phrase dit pourquoi. C’est une interprétation, pas un résultat de la norme.</translation>
    </message>
    <message>
        <source>How much of U it is, and what half the duration, no drift, or a temperature held to ± 1, 2 or 5 °C would make of it at worst.</source>
        <translation>La part de U qu’elle représente, et ce qu’une durée divisée par deux, l’absence de dérive ou une température tenue à ±&#xa0;1, 2 ou 5&#xa0;°C en feraient, au pire.</translation>
    </message>
    <message>
        <source>agreeing</source>
        <translation>concordant</translation>
    </message>
    <message>
        <source>interval, 95 %</source>
        <translation>intervalle, 95&#xa0;%</translation>
    </message>
    <message>
        <source>Case</source>
        <comment>of drift</comment>
        <translation>Cas</translation>
    </message>
    <message>
        <source>Difference of the paths</source>
        <translation>Différence des trajectoires</translation>
    </message>
    <message>
        <source>Sources that both circles show</source>
        <translation>Sources que les deux cercles montrent</translation>
    </message>
    <message>
        <source>each about its least squares centre</source>
        <translation>chacune autour de son centre des moindres carrés</translation>
    </message>
    <message>
        <source>That is beyond the ends of the axis, %1 and %2.</source>
        <translation>C’est au-delà des extrémités de l’axe, %1 et %2.</translation>
    </message>
    <message>
        <source>That is more than the travel of the axis, %1.</source>
        <translation>C’est plus que la longueur d’axe, %1.</translation>
    </message>
    <message>
        <source>program: without it that of the machine&apos;s control</source>
        <translation>program&#xa0;: sans l’option, celui de la commande de la machine</translation>
    </message>
    <message>
        <source>the test has no targets to move to: plan them with %1</source>
        <translation>l’essai n’a pas de points visés à atteindre&#xa0;: les planifier avec %1</translation>
    </message>
    <message>
        <source>the test names no control whose language is known: say it with %1</source>
        <translation>l’essai ne nomme aucune commande dont le langage soit connu&#xa0;: l’indiquer avec %1</translation>
    </message>
    <message>
        <source>Variation over the duration</source>
        <translation>Variation selon la durée</translation>
    </message>
    <message>
        <source>Drift and temperatures</source>
        <translation>Dérive et températures</translation>
    </message>
    <message>
        <source>%1 or %2? Type one of them</source>
        <translation>%1 ou %2&#x202f;? Saisir l’une des deux</translation>
    </message>
    <message>
        <source>a power of ten: type all digits</source>
        <translation>une puissance de dix&#xa0;: saisir tous les chiffres</translation>
    </message>
    <message>
        <source>more than 21 digits before the decimal mark</source>
        <translation>plus de 21 chiffres avant la virgule</translation>
    </message>
    <message>
        <source>Generalised least squares since the last intervention; what tests share (instrument, temperature sensors, α of the machine) is no scatter.</source>
        <translation>Moindres carrés généralisés depuis la dernière intervention&#x202f;; ce que des essais ont en commun (instrument, capteurs de température, α de la machine) n’est pas de la dispersion.</translation>
    </message>
    <message>
        <source>V = diag(r² + s²) + Σ c·cᵀ: r own, c shared, s scatter beyond them.</source>
        <translation>V = diag(r² + s²) + Σ c·cᵀ&#xa0;: r part propre, c part commune, s dispersion au-delà.</translation>
    </message>
    <message>
        <source>A trend is shown where the slope is at least t times its standard uncertainty (95 %). Not before: line + t·u reaches the limit, less the guard band where conformity has to be proven; one-sided 95 %, for the level, not for the next test.</source>
        <translation>Une tendance est indiquée si la pente atteint au moins t fois son incertitude type (95&#xa0;%). Pas avant&#xa0;: la droite + t·u atteint la limite, diminuée de la bande de garde si la conformité est à prouver&#x202f;; borne unilatérale à 95&#xa0;%, pour le niveau, non pour le prochain essai.</translation>
    </message>
    <message>
        <source>the %1 in which %2 varies most</source>
        <translation>les %1 où %2 varie le plus</translation>
    </message>
    <message>
        <source>Variation of %1 in %2</source>
        <translation>Variation de %1 en %2</translation>
    </message>
    <message>
        <source>Variation of %1, whole record</source>
        <translation>Variation de %1, tout le relevé</translation>
    </message>
    <message>
        <source>Share</source>
        <comment>of the drift in an uncertainty</comment>
        <translation>Part</translation>
    </message>
    <message>
        <source>%1 of U²(%2)</source>
        <translation>%1 de U²(%2)</translation>
    </message>
    <message>
        <source>without drift %1</source>
        <translation>sans dérive&#xa0;: %1</translation>
    </message>
    <message>
        <source>Cause</source>
        <comment>of the drift</comment>
        <translation>Origine</translation>
    </message>
    <message>
        <source>no temperature was recorded</source>
        <translation>aucune température relevée</translation>
    </message>
    <message>
        <source>thin black line: %1</source>
        <translation>trait noir fin&#xa0;: %1</translation>
    </message>
    <message>
        <source>The newest comparable test of each machine of a type, with upper tolerance limits: what most machines of the type stay below. The machines are those in the register, no random sample. The examples have one of eight machines.</source>
        <translation>Le dernier essai comparable de chaque machine d’un type, avec des limites supérieures de tolérance&#xa0;: ce que la plupart des machines du type ne dépassent pas. Les machines sont celles du registre, pas un échantillon aléatoire. Les exemples en contiennent un de huit machines.</translation>
    </message>
    <message>
        <source>E_n (ISO/IEC 17043): difference over its U; the results agree where its magnitude is at most 1.</source>
        <translation>E_n (ISO/IEC 17043)&#xa0;: différence divisée par son U&#x202f;; les résultats concordent lorsqu’il vaut au plus 1 en valeur absolue.</translation>
    </message>
    <message>
        <source>Unchanged within t where difference and U together are at most t; changed by more than t where the difference less U exceeds it; always between these two sessions.</source>
        <translation>Inchangé à t près lorsque différence et U ne dépassent pas t ensemble&#x202f;; changé de plus de t lorsque la différence diminuée de U dépasse t&#x202f;; toujours entre ces deux séances.</translation>
    </message>
    <message>
        <source>Parts of U (%1), each alone: repeatability; errors of measurement; shift of the mean, which decides nothing: %2.</source>
        <translation>Parts de U (%1), chacune seule&#xa0;: répétabilité&#x202f;; erreurs de mesure&#x202f;; écart de la moyenne, qui ne décide de rien&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Repeatability alone (%1): %2.</source>
        <translation>Répétabilité seule (%1)&#xa0;: %2.</translation>
    </message>
    <message>
        <source>list, trend: what has changed in each test since the last one of its axis or plane; reads their files</source>
        <translation>list, trend&#xa0;: ce qui a changé à chaque essai depuis le dernier de son axe ou plan&#x202f;; lit leurs fichiers</translation>
    </message>
    <message>
        <source>type: the type of the machines, or maker and type; may be left out where files are all of one</source>
        <translation>type&#xa0;: le type des machines, ou constructeur et type&#x202f;; facultatif lorsque les fichiers sont tous d’un même type</translation>
    </message>
    <message>
        <source>files and --%1 do not go together</source>
        <translation>des fichiers et --%1 s’excluent</translation>
    </message>
    <message>
        <source>the machines of the files are not all of one type; choose it with --type</source>
        <translation>les machines des fichiers ne sont pas toutes d’un même type&#x202f;; choisissez-le par --type</translation>
    </message>
    <message>
        <source>Further conditions</source>
        <translation>Autres conditions</translation>
    </message>
    <message>
        <source>Serial No.</source>
        <comment>column</comment>
        <translation>N° de série</translation>
    </message>
    <message>
        <source>The trend follows from the attached values; the tests themselves are not attached.</source>
        <translation>La tendance découle des valeurs jointes&#x202f;; les essais eux-mêmes ne sont pas joints.</translation>
    </message>
    <message>
        <source>this PDF is the history of a machine: it carries the values of its tests and no test file; verify it, or open the tests it names</source>
        <translation>ce PDF est l’historique d’une machine&#xa0;: il porte les valeurs de ses essais, sans fichier d’essai&#x202f;; vérifiez-le ou ouvrez les essais qu’il nomme</translation>
    </message>
    <message>
        <source>these are no data of a printed history, or a newer program wrote them</source>
        <translation>ce ne sont pas les données d’un historique imprimé, ou un programme plus récent les a écrites</translation>
    </message>
    <message>
        <source>The newest comparable test of each machine; U is stated and not subtracted. Upper tolerance limit: mean + k·s, log-normal exp(m + k·s) of the logarithms, k = t′(N − 1; z·√N)/√N of the noncentral t distribution (Boost.Math). Both are shown; no test chooses between them. Largest value: confidence 1 − p^N, by order statistics. Normality, from 8 machines on: Shapiro and Francia, J. Am. Stat. Assoc. 67 (1972), 215–216; probability: Royston, Statistics in Medicine 12 (1993), 181–184.</source>
        <translation>Essai comparable le plus récent de chaque machine&#x202f;; U est indiquée et non retranchée. Limite supérieure de tolérance&#xa0;: moyenne + k·s, ou log-normale exp(m + k·s) des logarithmes, k = t′(N − 1&#x202f;; z·√N)/√N de la loi de Student non centrée (Boost.Math). Les deux sont affichées&#x202f;; aucun test ne choisit entre elles. Plus grande valeur&#xa0;: niveau de confiance 1 − p^N, par les statistiques d’ordre. Normalité, à partir de 8 machines&#xa0;: Shapiro et Francia, J. Am. Stat. Assoc. 67 (1972), 215–216&#x202f;; probabilité&#xa0;: Royston, Statistics in Medicine 12 (1993), 181–184.</translation>
    </message>
    <message>
        <source>value ± U</source>
        <translation>valeur ± U</translation>
    </message>
    <message>
        <source>U: 95 % from both fits; degrees of freedom by JCGM 100, G.4</source>
        <translation>U&#xa0;: 95&#xa0;% d’après les deux ajustements&#x202f;; degrés de liberté selon JCGM&#xa0;100, G.4</translation>
    </message>
    <message>
        <source>U of the difference: one simulation of both tests (JCGM 101), %1 trials, 95.45 %. Whole cycles are drawn anew, a method of this program: residuals widened by half of Student’s t of 2n − 2 degrees of freedom; band of the curves by Bonferroni.</source>
        <translation>U de la différence&#xa0;: une simulation des deux essais (JCGM&#xa0;101), %1 tirages, 95,45&#xa0;%. Les cycles entiers sont tirés à nouveau, méthode propre à ce programme&#xa0;: résidus élargis par la moitié du t de Student à 2n − 2 degrés de liberté&#x202f;; bande des courbes selon Bonferroni.</translation>
    </message>
    <message>
        <source>U of the difference: root of the sum of the squares of both U and of the repeatability (JCGM 100); nothing shared is known.</source>
        <translation>U de la différence&#xa0;: racine de la somme des carrés des deux U et de la répétabilité (JCGM&#xa0;100)&#x202f;; rien de commun n’est connu.</translation>
    </message>
    <message>
        <source>nothing is proven without a measurement uncertainty</source>
        <translation>rien n’est prouvé sans incertitude de mesure</translation>
    </message>
    <message>
        <source>nothing is proven: not corrected to 20 °C</source>
        <translation>rien n’est prouvé&#xa0;: sans correction à 20&#xa0;°C</translation>
    </message>
    <message>
        <source>nothing is proven: not shown to hold at 20 °C</source>
        <translation>rien n’est prouvé&#xa0;: validité à 20&#xa0;°C non établie</translation>
    </message>
    <message>
        <source>θ held to ± %1, at worst</source>
        <translation>θ tenue à ± %1, au pire</translation>
    </message>
    <message>
        <source>Interpretation, not a result of ISO 230-2. Environmental variation error: largest range over a duration T (public drafts of annex A).</source>
        <translation>Interprétation, pas un résultat de l’ISO 230-2. Erreur de variation environnementale&#xa0;: plus grande étendue sur T (projets publics de l’annexe&#xa0;A).</translation>
    </message>
    <message>
        <source>U of the budget (GUM) with that variation.</source>
        <translation>U du budget (GUM) avec cette variation.</translation>
    </message>
    <message>
        <source>θ held to ± Δ: at most 2Δ·|k|·(1 − e^(−T/τ)) plus the variation of x&#xa0;−&#xa0;k·y over T.</source>
        <translation>θ tenue à ± Δ&#xa0;: au plus 2Δ·|k|·(1 − e^(−T/τ)) plus la variation de x&#xa0;−&#xa0;k·y sur T.</translation>
    </message>
    <message>
        <source>x = a + b·t + k·y; τ·dy/dt = θ − y: one time constant, a model of this program. k and b by least squares, τ by a search; intervals of 95 % (Student’s t, degrees of freedom by JCGM 100, G.4) for noise that may be correlated, its spectrum taken from the residuals; shown by an F test. Of several temperatures the one that explains most.</source>
        <translation>x = a + b·t + k·y&#x202f;; τ·dy/dt = θ − y&#xa0;: une seule constante de temps, modèle propre à ce programme. k et b par moindres carrés, τ par balayage&#x202f;; intervalles à 95&#xa0;% (t de Student, degrés de liberté selon JCGM&#xa0;100, G.4) pour un bruit qui peut être corrélé, dont le spectre est tiré des résidus&#x202f;; établi par un test F. De plusieurs températures, celle qui explique le mieux.</translation>
    </message>
    <message>
        <source>%1 was warm after %2: less than a tenth of the range of y was left.</source>
        <translation>%1 était en température après %2&#xa0;: il restait moins d’un dixième de l’étendue de y.</translation>
    </message>
    <message>
        <source>expected a percentage from 0 to 100</source>
        <translation>attendu&#xa0;: un pourcentage de 0 à 100</translation>
    </message>
    <message>
        <source>expected 0 or a coefficient in µm/(m·°C), such as 11.5 for steel</source>
        <translation>attendu&#xa0;: 0 ou un coefficient en µm/(m·°C), par exemple 11,5 pour l’acier</translation>
    </message>
    <message>
        <source>Impossible value for “%1”: %2.</source>
        <translation>Valeur impossible pour «&#xa0;%1&#xa0;»&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Impossible value: the times of the drift test fall from %1 to %2.</source>
        <translation>Valeur impossible&#xa0;: les temps de l’essai de dérive reculent de %1 à %2.</translation>
    </message>
    <message>
        <source>Impossible value: the times of the temperatures of sensor %3 fall from %1 to %2.</source>
        <translation>Valeur impossible&#xa0;: les temps des températures du capteur %3 reculent de %1 à %2.</translation>
    </message>
    <message>
        <source>the unit of “%1” does not fit here; expected %2</source>
        <translation>l’unité de «&#xa0;%1&#xa0;» ne convient pas ici&#x202f;; attendu&#xa0;: %2</translation>
    </message>
    <message>
        <source>Edition: nothing in the file says it; %1 is taken.</source>
        <translation>Édition&#xa0;: rien ne le dit dans le fichier&#x202f;; %1 est retenue.</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>«&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>marks of missing readings: %1</source>
        <translation>marques de relevés manquants&#xa0;: %1</translation>
    </message>
    <message>
        <source>overdue since %1 (%2)</source>
        <translation>en retard depuis le %1 (%2)</translation>
    </message>
    <message>
        <source>no test of the file has the field “%1”</source>
        <translation>aucun essai du fichier n’a le champ «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Compensation in the test: “%1”. Table and prediction hold on top of what was active then: add the two, do not replace it.</source>
        <translation>Compensation pendant l’essai&#xa0;: «&#xa0;%1&#xa0;». La table et la prévision s’ajoutent à ce qui était alors actif&#xa0;: additionner les deux, ne pas remplacer.</translation>
    </message>
    <message>
        <source>The readings are not stated to be corrected to 20 °C: table and prediction hold for the machine at %1, expansion included.</source>
        <translation>Rien n’indique que les relevés sont corrigés à 20&#xa0;°C&#xa0;: la table et la prévision valent pour la machine à %1, dilatation comprise.</translation>
    </message>
    <message>
        <source>The readings are not stated to be corrected to 20 °C: table and prediction hold for the temperature of the test.</source>
        <translation>Rien n’indique que les relevés sont corrigés à 20&#xa0;°C&#xa0;: la table et la prévision valent à la température de l’essai.</translation>
    </message>
    <message>
        <source>Comparable tests</source>
        <translation>Essais comparables</translation>
    </message>
    <message>
        <source>a verdict other than “conforms” (the report is written all the same), an unmet requirement (check), a difference (verify, compare, selftest), nothing judged or proven (compare)</source>
        <translation>un verdict autre que «&#xa0;conforme&#xa0;» (le rapport est écrit malgré tout), une exigence non satisfaite (check), une différence (verify, compare, selftest), rien de jugé ou de prouvé (compare)</translation>
    </message>
    <message>
        <source>the template replaces “%1” by “%2”</source>
        <translation>le modèle remplace «&#xa0;%1&#xa0;» par «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>the template is of the instrument with the serial number %1, the file has the one with %2</source>
        <translation>le modèle est celui de l’instrument de numéro de série %1, le fichier a l’instrument %2</translation>
    </message>
    <message>
        <source>--template %1 has no effect here: it fits no test of the file; limits are of one kind of test, and of linear or of rotary axes</source>
        <translation>--template %1 est sans effet ici&#xa0;: il ne convient à aucun essai du fichier&#x202f;; des limites sont celles d’un seul type d’essai, et d’axes linéaires ou d’axes rotatifs</translation>
    </message>
    <message>
        <source>the user has no folder of their own (HOME): say with %1 where the register is</source>
        <translation>l’utilisateur n’a pas de dossier personnel (HOME)&#xa0;: indiquer par %1 où se trouve le registre</translation>
    </message>
    <message>
        <source>Every target lies where a cyclic error of the pitch %1 is 0: it does not show in the readings. Choose other --targets, another --travel or pitch.</source>
        <translation>Tous les points visés se trouvent là où une erreur cyclique de pas %1 est nulle&#xa0;: elle ne paraît pas dans les relevés. Choisir d’autres --targets, un autre --travel ou un autre pas.</translation>
    </message>
    <message>
        <source>standard output takes one part program, and the zone has its own; write them into files</source>
        <translation>la sortie standard prend un seul programme pièce, et la zone a le sien&#x202f;; les écrire dans des fichiers</translation>
    </message>
    <message>
        <source>another unit than the one shown</source>
        <translation>autre unité que celle indiquée</translation>
    </message>
    <message>
        <source>joined with %1</source>
        <translation>réunie à %1</translation>
    </message>
    <message>
        <source>joins them, and is not there now; connect it</source>
        <translation>ce dossier les réunit et n’est pas accessible maintenant&#x202f;; le connecter</translation>
    </message>
    <message>
        <source>no machine called “%1” was joined with another; “register list” shows which were</source>
        <translation>aucune machine «&#xa0;%1&#xa0;» n’a été réunie à une autre&#x202f;; «&#xa0;register list&#xa0;» montre lesquelles l’ont été</translation>
    </message>
    <message>
        <source>all tests of all machines in some folders, over the years: scan FOLDER…, list, trend, report, type [FILE…], join MACHINE MACHINE, separate MACHINE, interval MACHINE MONTHS</source>
        <translation>tous les essais de toutes les machines dans des dossiers, au fil des ans&#xa0;: scan FOLDER…, list, trend, report, type [FILE…], join MACHINE MACHINE, separate MACHINE, interval MACHINE MONTHS</translation>
    </message>
</context>
</TS>
