<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>ActionsPage</name>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>⚠ Can move the camera or change how it is held, until the next start</source>
        <translation>⚠ Kann die Kamera bewegen oder ändern, wie sie gehalten wird, bis zum nächsten Start</translation>
    </message>
    <message>
        <source>⚠ Changes permanent memory; a snapshot is taken first</source>
        <translation>⚠ Ändert den Festspeicher; vorher wird eine Sicherung gemacht</translation>
    </message>
    <message>
        <source>⚠ Overwrites settings; a snapshot is taken first</source>
        <translation>⚠ Überschreibt Einstellungen; vorher wird eine Sicherung gemacht</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Aktionen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation>Suchen (Strg+F)</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Aktionen durchsuchen</translation>
    </message>
    <message>
        <source>Actions of this board</source>
        <translation>Aktionen dieses Boards</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>The board&apos;s reply appears here.</source>
        <translation>Hier erscheint die Antwort des Boards.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ausführen</translation>
    </message>
    <message>
        <source>%1: overwrite settings</source>
        <translation>%1: Einstellungen überschreiben</translation>
    </message>
    <message>
        <source>%1 …</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>gesendet</translation>
    </message>
    <message>
        <source>The gimbal is being set up.</source>
        <translation>Der Gimbal wird gerade eingerichtet.</translation>
    </message>
    <message>
        <source>A search, measurement or calibration is running.</source>
        <translation>Eine Suche, Messung oder Kalibrierung läuft.</translation>
    </message>
    <message>
        <source>The settings as they were are kept in %1</source>
        <translation>Die Einstellungen, wie sie waren, liegen in %1</translation>
    </message>
    <message>
        <source>%1: put stored values into use?</source>
        <translation>%1: gespeicherte Werte in Gebrauch nehmen?</translation>
    </message>
    <message>
        <source>Do nothing</source>
        <translation>Nichts tun</translation>
    </message>
    <message>
        <source>Changes nothing that is stored</source>
        <translation>Ändert nichts Gespeichertes</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>Band</source>
        <translation>Band</translation>
    </message>
    <message>
        <source>Charge drawn</source>
        <translation>Entnommene Ladung</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>Battery level</source>
        <translation>Akkustand</translation>
    </message>
    <message>
        <source>Battery voltage</source>
        <translation>Akkuspannung</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>Kalibriert</translation>
    </message>
    <message>
        <source>Being calibrated</source>
        <translation>Wird kalibriert</translation>
    </message>
    <message>
        <source>Values changed</source>
        <translation>Geänderte Werte</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Confirmed</source>
        <translation>Bestätigt</translation>
    </message>
    <message>
        <source>Processor load</source>
        <translation>Prozessorlast</translation>
    </message>
    <message>
        <source>Processor temperature</source>
        <translation>Prozessortemperatur</translation>
    </message>
    <message>
        <source>Exposure mode</source>
        <translation>Belichtungsart</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Sensitivity (ISO)</source>
        <translation>Empfindlichkeit (ISO)</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Power step</source>
        <translation>Leistungsstufe</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Powers it has (dBm)</source>
        <translation>Mögliche Leistungen (dBm)</translation>
    </message>
    <message>
        <source>Restarts in</source>
        <translation>Neustart in</translation>
    </message>
    <message>
        <source>Receive level</source>
        <translation>Empfangspegel</translation>
    </message>
    <message>
        <source>Receive quality</source>
        <translation>Empfangsqualität</translation>
    </message>
    <message>
        <source>Shutter</source>
        <translation>Verschluss</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>White balance</source>
        <translation>Weißabgleich</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Bytes (hex)</source>
        <translation>Bytes (hex)</translation>
    </message>
    <message>
        <source>Devices that answer</source>
        <translation>Geräte, die antworten</translation>
    </message>
    <message>
        <source>Rows left out because they were late</source>
        <translation>Zeilen, die zu spät waren und ausgelassen wurden</translation>
    </message>
    <message>
        <source>Without a signal</source>
        <translation>Ohne Signal</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>In use only after a restart</source>
        <translation>Erst nach einem Neustart in Gebrauch</translation>
    </message>
    <message>
        <source>Rows sent</source>
        <translation>Gesendete Zeilen</translation>
    </message>
    <message>
        <source>The board has fallen silent</source>
        <translation>Das Board ist verstummt</translation>
    </message>
    <message>
        <source>Bytes written</source>
        <translation>Geschriebene Bytes</translation>
    </message>
    <message>
        <source>Last command</source>
        <translation>Letzter Befehl</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Parts of the configuration found in it</source>
        <translation>Darin gefundene Teile der Konfiguration</translation>
    </message>
    <message>
        <source>The copy is of another board</source>
        <translation>Die Kopie stammt von einem anderen Board</translation>
    </message>
    <message>
        <source>The copy is of another firmware</source>
        <translation>Die Kopie stammt von anderer Firmware</translation>
    </message>
    <message>
        <source>Ranges whose meaning is documented nowhere</source>
        <translation>Bereiche, deren Bedeutung nirgends dokumentiert ist</translation>
    </message>
    <message>
        <source>Files of the board</source>
        <translation>Dateien des Boards</translation>
    </message>
    <message>
        <source>Files written or erased</source>
        <translation>Dateien geschrieben oder gelöscht</translation>
    </message>
    <message>
        <source>Files that differ</source>
        <translation>Dateien, die sich unterscheiden</translation>
    </message>
</context>
<context>
    <name>AdjustableModel</name>
    <message>
        <source>Takes effect at once, in volatile memory, from %1 to %2</source>
        <translation>Wirkt sofort, im flüchtigen Speicher, von %1 bis %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1: %2 to %3</source>
        <translation>%1: %2 bis %3</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>In Gebrauch</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Schlüssel</translation>
    </message>
</context>
<context>
    <name>AlarmBar</name>
    <message>
        <source>Acknowledge</source>
        <translation>Quittieren</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Takes the alarm away, here and on the dashboard</source>
        <translation>Nimmt den Alarm weg, hier und auf der Übersicht</translation>
    </message>
    <message>
        <source>Severe</source>
        <translation>Schwerwiegend</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>(%1 times)</source>
        <translation>(%1-mal)</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiterer</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Stop motors</source>
        <translation>Motoren stoppen</translation>
    </message>
    <message>
        <source>Over: %1</source>
        <translation>Vorbei: %1</translation>
    </message>
    <message>
        <source>Not watched any more: %1</source>
        <translation>Nicht mehr überwacht: %1</translation>
    </message>
</context>
<context>
    <name>AlarmCard</name>
    <message>
        <source>%1, %2, over</source>
        <translation>%1, %2, vorbei</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Quittieren</translation>
    </message>
    <message>
        <source>Acknowledge: %1</source>
        <translation>Quittieren: %1</translation>
    </message>
    <message>
        <source>%1, %2, not watched any more</source>
        <translation>%1, %2, nicht mehr überwacht</translation>
    </message>
</context>
<context>
    <name>AlarmText</name>
    <message>
        <source>about %1 Hz (or more: the samples come too slowly to tell)</source>
        <translation>etwa %1 Hz (oder mehr: die Messwerte kommen dafür zu langsam)</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n Wert</numerusform>
            <numerusform>%n Werte</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 and %2 have run away: %1 is %3° from its target and does not come back.</source>
        <translation>%1 und %2 sind durchgegangen: %1 ist %3° vom Ziel entfernt und kommt nicht zurück.</translation>
    </message>
    <message>
        <source>%1 is %2° from its target and does not come back.</source>
        <translation>%1 ist %2° vom Ziel entfernt und kommt nicht zurück.</translation>
    </message>
    <message>
        <source>%1 and %2 run away together: %1 is %3° from its target and moves on.</source>
        <translation>%1 und %2 gehen zusammen durch: %1 ist %3° vom Ziel entfernt und dreht weiter.</translation>
    </message>
    <message>
        <source>%1 runs away: it is %2° from its target and moves on.</source>
        <translation>%1 geht durch: %2° vom Ziel entfernt, und es dreht weiter.</translation>
    </message>
    <message>
        <source>%1 oscillates at %2, with %3 °/s RMS.</source>
        <translation>%1 schwingt mit %2, %3 °/s RMS.</translation>
    </message>
    <message>
        <source>%1 stands at %2°, beyond its limit of %3°, where it was not steered to.</source>
        <translation>%1 steht bei %2°, jenseits der Grenze von %3°, ohne dorthin gesteuert zu sein.</translation>
    </message>
    <message>
        <source>%1 does not reach its target: %2° are missing for seconds.</source>
        <translation>%1 erreicht das Ziel nicht: seit Sekunden fehlen %2°.</translation>
    </message>
    <message>
        <source>The board does not see its motion sensor.</source>
        <translation>Das Board sieht seinen Bewegungssensor nicht.</translation>
    </message>
    <message>
        <source>A motion sensor does not work as it should.</source>
        <translation>Ein Bewegungssensor arbeitet nicht, wie er soll.</translation>
    </message>
    <message>
        <source>The motor drivers protect themselves: they are too hot or overloaded.</source>
        <translation>Die Motortreiber schützen sich selbst: zu heiß oder überlastet.</translation>
    </message>
    <message>
        <source>The board&apos;s sensor is at %1 °C, the limit is %2 °C.</source>
        <translation>Der Sensor des Boards hat %1 °C, die Grenze ist %2 °C.</translation>
    </message>
    <message>
        <source>The battery is low.</source>
        <translation>Der Akku ist schwach.</translation>
    </message>
    <message>
        <source>The battery is low: %1 V, the limit is %2 V.</source>
        <translation>Der Akku ist schwach: %1 V, die Grenze ist %2 V.</translation>
    </message>
    <message>
        <source>The board reports a low battery: %1 V.</source>
        <translation>Das Board meldet einen schwachen Akku: %1 V.</translation>
    </message>
    <message>
        <source>Each is driven by the other&apos;s error: the axes are swapped, in the wiring, in the motor outputs or in how the sensor is mounted. If they are not, both motors turn in the wrong direction.</source>
        <translation>Jede wird vom Fehler der anderen getrieben: die Achsen sind vertauscht, in der Verkabelung, bei den Motorausgängen oder in der Lage des Sensors. Wenn nicht, drehen beide Motoren falsch herum.</translation>
    </message>
    <message>
        <source>It is pushed away from its target: the motor turns in the wrong direction, or the sensor sees it the wrong way round.</source>
        <translation>Die Achse wird vom Ziel weggedrückt: der Motor dreht falsch herum, oder der Sensor sieht die Drehung verkehrt.</translation>
    </message>
    <message>
        <source>%1 does so as well, on its own: both motors turn in the wrong direction, or the sensor&apos;s axes are set up wrongly.</source>
        <translation>%1 tut das auch, für sich: beide Motoren drehen falsch herum, oder die Achsen des Sensors sind falsch eingestellt.</translation>
    </message>
    <message>
        <source>It began after values were changed live: there is too much gain, or a filter takes the loop&apos;s reserve.</source>
        <translation>Es begann, nachdem Werte live geändert wurden: zu viel Verstärkung, oder ein Filter nimmt dem Regelkreis die Reserve.</translation>
    </message>
    <message>
        <source>It swung to and fro before: there is too much gain.</source>
        <translation>Vorher schwang die Achse hin und her: zu viel Verstärkung.</translation>
    </message>
    <message>
        <source>There is too much gain: P or I is too high, or D is too low for them.</source>
        <translation>Zu viel Verstärkung: P oder I ist zu hoch, oder D ist dafür zu niedrig.</translation>
    </message>
    <message>
        <source>A part of the structure resonates at %1 Hz and the motor drives it; too high a D can do the same.</source>
        <translation>Ein Teil des Aufbaus hat bei %1 Hz eine Resonanz, und der Motor treibt sie an; ein zu hohes D wirkt ebenso.</translation>
    </message>
    <message>
        <source>The motor cannot hold it: something blocks it, the load is not balanced, the power is too low, or the direction is wrong.</source>
        <translation>Der Motor kann die Achse nicht halten: etwas blockiert sie, die Last ist nicht ausbalanciert, die Leistung reicht nicht, oder die Drehrichtung ist falsch.</translation>
    </message>
    <message>
        <source>Too much gain or a resonance of the structure.</source>
        <translation>Zu viel Verstärkung oder eine Resonanz des Aufbaus.</translation>
    </message>
    <message>
        <source>Something turned it there, or the board lost its orientation.</source>
        <translation>Etwas hat sie dorthin gedreht, oder das Board hat die Orientierung verloren.</translation>
    </message>
    <message>
        <source>The motor does all it can: something blocks or holds the axis, it is at its stop, or it has too little power.</source>
        <translation>Der Motor tut, was er kann: etwas blockiert oder hält die Achse, sie ist am Anschlag, oder die Leistung reicht nicht.</translation>
    </message>
    <message>
        <source>Without it nothing is stabilised.</source>
        <translation>Ohne ihn wird nichts stabilisiert.</translation>
    </message>
    <message>
        <source>Motors that work hard all the time end like this.</source>
        <translation>So enden Motoren, die dauernd schwer arbeiten.</translation>
    </message>
    <message>
        <source>Nobody sees where it moves.</source>
        <translation>Niemand sieht, wohin er sich bewegt.</translation>
    </message>
    <message>
        <source>Check which motor is plugged in where, and the axes of the sensor, before the motors are switched on again.</source>
        <translation>Vor dem Einschalten prüfen, welcher Motor wo steckt und wie die Achsen des Sensors eingestellt sind.</translation>
    </message>
    <message>
        <source>Invert that motor, or check the sensor&apos;s orientation and the number of poles.</source>
        <translation>Diesen Motor umkehren, oder Lage des Sensors und Polzahl prüfen.</translation>
    </message>
    <message>
        <source>Go in smaller steps, and back at the first humming.</source>
        <translation>In kleineren Schritten vorgehen und beim ersten Brummen zurück.</translation>
    </message>
    <message>
        <source>Lower P, then D, of that axis.</source>
        <translation>P dieser Achse verringern, dann D.</translation>
    </message>
    <message>
        <source>Stiffen the camera&apos;s mount, lower D, or place a notch filter there.</source>
        <translation>Die Halterung der Kamera versteifen, D verringern oder dort einen Kerbfilter setzen.</translation>
    </message>
    <message>
        <source>Check balance, power and direction of that motor.</source>
        <translation>Balance, Leistung und Drehrichtung dieses Motors prüfen.</translation>
    </message>
    <message>
        <source>Lower the gains of that axis, or look for the resonance.</source>
        <translation>Die Verstärkung dieser Achse verringern oder die Resonanz suchen.</translation>
    </message>
    <message>
        <source>Move it back by hand with the motors off.</source>
        <translation>Mit ausgeschalteten Motoren von Hand zurückdrehen.</translation>
    </message>
    <message>
        <source>Free the axis, balance the load, or raise the power.</source>
        <translation>Die Achse befreien, die Last ausbalancieren oder die Leistung erhöhen.</translation>
    </message>
    <message>
        <source>Check the sensor&apos;s cable and connectors, then restart the board.</source>
        <translation>Kabel und Stecker des Sensors prüfen, dann das Board neu starten.</translation>
    </message>
    <message>
        <source>Let it cool, balance the load, and lower the power.</source>
        <translation>Abkühlen lassen, die Last ausbalancieren, die Leistung verringern.</translation>
    </message>
    <message>
        <source>Change the battery.</source>
        <translation>Akku wechseln.</translation>
    </message>
    <message>
        <source>Stop steering, then check the link and the board.</source>
        <translation>Nicht weiter steuern, dann die Verbindung und das Board prüfen.</translation>
    </message>
    <message>
        <source>The motors were switched off.</source>
        <translation>Die Motoren wurden ausgeschaltet.</translation>
    </message>
    <message>
        <source>The motors were told to stop, but nothing proves that they did: hold the camera and disconnect the power.</source>
        <translation>Die Motoren sollten anhalten, aber nichts beweist, dass sie es tun: Kamera festhalten und Strom trennen.</translation>
    </message>
    <message>
        <source>The motors are being switched off.</source>
        <translation>Die Motoren werden ausgeschaltet.</translation>
    </message>
    <message>
        <source>The last live change is being reverted.</source>
        <translation>Die letzte Live-Änderung wird zurückgenommen.</translation>
    </message>
    <message>
        <source>The last live change was reverted (%1).</source>
        <translation>Die letzte Live-Änderung wurde zurückgenommen (%1).</translation>
    </message>
    <message>
        <source>The last live change was reverted (%1), and it goes on all the same.</source>
        <translation>Die letzte Live-Änderung wurde zurückgenommen (%1), und es geht trotzdem weiter.</translation>
    </message>
    <message>
        <source>The last live change was not reverted: the board uses other values meanwhile.</source>
        <translation>Die letzte Live-Änderung wurde nicht zurückgenommen: das Board benutzt inzwischen andere Werte.</translation>
    </message>
    <message>
        <source>Reverting the last live change failed.</source>
        <translation>Die letzte Live-Änderung ließ sich nicht zurücknehmen.</translation>
    </message>
    <message>
        <source>Nothing was changed live just before, so nothing was reverted.</source>
        <translation>Kurz davor wurde nichts live geändert, daher wurde nichts zurückgenommen.</translation>
    </message>
    <message>
        <source>Runaway</source>
        <translation>Durchgehen</translation>
    </message>
    <message>
        <source>Oscillation</source>
        <translation>Schwingen</translation>
    </message>
    <message>
        <source>Beyond a limit</source>
        <translation>Jenseits einer Grenze</translation>
    </message>
    <message>
        <source>Target not reached</source>
        <translation>Ziel nicht erreicht</translation>
    </message>
    <message>
        <source>Sensor missing</source>
        <translation>Sensor fehlt</translation>
    </message>
    <message>
        <source>Overheating</source>
        <translation>Überhitzung</translation>
    </message>
    <message>
        <source>Low battery</source>
        <translation>Akku schwach</translation>
    </message>
    <message>
        <source>No data while steering</source>
        <translation>Keine Daten beim Steuern</translation>
    </message>
    <message>
        <source>The motor of %1 is at %2 °C, the limit is %3 °C.</source>
        <translation>Der Motor von %1 hat %2 °C, die Grenze ist %3 °C.</translation>
    </message>
    <message>
        <source>Overheating of the motors</source>
        <translation>Überhitzung der Motoren</translation>
    </message>
    <message>
        <source>the board does not tell it</source>
        <translation>das Board meldet nichts dazu</translation>
    </message>
    <message>
        <source>no data for it come</source>
        <translation>es kommen keine Daten dazu</translation>
    </message>
    <message>
        <source>above %1 Hz: data come too slowly</source>
        <translation>über %1 Hz: die Daten kommen zu langsam</translation>
    </message>
    <message>
        <source>except while it is steered to an angle from here</source>
        <translation>außer während von hier aus auf einen Winkel gesteuert wird</translation>
    </message>
    <message>
        <source>while it is steered otherwise than to angles</source>
        <translation>während anders als auf Winkel gesteuert wird</translation>
    </message>
    <message>
        <source>%1 turns on and on: %2° without a stop, and nothing is steered from here.</source>
        <translation>%1 dreht immer weiter: %2° ohne Halt, und von hier wird nichts gesteuert.</translation>
    </message>
    <message>
        <source>It may follow whoever turns the frame, or be steered by a remote control: the motors were left on. If neither is so, it runs away.</source>
        <translation>Vielleicht folgt die Achse jemandem, der den Rahmen dreht, oder eine Fernsteuerung steuert sie: Die Motoren blieben eingeschaltet. Ist beides nicht so, läuft sie weg.</translation>
    </message>
    <message>
        <source>Nobody is known to steer it: its motor drives it, in the wrong direction or by a sensor that does not see where it points.</source>
        <translation>Niemand scheint sie zu steuern: Ihr Motor treibt sie, in der falschen Richtung oder nach einem Sensor, der nicht sieht, wohin sie zeigt.</translation>
    </message>
    <message>
        <source>If nobody turns it, stop the motors.</source>
        <translation>Wenn niemand sie dreht, stoppen Sie die Motoren.</translation>
    </message>
    <message>
        <source>the board measures no battery&apos;s voltage</source>
        <translation>das Board misst keine Akkuspannung</translation>
    </message>
    <message>
        <source>The last live change was reverted (%1); it has been quiet since.</source>
        <translation>Die letzte Live-Änderung wurde zurückgenommen (%1); seither ist Ruhe.</translation>
    </message>
    <message>
        <source>The last live change was reverted (%1); it went on for a while after that.</source>
        <translation>Die letzte Live-Änderung wurde zurückgenommen (%1); danach ging es noch eine Weile weiter.</translation>
    </message>
    <message>
        <source>When it is empty the motors let go, and what they hold falls.</source>
        <translation>Ist er leer, lassen die Motoren los, und was sie halten, fällt.</translation>
    </message>
    <message>
        <source>The motors are driven although the drone says that it is disarmed.</source>
        <translation>Die Motoren werden angetrieben, obwohl die Drohne sagt, dass sie entschärft ist.</translation>
    </message>
    <message>
        <source>Something has let its outputs go on: a link that closed while it was armed, or a motor test.</source>
        <translation>Etwas hat ihre Ausgänge weiterlaufen lassen: eine Verbindung, die in scharfem Zustand schloss, oder ein Motortest.</translation>
    </message>
    <message>
        <source>Stop the motors, and keep clear of the propellers.</source>
        <translation>Motoren anhalten und Abstand von den Propellern halten.</translation>
    </message>
    <message>
        <source>Motors driven while disarmed</source>
        <translation>Motoren laufen trotz Entschärfung</translation>
    </message>
    <message>
        <source>No new live data for more than %1 s while it is steered.</source>
        <translation>Seit mehr als %1 s keine neuen Live-Daten, während gesteuert wird.</translation>
    </message>
    <message>
        <source>The battery&apos;s voltage of %1 V is below the alarm of %2 V that is set in the board.</source>
        <translation>Die Akkuspannung von %1 V liegt unter der Alarmschwelle von %2 V, die im Board eingestellt ist.</translation>
    </message>
    <message numerus="yes">
        <source>By its voltage it has %n cell(s) of %1 V, which are not low: the alarm is meant for a battery with more cells. If it has more, it is nearly empty.</source>
        <translation>
            <numerusform>Nach seiner Spannung hat er %n Zelle mit %1 V, die nicht schwach ist: die Alarmschwelle ist für einen Akku mit mehr Zellen gedacht. Hat er mehr, ist er fast leer.</numerusform>
            <numerusform>Nach seiner Spannung hat er %n Zellen mit %1 V, die nicht schwach sind: die Alarmschwelle ist für einen Akku mit mehr Zellen gedacht. Hat er mehr, ist er fast leer.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Count its cells: if it has %n, correct the battery&apos;s alarm in the board; if it has more, change it.</source>
        <translation>
            <numerusform>Seine Zellen zählen: hat er %n, die Alarmschwelle des Akkus im Board berichtigen; hat er mehr, ihn wechseln.</numerusform>
            <numerusform>Seine Zellen zählen: hat er %n, die Alarmschwelle des Akkus im Board berichtigen; hat er mehr, ihn wechseln.</numerusform>
        </translation>
    </message>
    <message>
        <source>Battery below the alarm</source>
        <translation>Akku unter der Alarmschwelle</translation>
    </message>
</context>
<context>
    <name>ArgumentForm</name>
    <message>
        <source>leave alone (%1 to %2 %3)</source>
        <translation>unberührt lassen (%1 bis %2 %3)</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
</context>
<context>
    <name>ArmedState</name>
    <message>
        <source>State of the drone</source>
        <translation>Zustand der Drohne</translation>
    </message>
    <message>
        <source>Not calibrated</source>
        <translation>Nicht kalibriert</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>Wird kalibriert</translation>
    </message>
    <message>
        <source>Disarmed</source>
        <translation>Entschärft</translation>
    </message>
    <message>
        <source>MOTORS DRIVEN</source>
        <translation>MOTOREN LAUFEN</translation>
    </message>
    <message>
        <source>ARMED</source>
        <translation>SCHARF</translation>
    </message>
    <message>
        <source>State not known</source>
        <translation>Zustand unbekannt</translation>
    </message>
    <message>
        <source>It cannot be armed before a calibration.</source>
        <translation>Vor einer Kalibrierung lässt sie sich nicht scharf schalten.</translation>
    </message>
    <message>
        <source>It lies still until this is over.</source>
        <translation>Sie bleibt ruhig liegen, bis das vorbei ist.</translation>
    </message>
    <message>
        <source>Propellers may turn at any moment.</source>
        <translation>Die Propeller können jeden Moment drehen.</translation>
    </message>
    <message>
        <source>Take it for armed: nothing tells it at present.</source>
        <translation>Für scharf halten: gerade meldet es niemand.</translation>
    </message>
    <message>
        <source>It is not armed, and drives motors all the same: keep clear.</source>
        <translation>Sie ist nicht scharf und treibt trotzdem Motoren an: Abstand halten.</translation>
    </message>
    <message>
        <source>Calibrated.</source>
        <translation>Kalibriert.</translation>
    </message>
    <message>
        <source>Outputs unknown</source>
        <translation>Ausgänge unbekannt</translation>
    </message>
    <message>
        <source>Disarmed. It does not tell what its motors do: see that they stand.</source>
        <translation>Entschärft. Was die Motoren tun, meldet sie nicht: nachsehen, ob sie stehen.</translation>
    </message>
    <message>
        <source>Not told yet</source>
        <translation>Noch nicht gemeldet</translation>
    </message>
    <message>
        <source>Armed or disarmed from here, it has not said so yet: take it for armed.</source>
        <translation>Von hier geschärft oder entschärft, was sie noch nicht gemeldet hat: für scharf halten.</translation>
    </message>
</context>
<context>
    <name>AttitudeView</name>
    <message>
        <source>Attitude of the camera</source>
        <translation>Lage der Kamera</translation>
    </message>
    <message>
        <source>Roll %1°, pitch %2°, yaw %3°</source>
        <translation>Roll %1°, Pitch %2°, Yaw %3°</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Keine Daten</translation>
    </message>
    <message>
        <source>No attitude yet</source>
        <translation>Noch keine Lage</translation>
    </message>
</context>
<context>
    <name>AutoTunePage</name>
    <message>
        <source>Auto-tune</source>
        <translation>Auto-Abstimmung</translation>
    </message>
    <message>
        <source>What to search</source>
        <translation>Was gesucht wird</translation>
    </message>
    <message>
        <source>Start: the camera will shake</source>
        <translation>Starten: die Kamera wird rütteln</translation>
    </message>
    <message>
        <source>Tracking error by iteration</source>
        <translation>Regelfehler je Durchgang</translation>
    </message>
    <message>
        <source>Gains before and now</source>
        <translation>Verstärkungen vorher und jetzt</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Search again: the camera will shake</source>
        <translation>Nochmals: die Kamera wird rütteln</translation>
    </message>
    <message>
        <source>The board is searching. Keep the gimbal as it is. F12 or the button STOP MOTORS stops everything.</source>
        <translation>Das Board sucht. Lassen Sie den Gimbal, wie er ist. F12 oder der Knopf MOTOREN STOPPEN hält alles an.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Iteration %1. Keep the gimbal as it is. F12 or the button STOP MOTORS stops everything.</source>
        <translation>Durchgang %1. Lassen Sie den Gimbal, wie er ist. F12 oder der Knopf MOTOREN STOPPEN hält alles an.</translation>
    </message>
    <message>
        <source>The previous gains are in use again.</source>
        <translation>Die Werte von vorher sind wieder in Gebrauch.</translation>
    </message>
    <message>
        <source>Gains by iteration (P solid, D dashed)</source>
        <translation>Verstärkungen je Durchgang (P durchgezogen, D gestrichelt)</translation>
    </message>
    <message>
        <source>This board has no command for it.</source>
        <translation>Dieses Board hat keinen Befehl dafür.</translation>
    </message>
    <message>
        <source>Stop and revert to the old gains</source>
        <translation>Anhalten und die neuen Werte zurücknehmen</translation>
    </message>
    <message>
        <source>Accept and store</source>
        <translation>Annehmen und speichern</translation>
    </message>
    <message>
        <source>Revert to the old gains</source>
        <translation>Neue Werte zurücknehmen</translation>
    </message>
    <message>
        <source>In use now</source>
        <translation>Jetzt in Gebrauch</translation>
    </message>
    <message>
        <source>What was in use when the search began; without a search, what is stored</source>
        <translation>Was in Gebrauch war, als die Suche begann; ohne Suche das Gespeicherte</translation>
    </message>
    <message>
        <source>What the board uses at this moment; during a search, what it is trying</source>
        <translation>Was das Board in diesem Augenblick benutzt; während einer Suche, was es gerade probiert</translation>
    </message>
    <message>
        <source>Hold the gimbal in your hand or on a stand, balanced, with all motors running. The board moves the camera a little to find gains; the lower “gain against stability”, the calmer the result. Nothing is stored before you accept.</source>
        <translation>Den Gimbal in der Hand oder auf einem Stativ halten, ausbalanciert, mit laufenden Motoren. Das Board bewegt die Kamera ein wenig, um Verstärkungen zu finden; je niedriger „Verstärkung gegen Stabilität“, desto ruhiger das Ergebnis. Gespeichert wird erst, wenn das Ergebnis angenommen ist.</translation>
    </message>
    <message>
        <source>The new gains are in use, but not stored. Try them: turn the gimbal by hand and look at Tuning. Then accept them or revert to the old ones.</source>
        <translation>Die neuen Werte sind in Gebrauch, aber nicht gespeichert. Zum Probieren den Gimbal von Hand drehen und „Abstimmen“ ansehen. Dann annehmen oder zurücknehmen.</translation>
    </message>
    <message>
        <source>Angle error, RMS: %1.</source>
        <translation>Winkelfehler, RMS: %1.</translation>
    </message>
    <message>
        <source>The gains that the board found hold the camera worse; they were reverted.</source>
        <translation>Die Verstärkungen, die das Board gefunden hat, halten die Kamera schlechter; sie wurden zurückgenommen.</translation>
    </message>
    <message>
        <source>Balance the camera, hold the gimbal still, and search again with a lower gain.</source>
        <translation>Tarieren Sie die Kamera aus, halten Sie den Gimbal still und suchen Sie noch einmal mit weniger Verstärkung.</translation>
    </message>
    <message>
        <source>The search that was broken off could not be ended: the board may be moving the camera on.</source>
        <translation>Die abgebrochene Suche ließ sich nicht beenden: Das Board bewegt die Kamera womöglich weiter.</translation>
    </message>
    <message>
        <source>The search that was broken off has been stopped; the gains are those from before.</source>
        <translation>Die abgebrochene Suche wurde beendet; die Verstärkungen sind die von zuvor.</translation>
    </message>
    <message>
        <source>The search was broken off and has been stopped. The board uses other gains than before, and may have stored them: %1. Revert and store the old gains, or accept the new ones.</source>
        <translation>Die Suche wurde abgebrochen und ist beendet. Das Board verwendet andere Verstärkungen als zuvor und hat sie womöglich gespeichert: %1. Nehmen Sie sie zurück und speichern Sie die alten, oder übernehmen Sie die neuen.</translation>
    </message>
    <message>
        <source>After the search that was broken off the board uses other gains.</source>
        <translation>Nach der abgebrochenen Suche verwendet das Board andere Verstärkungen.</translation>
    </message>
    <message>
        <source>It may have stored them; it does not tell.</source>
        <translation>Womöglich hat es sie gespeichert; es sagt dazu nichts.</translation>
    </message>
    <message>
        <source>Revert to the old gains on the page Auto-tune and store them, or accept the new ones.</source>
        <translation>Sie können auf der Seite Auto-Abstimmung die neuen Verstärkungen zurücknehmen und die alten speichern, oder die neuen übernehmen.</translation>
    </message>
    <message>
        <source>The board may be searching on, and store what it finds.</source>
        <translation>Das Board sucht womöglich weiter und speichert, was es findet.</translation>
    </message>
    <message>
        <source>When it is connected again, the search is stopped and the gains are compared.</source>
        <translation>Sobald es wieder verbunden ist, wird die Suche beendet und werden die Verstärkungen verglichen.</translation>
    </message>
    <message>
        <source>The link ended before the new gains were accepted or reverted.</source>
        <translation>Die Verbindung endete, bevor die neuen Verstärkungen angenommen oder zurückgenommen wurden.</translation>
    </message>
    <message>
        <source>Stop the motors.</source>
        <translation>Stoppen Sie die Motoren.</translation>
    </message>
    <message>
        <source>The board uses the gains from before the search again.</source>
        <translation>Das Board benutzt wieder die Verstärkungen von vor der Suche.</translation>
    </message>
    <message>
        <source>The link ended before the new gains were accepted or reverted. The board uses them still: %1. Accept them, or revert to the old ones.</source>
        <translation>Die Verbindung endete, bevor die neuen Verstärkungen angenommen oder zurückgenommen wurden. Das Board benutzt sie noch: %1. Nehmen Sie sie an oder kehren Sie zu den alten zurück.</translation>
    </message>
    <message>
        <source>Profile %1 is in use now. What was found for profile %2 was not stored and is gone.</source>
        <translation>Jetzt wird Profil %1 verwendet. Was für Profil %2 gefunden wurde, wurde nicht gespeichert und ist weg.</translation>
    </message>
    <message>
        <source>The search has ended with it.</source>
        <translation>Die Suche ist damit zu Ende.</translation>
    </message>
    <message>
        <source>The board is told to end the search, and watched until it has…</source>
        <translation>Das Board soll die Suche beenden und wird beobachtet, bis es das getan hat…</translation>
    </message>
    <message>
        <source>The board searches on although it was told to stop. Stop it once more, or stop the motors.</source>
        <translation>Das Board sucht weiter, obwohl es aufhören sollte. Beenden Sie die Suche noch einmal, oder stoppen Sie die Motoren.</translation>
    </message>
    <message>
        <source>The old gains are in use again. If the board has stored those that it tried, they come back at its next start.</source>
        <translation>Die alten Verstärkungen sind wieder in Gebrauch. Hat das Board die ausprobierten gespeichert, kommen sie mit seinem nächsten Start zurück.</translation>
    </message>
    <message>
        <source>Store the old gains</source>
        <translation>Alte Verstärkungen speichern</translation>
    </message>
    <message>
        <source>Leave it so</source>
        <translation>So lassen</translation>
    </message>
</context>
<context>
    <name>AxisDial</name>
    <message>
        <source>Angle %1°, target %2°, motor power %3 %</source>
        <translation>Winkel %1°, Ziel %2°, Motorleistung %3 %</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Keine Daten</translation>
    </message>
    <message>
        <source>Motor power %1 %</source>
        <translation>Motorleistung %1 %</translation>
    </message>
    <message>
        <source>steered from %1° to %2°</source>
        <translation>gesteuert von %1° bis %2°</translation>
    </message>
    <message>
        <source>follows</source>
        <translation>folgt</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>hält</translation>
    </message>
    <message>
        <source>This axis follows the frame.</source>
        <translation>Diese Achse folgt dem Rahmen.</translation>
    </message>
    <message>
        <source>This axis keeps its direction, however the frame turns.</source>
        <translation>Diese Achse hält ihre Richtung, wie auch immer sich der Rahmen dreht.</translation>
    </message>
    <message>
        <source>motor off</source>
        <translation>Motor aus</translation>
    </message>
</context>
<context>
    <name>BackupsPage</name>
    <message>
        <source>by the operator</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>before the first write</source>
        <translation>vor dem ersten Schreiben</translation>
    </message>
    <message>
        <source>before the action %1</source>
        <translation>vor der Aktion %1</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Sicherungen</translation>
    </message>
    <message>
        <source>Take a snapshot now</source>
        <translation>Jetzt sichern</translation>
    </message>
    <message>
        <source>Restore as edits</source>
        <translation>Als Änderungen wiederherstellen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Put the snapshot&apos;s values into the forms; nothing is on the board before you review and write</source>
        <translation>Setzt die Werte der Sicherung in die Formulare; auf dem Board ist erst etwas, wenn Sie prüfen und schreiben</translation>
    </message>
    <message>
        <source>Copy the snapshot to a file of your choice</source>
        <translation>Kopiert die Sicherung in eine Datei Ihrer Wahl</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>Gemacht</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Snapshots of this board</source>
        <translation>Sicherungen dieses Boards</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>Sicherung</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Differences between the snapshot and now</source>
        <translation>Unterschiede zwischen der Sicherung und jetzt</translation>
    </message>
    <message>
        <source>What differs from now</source>
        <translation>Was sich unterscheidet</translation>
    </message>
    <message>
        <source>Export snapshot</source>
        <translation>Sicherung exportieren</translation>
    </message>
    <message>
        <source>GimbalDesk configurations (*.json)</source>
        <translation>GimbalDesk-Konfigurationen (*.json)</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>beschädigt</translation>
    </message>
    <message>
        <source>No snapshot yet. One is taken before the first write to a board, and before each action that writes.</source>
        <translation>Noch keine Sicherung. Es wird eine gemacht vor dem ersten Schreiben auf ein Board und vor jeder Aktion, die schreibt.</translation>
    </message>
    <message>
        <source>All values are the same.</source>
        <translation>Alle Werte sind gleich.</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) differ.</source>
        <translation>
            <numerusform>%n Wert ist anders.</numerusform>
            <numerusform>%n Werte sind anders.</numerusform>
        </translation>
    </message>
    <message>
        <source>Profile names differ.</source>
        <translation>Profilnamen sind anders.</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Load a file…</source>
        <translation>Datei laden…</translation>
    </message>
    <message>
        <source>Put a file&apos;s values into the forms; nothing is on the board before you review and write</source>
        <translation>Die Werte einer Datei in die Formulare übernehmen; auf dem Board ist nichts, bevor Sie prüfen und schreiben</translation>
    </message>
    <message>
        <source>Save to a file…</source>
        <translation>In Datei sichern…</translation>
    </message>
    <message>
        <source>Save the values as they are shown, edits included</source>
        <translation>Die Werte sichern, wie sie gezeigt werden, mit Änderungen</translation>
    </message>
    <message>
        <source>Load a configuration</source>
        <translation>Konfiguration laden</translation>
    </message>
    <message>
        <source>Save the configuration</source>
        <translation>Konfiguration sichern</translation>
    </message>
    <message>
        <source>Share…</source>
        <translation>Teilen…</translation>
    </message>
    <message>
        <source>All values as one picture</source>
        <translation>Alle Werte als ein Bild</translation>
    </message>
    <message>
        <source>%1 differ.</source>
        <translation>%1 unterscheiden sich.</translation>
    </message>
    <message>
        <source>before “%1”</source>
        <translation>vor „%1“</translation>
    </message>
    <message>
        <source>%1 (incomplete)</source>
        <translation>%1 (unvollständig)</translation>
    </message>
    <message>
        <source>All values that could be compared are the same.</source>
        <translation>Alle Werte, die sich vergleichen ließen, sind gleich.</translation>
    </message>
    <message>
        <source>Not known: %1.</source>
        <translation>Nicht bekannt: %1.</translation>
    </message>
    <message>
        <source>Left out, as this board does not take them: %1.</source>
        <translation>Ausgelassen, weil dieses Board sie nicht annimmt: %1.</translation>
    </message>
    <message>
        <source>Which board…</source>
        <translation>Welches Board…</translation>
    </message>
    <message>
        <source>Say which board this is</source>
        <translation>Angeben, welches Board das ist</translation>
    </message>
    <message>
        <source>This board has no serial number and no name yet.</source>
        <translation>Dieses Board hat keine Seriennummer und noch keinen Namen.</translation>
    </message>
    <message>
        <source>Board “%1”. It has no serial number.</source>
        <translation>Board „%1“. Es hat keine Seriennummer.</translation>
    </message>
    <message>
        <source>unwritten edits of an earlier run</source>
        <translation>ungeschriebene Änderungen von früher</translation>
    </message>
    <message numerus="yes">
        <source>Compared with what the board holds; %n unwritten change(s) are left aside.</source>
        <translation>
            <numerusform>Verglichen mit dem, was das Board enthält; %n ungeschriebene Änderung bleibt außer Betracht.</numerusform>
            <numerusform>Verglichen mit dem, was das Board enthält; %n ungeschriebene Änderungen bleiben außer Betracht.</numerusform>
        </translation>
    </message>
    <message>
        <source>by the operator, of what was in use</source>
        <translation>von Hand, was in Gebrauch war</translation>
    </message>
    <message>
        <source>A snapshot holds no calibration of the board&apos;s sensors: restoring one leaves that as it is.</source>
        <translation>Eine Sicherung enthält die Kalibrierung der Sensoren nicht: Beim Wiederherstellen bleibt diese, wie sie auf dem Board ist.</translation>
    </message>
    <message>
        <source>Is this the same board?</source>
        <translation>Ist dies dasselbe Board?</translation>
    </message>
    <message>
        <source>The snapshot is of “%1”. The board that is connected looks the same and has no serial number: it may be another one.</source>
        <translation>Die Sicherung ist von „%1“. Das verbundene Board sieht gleich aus und hat keine Seriennummer: Es kann ein anderes sein.</translation>
    </message>
    <message>
        <source>It is “%1”</source>
        <translation>Es ist „%1“</translation>
    </message>
    <message>
        <source>It is another one…</source>
        <translation>Es ist ein anderes…</translation>
    </message>
    <message>
        <source>Do not restore</source>
        <translation>Nicht wiederherstellen</translation>
    </message>
    <message>
        <source>Taken for “%1”, a board that looks the same. It has no serial number.</source>
        <translation>Für „%1“ gehalten, ein Board, das gleich aussieht. Es hat keine Seriennummer.</translation>
    </message>
</context>
<context>
    <name>BatteryView</name>
    <message>
        <source>Battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>no battery</source>
        <translation>kein Akku</translation>
    </message>
    <message>
        <source>✖ motors off</source>
        <translation>✖ Motoren aus</translation>
    </message>
    <message>
        <source>⚠ low</source>
        <translation>⚠ schwach</translation>
    </message>
    <message>
        <source>✓ good</source>
        <translation>✓ gut</translation>
    </message>
    <message numerus="yes">
        <source>%n cell(s) by the voltage, %1 V each</source>
        <translation>
            <numerusform>%n Zelle nach der Spannung, je %1 V</numerusform>
            <numerusform>%n Zellen nach der Spannung, je %1 V</numerusform>
        </translation>
    </message>
    <message>
        <source>Alarm below %1 V, off below %2 V</source>
        <translation>Alarm unter %1 V, aus unter %2 V</translation>
    </message>
    <message>
        <source>Alarm below %1 V</source>
        <translation>Alarm unter %1 V</translation>
    </message>
    <message>
        <source>Motors off below %1 V</source>
        <translation>Motoren aus unter %1 V</translation>
    </message>
    <message>
        <source>No limits are known.</source>
        <translation>Keine Grenzen bekannt.</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Keine Daten</translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation>%1 V</translation>
    </message>
    <message>
        <source>⚠ below the alarm</source>
        <translation>⚠ unter der Alarmschwelle</translation>
    </message>
    <message numerus="yes">
        <source>%n cell(s) as the board counts, %1 V each</source>
        <translation>
            <numerusform>%n Zelle, wie das Board zählt, %1 V</numerusform>
            <numerusform>%n Zellen, wie das Board zählt, je %1 V</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>BenchPage</name>
    <message>
        <source>Test bench</source>
        <translation>Prüfstand</translation>
    </message>
    <message>
        <source>Beep</source>
        <translation>Piepsen</translation>
    </message>
    <message>
        <source>Stop beeping</source>
        <translation>Piepsen beenden</translation>
    </message>
    <message>
        <source>Turn one motor</source>
        <translation>Einen Motor drehen</translation>
    </message>
    <message>
        <source>⚠ Propellers off. The motor turns at 5 % for 5 s; the drone hears nothing for 8 s, also no stop.</source>
        <translation>⚠ Propeller ab. Der Motor dreht 5 s lang mit 5 %; die Drohne hört 8 s lang nichts, auch keinen Stopp.</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>How long the drone still hears nothing</source>
        <translation>Wie lange die Drohne noch nichts hört</translation>
    </message>
    <message>
        <source>&amp;Motor</source>
        <translation>&amp;Motor</translation>
    </message>
    <message>
        <source>Find it by its sound</source>
        <translation>Am Ton wiederfinden</translation>
    </message>
    <message>
        <source>The motors beep until they are told to stop. The drone does not say whether they do.</source>
        <translation>Die Motoren piepsen, bis das beendet wird. Ob sie es tun, sagt die Drohne nicht.</translation>
    </message>
    <message>
        <source>Turn motor %1…</source>
        <translation>Motor %1 drehen…</translation>
    </message>
    <message>
        <source>Turn a motor…</source>
        <translation>Einen Motor drehen…</translation>
    </message>
    <message>
        <source>Click a motor, or choose its number.</source>
        <translation>Einen Motor anklicken oder seine Nummer wählen.</translation>
    </message>
    <message numerus="yes">
        <source>The drone has %n motor(s).</source>
        <translation>
            <numerusform>Die Drohne hat %n Motor.</numerusform>
            <numerusform>Die Drohne hat %n Motoren.</numerusform>
        </translation>
    </message>
    <message>
        <source>That the propellers are off is asked each time.</source>
        <translation>Dass die Propeller ab sind, wird jedes Mal gefragt.</translation>
    </message>
    <message numerus="yes">
        <source>The drone hears nothing for %n more second(s), also no stop. Stop motors (F12) is then the first thing that it hears. To stop it at once: its battery.</source>
        <translation>
            <numerusform>Die Drohne hört noch %n Sekunde lang nichts, auch keinen Stopp. Motoren stoppen (F12) ist danach das Erste, was sie hört. Sofort hilft nur ihr Akku.</numerusform>
            <numerusform>Die Drohne hört noch %n Sekunden lang nichts, auch keinen Stopp. Motoren stoppen (F12) ist danach das Erste, was sie hört. Sofort hilft nur ihr Akku.</numerusform>
        </translation>
    </message>
    <message>
        <source>Sent: beep</source>
        <translation>Gesendet: piepsen</translation>
    </message>
    <message>
        <source>Sent: stop</source>
        <translation>Gesendet: beenden</translation>
    </message>
    <message>
        <source>The calibration of the motor controllers is over. Whether they took it only their tones tell.</source>
        <translation>Die Kalibrierung der Motorregler ist vorbei. Ob sie sie übernommen haben, sagen nur ihre Töne.</translation>
    </message>
    <message>
        <source>The drone does not stream its outputs, so nobody knows how many motors it has. Switch full telemetry on.</source>
        <translation>Die Drohne sendet ihre Ausgänge nicht, darum weiß niemand, wie viele Motoren sie hat. Schalten Sie die volle Telemetrie ein.</translation>
    </message>
    <message>
        <source>Full telemetry (Actions)…</source>
        <translation>Volle Telemetrie (Aktionen)…</translation>
    </message>
    <message>
        <source>Calibrate (Actions)…</source>
        <translation>Kalibrieren (Aktionen)…</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>in the middle</source>
        <translation>in der Mitte</translation>
    </message>
    <message>
        <source>top left</source>
        <translation>oben links</translation>
    </message>
    <message>
        <source>top right</source>
        <translation>oben rechts</translation>
    </message>
    <message>
        <source>at the top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>bottom left</source>
        <translation>unten links</translation>
    </message>
    <message>
        <source>bottom right</source>
        <translation>unten rechts</translation>
    </message>
    <message>
        <source>at the bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>Motor %1, %2 in the picture. Until it is over no other can be chosen.</source>
        <translation>Motor %1, im Bild %2. Bis es vorbei ist, lässt sich kein anderer wählen.</translation>
    </message>
    <message>
        <source>Wait until what is being done is over.</source>
        <translation>Warten Sie, bis der laufende Vorgang zu Ende ist.</translation>
    </message>
    <message>
        <source>front left</source>
        <translation>vorn links</translation>
    </message>
    <message>
        <source>front right</source>
        <translation>vorn rechts</translation>
    </message>
    <message>
        <source>rear left</source>
        <translation>hinten links</translation>
    </message>
    <message>
        <source>rear right</source>
        <translation>hinten rechts</translation>
    </message>
</context>
<context>
    <name>BlackBoxModel</name>
    <message>
        <source>changed</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Zeit, s</translation>
    </message>
</context>
<context>
    <name>BlackBoxPage</name>
    <message>
        <source>Black box</source>
        <translation>Blackbox</translation>
    </message>
    <message>
        <source>Next change</source>
        <translation>Nächste Änderung</translation>
    </message>
    <message>
        <source>Names (Ctrl+F)</source>
        <translation>Namen (Strg+F)</translation>
    </message>
    <message>
        <source>Show only names that hold these words</source>
        <translation>Nur Namen zeigen, in denen diese Wörter vorkommen</translation>
    </message>
    <message>
        <source>To the next changed value of the chosen column (F3)</source>
        <translation>Zum nächsten geänderten Wert der gewählten Spalte (F3)</translation>
    </message>
    <message>
        <source>Lines of the black box</source>
        <translation>Zeilen der Blackbox</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
    <message>
        <source>Open the black box of a drone to see its lines.</source>
        <translation>Öffnen Sie die Blackbox einer Drohne, um ihre Zeilen zu sehen.</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s)</source>
        <translation>
            <numerusform>%n Zeile</numerusform>
            <numerusform>%n Zeilen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n name(s)</source>
        <translation>
            <numerusform>%n Name</numerusform>
            <numerusform>%n Namen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 s. Values that differ from the line before are bold.</source>
        <translation>%1 s. Werte, die von der Zeile davor abweichen, sind fett.</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) of the file could not be read.</source>
        <translation>
            <numerusform>%n Stelle der Datei ließ sich nicht lesen.</numerusform>
            <numerusform>%n Stellen der Datei ließen sich nicht lesen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>BoardNameDialog</name>
    <message>
        <source>Store the name on the board as well</source>
        <translation>Den Namen auch auf dem Board speichern</translation>
    </message>
    <message>
        <source>Use this name</source>
        <translation>Diesen Namen verwenden</translation>
    </message>
    <message>
        <source>Which board is this?</source>
        <translation>Welches Board ist das?</translation>
    </message>
    <message>
        <source>It is “%1”</source>
        <translation>Es ist „%1“</translation>
    </message>
    <message>
        <source>It is a new one, with this name:</source>
        <translation>Es ist ein neues mit diesem Namen:</translation>
    </message>
    <message>
        <source>Name of the board</source>
        <translation>Name des Boards</translation>
    </message>
    <message>
        <source>Then it is told from boards that are otherwise the same. A snapshot is taken first.</source>
        <translation>Dann ist es von sonst gleichen Boards zu unterscheiden. Zuvor wird eine Sicherung gemacht.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>It is this one</source>
        <translation>Es ist dieses</translation>
    </message>
    <message>
        <source>A board of that name is known: it becomes this one.</source>
        <translation>Ein Board dieses Namens ist bekannt: Es gilt dann als dieses.</translation>
    </message>
    <message>
        <source>It has no serial number. Under its name its snapshots and unwritten changes are kept apart from those of other boards.</source>
        <translation>Es hat keine Seriennummer. Unter seinem Namen bleiben seine Sicherungen und ungeschriebenen Änderungen von denen anderer Boards getrennt.</translation>
    </message>
    <message>
        <source>The board has this name already. If it is the one that it left the factory with, every such board will be taken for this one.</source>
        <translation>Das Board hat diesen Namen bereits. Wenn es der Name ab Werk ist, wird jedes solche Board für dieses gehalten.</translation>
    </message>
</context>
<context>
    <name>BoardNaming</name>
    <message>
        <source>This board has no serial number and looks like none that has a name here. It may be a new one, or one that was renamed elsewhere (known: %1).</source>
        <translation>Dieses Board hat keine Seriennummer und gleicht keinem, das hier einen Namen hat. Es kann neu sein oder anderswo umbenannt (bekannt: %1).</translation>
    </message>
    <message>
        <source>Several boards look like this one: %1. Say which one it is; until then its snapshots are kept apart.</source>
        <translation>Mehrere Boards sehen so aus: %1. Bis angegeben ist, welches es ist, bleiben seine Sicherungen getrennt.</translation>
    </message>
    <message>
        <source>Taken for the board “%1”, which looks the same: it has no serial number. If it is another one, say so under Backups.</source>
        <translation>Gilt als Board „%1“, das gleich aussieht: Es hat keine Seriennummer. Ist es ein anderes, lässt sich das unter Sicherungen angeben.</translation>
    </message>
    <message>
        <source>Name the board…</source>
        <translation>Board benennen…</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Board %1</source>
        <translation>Board %1</translation>
    </message>
    <message>
        <source>This board has no serial number. Give it a name once, so that its snapshots and unwritten changes are not mixed with those of another board that looks the same.</source>
        <translation>Dieses Board hat keine Seriennummer. Einmal benannt, vermischen sich seine Sicherungen und ungeschriebenen Änderungen nicht mit denen eines anderen, das gleich aussieht.</translation>
    </message>
</context>
<context>
    <name>BoardText</name>
    <message>
        <source>%1, “%2”</source>
        <translation>%1, „%2“</translation>
    </message>
    <message>
        <source>%1, number %2</source>
        <translation>%1, Nummer %2</translation>
    </message>
</context>
<context>
    <name>BoardWriter</name>
    <message>
        <source>Changes of the interrupted write</source>
        <translation>Änderungen des unterbrochenen Schreibens</translation>
    </message>
    <message>
        <source>Profile names written and read back.</source>
        <translation>Profilnamen geschrieben und zurückgelesen.</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) written and read back.</source>
        <translation>
            <numerusform>%n Wert geschrieben und zurückgelesen.</numerusform>
            <numerusform>%n Werte geschrieben und zurückgelesen.</numerusform>
        </translation>
    </message>
    <message>
        <source>When the board is back it is read again; then the write can be finished or undone.</source>
        <translation>Wenn das Board zurück ist, wird es neu gelesen; dann lässt sich das Schreiben abschließen oder zurücknehmen.</translation>
    </message>
    <message>
        <source>The last write was interrupted: %1 of %2 values are not on the board.</source>
        <translation>Das letzte Schreiben wurde unterbrochen: %1 von %2 Werten sind nicht auf dem Board.</translation>
    </message>
    <message>
        <source>The board holds the old values.</source>
        <translation>Das Board hält die alten Werte.</translation>
    </message>
    <message numerus="yes">
        <source>Finish: write %n value(s)</source>
        <translation>
            <numerusform>Abschließen: %n Wert schreiben</numerusform>
            <numerusform>Abschließen: %n Werte schreiben</numerusform>
        </translation>
    </message>
    <message>
        <source>Leave it as it is</source>
        <translation>So lassen</translation>
    </message>
    <message>
        <source>The interrupted write was complete: every value is on the board.</source>
        <translation>Das unterbrochene Schreiben war vollständig: Alle Werte sind auf dem Board.</translation>
    </message>
    <message>
        <source>Everything else that was in use on the board is stored now as well; what it was could not be told: %1</source>
        <translation>Auch alles andere, was auf dem Board in Gebrauch war, ist jetzt gespeichert; was es war, ließ sich nicht feststellen: %1</translation>
    </message>
    <message>
        <source>%1 (%2 sets it)</source>
        <translation>%1 (%2 setzt ihn)</translation>
    </message>
    <message numerus="yes">
        <source>%n other value(s) stay in use without being stored: %1</source>
        <translation>
            <numerusform>%n anderer Wert bleibt ungespeichert in Gebrauch: %1</numerusform>
            <numerusform>%n andere Werte bleiben ungespeichert in Gebrauch: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other value(s) in use are stored too: %1</source>
        <translation>
            <numerusform>%n anderer Wert in Gebrauch ist mitgespeichert: %1</numerusform>
            <numerusform>%n andere Werte in Gebrauch sind mitgespeichert: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other value(s) are in use as they are stored again: %1</source>
        <translation>
            <numerusform>%n anderer Wert ist wieder so in Gebrauch, wie er gespeichert ist: %1</numerusform>
            <numerusform>%n andere Werte sind wieder so in Gebrauch, wie sie gespeichert sind: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Revert %n value(s)</source>
        <translation>
            <numerusform>%n Wert zurücknehmen</numerusform>
            <numerusform>%n Werte zurücknehmen</numerusform>
        </translation>
    </message>
    <message>
        <source>Whether the interrupted write is stored could not be read.</source>
        <translation>Ob der unterbrochene Schreibvorgang gespeichert ist, konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The interrupted write has left “%1” as the active profile; before it was “%2”.</source>
        <translation>Das unterbrochene Schreiben hat „%1“ als aktives Profil zurückgelassen; zuvor war es „%2“.</translation>
    </message>
    <message>
        <source>The interrupted write belongs to the board before: it is neither finished nor undone on this one.</source>
        <translation>Der unterbrochene Schreibvorgang gehört zum vorherigen Board: Auf diesem wird er weder beendet noch rückgängig gemacht.</translation>
    </message>
    <message>
        <source>Once the board has started, compare what is in use with what is stored.</source>
        <translation>Vergleichen Sie, sobald das Board gestartet ist, was in Gebrauch und was gespeichert ist.</translation>
    </message>
    <message>
        <source>Not in use any more, because it was not stored: %1</source>
        <translation>Nicht mehr in Gebrauch, weil es nicht gespeichert war: %1</translation>
    </message>
    <message>
        <source>The settings as they were are kept in %1</source>
        <translation>Die Einstellungen, wie sie waren, liegen in %1</translation>
    </message>
    <message>
        <source>What could be read of the settings as they were is kept in %1</source>
        <translation>Was von den Einstellungen, wie sie waren, zu lesen war, liegt in %1</translation>
    </message>
    <message>
        <source>That backup lacks what could not be read: %1.</source>
        <translation>Dieser Sicherung fehlt, was nicht zu lesen war: %1.</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Es wurde nichts geschrieben.</translation>
    </message>
    <message numerus="yes">
        <source>%n of them the board had used already: its next start shows whether they are stored.</source>
        <translation>
            <numerusform>%n davon hatte das Board schon in Gebrauch: Ob er gespeichert ist, zeigt sein nächster Start.</numerusform>
            <numerusform>%n davon hatte das Board schon in Gebrauch: Ob sie gespeichert sind, zeigt sein nächster Start.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CalibrationPage</name>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>usable</source>
        <translation>brauchbar</translation>
    </message>
    <message>
        <source>poor, repeat it</source>
        <translation>schlecht, bitte wiederholen</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Gyroscope</source>
        <translation>Gyroskop</translation>
    </message>
    <message>
        <source>Finds the zero of the turn-rate sensor. Do it when the camera drifts, after large temperature changes, and before anything else. Takes about ten seconds, with the camera lying still.</source>
        <translation>Findet den Nullpunkt des Gyroskops. Nötig, wenn die Kamera wandert, nach großen Temperaturwechseln und vor allem anderen. Dauert etwa zehn Sekunden, während die Kamera still liegt.</translation>
    </message>
    <message>
        <source>Calibrate the gyroscope</source>
        <translation>Gyroskop kalibrieren</translation>
    </message>
    <message>
        <source>Accelerometer, level</source>
        <translation>Beschleunigungssensor, waagerecht</translation>
    </message>
    <message>
        <source>Finds what is level. Do it when the horizon is crooked. Takes about ten seconds, with the sensor lying level.</source>
        <translation>Findet, was waagerecht ist. Nötig, wenn der Horizont schief ist. Dauert etwa zehn Sekunden, während der Sensor waagerecht liegt.</translation>
    </message>
    <message>
        <source>Calibrate level</source>
        <translation>Waagerechte kalibrieren</translation>
    </message>
    <message>
        <source>Accelerometer, six positions</source>
        <translation>Beschleunigungssensor, sechs Lagen</translation>
    </message>
    <message>
        <source>Finds zero and scale of all three directions, for a horizon that stays straight at every angle. Do it once for each sensor; each of its six faces has to lie up once. Takes about two minutes.</source>
        <translation>Findet Nullpunkt und Maßstab aller drei Richtungen, für einen Horizont, der bei jedem Winkel gerade bleibt. Einmal je Sensor; jede seiner sechs Seiten muss einmal oben liegen. Dauert etwa zwei Minuten.</translation>
    </message>
    <message>
        <source>Calibrate six positions</source>
        <translation>Sechs Lagen kalibrieren</translation>
    </message>
    <message>
        <source>Stillness</source>
        <translation>Ruhe</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Fortschritt der Messung</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Lay the camera down so that nothing moves it. Take your hands off the table.</source>
        <translation>Legen Sie die Kamera so hin, dass nichts sie bewegt. Hände vom Tisch.</translation>
    </message>
    <message>
        <source>Put the sensor level, Z up, and let it lie still.</source>
        <translation>Legen Sie den Sensor waagerecht, Z oben, und lassen Sie ihn still liegen.</translation>
    </message>
    <message>
        <source>%1 of 6 done. Lay the sensor on another face.</source>
        <translation>%1 von 6 erledigt. Legen Sie den Sensor auf eine andere Seite.</translation>
    </message>
    <message>
        <source>Measuring. Leave it absolutely still for about %1 seconds; the motors are off meanwhile.</source>
        <translation>Messung läuft. Halten Sie etwa %1 Sekunden lang alles völlig still; die Motoren sind so lange aus.</translation>
    </message>
    <message>
        <source>If it is moved, the board begins again.</source>
        <translation>Wird er bewegt, beginnt das Board von vorn.</translation>
    </message>
    <message>
        <source>Waiting for live data of the sensor.</source>
        <translation>Es wird auf Daten des Sensors gewartet.</translation>
    </message>
    <message>
        <source>It moves (%1 °/s). Waiting until it is still.</source>
        <translation>Bewegung (%1 °/s). Es geht weiter, sobald alles still ist.</translation>
    </message>
    <message>
        <source>Still, but not level: %1. Waiting for Z up.</source>
        <translation>Still, aber nicht waagerecht: %1. Es geht weiter, sobald Z oben liegt.</translation>
    </message>
    <message>
        <source>Still, but tilted. Waiting until one face lies up.</source>
        <translation>Still, aber schräg. Es geht weiter, sobald eine Seite oben liegt.</translation>
    </message>
    <message>
        <source>%1 is done already. Waiting for another face.</source>
        <translation>%1 ist schon erledigt. Es geht mit einer anderen Seite weiter.</translation>
    </message>
    <message>
        <source>✓ Still, %1. Ready.</source>
        <translation>✓ Still, %1. Bereit.</translation>
    </message>
    <message>
        <source>The calibration was cancelled.</source>
        <translation>Die Kalibrierung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The board may still finish this measurement by itself within a few seconds.</source>
        <translation>Das Board beendet diese Messung vielleicht noch selbst, in wenigen Sekunden.</translation>
    </message>
    <message>
        <source>Calibrate again when the sensor lies still.</source>
        <translation>Kalibrieren Sie nochmals, wenn der Sensor still liegt.</translation>
    </message>
    <message>
        <source>Gyroscope: %1</source>
        <translation>Gyroskop: %1</translation>
    </message>
    <message>
        <source>Accelerometer: %1</source>
        <translation>Beschleunigungssensor: %1</translation>
    </message>
    <message>
        <source>Drift before</source>
        <translation>Drift vorher</translation>
    </message>
    <message>
        <source>%1 °/s</source>
        <translation>%1 °/s</translation>
    </message>
    <message>
        <source>Drift now</source>
        <translation>Drift jetzt</translation>
    </message>
    <message>
        <source>Noise of the sensor</source>
        <translation>Rauschen des Sensors</translation>
    </message>
    <message>
        <source>Good is a drift below %1 °/s.</source>
        <translation>Gut ist eine Drift unter %1 °/s.</translation>
    </message>
    <message>
        <source>Error against gravity</source>
        <translation>Fehler gegen die Schwerkraft</translation>
    </message>
    <message>
        <source>%1 g</source>
        <translation>%1 g</translation>
    </message>
    <message>
        <source>That is a tilt of about</source>
        <translation>Das ist eine Neigung von etwa</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Good is an error below %1 g; the noise of the sensor is part of it.</source>
        <translation>Gut ist ein Fehler unter %1 g; das Rauschen des Sensors gehört dazu.</translation>
    </message>
    <message>
        <source>The result is stored in the sensor&apos;s memory; the settings as they were are among the backups.</source>
        <translation>Das Ergebnis steht im Speicher des Sensors; die Einstellungen, wie sie waren, liegen bei den Sicherungen.</translation>
    </message>
    <message>
        <source>This board has no command for it.</source>
        <translation>Dieses Board hat keinen Befehl dafür.</translation>
    </message>
    <message>
        <source>Lay the sensor on one of its six faces, with the motors off. Begin with Z up.</source>
        <translation>Den Sensor bei ausgeschalteten Motoren auf eine seiner sechs Seiten legen. Mit Z oben beginnen.</translation>
    </message>
    <message>
        <source>The motors run. Stop them before the sensor is turned over.</source>
        <translation>Die Motoren laufen. Sie müssen aus sein, bevor der Sensor gewendet wird.</translation>
    </message>
    <message>
        <source>%1 of 6 positions were measured: %2.</source>
        <translation>%1 von 6 Lagen wurden gemessen: %2.</translation>
    </message>
    <message>
        <source>Whether the board has finished the measurement under way is not known.</source>
        <translation>Ob das Board die laufende Messung beendet hat, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Nothing was measured; the sensor&apos;s calibration is the one from before.</source>
        <translation>Es wurde nichts gemessen; die Kalibrierung des Sensors ist die von vorher.</translation>
    </message>
    <message>
        <source>Calibrate again from the beginning when the board is connected.</source>
        <translation>Kalibrieren Sie von vorn, wenn das Board verbunden ist.</translation>
    </message>
    <message>
        <source>The calibration ended with the link.</source>
        <translation>Die Kalibrierung endete mit der Verbindung.</translation>
    </message>
    <message>
        <source>It measures %1 g instead of 1 g, which no sensor at rest does. Let it lie still, or check the sensor and its calibration.</source>
        <translation>Er misst %1 g statt 1 g, was kein ruhender Sensor tut. Lassen Sie ihn still liegen, oder prüfen Sie den Sensor und seine Kalibrierung.</translation>
    </message>
    <message>
        <source>%1. Waiting until the sensor sends live data again.</source>
        <translation>%1. Gewartet wird, bis der Sensor wieder Live-Daten sendet.</translation>
    </message>
    <message>
        <source>Copies of the calibrations</source>
        <translation>Kopien der Kalibrierungen</translation>
    </message>
    <message>
        <source>Keep the calibrations that the board holds in files, and compare what it has now with what it had before. What its sensors keep themselves no command reads.</source>
        <translation>Behalten Sie die Kalibrierungen, die das Board in Dateien hält, und vergleichen Sie, was es jetzt hat, mit dem Stand davor. Was seine Sensoren selbst behalten, liest kein Befehl.</translation>
    </message>
    <message>
        <source>Copy…</source>
        <translation>Kopieren…</translation>
    </message>
    <message>
        <source>Into a file; nothing on the board is changed</source>
        <translation>In eine Datei; auf dem Board ändert sich nichts</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Vergleichen…</translation>
    </message>
    <message>
        <source>Tell what differs between a copy and the board</source>
        <translation>Sagen, was sich zwischen einer Kopie und dem Board unterscheidet</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translation>Wiederherstellen…</translation>
    </message>
    <message>
        <source>Write the calibrations of a copy</source>
        <translation>Die Kalibrierungen einer Kopie schreiben</translation>
    </message>
    <message>
        <source>Sensor that the board shows and calibrates</source>
        <translation>Sensor, den das Board zeigt und kalibriert</translation>
    </message>
    <message>
        <source>Sensor: main IMU</source>
        <translation>Sensor: Haupt-IMU</translation>
    </message>
    <message>
        <source>Sensor: frame IMU</source>
        <translation>Sensor: Rahmen-IMU</translation>
    </message>
    <message>
        <source>How the simulated camera is turned</source>
        <translation>Wie die simulierte Kamera gedreht wird</translation>
    </message>
    <message>
        <source>not turned, unless the page asks for it</source>
        <translation>nicht gedreht, solange die Seite es nicht verlangt</translation>
    </message>
    <message>
        <source>turned to all sides</source>
        <translation>nach allen Seiten gedreht</translation>
    </message>
    <message>
        <source>turned about its upright axis only</source>
        <translation>nur um ihre Hochachse gedreht</translation>
    </message>
    <message>
        <source>Magnetometer</source>
        <translation>Magnetometer</translation>
    </message>
    <message>
        <source>Finds what the iron beside it adds to the earth&apos;s field. Do it when the camera does not keep its heading, and after anything made of iron was mounted. Takes about a minute, with the camera turned in your hands to all sides.</source>
        <translation>Findet, was das Eisen daneben zum Feld der Erde hinzufügt. Nötig, wenn die Kamera ihren Kurs nicht hält, und nachdem etwas aus Eisen angebaut wurde. Dauert etwa eine Minute, in der Sie die Kamera in den Händen nach allen Seiten drehen.</translation>
    </message>
    <message>
        <source>Magnetometer…</source>
        <translation>Magnetometer…</translation>
    </message>
    <message>
        <source>The board shows another sensor now. The calibration begins anew.</source>
        <translation>Das Board zeigt jetzt einen anderen Sensor. Die Kalibrierung beginnt von vorn.</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>frame IMU</source>
        <translation>Rahmen-IMU</translation>
    </message>
    <message>
        <source>main IMU</source>
        <translation>Haupt-IMU</translation>
    </message>
</context>
<context>
    <name>CameraPage</name>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Take a picture</source>
        <translation>Foto machen</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Saves the video as it comes, without encoding it again (Matroska)</source>
        <translation>Sichert das Video so, wie es kommt, ohne es neu zu kodieren (Matroska)</translation>
    </message>
    <message>
        <source>Saves the picture in its full size (PNG)</source>
        <translation>Sichert das Bild in voller Größe (PNG)</translation>
    </message>
    <message>
        <source>F11, or a double click on the picture; Esc leaves it</source>
        <translation>F11 oder ein Doppelklick auf das Bild; Esc verlässt es</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>How the video comes</source>
        <translation>Wie das Video kommt</translation>
    </message>
    <message>
        <source>Connection and files</source>
        <translation>Verbindung und Dateien</translation>
    </message>
    <message>
        <source>Address of the video</source>
        <translation>Adresse des Videos</translation>
    </message>
    <message>
        <source>HOST:PORT, HOST or :PORT. Empty: the drone&apos;s host, port %1.</source>
        <translation>HOST:PORT, HOST oder :PORT. Leer: der Host der Drohne, Port %1.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Folder for pictures and recordings</source>
        <translation>Ordner für Bilder und Aufnahmen</translation>
    </message>
    <message>
        <source>Where pictures and recordings are saved. Empty: %1</source>
        <translation>Wo Bilder und Aufnahmen gesichert werden. Leer: %1</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>The drone sends its video to whoever asked last: a second viewer takes it away.</source>
        <translation>Die Drohne sendet ihr Video an den, der zuletzt gefragt hat: Ein zweiter Betrachter nimmt es weg.</translation>
    </message>
    <message>
        <source>There is no video: the module libgimbaldesk-video is missing beside this program. Install it again.</source>
        <translation>Es gibt kein Video: Neben diesem Programm fehlt das Modul libgimbaldesk-video. Das Programm neu installieren.</translation>
    </message>
    <message>
        <source>The address %1 is not known in this network. Check it at the right.</source>
        <translation>Die Adresse %1 ist in diesem Netz nicht bekannt. Rechts prüfen.</translation>
    </message>
    <message>
        <source>Connect a drone to see its picture.</source>
        <translation>Eine Drohne verbinden, um ihr Bild zu sehen.</translation>
    </message>
    <message>
        <source>Waiting for video from %1 …</source>
        <translation>Warten auf Video von %1…</translation>
    </message>
    <message>
        <source>No video comes from %1. The drone has no camera, the port is another one, or another viewer asked for it later.</source>
        <translation>Von %1 kommt kein Video. Die Drohne hat keine Kamera, der Port ist ein anderer, oder ein anderer Betrachter hat danach gefragt.</translation>
    </message>
    <message>
        <source>What comes from %1 is no video that is known here (H.264, MJPEG).</source>
        <translation>Was von %1 kommt, ist kein hier bekanntes Video (H.264, MJPEG).</translation>
    </message>
    <message>
        <source>Video comes from %1, and no picture could be decoded so far.</source>
        <translation>Von %1 kommt Video, doch noch ließ sich kein Bild dekodieren.</translation>
    </message>
    <message>
        <source>%1 × %2 %3</source>
        <translation>%1 × %2 %3</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>%1 Mbit/s</source>
        <translation>%1 Mbit/s</translation>
    </message>
    <message>
        <source>%1 % lost</source>
        <translation>%1 % verloren</translation>
    </message>
    <message>
        <source>%1 ms behind</source>
        <translation>%1 ms zurück</translation>
    </message>
    <message>
        <source>no picture for %1 s</source>
        <translation>seit %1 s kein Bild</translation>
    </message>
    <message>
        <source>an old picture</source>
        <translation>ein altes Bild</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) lost</source>
        <translation>
            <numerusform>%n Bild verloren</numerusform>
            <numerusform>%n Bilder verloren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged picture(s)</source>
        <translation>
            <numerusform>%n beschädigtes Bild</numerusform>
            <numerusform>%n beschädigte Bilder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) that could not be decoded</source>
        <translation>
            <numerusform>%n Bild, das sich nicht dekodieren ließ</numerusform>
            <numerusform>%n Bilder, die sich nicht dekodieren ließen</numerusform>
        </translation>
    </message>
    <message>
        <source>From a frame&apos;s first datagram to the screen; at most %1 ms lately</source>
        <translation>Vom ersten Datagramm eines Bildes bis zum Bildschirm; zuletzt höchstens %1 ms</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Aufnahme beenden</translation>
    </message>
    <message>
        <source>● waiting for a key frame</source>
        <translation>● wartet auf ein Schlüsselbild</translation>
    </message>
    <message>
        <source>Nothing was recorded: no frame came that decoding can begin with.</source>
        <translation>Nichts wurde aufgenommen: Es kam kein Bild, mit dem das Dekodieren beginnen kann.</translation>
    </message>
    <message>
        <source>loss cannot be counted</source>
        <translation>Verlust nicht zählbar</translation>
    </message>
    <message>
        <source>Frames of MJPEG have no numbers: how many were lost nobody can tell</source>
        <translation>Bilder in MJPEG haben keine Nummern: wie viele verloren gingen, kann niemand sagen</translation>
    </message>
    <message>
        <source>There is no picture yet.</source>
        <translation>Es gibt noch kein Bild.</translation>
    </message>
</context>
<context>
    <name>ChangeModel</name>
    <message>
        <source>Profile name</source>
        <translation>Profilname</translation>
    </message>
    <message>
        <source>All profiles</source>
        <translation>Alle Profile</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>On the board</source>
        <translation>Auf dem Board</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>as on the board</source>
        <translation>wie auf dem Board</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>+%1 −%2 lines</source>
        <translation>+%1 −%2 Zeilen</translation>
    </message>
</context>
<context>
    <name>ChannelModel</name>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n Wert</numerusform>
            <numerusform>%n Werte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) came that are no numbers, or not initialised; they are gaps.</source>
        <translation>
            <numerusform>%n Wert kam, der keine Zahl oder nicht initialisiert ist; er ist eine Lücke.</numerusform>
            <numerusform>%n Werte kamen, die keine Zahlen oder nicht initialisiert sind; sie sind Lücken.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CommandPalette</name>
    <message>
        <source>Go to or do</source>
        <translation>Gehe zu oder tue</translation>
    </message>
    <message>
        <source>Page, parameter, channel or action</source>
        <translation>Seite, Parameter, Kanal oder Aktion</translation>
    </message>
    <message>
        <source>Matches</source>
        <translation>Treffer</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Review and write</source>
        <translation>Prüfen und schreiben</translation>
    </message>
    <message>
        <source>Take a snapshot</source>
        <translation>Sicherung machen</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Stop motors</source>
        <translation>Motoren stoppen</translation>
    </message>
    <message>
        <source>Start motors</source>
        <translation>Motoren starten</translation>
    </message>
    <message>
        <source>Read the board again</source>
        <translation>Das Board neu lesen</translation>
    </message>
    <message>
        <source>Nothing was found.</source>
        <translation>Nichts gefunden.</translation>
    </message>
    <message>
        <source>Messages so far</source>
        <translation>Bisherige Meldungen</translation>
    </message>
    <message>
        <source>Open a file</source>
        <translation>Datei öffnen</translation>
    </message>
    <message>
        <source>configuration, recording, black box</source>
        <translation>Konfiguration, Aufzeichnung, Blackbox</translation>
    </message>
</context>
<context>
    <name>Confirmations</name>
    <message>
        <source>Nothing stops it meanwhile, neither “STOP MOTORS” nor F12: only taking its battery away does.</source>
        <translation>Nichts hält das zwischendurch an, weder „MOTOREN STOPPEN“ noch F12: nur das Abziehen des Akkus.</translation>
    </message>
    <message>
        <source>Whoever goes on confirms: “%1”.</source>
        <translation>Wer fortfährt, bestätigt: „%1“.</translation>
    </message>
    <message>
        <source>Do nothing</source>
        <translation>Nichts tun</translation>
    </message>
    <message>
        <source>“%1” is not asked any more: the board is not as it has to be for that.</source>
        <translation>„%1“ wird nicht mehr gefragt: Der Controller ist nicht so, wie er dafür sein muss.</translation>
    </message>
</context>
<context>
    <name>ConsolePage</name>
    <message>
        <source>Console</source>
        <translation>Konsole</translation>
    </message>
    <message>
        <source>Live data too</source>
        <translation>Auch Live-Daten</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Allow commands that change something</source>
        <translation>Befehle erlauben, die etwas ändern</translation>
    </message>
    <message>
        <source>Filter (Ctrl+F)</source>
        <translation>Filtern (Strg+F)</translation>
    </message>
    <message>
        <source>Filter frames</source>
        <translation>Frames filtern</translation>
    </message>
    <message>
        <source>Show the frames of streamed live data as well</source>
        <translation>Auch die Frames der Live-Daten zeigen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Sichern…</translation>
    </message>
    <message>
        <source>Save all frames listed as text</source>
        <translation>Alle aufgeführten Frames als Text sichern</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Frames</translation>
    </message>
    <message>
        <source>The chosen frame</source>
        <translation>Der gewählte Frame</translation>
    </message>
    <message>
        <source>Choose a frame to see all of it.</source>
        <translation>Wählen Sie einen Frame, um alles davon zu sehen.</translation>
    </message>
    <message>
        <source>Command to send</source>
        <translation>Zu sendender Befehl</translation>
    </message>
    <message>
        <source>Commands that write take a snapshot first; motors may move</source>
        <translation>Befehle, die schreiben, machen vorher eine Sicherung; Motoren können sich bewegen</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Save frames</source>
        <translation>Frames sichern</translation>
    </message>
    <message>
        <source>Text files (*.txt)</source>
        <translation>Textdateien (*.txt)</translation>
    </message>
    <message>
        <source>%1 was not sent.</source>
        <translation>%1 wurde nicht gesendet.</translation>
    </message>
    <message>
        <source>Tick “Allow commands that change something” to send it all the same.</source>
        <translation>Haken Sie „Befehle erlauben, die etwas ändern“ an, um es trotzdem zu senden.</translation>
    </message>
    <message>
        <source>Command: a name with fields or bytes, or a whole frame in hex</source>
        <translation>Befehl: ein Name mit Feldern oder Bytes, oder ein ganzer Frame in Hex</translation>
    </message>
    <message>
        <source>It can move motors or change settings.</source>
        <translation>Er kann Motoren bewegen oder Einstellungen ändern.</translation>
    </message>
</context>
<context>
    <name>ControlPad</name>
    <message>
        <source>Steering pad</source>
        <translation>Steuerfeld</translation>
    </message>
    <message>
        <source>Drag, or hold the arrow keys; Shift for slow</source>
        <translation>Ziehen oder Pfeiltasten halten; Umschalt für langsam</translation>
    </message>
</context>
<context>
    <name>ControlPage</name>
    <message>
        <source>Control</source>
        <translation>Steuern</translation>
    </message>
    <message>
        <source>To the middle</source>
        <translation>Zur Mitte</translation>
    </message>
    <message>
        <source>While armed the camera moves as you steer. Let go, leave this page or press Esc to end it.</source>
        <translation>Solange scharf, bewegt sich die Kamera, wie Sie steuern. Loslassen, Seite verlassen oder Esc beendet es.</translation>
    </message>
    <message>
        <source>Mode of control</source>
        <translation>Art der Steuerung</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Steer</source>
        <translation>Lenken</translation>
    </message>
    <message>
        <source>Angles to go to</source>
        <translation>Zielwinkel</translation>
    </message>
    <message>
        <source>Angle, %1</source>
        <translation>Winkel, %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>%1 °/s</source>
        <translation>%1 °/s</translation>
    </message>
    <message>
        <source>■ Disarm</source>
        <translation>■ Entschärfen</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Scharf schalten</translation>
    </message>
    <message>
        <source>Armed: the camera follows you. It stops when you let go, leave this page, or do nothing for %1 s.</source>
        <translation>Scharf: die Kamera folgt Ihnen. Sie hält an, wenn Sie loslassen, die Seite verlassen oder %1 s nichts tun.</translation>
    </message>
    <message>
        <source>Control was disarmed: nothing was moved for %1 s.</source>
        <translation>Die Steuerung wurde entschärft: %1 s lang wurde nichts bewegt.</translation>
    </message>
    <message>
        <source>is</source>
        <translation>ist</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Armed, but nothing is sent yet: the angles that hold the camera are unknown. Set each of them, or press “To the middle”.</source>
        <translation>Scharf, aber noch wird nichts gesendet: Welche Winkel die Kamera halten, ist unbekannt. Jeden einstellen oder „Zur Mitte“ drücken.</translation>
    </message>
    <message>
        <source>Not in pan mode since it started</source>
        <translation>Seit dem Start nie im Pan-Modus</translation>
    </message>
    <message>
        <source>The board does not report its targets, and an axis that has followed the handle counts its angles from there. If you know that none has since the board was switched on, by remote control or otherwise, the camera can be held where it is.</source>
        <translation>Das Board meldet seine Ziele nicht, und eine Achse, die dem Griff gefolgt ist, zählt ihre Winkel von dort. Wenn Sie wissen, dass seit dem Einschalten keine gefolgt ist, auch nicht durch die Fernsteuerung, kann die Kamera dort gehalten werden, wo sie ist.</translation>
    </message>
    <message>
        <source>Armed, but nothing is sent yet: the board does not report its targets, and it was running before this link. Set each angle, press “To the middle”, or tick “%1” if that is so.</source>
        <translation>Scharf, aber noch wird nichts gesendet: Das Board meldet seine Ziele nicht und lief schon vor dieser Verbindung. Jeden Winkel einstellen, „Zur Mitte“ drücken oder, wenn es so ist, „%1“ ankreuzen.</translation>
    </message>
    <message>
        <source>Not armed: the motors are off, and where a limp camera hangs is no target. Start the motors, then arm.</source>
        <translation>Nicht scharf: Die Motoren sind aus, und wo eine schlaffe Kamera hängt, ist kein Ziel. Erst die Motoren starten, dann scharf schalten.</translation>
    </message>
    <message>
        <source>Not armed: the camera is not steered. Choose a mode, then arm. What stands under “Functions” acts at once, armed or not.</source>
        <translation>Nicht scharf: Die Kamera wird nicht gesteuert. Eine Betriebsart wählen, dann scharf schalten. Was unter „Funktionen“ steht, wirkt sofort, scharf oder nicht.</translation>
    </message>
    <message>
        <source>Not armed: the camera is not steered. Choose a mode, then arm.</source>
        <translation>Nicht scharf: Die Kamera wird nicht gesteuert. Eine Betriebsart wählen, dann scharf schalten.</translation>
    </message>
    <message>
        <source>Control was disarmed: the motors are off.</source>
        <translation>Die Steuerung ist nicht mehr scharf: Die Motoren sind aus.</translation>
    </message>
    <message>
        <source>Not armed: the motors are being stopped, and the board has not confirmed it.</source>
        <translation>Nicht scharf: Die Motoren werden gestoppt, und das Board hat es noch nicht bestätigt.</translation>
    </message>
</context>
<context>
    <name>CopyCard</name>
    <message numerus="yes">
        <source>%n byte(s)</source>
        <translation>
            <numerusform>%n Byte</numerusform>
            <numerusform>%n Byte</numerusform>
        </translation>
    </message>
    <message>
        <source>not there</source>
        <translation>nicht vorhanden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Also from another board</source>
        <translation>Auch von einem anderen Board</translation>
    </message>
    <message>
        <source>Calibrations and licence of another board are refused otherwise: they do not fit this board&apos;s sensors</source>
        <translation>Kalibrierungen und Lizenz eines anderen Boards werden sonst abgelehnt: Sie passen nicht zu den Sensoren dieses Boards</translation>
    </message>
    <message>
        <source>What differs between the copy and the board</source>
        <translation>Was sich zwischen Kopie und Board unterscheidet</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Board</translation>
    </message>
    <message>
        <source>This board has no command for it.</source>
        <translation>Dieses Board hat keinen Befehl dafür.</translation>
    </message>
    <message>
        <source>Copies of a board (*.bin)</source>
        <translation>Kopien eines Boards (*.bin)</translation>
    </message>
    <message>
        <source>Copy into a file</source>
        <translation>In eine Datei kopieren</translation>
    </message>
    <message>
        <source>Choose a copy</source>
        <translation>Eine Kopie wählen</translation>
    </message>
    <message>
        <source>%1 …</source>
        <translation>%1…</translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) of memory differ.</source>
        <translation>
            <numerusform>%n Byte des Speichers unterscheidet sich.</numerusform>
            <numerusform>%n Byte des Speichers unterscheiden sich.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) differ.</source>
        <translation>
            <numerusform>%n Datei unterscheidet sich.</numerusform>
            <numerusform>%n Dateien unterscheiden sich.</numerusform>
        </translation>
    </message>
    <message>
        <source>The board holds what the copy does.</source>
        <translation>Das Board enthält dasselbe wie die Kopie.</translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) of memory are copied.</source>
        <translation>
            <numerusform>%n Byte des Speichers ist kopiert.</numerusform>
            <numerusform>%n Byte des Speichers sind kopiert.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) are copied.</source>
        <translation>
            <numerusform>%n Datei ist kopiert.</numerusform>
            <numerusform>%n Dateien sind kopiert.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) of memory were written.</source>
        <translation>
            <numerusform>%n Byte des Speichers wurde geschrieben.</numerusform>
            <numerusform>%n Byte des Speichers wurden geschrieben.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were written or erased.</source>
        <translation>
            <numerusform>%n Datei wurde geschrieben oder gelöscht.</numerusform>
            <numerusform>%n Dateien wurden geschrieben oder gelöscht.</numerusform>
        </translation>
    </message>
    <message>
        <source>The place of %1 parts of the settings was found; the others are as they were.</source>
        <translation>Der Platz von %1 Teilen der Einstellungen wurde gefunden; die anderen sind, wie sie waren.</translation>
    </message>
    <message>
        <source>The copy is of another board.</source>
        <translation>Die Kopie stammt von einem anderen Board.</translation>
    </message>
    <message>
        <source>The copy is of firmware %1.</source>
        <translation>Die Kopie stammt von Firmware %1.</translation>
    </message>
    <message numerus="yes">
        <source>What lies in %n range(s) is documented nowhere.</source>
        <translation>
            <numerusform>Was in %n Bereich liegt, ist nirgends dokumentiert.</numerusform>
            <numerusform>Was in %n Bereichen liegt, ist nirgends dokumentiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>It is in use after a restart.</source>
        <translation>Es gilt nach einem Neustart.</translation>
    </message>
    <message>
        <source>Profile %1: %2</source>
        <translation>Profil %1: %2</translation>
    </message>
    <message>
        <source>File %1 %2</source>
        <translation>Datei %1 %2</translation>
    </message>
    <message>
        <source>Address %1</source>
        <translation>Adresse %1</translation>
    </message>
</context>
<context>
    <name>CurveChart</name>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
</context>
<context>
    <name>DashboardPage</name>
    <message>
        <source>Dashboard</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>Attitude</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Axes: angle and target</source>
        <translation>Achsen: Winkel und Ziel</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>State of the board</source>
        <translation>Zustand des Boards</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>Sensor temperature</source>
        <translation>Sensortemperatur</translation>
    </message>
    <message>
        <source>Control cycle</source>
        <translation>Regeltakt</translation>
    </message>
    <message>
        <source>Sensor bus errors</source>
        <translation>Fehler am Sensorbus</translation>
    </message>
    <message>
        <source>Frames received</source>
        <translation>Empfangene Nachrichten</translation>
    </message>
    <message>
        <source>%1 per second</source>
        <translation>%1 je Sekunde</translation>
    </message>
    <message>
        <source>Damaged frames</source>
        <translation>Beschädigte Nachrichten</translation>
    </message>
    <message>
        <source>Answer time</source>
        <translation>Antwortzeit</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Not connected.</source>
        <translation>Nicht verbunden.</translation>
    </message>
    <message>
        <source>No live data yet.</source>
        <translation>Noch keine Live-Daten.</translation>
    </message>
    <message>
        <source>● Motors are running.</source>
        <translation>● Motoren laufen.</translation>
    </message>
    <message>
        <source>○ Motors are off.</source>
        <translation>○ Motoren sind aus.</translation>
    </message>
    <message>
        <source>✓ The board reports no errors.</source>
        <translation>✓ Das Board meldet keine Fehler.</translation>
    </message>
    <message>
        <source>State: %1</source>
        <translation>Zustand: %1</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>⚠ Could not be read: %1.</source>
        <translation>⚠ Nicht gelesen: %1.</translation>
    </message>
    <message>
        <source>Nothing is known about the values there.</source>
        <translation>Über die Werte darin ist nichts bekannt.</translation>
    </message>
    <message>
        <source>Camera and frame</source>
        <translation>Kamera und Rahmen</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>kB/s</source>
        <translation>kB/s</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Empfangen</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Gesendet</translation>
    </message>
    <message>
        <source>Unanswered</source>
        <translation>Unbeantwortet</translation>
    </message>
    <message>
        <source>Angles, last %1 s</source>
        <translation>Winkel, letzte %1 s</translation>
    </message>
    <message>
        <source>Angles of the camera</source>
        <translation>Winkel der Kamera</translation>
    </message>
    <message>
        <source>The recording stands still.</source>
        <translation>Die Aufzeichnung steht.</translation>
    </message>
    <message>
        <source>Live data have stopped.</source>
        <translation>Es kommen keine Live-Daten mehr.</translation>
    </message>
    <message>
        <source>⚠ Whether the motors run is not known: the live data stand still.</source>
        <translation>⚠ Ob die Motoren laufen, ist nicht bekannt: Die Live-Daten stehen still.</translation>
    </message>
    <message>
        <source>Angles of the drone</source>
        <translation>Winkel der Drohne</translation>
    </message>
</context>
<context>
    <name>DebugModel</name>
    <message>
        <source>unknown type</source>
        <translation>unbekannter Typ</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>Kleinster</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Größter</translation>
    </message>
</context>
<context>
    <name>DebugPage</name>
    <message>
        <source>Debug variables</source>
        <translation>Debug-Variablen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Reset bounds</source>
        <translation>Grenzen vergessen</translation>
    </message>
    <message>
        <source>Only the firmware&apos;s makers know what these variables mean; they are useful for technical support.</source>
        <translation>Was diese Variablen bedeuten, wissen nur die Hersteller der Firmware; sie helfen dem Support.</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Reset the lowest and highest values</source>
        <translation>Kleinsten und größten Wert neu beginnen</translation>
    </message>
    <message>
        <source>Choose several with Ctrl or Shift to see them together</source>
        <translation>Wählen Sie mit Strg oder Umschalt mehrere, um sie zusammen zu sehen</translation>
    </message>
</context>
<context>
    <name>DiffView</name>
    <message numerus="yes">
        <source>⋯ %n line(s) without a difference</source>
        <translation>
            <numerusform>⋯ %n Zeile ohne Unterschied</numerusform>
            <numerusform>⋯ %n Zeilen ohne Unterschied</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>DirectionCard</name>
    <message>
        <source>Directions</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>as it is held</source>
        <translation>wie sie gehalten wird</translation>
    </message>
    <message>
        <source>level</source>
        <translation>waagerecht</translation>
    </message>
    <message>
        <source>right side down</source>
        <translation>rechte Seite unten</translation>
    </message>
    <message>
        <source>left side down</source>
        <translation>linke Seite unten</translation>
    </message>
    <message>
        <source>nose down</source>
        <translation>Nase unten</translation>
    </message>
    <message>
        <source>nose up</source>
        <translation>Nase oben</translation>
    </message>
    <message>
        <source>turned to the right</source>
        <translation>nach rechts gedreht</translation>
    </message>
    <message>
        <source>turned to the left</source>
        <translation>nach links gedreht</translation>
    </message>
    <message>
        <source>Simulated drone: your hands</source>
        <translation>Simulierte Drohne: Ihre Hände</translation>
    </message>
    <message>
        <source>Cancel the check</source>
        <translation>Prüfung abbrechen</translation>
    </message>
    <message>
        <source>Yes, those</source>
        <translation>Ja, diese</translation>
    </message>
    <message>
        <source>No, others</source>
        <translation>Nein, andere</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Fortschritt der Prüfung</translation>
    </message>
    <message>
        <source>%1 answers the wrong way round.</source>
        <translation>%1 antwortet verkehrt herum.</translation>
    </message>
    <message>
        <source>It would turn over as soon as it leaves the ground.</source>
        <translation>Sie würde sich überschlagen, sobald sie abhebt.</translation>
    </message>
    <message>
        <source>Do not fly it. Correct the axes, the motors&apos; places or the mixing in the configuration text, then check again.</source>
        <translation>Nicht fliegen. Achsen, Plätze der Motoren oder Mischung im Konfigurationstext berichtigen, dann noch einmal prüfen.</translation>
    </message>
    <message>
        <source>Checked with this drone and this configuration.</source>
        <translation>Mit dieser Drohne und dieser Konfiguration geprüft.</translation>
    </message>
    <message>
        <source>Angles and sticks are checked; what the motors answer is not.</source>
        <translation>Winkel und Knüppel sind geprüft, die Antwort der Motoren nicht.</translation>
    </message>
    <message>
        <source>Not checked. Nothing tells the program which way this drone counts its axes, so it is not armed until you have looked.</source>
        <translation>Nicht geprüft. Nichts sagt dem Programm, in welcher Richtung diese Drohne ihre Achsen zählt; bevor Sie nachgesehen haben, wird sie nicht scharf geschaltet.</translation>
    </message>
    <message>
        <source>Check again…</source>
        <translation>Noch einmal prüfen…</translation>
    </message>
    <message>
        <source>Check directions…</source>
        <translation>Richtungen prüfen…</translation>
    </message>
    <message>
        <source>Calibrate it first: its angles are not known before.</source>
        <translation>Zuerst kalibrieren: Vorher sind ihre Winkel unbekannt.</translation>
    </message>
    <message>
        <source>Hold it level, then tilt it to its right side.</source>
        <translation>Waagerecht halten, dann auf ihre rechte Seite neigen.</translation>
    </message>
    <message>
        <source>Hold it level, then tilt its nose down.</source>
        <translation>Waagerecht halten, dann die Nase nach unten neigen.</translation>
    </message>
    <message>
        <source>Hold it level, then turn its nose to the right, seen from above.</source>
        <translation>Waagerecht halten, dann die Nase nach rechts drehen, von oben gesehen.</translation>
    </message>
    <message>
        <source>Faster turned: %1. Are those the motors on its right?</source>
        <translation>Schneller drehten: %1. Sind das die Motoren auf ihrer rechten Seite?</translation>
    </message>
    <message>
        <source>Faster turned: %1. Are those the motors in front?</source>
        <translation>Schneller drehten: %1. Sind das die Motoren vorn?</translation>
    </message>
    <message>
        <source>Faster turned: %1. Are those the ones that turn clockwise, seen from above?</source>
        <translation>Schneller drehten: %1. Sind das die, die sich im Uhrzeigersinn drehen, von oben gesehen?</translation>
    </message>
    <message>
        <source>Faster turned: %1. Are those the motors on its left?</source>
        <translation>Schneller drehten: %1. Sind das die Motoren auf ihrer linken Seite?</translation>
    </message>
    <message>
        <source>Faster turned: %1. Are those the motors behind?</source>
        <translation>Schneller drehten: %1. Sind das die Motoren hinten?</translation>
    </message>
    <message>
        <source>Faster turned: %1. Are those the ones that turn counter-clockwise, seen from above?</source>
        <translation>Schneller drehten: %1. Sind das die, die sich gegen den Uhrzeigersinn drehen, von oben gesehen?</translation>
    </message>
    <message>
        <source>No motor turns faster than the others yet.</source>
        <translation>Noch dreht kein Motor schneller als die anderen.</translation>
    </message>
    <message>
        <source>Not armed: open a control session with the propellers off, then arm.</source>
        <translation>Nicht scharf: eine Steuersitzung mit abgenommenen Propellern öffnen, dann scharf schalten.</translation>
    </message>
    <message>
        <source>Another angle moves more than this one. If it was turned as said, its axes are set up wrongly.</source>
        <translation>Ein anderer Winkel bewegt sich mehr als dieser. Wenn sie wie gesagt bewegt wurde, sind ihre Achsen falsch eingestellt.</translation>
    </message>
    <message>
        <source>Another stick moves, or this one the other way. See how the sticks are mapped.</source>
        <translation>Ein anderer Knüppel bewegt sich oder dieser andersherum. Nachsehen, wie die Knüppel zugeordnet sind.</translation>
    </message>
    <message>
        <source>Seen. Put it level again.</source>
        <translation>Gesehen. Wieder waagerecht halten.</translation>
    </message>
    <message>
        <source>Seen. Let go.</source>
        <translation>Gesehen. Loslassen.</translation>
    </message>
    <message>
        <source>Nothing has moved far enough yet.</source>
        <translation>Noch hat sich nichts weit genug bewegt.</translation>
    </message>
    <message>
        <source>Push the stick for roll to the right, at least a third of the way, and let go.</source>
        <translation>Den Knüppel für Roll nach rechts drücken, mindestens ein Drittel des Weges, und loslassen.</translation>
    </message>
    <message>
        <source>Push the stick for pitch forward, at least a third of the way, and let go.</source>
        <translation>Den Knüppel für Pitch nach vorn drücken, mindestens ein Drittel des Weges, und loslassen.</translation>
    </message>
    <message>
        <source>Push the stick for yaw to the right, at least a third of the way, and let go.</source>
        <translation>Den Knüppel für Yaw nach rechts drücken, mindestens ein Drittel des Weges, und loslassen.</translation>
    </message>
    <message>
        <source>Armed without propellers, with 5 to 15 % throttle: hold it level, then tilt it to its right side.</source>
        <translation>Scharf, ohne Propeller, mit 5 bis 15 % Gas: waagerecht halten, dann auf ihre rechte Seite neigen.</translation>
    </message>
    <message>
        <source>Armed without propellers, with 5 to 15 % throttle: hold it level, then tilt its nose down.</source>
        <translation>Scharf, ohne Propeller, mit 5 bis 15 % Gas: waagerecht halten, dann die Nase nach unten neigen.</translation>
    </message>
    <message>
        <source>Armed without propellers, with 5 to 15 % throttle: hold it level, then turn its nose to the right.</source>
        <translation>Scharf, ohne Propeller, mit 5 bis 15 % Gas: waagerecht halten, dann die Nase nach rechts drehen.</translation>
    </message>
    <message>
        <source>Hold it level and push the stick for roll to the right, at least a third of the way.</source>
        <translation>Waagerecht halten und den Knüppel für Roll nach rechts drücken, mindestens ein Drittel des Weges.</translation>
    </message>
    <message>
        <source>Hold it level and push the stick for pitch forward, at least a third of the way.</source>
        <translation>Waagerecht halten und den Knüppel für Pitch nach vorn drücken, mindestens ein Drittel des Weges.</translation>
    </message>
    <message>
        <source>Hold it level and push the stick for yaw to the right, at least a third of the way.</source>
        <translation>Waagerecht halten und den Knüppel für Yaw nach rechts drücken, mindestens ein Drittel des Weges.</translation>
    </message>
    <message>
        <source>The control session is one for a test stand, with the propellers on. Close it, take the propellers off, and open one that says so.</source>
        <translation>Die Steuersitzung ist eine für den Teststand, mit Propellern. Schließen Sie sie, nehmen Sie die Propeller ab, und öffnen Sie eine, die das sagt.</translation>
    </message>
    <message>
        <source>Not armed: the session is open; hold the key to arm.</source>
        <translation>Nicht scharf: Die Sitzung ist offen; zum Scharfschalten die Taste halten.</translation>
    </message>
    <message>
        <source>Look at the drone: places and directions in the picture are those of the text, and are being checked now.</source>
        <translation>Sehen Sie auf die Drohne: Orte und Drehrichtungen im Bild sind die des Textes und werden gerade erst geprüft.</translation>
    </message>
    <message>
        <source>That contradicts what was answered before: a motor has one place and turns one way. These axes are asked again.</source>
        <translation>Das widerspricht einer früheren Antwort: Ein Motor hat einen Platz und eine Drehrichtung. Diese Achsen werden noch einmal gefragt.</translation>
    </message>
    <message>
        <source>Hold it level and let the sticks go until the motors turn steadily. If they do not, disarm and arm again.</source>
        <translation>Waagerecht halten und die Knüppel loslassen, bis die Motoren gleichmäßig drehen. Tun sie das nicht, entschärfen und wieder scharf schalten.</translation>
    </message>
    <message>
        <source>Checked, until another connection is made: it has no serial number. With a name (Backups) it is kept.</source>
        <translation>Geprüft, bis eine andere Verbindung aufgebaut wird: Die Drohne hat keine Seriennummer. Mit einem Namen (Sicherungen) bleibt die Prüfung gültig.</translation>
    </message>
    <message>
        <source>It would spin as soon as it leaves the ground.</source>
        <translation>Sie würde sich um sich selbst drehen, sobald sie abhebt.</translation>
    </message>
    <message>
        <source>Turned round: from now on this stick is sent the other way. Let it go until the motors turn steadily, then push it again.</source>
        <translation>Umgedreht: Von jetzt an wird dieser Knüppel andersherum gesendet. Lassen Sie ihn los, bis die Motoren gleichmäßig drehen, und drücken Sie ihn dann noch einmal.</translation>
    </message>
    <message>
        <source>From the beginning…</source>
        <translation>Von vorn beginnen…</translation>
    </message>
    <message>
        <source>All directions are known: it may be flown.</source>
        <translation>Alle Richtungen sind bekannt: Sie darf geflogen werden.</translation>
    </message>
    <message>
        <source>Go on with the check…</source>
        <translation>Prüfung fortsetzen…</translation>
    </message>
    <message>
        <source>This stick is sent the other way.</source>
        <translation>Dieser Stick wird umgekehrt gesendet.</translation>
    </message>
    <message>
        <source>Checked, until another connection is made: it has no serial number. If it is “%1”, say so, and it is kept.</source>
        <translation>Geprüft, bis eine andere Verbindung hergestellt wird: Sie hat keine Seriennummer. Ist es „%1“, dann sagen Sie es, und das Ergebnis bleibt.</translation>
    </message>
    <message>
        <source>Checked for “%1” on %2.</source>
        <translation>Für „%1“ am %2 geprüft.</translation>
    </message>
    <message>
        <source>Checked for “%1”.</source>
        <translation>Für „%1“ geprüft.</translation>
    </message>
    <message>
        <source>Is this the same drone? It has no serial number, and another one may look the same. Until you say so, or have checked it, it is not armed.</source>
        <translation>Ist dies dieselbe Drohne? Sie hat keine Seriennummer, und eine andere kann gleich aussehen. Bis Sie das sagen oder sie geprüft haben, wird sie nicht scharf geschaltet.</translation>
    </message>
    <message>
        <source>It is “%1”</source>
        <translation>Es ist „%1“</translation>
    </message>
    <message>
        <source>Propellers off: while it is tilted by hand the controller drives motors up to full throttle, whatever the throttle here says.</source>
        <translation>Propeller ab: Während sie mit der Hand geneigt wird, treibt der Regler Motoren bis zu Vollgas, was auch immer das Gas hier anzeigt.</translation>
    </message>
    <message>
        <source>The motors are compared once it is turned that way by %1°, and less any other way.</source>
        <translation>Die Motoren werden verglichen, sobald sie so herum um %1° gedreht ist und anders herum weniger.</translation>
    </message>
    <message>
        <source>The motors are compared once the stick is pushed that way, at least a third.</source>
        <translation>Die Motoren werden verglichen, sobald der Knüppel so herum wenigstens ein Drittel ausgelenkt ist.</translation>
    </message>
</context>
<context>
    <name>DocumentsPage</name>
    <message>
        <source>Documents</source>
        <translation>Dokumente</translation>
    </message>
    <message>
        <source>Load file…</source>
        <translation>Datei laden…</translation>
    </message>
    <message>
        <source>Save file…</source>
        <translation>Datei sichern…</translation>
    </message>
    <message>
        <source>Put the text of a file in place of this one</source>
        <translation>Den Text einer Datei an die Stelle von diesem setzen</translation>
    </message>
    <message>
        <source>Save the text as it is shown</source>
        <translation>Den Text sichern, wie er gezeigt wird</translation>
    </message>
    <message>
        <source>Documents of this board</source>
        <translation>Dokumente dieses Boards</translation>
    </message>
    <message>
        <source>Text of the document</source>
        <translation>Text des Dokuments</translation>
    </message>
    <message>
        <source>Load a document</source>
        <translation>Dokument laden</translation>
    </message>
    <message>
        <source>Texts (*)</source>
        <translation>Texte (*)</translation>
    </message>
    <message>
        <source>Save the document</source>
        <translation>Dokument sichern</translation>
    </message>
    <message>
        <source>Connect a board, or open a file, to see its documents.</source>
        <translation>Verbinden Sie ein Board oder öffnen Sie eine Datei, um die Dokumente zu sehen.</translation>
    </message>
    <message>
        <source>This document is not UTF-8 text. It can be saved to a file, but not edited here.</source>
        <translation>Dieses Dokument ist kein UTF-8-Text. Es kann in einer Datei gesichert, aber hier nicht bearbeitet werden.</translation>
    </message>
    <message>
        <source>%1 bytes, and the board takes %2 to %3: this is not kept as an edit.</source>
        <translation>%1 Bytes, und das Board nimmt %2 bis %3: Das wird nicht als Änderung übernommen.</translation>
    </message>
    <message>
        <source>The board restarts when it is written.</source>
        <translation>Das Board startet neu, wenn es geschrieben wird.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Search in the text (Ctrl+F)</source>
        <translation>Im Text suchen (Strg+F)</translation>
    </message>
    <message>
        <source>Show line by line what differs from the board</source>
        <translation>Zeile für Zeile zeigen, was vom Board abweicht</translation>
    </message>
    <message>
        <source>Difference from the board</source>
        <translation>Unterschied zum Board</translation>
    </message>
    <message>
        <source>%1 of %2 bytes.</source>
        <translation>%1 von %2 Bytes.</translation>
    </message>
    <message>
        <source>Line %1: %2.</source>
        <translation>Zeile %1: %2.</translation>
    </message>
    <message>
        <source>The text cannot be used: %1.</source>
        <translation>Der Text ist nicht brauchbar: %1.</translation>
    </message>
    <message>
        <source>Go to line %1</source>
        <translation>Zu Zeile %1</translation>
    </message>
    <message>
        <source>✓ Valid %1. That does not prove that the board starts with it.</source>
        <translation>✓ Gültiges %1. Das beweist nicht, dass das Board damit startet.</translation>
    </message>
    <message>
        <source>No difference: the text is as it is stored.</source>
        <translation>Kein Unterschied: Der Text ist, wie er gespeichert ist.</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) added</source>
        <translation>
            <numerusform>%n Zeile hinzugefügt</numerusform>
            <numerusform>%n Zeilen hinzugefügt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) removed</source>
        <translation>
            <numerusform>%n Zeile entfernt</numerusform>
            <numerusform>%n Zeilen entfernt</numerusform>
        </translation>
    </message>
    <message>
        <source>Lines with − are stored now; those with + take their place when the text is written.</source>
        <translation>Zeilen mit − sind jetzt gespeichert; Zeilen mit + treten an ihre Stelle, wenn der Text geschrieben wird.</translation>
    </message>
    <message>
        <source>Show in the text</source>
        <translation>Im Text zeigen</translation>
    </message>
</context>
<context>
    <name>DroneObstacle</name>
    <message>
        <source>Not connected.</source>
        <translation>Nicht verbunden.</translation>
    </message>
    <message>
        <source>This drone is only looked at: its generation of the protocol is not known well enough.</source>
        <translation>Diese Drohne wird nur angesehen: Die Generation ihres Protokolls ist nicht gut genug bekannt.</translation>
    </message>
    <message>
        <source>The drone is armed.</source>
        <translation>Die Drohne ist scharf.</translation>
    </message>
    <message>
        <source>Motors are driven already.</source>
        <translation>Es werden schon Motoren angetrieben.</translation>
    </message>
    <message>
        <source>Whether it is armed is not known at present.</source>
        <translation>Ob sie scharf ist, ist gerade nicht bekannt.</translation>
    </message>
    <message>
        <source>It calibrates.</source>
        <translation>Sie kalibriert gerade.</translation>
    </message>
    <message>
        <source>Calibrate it first: without that, a motor test hangs it until it is switched off.</source>
        <translation>Kalibrieren Sie sie zuerst: Sonst hängt sie bei einem Motortest, bis sie ausgeschaltet wird.</translation>
    </message>
</context>
<context>
    <name>EditGuide</name>
    <message>
        <source>%1: “%2” is no value of it (%3). Change it, or press Esc in its field; then review.</source>
        <translation>%1: „%2“ ist kein Wert dafür (%3). Ändern Sie ihn, oder drücken Sie Esc in seinem Feld; prüfen Sie dann.</translation>
    </message>
    <message>
        <source>The text has a mistake in line %1, so it is not written.</source>
        <translation>Der Text hat in Zeile %1 einen Fehler und wird deshalb nicht geschrieben.</translation>
    </message>
    <message>
        <source>The text has a mistake, so it is not written.</source>
        <translation>Der Text hat einen Fehler und wird deshalb nicht geschrieben.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Its page shows the place: mend it there, then try again.</source>
        <translation>Seine Seite zeigt die Stelle: Verbessern Sie sie dort, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Change one of the two so that both can hold, then write again.</source>
        <translation>Einen der beiden so ändern, dass beide gelten können, dann noch einmal schreiben.</translation>
    </message>
</context>
<context>
    <name>EditStack</name>
    <message>
        <source>Profile name</source>
        <translation>Profilname</translation>
    </message>
    <message>
        <source>Discard all changes</source>
        <translation>Alle Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Copy profile %1 onto profile %2</source>
        <translation>Profil %1 auf Profil %2 kopieren</translation>
    </message>
    <message>
        <source>Unwritten changes</source>
        <translation>Ungeschriebene Änderungen</translation>
    </message>
</context>
<context>
    <name>ErrorDetail</name>
    <message>
        <source>a segment has 16 to 65536 samples, an even number</source>
        <translation>ein Abschnitt hat 16 bis 65536 Messwerte, eine gerade Zahl</translation>
    </message>
    <message>
        <source>the overlap is 0 to 0.9</source>
        <translation>die Überlappung ist 0 bis 0.9</translation>
    </message>
    <message>
        <source>the sample rate is not known</source>
        <translation>die Abtastrate ist nicht bekannt</translation>
    </message>
    <message>
        <source>%1 samples are fewer than one segment of %2</source>
        <translation>%1 Messwerte sind weniger als ein Abschnitt von %2</translation>
    </message>
    <message>
        <source>%1 samples are too few for a step</source>
        <translation>%1 Messwerte sind zu wenige für einen Sprung</translation>
    </message>
    <message>
        <source>the samples end where they began: no step to measure</source>
        <translation>die Messwerte enden, wo sie begannen: kein Sprung zu messen</translation>
    </message>
    <message>
        <source>no samples</source>
        <translation>keine Messwerte</translation>
    </message>
    <message>
        <source>the target did not step: another control source may hold it</source>
        <translation>das Ziel ist nicht gesprungen: vielleicht hält es eine andere Steuerquelle</translation>
    </message>
    <message>
        <source>the command did not step</source>
        <translation>der Befehl ist nicht gesprungen</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not a whole number</source>
        <translation>%1: „%2“ ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>%1: %2 is not within %3 .. %4</source>
        <translation>%1: %2 liegt nicht zwischen %3 und %4</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not a number</source>
        <translation>%1: „%2“ ist keine Zahl</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not a series of bytes in hex</source>
        <translation>%1: „%2“ ist keine Folge von Bytes in Hex</translation>
    </message>
    <message>
        <source>%1 bytes are too few</source>
        <translation>%1 Bytes sind zu wenige</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos;</source>
        <translation>ein Feld „%1“ gibt es nicht</translation>
    </message>
    <message>
        <source>only generations F and G are told to do anything</source>
        <translation>nur den Generationen F und G wird etwas befohlen</translation>
    </message>
    <message>
        <source>the drone says that it is armed</source>
        <translation>die Drohne meldet, dass sie scharf ist</translation>
    </message>
    <message>
        <source>the drone drives its motors though disarmed</source>
        <translation>die Drohne treibt ihre Motoren an, obwohl sie unscharf ist</translation>
    </message>
    <message>
        <source>this generation does not tell it</source>
        <translation>diese Generation meldet es nicht</translation>
    </message>
    <message>
        <source>only generations F and G are asked for their recordings</source>
        <translation>nur die Generationen F und G werden nach ihren Aufnahmen gefragt</translation>
    </message>
    <message>
        <source>the transmitter sends with power %1</source>
        <translation>der Sender sendet mit Leistung %1</translation>
    </message>
    <message>
        <source>the transmitter sends in the band %1 on channel %2</source>
        <translation>der Sender sendet im Band %1 auf Kanal %2</translation>
    </message>
    <message>
        <source>the drone has no video transmitter</source>
        <translation>die Drohne hat keinen Videosender</translation>
    </message>
    <message>
        <source>the drone is armed</source>
        <translation>die Drohne ist scharf</translation>
    </message>
    <message>
        <source>the drone does not say that it is calibrated</source>
        <translation>die Drohne meldet nicht, dass sie kalibriert ist</translation>
    </message>
    <message>
        <source>the drone did not begin to calibrate</source>
        <translation>die Drohne hat nicht zu kalibrieren begonnen</translation>
    </message>
    <message>
        <source>the drone had taken it up already, and has carried it out</source>
        <translation>die Drohne hatte es schon angenommen und hat es ausgeführt</translation>
    </message>
    <message>
        <source>the drone does not answer any more; only switching it off and on helps</source>
        <translation>die Drohne antwortet nicht mehr; nur Aus- und Einschalten hilft</translation>
    </message>
    <message>
        <source>the drone is not calibrated</source>
        <translation>die Drohne ist nicht kalibriert</translation>
    </message>
    <message>
        <source>the drone does not stream its outputs, so nobody knows how many motors it has; switch full telemetry on</source>
        <translation>die Drohne sendet ihre Ausgänge nicht, darum weiß niemand, wie viele Motoren sie hat; volle Telemetrie einschalten</translation>
    </message>
    <message>
        <source>the drone has %1 motors</source>
        <translation>die Drohne hat %1 Motoren</translation>
    </message>
    <message>
        <source>the drone is calibrating</source>
        <translation>die Drohne kalibriert gerade</translation>
    </message>
    <message>
        <source>the drone holds another text than was uploaded</source>
        <translation>die Drohne hat einen anderen Text als den hochgeladenen</translation>
    </message>
    <message>
        <source>after its restart the drone uses other gains</source>
        <translation>nach ihrem Neustart verwendet die Drohne andere Verstärkungen</translation>
    </message>
    <message>
        <source>the drone has not come back after its restart; what it was given may not start, and then only a login on its computer helps</source>
        <translation>die Drohne ist nach ihrem Neustart nicht zurückgekommen; was sie bekommen hat, startet vielleicht nicht, und dann hilft nur eine Anmeldung auf ihrem Rechner</translation>
    </message>
    <message>
        <source>the drone has not restarted</source>
        <translation>die Drohne hat nicht neu gestartet</translation>
    </message>
    <message>
        <source>the drone refuses to calibrate</source>
        <translation>die Drohne verweigert die Kalibrierung</translation>
    </message>
    <message>
        <source>the drone has no camera</source>
        <translation>die Drohne hat keine Kamera</translation>
    </message>
    <message>
        <source>no camera answers</source>
        <translation>keine Kamera antwortet</translation>
    </message>
    <message>
        <source>%1: another value came back</source>
        <translation>%1: ein anderer Wert kam zurück</translation>
    </message>
    <message>
        <source>a gain is no number</source>
        <translation>eine Verstärkung ist keine Zahl</translation>
    </message>
    <message>
        <source>%1 bytes; less than %2 are allowed</source>
        <translation>%1 Bytes; erlaubt sind weniger als %2</translation>
    </message>
    <message>
        <source>the configuration text is uploaded over UDP only</source>
        <translation>der Konfigurationstext wird nur über UDP hochgeladen</translation>
    </message>
    <message>
        <source>the drone confirmed the text, and has not restarted</source>
        <translation>die Drohne hat den Text bestätigt und nicht neu gestartet</translation>
    </message>
    <message>
        <source>the drone answers, and does not take the text</source>
        <translation>die Drohne antwortet und nimmt den Text nicht an</translation>
    </message>
    <message>
        <source>the text did not arrive whole; it was not written</source>
        <translation>der Text ist nicht ganz angekommen; er wurde nicht geschrieben</translation>
    </message>
    <message>
        <source>a drone decides by itself what it streams</source>
        <translation>eine Drohne entscheidet selbst, was sie sendet</translation>
    </message>
    <message>
        <source>the battery is low: %1 V, %2 %. A drone that loses its power while its program is replaced does not start any more; charge or change the battery first</source>
        <translation>der Akku ist schwach: %1 V, %2 %. Eine Drohne, die beim Ersetzen ihres Programms den Strom verliert, startet nicht mehr; zuerst den Akku laden oder wechseln</translation>
    </message>
    <message>
        <source>firmware is uploaded over UDP only</source>
        <translation>Firmware wird nur über UDP hochgeladen</translation>
    </message>
    <message>
        <source>a piece of the firmware</source>
        <translation>ein Stück der Firmware</translation>
    </message>
    <message>
        <source>the drone did not take a piece of the firmware, and may have taken its bytes for commands; look whether it is armed</source>
        <translation>die Drohne hat ein Stück der Firmware nicht angenommen und seine Bytes vielleicht für Befehle gehalten; nachsehen, ob sie scharf ist</translation>
    </message>
    <message>
        <source>the drone runs the firmware that it had; its stream stays silent until it is restarted: switch it off and on</source>
        <translation>die Drohne läuft mit ihrer bisherigen Firmware; sie sendet nichts, bis sie neu startet: aus- und einschalten</translation>
    </message>
    <message>
        <source>nothing to send</source>
        <translation>nichts zu senden</translation>
    </message>
    <message>
        <source>%1 is not sent from here</source>
        <translation>%1 wird von hier nicht gesendet</translation>
    </message>
    <message>
        <source>there is no message &apos;%1&apos;</source>
        <translation>eine Nachricht „%1“ gibt es nicht</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>%1 fields are needed, not %2</source>
        <translation>%1 Felder sind nötig, nicht %2</translation>
    </message>
    <message>
        <source>%1: %2 is no number</source>
        <translation>%1: %2 ist keine Zahl</translation>
    </message>
    <message>
        <source>the text has no checksum</source>
        <translation>der Text hat keine Prüfsumme</translation>
    </message>
    <message>
        <source>the text of %1 bytes does not fit its checksum</source>
        <translation>der Text von %1 Bytes passt nicht zu seiner Prüfsumme</translation>
    </message>
    <message>
        <source>a black box has no streams</source>
        <translation>eine Blackbox hat keine Datenströme</translation>
    </message>
    <message>
        <source>this board has no streams; it is asked for each sample</source>
        <translation>dieses Board hat keine Datenströme; es wird nach jedem Messwert gefragt</translation>
    </message>
    <message>
        <source>say which family it is with ?family= and one of %1</source>
        <translation>mit ?family= und einem von %1 sagen, welche Familie es ist</translation>
    </message>
    <message>
        <source>%1 counts in whole steps</source>
        <translation>%1 zählt in ganzen Schritten</translation>
    </message>
    <message>
        <source>the board is tuning itself</source>
        <translation>das Board stimmt sich gerade selbst ab</translation>
    </message>
    <message>
        <source>nothing was changed live</source>
        <translation>nichts wurde live geändert</translation>
    </message>
    <message>
        <source>variable %1: %2 was written, %3 is in use</source>
        <translation>Variable %1: %2 wurde geschrieben, %3 ist in Gebrauch</translation>
    </message>
    <message>
        <source>%1 has control characters, such as a line break</source>
        <translation>%1 hat Steuerzeichen, etwa einen Zeilenumbruch</translation>
    </message>
    <message>
        <source>%1=%2 is neither on nor off</source>
        <translation>%1=%2 ist weder on noch off</translation>
    </message>
    <message>
        <source>%1=%2 is none of: %3</source>
        <translation>%1=%2 ist keines von: %3</translation>
    </message>
    <message>
        <source>%1=%2 is not a %3 from %4 to %5</source>
        <translation>%1=%2 ist keine %3 von %4 bis %5</translation>
    </message>
    <message>
        <source>whole number</source>
        <translation>ganze Zahl</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>%1=%2 may mean %3 or the number of another; give the name: %4</source>
        <translation>%1=%2 kann %3 oder die Nummer eines anderen bedeuten; den Namen angeben: %4</translation>
    </message>
    <message>
        <source>%1 has no argument &apos;%2&apos;</source>
        <translation>%1 hat kein Argument „%2“</translation>
    </message>
    <message>
        <source>this board lacks something for that step</source>
        <translation>diesem Board fehlt etwas für diesen Schritt</translation>
    </message>
    <message>
        <source>no telemetry</source>
        <translation>keine Live-Daten</translation>
    </message>
    <message>
        <source>the motors are off</source>
        <translation>die Motoren sind aus</translation>
    </message>
    <message>
        <source>motors off</source>
        <translation>Motoren aus</translation>
    </message>
    <message>
        <source>%1 V: that is no battery, only USB feeds the board. Connect the battery</source>
        <translation>%1 V: das ist kein Akku, nur USB versorgt das Board. Den Akku anschließen</translation>
    </message>
    <message>
        <source>%1 V fits no number of cells: charge the battery, or say how many it has</source>
        <translation>%1 V passt zu keiner Zellenzahl: den Akku laden oder sagen, wie viele er hat</translation>
    </message>
    <message>
        <source>%1 V fits %2 cells: say how many it has</source>
        <translation>%1 V passt zu %2 Zellen: sagen, wie viele er hat</translation>
    </message>
    <message>
        <source>%1 V at %2 cells is %3 V for each: charge the battery, or correct the number</source>
        <translation>%1 V bei %2 Zellen sind %3 V für jede: den Akku laden oder die Zahl berichtigen</translation>
    </message>
    <message>
        <source>the camera was not held level for a minute: hold it level, then begin again</source>
        <translation>die Kamera wurde eine Minute lang nicht waagerecht gehalten: waagerecht halten, dann neu beginnen</translation>
    </message>
    <message>
        <source>the camera did not move at all, so it was not let go: let go, and tip it lightly</source>
        <translation>die Kamera hat sich gar nicht bewegt, also wurde sie nicht losgelassen: loslassen und leicht antippen</translation>
    </message>
    <message>
        <source>%1 is %2° away from its target</source>
        <translation>%1 ist %2° von seinem Ziel entfernt</translation>
    </message>
    <message>
        <source>not a record of a set-up that this version reads</source>
        <translation>keine Aufzeichnung einer Einrichtung, die diese Version liest</translation>
    </message>
    <message>
        <source>the notch that was tried is still on the board</source>
        <translation>der erprobte Kerbfilter ist noch auf dem Board</translation>
    </message>
    <message>
        <source>the camera was not moved by more than some degrees: move it by hand as far as it may go</source>
        <translation>die Kamera wurde nur um wenige Grad bewegt: von Hand so weit bewegen, wie sie darf</translation>
    </message>
    <message>
        <source>%1 of %2 bytes</source>
        <translation>%1 von %2 Bytes</translation>
    </message>
    <message>
        <source>%1 bytes in %2</source>
        <translation>%1 Bytes in %2</translation>
    </message>
    <message>
        <source>%1 is %2, allowed are %3 to %4</source>
        <translation>%1 ist %2, erlaubt sind %3 bis %4</translation>
    </message>
    <message>
        <source>the board cannot be steered to an angle</source>
        <translation>das Board lässt sich nicht auf einen Winkel steuern</translation>
    </message>
    <message>
        <source>the board does not tell its targets, so the line&apos;s delay would be taken for its own; steps can be measured</source>
        <translation>das Board meldet seine Ziele nicht, darum würde die Verzögerung der Leitung für seine gehalten; Sprünge lassen sich messen</translation>
    </message>
    <message>
        <source>no telemetry of the angles</source>
        <translation>keine Live-Daten der Winkel</translation>
    </message>
    <message>
        <source>the axis is %1° away from its target</source>
        <translation>die Achse ist %1° von ihrem Ziel entfernt</translation>
    </message>
    <message>
        <source>the axis does not come to rest in its middle</source>
        <translation>die Achse kommt in ihrer Mitte nicht zur Ruhe</translation>
    </message>
    <message>
        <source>target and angle do not come in the same rows</source>
        <translation>Ziel und Winkel kommen nicht in denselben Zeilen</translation>
    </message>
    <message>
        <source>only %1 of %2 s arrived without a hole</source>
        <translation>nur %1 von %2 s sind lückenlos angekommen</translation>
    </message>
    <message>
        <source>no telemetry for %1 s</source>
        <translation>%1 s lang keine Live-Daten</translation>
    </message>
    <message>
        <source>the motors went off</source>
        <translation>die Motoren sind ausgegangen</translation>
    </message>
    <message>
        <source>%1° from the middle, %2° are allowed</source>
        <translation>%1° von der Mitte, erlaubt sind %2°</translation>
    </message>
    <message>
        <source>this board has one profile, without a name</source>
        <translation>dieses Board hat ein Profil, ohne Namen</translation>
    </message>
    <message>
        <source>profile names; the board takes all of them at once, so those that were not read would be erased: nothing was written</source>
        <translation>Profilnamen; das Board nimmt alle auf einmal, nicht gelesene würden gelöscht: nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>profile names: %1</source>
        <translation>Profilnamen: %1</translation>
    </message>
    <message>
        <source>the board sends no angular rate of this axis</source>
        <translation>das Board sendet keine Drehrate dieser Achse</translation>
    </message>
    <message>
        <source>%1 could not be read</source>
        <translation>%1 ließ sich nicht lesen</translation>
    </message>
    <message>
        <source>nothing tells %1</source>
        <translation>nichts meldet %1</translation>
    </message>
    <message>
        <source>profile %1 is in use now, and was profile %2 when the board was read</source>
        <translation>jetzt ist Profil %1 in Gebrauch, beim Lesen des Boards war es Profil %2</translation>
    </message>
    <message>
        <source>the active profile is another than before</source>
        <translation>das aktive Profil ist ein anderes als vorher</translation>
    </message>
    <message>
        <source>%1: each answer is another</source>
        <translation>%1: jede Antwort ist eine andere</translation>
    </message>
    <message>
        <source>%1 does not hold what was saved</source>
        <translation>%1 enthält nicht, was gesichert wurde</translation>
    </message>
    <message>
        <source>this board has a serial number, which names it</source>
        <translation>dieses Board hat eine Seriennummer, die es benennt</translation>
    </message>
    <message>
        <source>a board without a serial number needs a name</source>
        <translation>ein Board ohne Seriennummer braucht einen Namen</translation>
    </message>
    <message>
        <source>the recording has ended</source>
        <translation>die Aufnahme ist zu Ende</translation>
    </message>
    <message>
        <source>%1=%2 is not a number from %3 to %4</source>
        <translation>%1=%2 ist keine Zahl von %3 bis %4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not an address; one looks like 127.0.0.1:%2</source>
        <translation>„%1“ ist keine Adresse; eine sieht aus wie 127.0.0.1:%2</translation>
    </message>
    <message>
        <source>sent %1 times</source>
        <translation>%1-mal gesendet</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a whole number from %2 to %3</source>
        <translation>„%1“ ist keine ganze Zahl von %2 bis %3</translation>
    </message>
    <message>
        <source>the board does not see its motion sensor</source>
        <translation>das Board sieht seinen Bewegungssensor nicht</translation>
    </message>
    <message>
        <source>the board reports that its motors are off</source>
        <translation>das Board meldet, dass seine Motoren aus sind</translation>
    </message>
    <message>
        <source>the board reports that its motors are running</source>
        <translation>das Board meldet, dass seine Motoren laufen</translation>
    </message>
    <message>
        <source>steering in that mode</source>
        <translation>Steuern in dieser Betriebsart</translation>
    </message>
    <message>
        <source>%1=%2: in the mode &apos;%3&apos; it goes from %4 to %5%6</source>
        <translation>%1=%2: in der Betriebsart „%3“ geht es von %4 bis %5%6</translation>
    </message>
    <message>
        <source>steer needs roll=, pitch= or yaw=</source>
        <translation>steer braucht roll=, pitch= oder yaw=</translation>
    </message>
    <message>
        <source>firmware before 2.55b5 steers all axes at once and cannot leave one alone: name roll, pitch and yaw</source>
        <translation>Firmware vor 2.55b5 steuert alle Achsen zugleich und kann keine in Ruhe lassen: Roll, Pitch und Yaw nennen</translation>
    </message>
    <message>
        <source>the motors are off, so nothing would move</source>
        <translation>die Motoren sind aus, darum würde sich nichts bewegen</translation>
    </message>
    <message>
        <source>as the board tells it, neither the camera nor its target has turned</source>
        <translation>wie das Board es meldet, haben sich weder die Kamera noch ihr Ziel gedreht</translation>
    </message>
    <message>
        <source>control was given back before the camera was there, %1</source>
        <translation>die Steuerung wurde zurückgegeben, bevor die Kamera dort war, %1</translation>
    </message>
    <message>
        <source>the camera did not get where it was steered to, %1</source>
        <translation>die Kamera kam nicht dahin, wohin sie gesteuert wurde, %1</translation>
    </message>
    <message>
        <source>the limits of the sticks may hold it back, which limited=off lifts</source>
        <translation>vielleicht halten sie die Grenzen der Steuerknüppel zurück, die limited=off aufhebt</translation>
    </message>
    <message>
        <source>a melody has at most %1 notes</source>
        <translation>eine Melodie hat höchstens %1 Töne</translation>
    </message>
    <message>
        <source>variable %1 was not told</source>
        <translation>Variable %1 wurde nicht gemeldet</translation>
    </message>
    <message>
        <source>%1: whether the values in use are stored now shows only when the board has restarted</source>
        <translation>%1: ob die Werte in Gebrauch jetzt gespeichert sind, zeigt sich erst nach einem Neustart des Boards</translation>
    </message>
    <message>
        <source>the board has no frame sensor that works</source>
        <translation>das Board hat keinen Rahmensensor, der arbeitet</translation>
    </message>
    <message>
        <source>the board goes on with its frame sensor</source>
        <translation>das Board macht mit seinem Rahmensensor weiter</translation>
    </message>
    <message>
        <source>no function of this profile has a signal</source>
        <translation>keine Funktion dieses Profils hat ein Signal</translation>
    </message>
    <message>
        <source>the board tells that the slot is %1</source>
        <translation>das Board meldet, dass der Platz %1 ist</translation>
    </message>
    <message>
        <source>still in use</source>
        <translation>noch in Gebrauch</translation>
    </message>
    <message>
        <source>data needs up to %1 bytes in hex</source>
        <translation>data braucht bis zu %1 Bytes in Hex</translation>
    </message>
    <message>
        <source>the board holds other data</source>
        <translation>das Board hat andere Daten</translation>
    </message>
    <message>
        <source>READ_FILE at page %1</source>
        <translation>READ_FILE auf Seite %1</translation>
    </message>
    <message>
        <source>the board holds another file</source>
        <translation>das Board hat eine andere Datei</translation>
    </message>
    <message>
        <source>the board still has the file</source>
        <translation>das Board hat die Datei noch</translation>
    </message>
    <message>
        <source>no slot has a signal</source>
        <translation>kein Platz hat ein Signal</translation>
    </message>
    <message>
        <source>the board shows its other sensor, so nobody would see what the calibration does: imu.select imu=%1 first</source>
        <translation>das Board zeigt seinen anderen Sensor, darum sähe niemand, was die Kalibrierung bewirkt: zuerst imu.select imu=%1</translation>
    </message>
    <message>
        <source>the sensor does not lie level and the motors are running; six=on switches them off</source>
        <translation>der Sensor liegt nicht waagerecht, und die Motoren laufen; six=on schaltet sie aus</translation>
    </message>
    <message>
        <source>%1: it was not confirmed, and motors that were off run now</source>
        <translation>%1: es wurde nicht bestätigt, und Motoren, die aus waren, laufen jetzt</translation>
    </message>
    <message>
        <source>%1: the end was not confirmed</source>
        <translation>%1: das Ende wurde nicht bestätigt</translation>
    </message>
    <message>
        <source>%1: neither start nor end was confirmed; nobody can tell whether the board calibrated</source>
        <translation>%1: weder Beginn noch Ende wurde bestätigt; niemand weiß, ob das Board kalibriert hat</translation>
    </message>
    <message>
        <source>the sensor moves (%1 °/s): let it lie still</source>
        <translation>der Sensor bewegt sich (%1 °/s): still liegen lassen</translation>
    </message>
    <message>
        <source>the sensor measures %1 g instead of 1 g, which none at rest does: something moves it, it is defective, or an earlier calibration is wrong, which action=reset-all removes</source>
        <translation>der Sensor misst %1 g statt 1 g, was keiner in Ruhe tut: etwas bewegt ihn, er ist defekt, oder eine frühere Kalibrierung ist falsch, die action=reset-all entfernt</translation>
    </message>
    <message>
        <source>the gyroscope shows %1 °/s at rest, and showed %2 °/s before</source>
        <translation>das Gyroskop zeigt in Ruhe %1 °/s, vorher %2 °/s</translation>
    </message>
    <message>
        <source>the accelerometer is off by %1 g, and was by %2 g before</source>
        <translation>der Beschleunigungssensor liegt um %1 g daneben, vorher um %2 g</translation>
    </message>
    <message>
        <source>the board repeats the same figures: they are not measured</source>
        <translation>das Board wiederholt dieselben Zahlen: sie sind nicht gemessen</translation>
    </message>
    <message>
        <source>it measures %1 V</source>
        <translation>es misst %1 V</translation>
    </message>
    <message>
        <source>AUTO_PID: it searches on</source>
        <translation>AUTO_PID: es sucht weiter</translation>
    </message>
    <message>
        <source>no axis to tune</source>
        <translation>keine Achse zum Abstimmen</translation>
    </message>
    <message>
        <source>AUTO_PID: the board says that the search has ended, with %1=%2, and still uses %3</source>
        <translation>AUTO_PID: das Board meldet die Suche als beendet, mit %1=%2, und verwendet noch %3</translation>
    </message>
    <message>
        <source>the board was told to stop searching, and reports no search any more</source>
        <translation>dem Board wurde befohlen, die Suche zu beenden, und es meldet keine mehr</translation>
    </message>
    <message>
        <source>the board may be searching; it was told to stop, without proof (%1): switch the motors off</source>
        <translation>das Board sucht vielleicht noch; ihm wurde befohlen aufzuhören, ohne Beleg (%1): die Motoren ausschalten</translation>
    </message>
    <message>
        <source>the gains from before could not be put back (%1)</source>
        <translation>die Verstärkungen von vorher ließen sich nicht wiederherstellen (%1)</translation>
    </message>
    <message>
        <source>the search has ended; which gains are in use could not be read</source>
        <translation>die Suche ist beendet; welche Verstärkungen in Gebrauch sind, ließ sich nicht lesen</translation>
    </message>
    <message>
        <source>%1 with %2 bytes</source>
        <translation>%1 mit %2 Bytes</translation>
    </message>
    <message>
        <source>profile %1 was to be used, profile %2 is</source>
        <translation>Profil %1 sollte verwendet werden, Profil %2 wird es</translation>
    </message>
    <message>
        <source>data needs 1 to %1 bytes in hex</source>
        <translation>data braucht 1 bis %1 Bytes in Hex</translation>
    </message>
    <message>
        <source>this is the memory with the board&apos;s calibrations and its licence; memory.restore writes it with a copy, and compares</source>
        <translation>dies ist der Speicher mit den Kalibrierungen und der Lizenz des Boards; memory.restore schreibt ihn mit Kopie und vergleicht</translation>
    </message>
    <message>
        <source>the board goes on as before</source>
        <translation>das Board macht weiter wie vorher</translation>
    </message>
    <message>
        <source>mode asks for an attitude and sets none</source>
        <translation>mode verlangt eine Lage und setzt keine</translation>
    </message>
    <message>
        <source>stopped at command %1</source>
        <translation>angehalten bei Befehl %1</translation>
    </message>
    <message>
        <source>after %1 come payload bytes in hex%2</source>
        <translation>nach %1 kommen Nutzbytes in Hex%2</translation>
    </message>
    <message>
        <source>these bytes are not one complete frame with valid checksums</source>
        <translation>diese Bytes sind kein vollständiger Rahmen mit gültigen Prüfsummen</translation>
    </message>
    <message>
        <source>there is no command &apos;%1&apos;</source>
        <translation>einen Befehl „%1“ gibt es nicht</translation>
    </message>
    <message>
        <source>%1 is what the board sends</source>
        <translation>%1 ist etwas, das das Board sendet</translation>
    </message>
    <message>
        <source>%1 payload bytes, a frame holds 255</source>
        <translation>%1 Nutzbytes, in einen Rahmen passen 255</translation>
    </message>
    <message>
        <source>the board does not tell the size of its memory</source>
        <translation>das Board meldet die Größe seines Speichers nicht</translation>
    </message>
    <message>
        <source>it was read from firmware %1, and nobody tells where %2 keeps what</source>
        <translation>er wurde von Firmware %1 gelesen, und niemand sagt, wo %2 was ablegt</translation>
    </message>
    <message>
        <source>from address %1 on the board holds other bytes than were written</source>
        <translation>ab Adresse %1 hat das Board andere Bytes als die geschriebenen</translation>
    </message>
    <message>
        <source>%1 holds %2 bytes, the board&apos;s memory has %3</source>
        <translation>%1 hat %2 Bytes, der Speicher des Boards hat %3</translation>
    </message>
    <message>
        <source>%1 bytes were written before; the same again goes on from there</source>
        <translation>%1 Bytes wurden vorher geschrieben; derselbe Aufruf macht dort weiter</translation>
    </message>
    <message>
        <source>%1 has room for %2 bytes</source>
        <translation>%1 hat Platz für %2 Bytes</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not name=value; the fields are %2</source>
        <translation>„%1“ ist nicht Name=Wert; die Felder sind %2</translation>
    </message>
    <message>
        <source>%1 is given twice</source>
        <translation>%1 ist zweimal angegeben</translation>
    </message>
    <message>
        <source>%1: %2 is not within 0 .. %3</source>
        <translation>%1: %2 liegt nicht zwischen 0 und %3</translation>
    </message>
    <message>
        <source>%1: the length of a rotation is 1, not %2</source>
        <translation>%1: die Länge einer Drehung ist 1, nicht %2</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; here; the fields are %2</source>
        <translation>ein Feld „%1“ gibt es hier nicht; die Felder sind %2</translation>
    </message>
    <message>
        <source>a frame holds %1 payload bytes</source>
        <translation>in einen Rahmen passen %1 Nutzbytes</translation>
    </message>
    <message>
        <source>debug variable %1 has the unknown type %2</source>
        <translation>Debugvariable %1 hat den unbekannten Typ %2</translation>
    </message>
    <message>
        <source>%1: nothing has changed, and the board was not seen to calibrate</source>
        <translation>%1: nichts hat sich geändert, und das Board hat nicht sichtbar kalibriert</translation>
    </message>
    <message>
        <source>%1: nothing has changed, and the end was not confirmed</source>
        <translation>%1: nichts hat sich geändert, und das Ende wurde nicht bestätigt</translation>
    </message>
    <message>
        <source>this firmware turns the motors by %1 at a speed of its own</source>
        <translation>diese Firmware dreht die Motoren um %1 mit eigener Geschwindigkeit</translation>
    </message>
    <message>
        <source>an angle and</source>
        <translation>einen eigenen Winkel und</translation>
    </message>
    <message>
        <source>this angle</source>
        <translation>diesen Winkel</translation>
    </message>
    <message>
        <source>this firmware takes the position of all motors at once</source>
        <translation>diese Firmware nimmt die Stellung aller Motoren auf einmal</translation>
    </message>
    <message>
        <source>the motor of %1 stands at %2°, as before</source>
        <translation>der Motor von %1 steht auf %2°, wie vorher</translation>
    </message>
    <message>
        <source>fc.map.roll and fc.map.pitch name no input that carries a flight controller&apos;s signal</source>
        <translation>fc.map.roll und fc.map.pitch nennen keinen Eingang mit dem Signal eines Flugreglers</translation>
    </message>
    <message>
        <source>the magnetometer repeats the same figures: they are not measured</source>
        <translation>das Magnetometer wiederholt dieselben Zahlen: sie sind nicht gemessen</translation>
    </message>
    <message>
        <source>the heading is off by %1°, and was off by %2° before</source>
        <translation>der Kurs liegt um %1° daneben, vorher um %2°</translation>
    </message>
    <message>
        <source>it had begun on the board</source>
        <translation>es hatte auf dem Board begonnen</translation>
    </message>
    <message>
        <source>it had begun; what is stored now could not be read</source>
        <translation>es hatte begonnen; was jetzt gespeichert ist, ließ sich nicht lesen</translation>
    </message>
    <message>
        <source>it had begun; what is stored is as before</source>
        <translation>es hatte begonnen; gespeichert ist dasselbe wie vorher</translation>
    </message>
    <message>
        <source>it had begun, and what is stored has changed</source>
        <translation>es hatte begonnen, und das Gespeicherte hat sich geändert</translation>
    </message>
    <message>
        <source>no stream %1</source>
        <translation>kein Datenstrom %1</translation>
    </message>
    <message>
        <source>%1 samples/s, 0 to %2 are possible</source>
        <translation>%1 Messwerte/s, möglich sind 0 bis %2</translation>
    </message>
    <message>
        <source>%1 without a channel that the board can send</source>
        <translation>%1 ohne einen Kanal, den das Board senden kann</translation>
    </message>
    <message>
        <source>%1 of %2 bytes, %3 fit into a frame</source>
        <translation>%1 von %2 Bytes, in einen Rahmen passen %3</translation>
    </message>
    <message>
        <source>this firmware has no streams; it is asked for each sample</source>
        <translation>diese Firmware hat keine Datenströme; sie wird nach jedem Messwert gefragt</translation>
    </message>
    <message>
        <source>%1=%2, allowed %3 to %4 µs, or 0 for the middle</source>
        <translation>%1=%2, erlaubt sind %3 bis %4 µs, oder 0 für die Mitte</translation>
    </message>
    <message>
        <source>sticks needs pitch=, roll= or yaw=</source>
        <translation>sticks braucht pitch=, roll= oder yaw=</translation>
    </message>
    <message>
        <source>%1 is off, so script %2 never runs; choose an input for it first</source>
        <translation>%1 ist aus, darum läuft Skript %2 nie; zuerst einen Eingang dafür wählen</translation>
    </message>
    <message>
        <source>a name has up to 16 letters, not %1</source>
        <translation>ein Name hat bis zu 16 Buchstaben, nicht %1</translation>
    </message>
    <message>
        <source>the board has no letter “%1” for its name</source>
        <translation>das Board hat für seinen Namen keinen Buchstaben „%1“</translation>
    </message>
    <message>
        <source>the board calls itself %1, not %2</source>
        <translation>das Board nennt sich %1, nicht %2</translation>
    </message>
    <message>
        <source>the board has not answered since it was told to restart</source>
        <translation>das Board antwortet nicht, seit ihm der Neustart befohlen wurde</translation>
    </message>
    <message>
        <source>the board has not restarted; its state is “%1”</source>
        <translation>das Board hat nicht neu gestartet; sein Zustand ist „%1“</translation>
    </message>
    <message>
        <source>nothing has changed, and these are no defaults: %1</source>
        <translation>nichts hat sich geändert, und dies sind keine Vorgaben: %1</translation>
    </message>
    <message>
        <source>still on auto: %1</source>
        <translation>noch auf Automatik: %1</translation>
    </message>
    <message>
        <source>word=%1, allowed 0 to %2</source>
        <translation>word=%1, erlaubt sind 0 bis %2</translation>
    </message>
    <message>
        <source>there is no sensor Imu%1</source>
        <translation>einen Sensor Imu%1 gibt es nicht</translation>
    </message>
    <message>
        <source>no further face lay still for %1 s</source>
        <translation>keine weitere Seite lag %1 s lang still</translation>
    </message>
    <message>
        <source>no sensor is like that: zeros %1 %2 %3, scales %4 %5 %6</source>
        <translation>so ist kein Sensor: Nullpunkte %1 %2 %3, Maßstäbe %4 %5 %6</translation>
    </message>
    <message>
        <source>%1 was written, %2 read</source>
        <translation>%1 wurde geschrieben, %2 gelesen</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: the board does not know this command</source>
        <translation>„%1“: das Board kennt diesen Befehl nicht</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: the command arrived in pieces</source>
        <translation>„%1“: der Befehl kam in Stücken an</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: the command arrived damaged</source>
        <translation>„%1“: der Befehl kam beschädigt an</translation>
    </message>
    <message>
        <source>%1: the command arrived in pieces</source>
        <translation>%1: der Befehl kam in Stücken an</translation>
    </message>
    <message>
        <source>%1: the board does not know this command</source>
        <translation>%1: das Board kennt diesen Befehl nicht</translation>
    </message>
    <message>
        <source>%1: access denied</source>
        <translation>%1: Zugriff verweigert</translation>
    </message>
    <message>
        <source>%1: this firmware does not know it</source>
        <translation>%1: diese Firmware kennt es nicht</translation>
    </message>
    <message>
        <source>%1: the command arrived damaged</source>
        <translation>%1: der Befehl kam beschädigt an</translation>
    </message>
    <message>
        <source>%1: wrong length</source>
        <translation>%1: falsche Länge</translation>
    </message>
    <message>
        <source>%1: value out of range</source>
        <translation>%1: Wert außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>another parameter than %1</source>
        <translation>ein anderer Parameter als %1</translation>
    </message>
    <message>
        <source>word %1: %2 was written, %3 read</source>
        <translation>Wort %1: %2 wurde geschrieben, %3 gelesen</translation>
    </message>
    <message>
        <source>scripts cannot be written while the heartbeat is on</source>
        <translation>Skripte lassen sich nicht schreiben, solange der Herzschlag eingeschaltet ist</translation>
    </message>
    <message>
        <source>only parameters with names can be saved in this file</source>
        <translation>in dieser Datei lassen sich nur Parameter mit Namen sichern</translation>
    </message>
    <message>
        <source>this board has no parameter %1, its last is %2; it would confirm the command and do nothing</source>
        <translation>dieses Board hat keinen Parameter %1, sein letzter ist %2; es würde den Befehl bestätigen und nichts tun</translation>
    </message>
    <message>
        <source>a name that this board does not know would set its first parameter, and its names are not known for certain: use PARAM_SET2 with the number</source>
        <translation>ein Name, den dieses Board nicht kennt, würde seinen ersten Parameter setzen, und seine Namen sind nicht sicher bekannt: PARAM_SET2 mit der Nummer verwenden</translation>
    </message>
    <message>
        <source>this board has no parameter &apos;%1&apos; and would set its first one</source>
        <translation>dieses Board hat keinen Parameter „%1“ und würde seinen ersten setzen</translation>
    </message>
    <message>
        <source>this board has no parameter %1 and would set its first one</source>
        <translation>dieses Board hat keinen Parameter %1 und würde seinen ersten setzen</translation>
    </message>
    <message>
        <source>after %1 come %2 bytes in hex</source>
        <translation>nach %1 kommen %2 Bytes in Hex</translation>
    </message>
    <message>
        <source>no live value %1</source>
        <translation>kein Live-Wert %1</translation>
    </message>
    <message>
        <source>the board is starting, with motors disabled; what is stored can be read once it works normally</source>
        <translation>das Board startet, mit abgeschalteten Motoren; was gespeichert ist, lässt sich lesen, sobald es normal arbeitet</translation>
    </message>
    <message>
        <source>the board does not go into standby</source>
        <translation>das Board geht nicht in Bereitschaft</translation>
    </message>
    <message>
        <source>the board answers no plain commands</source>
        <translation>das Board antwortet auf keine einfachen Befehle</translation>
    </message>
    <message>
        <source>the board confirms that it loads what is stored, and what was in use stays</source>
        <translation>das Board bestätigt, dass es das Gespeicherte lädt, und was in Gebrauch war, bleibt</translation>
    </message>
    <message>
        <source>the board is in standby</source>
        <translation>das Board ist in Bereitschaft</translation>
    </message>
    <message>
        <source>the board stays in standby</source>
        <translation>das Board bleibt in Bereitschaft</translation>
    </message>
    <message>
        <source>the board&apos;s memory is not known</source>
        <translation>der Speicher des Boards ist nicht bekannt</translation>
    </message>
    <message>
        <source>what is stored cannot be read while the heartbeat is on</source>
        <translation>was gespeichert ist, lässt sich nicht lesen, solange der Herzschlag eingeschaltet ist</translation>
    </message>
    <message>
        <source>%1 is %2 in use and %3 where it is stored</source>
        <translation>%1 ist in Gebrauch %2 und gespeichert %3</translation>
    </message>
    <message>
        <source>the board is starting; all motors can be stored as disabled once it works normally</source>
        <translation>das Board startet; alle Motoren lassen sich als abgeschaltet speichern, sobald es normal arbeitet</translation>
    </message>
    <message>
        <source>the sensor Imu%1 was lost</source>
        <translation>der Sensor Imu%1 ging verloren</translation>
    </message>
    <message>
        <source>the camera was not tilted 45° down, without roll, for one second</source>
        <translation>die Kamera wurde nicht eine Sekunde lang um 45° nach unten geneigt, ohne Roll</translation>
    </message>
    <message>
        <source>no axis of the sensor pointed up for one second</source>
        <translation>keine Achse des Sensors zeigte eine Sekunde lang nach oben</translation>
    </message>
    <message>
        <source>there is no sensor</source>
        <translation>es gibt keinen Sensor</translation>
    </message>
    <message>
        <source>%1 errors on the sensor&apos;s bus: check its cable</source>
        <translation>%1 Fehler auf dem Bus des Sensors: sein Kabel prüfen</translation>
    </message>
    <message>
        <source>the motors are running; setup.motors_off disables them first</source>
        <translation>die Motoren laufen; zuerst schaltet setup.motors_off sie ab</translation>
    </message>
    <message>
        <source>these directions do not belong to a sensor</source>
        <translation>diese Richtungen gehören zu keinem Sensor</translation>
    </message>
    <message>
        <source>the battery is low</source>
        <translation>der Akku ist schwach</translation>
    </message>
    <message>
        <source>no battery was connected</source>
        <translation>kein Akku wurde angeschlossen</translation>
    </message>
    <message>
        <source>the board could not level: hold the camera still</source>
        <translation>das Board konnte sich nicht ausrichten: die Kamera still halten</translation>
    </message>
    <message>
        <source>the sensor was lost</source>
        <translation>der Sensor ging verloren</translation>
    </message>
    <message>
        <source>%1 errors on the sensor&apos;s bus</source>
        <translation>%1 Fehler auf dem Bus des Sensors</translation>
    </message>
    <message>
        <source>what was set up before the restart</source>
        <translation>was vor dem Neustart eingerichtet wurde</translation>
    </message>
    <message>
        <source>the board works normally, but has not restarted</source>
        <translation>das Board arbeitet normal, hat aber nicht neu gestartet</translation>
    </message>
    <message>
        <source>the board did not reach normal working</source>
        <translation>das Board kam nicht zum normalen Arbeiten</translation>
    </message>
    <message>
        <source>the direction of %1 is still on auto</source>
        <translation>die Richtung von %1 steht noch auf Automatik</translation>
    </message>
    <message>
        <source>magnets come in pairs: %1 is odd</source>
        <translation>Magnete gibt es paarweise: %1 ist ungerade</translation>
    </message>
    <message>
        <source>begin to align yaw first</source>
        <translation>zuerst mit dem Ausrichten von Yaw beginnen</translation>
    </message>
    <message>
        <source>the board is not in standby yet</source>
        <translation>das Board ist noch nicht in Bereitschaft</translation>
    </message>
    <message>
        <source>every motor is disabled: %1</source>
        <translation>jeder Motor ist abgeschaltet: %1</translation>
    </message>
    <message>
        <source>the board is starting; its motors start by themselves then</source>
        <translation>das Board startet; seine Motoren starten dann von selbst</translation>
    </message>
    <message>
        <source>no motor became active, though none is disabled</source>
        <translation>kein Motor wurde aktiv, obwohl keiner abgeschaltet ist</translation>
    </message>
    <message>
        <source>no motor became active; disabled are %1</source>
        <translation>kein Motor wurde aktiv; abgeschaltet sind %1</translation>
    </message>
    <message>
        <source>the motors are disabled in volatile memory; in use before: %1. Restart the board, or set these again, to use the motors, and store nothing before</source>
        <translation>die Motoren sind im flüchtigen Speicher abgeschaltet; vorher in Gebrauch: %1. Das Board neu starten oder diese wieder setzen, um die Motoren zu benutzen, und vorher nichts speichern</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a stream; one looks like realtime4@100</source>
        <translation>„%1“ ist kein Datenstrom; einer sieht aus wie realtime4@100</translation>
    </message>
    <message>
        <source>no samples in this span of time</source>
        <translation>keine Messwerte in dieser Zeitspanne</translation>
    </message>
    <message>
        <source>too few samples to tell their rate</source>
        <translation>zu wenige Messwerte, um ihre Rate zu nennen</translation>
    </message>
    <message>
        <source>the option &apos;%1&apos; has no value</source>
        <translation>die Option „%1“ hat keinen Wert</translation>
    </message>
    <message>
        <source>baud=%1 is not a rate between 300 and 4000000</source>
        <translation>baud=%1 ist keine Rate zwischen 300 und 4000000</translation>
    </message>
    <message>
        <source>parity=%1 is neither none nor even</source>
        <translation>parity=%1 ist weder none noch even</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not %2://host:port</source>
        <translation>„%1“ ist nicht %2://host:port</translation>
    </message>
    <message>
        <source>an address of video is HOST:PORT, not &apos;%1&apos;</source>
        <translation>eine Videoadresse ist HOST:PORT, nicht „%1“</translation>
    </message>
    <message>
        <source>a port is 1 to 65535, not %1</source>
        <translation>ein Port ist 1 bis 65535, nicht %1</translation>
    </message>
    <message>
        <source>the host of the video is missing</source>
        <translation>der Rechner des Videos fehlt</translation>
    </message>
    <message>
        <source>the video module is missing or does not fit this program: %1</source>
        <translation>das Videomodul fehlt oder passt nicht zu diesem Programm: %1</translation>
    </message>
    <message>
        <source>no video is received</source>
        <translation>kein Video wird empfangen</translation>
    </message>
    <message>
        <source>a recording runs</source>
        <translation>eine Aufnahme läuft</translation>
    </message>
    <message>
        <source>the size of the pictures has changed</source>
        <translation>die Größe der Bilder hat sich geändert</translation>
    </message>
    <message>
        <source>the motors may run, or start yet</source>
        <translation>die Motoren laufen vielleicht oder starten noch</translation>
    </message>
    <message>
        <source>the board may have carried it out: the camera may be moving</source>
        <translation>das Board hat es vielleicht ausgeführt: die Kamera bewegt sich vielleicht</translation>
    </message>
    <message>
        <source>what was in use before is not in use again: %1</source>
        <translation>was vorher in Gebrauch war, ist nicht wieder in Gebrauch: %1</translation>
    </message>
    <message>
        <source>libav has no decoder for this video</source>
        <translation>libav hat keinen Decoder für dieses Video</translation>
    </message>
    <message>
        <source>a picture of another size</source>
        <translation>ein Bild anderer Größe</translation>
    </message>
    <message>
        <source>libav has no encoder for H.264 or JPEG</source>
        <translation>libav hat keinen Encoder für H.264 oder JPEG</translation>
    </message>
    <message>
        <source>no measurement</source>
        <translation>keine Messung</translation>
    </message>
    <message>
        <source>at no frequency does the axis follow the target clearly enough to tell</source>
        <translation>bei keiner Frequenz folgt die Achse dem Ziel deutlich genug</translation>
    </message>
    <message>
        <source>another board</source>
        <translation>ein anderes Board</translation>
    </message>
    <message>
        <source>this board has no command that switches its motors on</source>
        <translation>dieses Board hat keinen Befehl, der seine Motoren einschaltet</translation>
    </message>
    <message>
        <source>disconnect first</source>
        <translation>zuerst trennen</translation>
    </message>
    <message>
        <source>this board has one profile</source>
        <translation>dieses Board hat ein Profil</translation>
    </message>
    <message>
        <source>%1 bytes: %2</source>
        <translation>%1 Bytes: %2</translation>
    </message>
    <message>
        <source>for %1 add ?family=%2 to the address</source>
        <translation>für %1 ?family=%2 an die Adresse anhängen</translation>
    </message>
    <message>
        <source>the port %1 disappeared</source>
        <translation>der Anschluss %1 ist verschwunden</translation>
    </message>
    <message>
        <source>%1 = %2, allowed %3</source>
        <translation>%1 = %2, erlaubt ist %3</translation>
    </message>
    <message>
        <source>%1 = %2, allowed %3..%4</source>
        <translation>%1 = %2, erlaubt ist %3..%4</translation>
    </message>
    <message>
        <source>the board is armed</source>
        <translation>das Board ist scharf</translation>
    </message>
    <message>
        <source>the sensors are not calibrated</source>
        <translation>die Sensoren sind nicht kalibriert</translation>
    </message>
    <message>
        <source>the motors are running</source>
        <translation>die Motoren laufen</translation>
    </message>
    <message>
        <source>whether the board is armed</source>
        <translation>ob das Board scharf ist</translation>
    </message>
    <message>
        <source>whether the sensors are calibrated</source>
        <translation>ob die Sensoren kalibriert sind</translation>
    </message>
    <message>
        <source>whether the motors are running</source>
        <translation>ob die Motoren laufen</translation>
    </message>
    <message>
        <source>%1 needs %2=...</source>
        <translation>%1 braucht %2=...</translation>
    </message>
    <message>
        <source>there is no %1</source>
        <translation>%1 gibt es nicht</translation>
    </message>
    <message>
        <source>%1; tried: %2</source>
        <translation>%1; versucht: %2</translation>
    </message>
    <message>
        <source>the transmitter has %1 steps of power</source>
        <translation>der Sender hat %1 Leistungsstufen</translation>
    </message>
    <message>
        <source>motors are turned over UDP only</source>
        <translation>Motoren werden nur über UDP gedreht</translation>
    </message>
    <message>
        <source>no answer came; whether the camera has switched is not known</source>
        <translation>keine Antwort kam; ob die Kamera umgeschaltet hat, ist nicht bekannt</translation>
    </message>
    <message>
        <source>the scale of a gain in the text is %1, which gives no number</source>
        <translation>der Faktor einer Verstärkung im Text ist %1, was keine Zahl ergibt</translation>
    </message>
    <message>
        <source>the camera was not held as asked for a minute, or its sensor sits at no right angle to it</source>
        <translation>die Kamera wurde eine Minute lang nicht wie verlangt gehalten, oder ihr Sensor sitzt nicht rechtwinklig zu ihr</translation>
    </message>
    <message>
        <source>one of the two tilts went the other way: the right side down, seen from behind the camera, then its nose</source>
        <translation>eine der beiden Neigungen ging in die andere Richtung: erst die rechte Seite nach unten, von hinter der Kamera gesehen, dann ihre Nase</translation>
    </message>
    <message>
        <source>the board&apos;s angles do not follow the camera</source>
        <translation>die Winkel des Boards folgen der Kamera nicht</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not an address; use serial:/dev/ttyUSB0, tcp://host:port, udp://host[:port], sim:simplebgc or replay:FILE</source>
        <translation>„%1“ ist keine Adresse; möglich sind serial:/dev/ttyUSB0, tcp://host:port, udp://host[:port], sim:simplebgc oder replay:DATEI</translation>
    </message>
    <message>
        <source>%1 is not sent from here: %2</source>
        <translation>%1 wird von hier nicht gesendet: %2</translation>
    </message>
    <message>
        <source>nobody uses it</source>
        <translation>niemand verwendet es</translation>
    </message>
    <message>
        <source>it moves the drone whether or not it is armed</source>
        <translation>es bewegt die Drohne, ob sie scharf ist oder nicht</translation>
    </message>
    <message>
        <source>these bytes are not one whole message</source>
        <translation>diese Bytes sind nicht eine ganze Nachricht</translation>
    </message>
    <message>
        <source>no input has a signal: switch the transmitter on, and see that its receiver is connected and of the kind that is set</source>
        <translation>kein Eingang hat ein Signal: den Sender einschalten, und prüfen, ob sein Empfänger angeschlossen und von der Art ist, die eingestellt ist</translation>
    </message>
    <message>
        <source>no input alone moved clearly for a minute: the transmitter is off, its receiver is not connected, or the board does not look at that input</source>
        <translation>eine Minute lang hat sich kein einzelner Eingang deutlich bewegt: der Sender ist aus, sein Empfänger ist nicht angeschlossen, oder das Board achtet nicht auf diesen Eingang</translation>
    </message>
    <message>
        <source>the motors were switched on meanwhile, as a stick or a switch can command: they are stopped</source>
        <translation>die Motoren wurden inzwischen eingeschaltet, wie es ein Knüppel oder Schalter befehlen kann: sie sind gestoppt</translation>
    </message>
    <message>
        <source>every stick is left out: choose one at least</source>
        <translation>alle Knüppel sind ausgelassen: mindestens einen wählen</translation>
    </message>
    <message>
        <source>the board&apos;s own signal of %1 does not follow the stick</source>
        <translation>das eigene Signal des Boards für %1 folgt dem Knüppel nicht</translation>
    </message>
    <message>
        <source>the board does not tell the power of its motors</source>
        <translation>das Board meldet die Leistung seiner Motoren nicht</translation>
    </message>
    <message>
        <source>%1 is not held with any power that its motor can bear: balance the camera, and see whether a cable pulls at it</source>
        <translation>%1 wird mit keiner Leistung gehalten, die ihr Motor verträgt: balancieren Sie die Kamera aus, und sehen Sie nach, ob ein Kabel an ihr zieht</translation>
    </message>
    <message>
        <source>%1 is not held with the power that was found for it</source>
        <translation>%1 wird mit der Leistung nicht gehalten, die für sie gefunden wurde</translation>
    </message>
    <message>
        <source>it turns with %1°/s</source>
        <translation>sie dreht sich mit %1°/s</translation>
    </message>
    <message>
        <source>%1 is not reached that way</source>
        <translation>%1 ist so nicht zu erreichen</translation>
    </message>
    <message>
        <source>no axis has a motor output: set them first</source>
        <translation>keine Achse hat einen Motorausgang: zuerst die Ausgänge setzen</translation>
    </message>
    <message>
        <source>the motor of %1 does not turn the camera: see whether it is connected, and nothing is in its way</source>
        <translation>der Motor von %1 dreht die Kamera nicht: prüfen, ob er angeschlossen und nichts im Weg ist</translation>
    </message>
    <message>
        <source>this is the memory of another board (%1, firmware %2), with its calibrations and its licence; part=settings takes its settings alone, other=on all of it</source>
        <translation>das ist der Speicher eines anderen Boards (%1, Firmware %2), mit dessen Kalibrierungen und Lizenz; part=settings nimmt nur die Einstellungen, other=on alles</translation>
    </message>
    <message>
        <source>this board has no number, so nobody can tell whether the calibrations and the licence in the copy are its own; part=settings takes the settings alone, other=on all of it</source>
        <translation>dieses Board hat keine Nummer, also kann niemand sagen, ob Kalibrierungen und Lizenz in der Kopie seine eigenen sind; part=settings nimmt nur die Einstellungen, other=on alles</translation>
    </message>
    <message>
        <source>the board keeps no files</source>
        <translation>das Board hat keine Dateien</translation>
    </message>
    <message>
        <source>%1 bytes were read before; the same again goes on from there</source>
        <translation>%1 Byte waren schon gelesen; derselbe Auftrag noch einmal macht dort weiter</translation>
    </message>
    <message>
        <source>each time it is read, the memory holds something else</source>
        <translation>bei jedem Lesen enthält der Speicher etwas anderes</translation>
    </message>
    <message>
        <source>%1: %2 files were changed before; the same again goes on from there</source>
        <translation>%1: %2 Dateien waren schon geändert; derselbe Auftrag noch einmal macht dort weiter</translation>
    </message>
    <message>
        <source>%1: the board holds another file (%2)</source>
        <translation>%1: das Board enthält eine andere Datei (%2)</translation>
    </message>
    <message>
        <source>none of the board&apos;s settings was found in its memory</source>
        <translation>keine der Einstellungen des Boards wurde in seinem Speicher gefunden</translation>
    </message>
    <message>
        <source>%1 is there already: the copy that is made before needs a file of its own</source>
        <translation>%1 gibt es schon: die Kopie, die vorher gemacht wird, braucht eine eigene Datei</translation>
    </message>
    <message>
        <source>the board tells nothing of its calibrations</source>
        <translation>das Board sagt nichts von seinen Kalibrierungen</translation>
    </message>
    <message>
        <source>there is no calibration in this file</source>
        <translation>in dieser Datei ist keine Kalibrierung</translation>
    </message>
    <message>
        <source>the board has not told yet whether its motors run</source>
        <translation>das Board hat noch nicht gemeldet, ob seine Motoren laufen</translation>
    </message>
    <message>
        <source>no axis is chosen</source>
        <translation>keine Achse ist gewählt</translation>
    </message>
    <message>
        <source>the camera is %1° away from the attitude that it was steered to</source>
        <translation>die Kamera ist %1° von der Lage entfernt, in die sie gesteuert wurde</translation>
    </message>
    <message>
        <source>what came out has nothing to do with what went in: the stimulus is too weak</source>
        <translation>was herauskam, hat mit dem, was hineinging, nichts zu tun: die Anregung ist zu schwach</translation>
    </message>
    <message>
        <source>the board was told to stop shaking the axis, without proof: switch the motors off</source>
        <translation>dem Board wurde gesagt, die Achse nicht mehr zu rütteln, ohne Beweis: Motoren ausschalten</translation>
    </message>
    <message>
        <source>the highest frequency has to be above the lowest</source>
        <translation>die höchste Frequenz muss über der niedrigsten liegen</translation>
    </message>
    <message>
        <source>%1 of the frames with samples were lost</source>
        <translation>%1 der Rahmen mit Messwerten gingen verloren</translation>
    </message>
    <message>
        <source>a sensor at rest measures 1 g in all, and the reference has %1 g</source>
        <translation>ein ruhender Sensor misst insgesamt 1 g, und die Vorgabe hat %1 g</translation>
    </message>
    <message>
        <source>the sensor does not stand still</source>
        <translation>der Sensor steht nicht still</translation>
    </message>
    <message>
        <source>the accelerometer is %1 g away from the reference</source>
        <translation>der Beschleunigungssensor ist %1 g von der Vorgabe entfernt</translation>
    </message>
    <message>
        <source>the board still counts %1 starts</source>
        <translation>das Board zählt noch immer %1 Starts</translation>
    </message>
    <message>
        <source>this firmware has the slots 1 to %1</source>
        <translation>diese Firmware hat die Plätze 1 bis %1</translation>
    </message>
    <message>
        <source>slot %1 holds no script</source>
        <translation>Platz %1 enthält kein Skript</translation>
    </message>
    <message>
        <source>slot %1 holds again what it held before</source>
        <translation>Platz %1 enthält wieder, was er vorher enthielt</translation>
    </message>
    <message>
        <source>what slot %1 holds now is not known</source>
        <translation>was Platz %1 jetzt enthält, ist nicht bekannt</translation>
    </message>
    <message>
        <source>what it held is in %1</source>
        <translation>was er enthielt, ist in %1</translation>
    </message>
    <message>
        <source>the script goes on: it tells command %1</source>
        <translation>das Skript läuft weiter: es meldet Befehl %1</translation>
    </message>
    <message>
        <source>no command of it was told: whether it runs is not known</source>
        <translation>es meldete keinen Befehl: ob es läuft, ist nicht bekannt</translation>
    </message>
    <message>
        <source>the board shows the sensor of its frame, and this step is about the camera&apos;s: select that one first</source>
        <translation>das Board zeigt den Sensor seines Rahmens, und in diesem Schritt geht es um den der Kamera: zuerst diesen auswählen</translation>
    </message>
    <message>
        <source>the magnetometer has seen %1 of 26 directions: turn the camera over while it is calibrated</source>
        <translation>das Magnetometer hat %1 von 26 Richtungen gesehen: die Kamera beim Kalibrieren in alle Richtungen drehen</translation>
    </message>
    <message>
        <source>%1 of 26 directions were seen</source>
        <translation>%1 von 26 Richtungen wurden gesehen</translation>
    </message>
</context>
<context>
    <name>ErrorText</name>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>The board did not answer in time.</source>
        <translation>Das Board hat nicht rechtzeitig geantwortet.</translation>
    </message>
    <message>
        <source>The link to the board broke.</source>
        <translation>Die Verbindung zum Board ist abgerissen.</translation>
    </message>
    <message>
        <source>There is no such port.</source>
        <translation>Diesen Anschluss gibt es nicht.</translation>
    </message>
    <message>
        <source>The adapter is not plugged in, or it has another name now.</source>
        <translation>Der Adapter ist nicht eingesteckt oder heißt jetzt anders.</translation>
    </message>
    <message>
        <source>Plug it in and choose it from the list.</source>
        <translation>Stecken Sie ihn ein und wählen Sie ihn aus der Liste.</translation>
    </message>
    <message>
        <source>You may not open this port.</source>
        <translation>Sie dürfen diesen Anschluss nicht öffnen.</translation>
    </message>
    <message>
        <source>On Linux, serial ports belong to the group dialout.</source>
        <translation>Unter Linux gehören serielle Anschlüsse der Gruppe dialout.</translation>
    </message>
    <message>
        <source>Run “sudo usermod -aG dialout $USER”, then log in again.</source>
        <translation>Führen Sie „sudo usermod -aG dialout $USER“ aus und melden Sie sich neu an.</translation>
    </message>
    <message>
        <source>Another program holds this port.</source>
        <translation>Ein anderes Programm hält diesen Anschluss.</translation>
    </message>
    <message>
        <source>Only one program can talk to a board at a time.</source>
        <translation>Nur ein Programm kann zur Zeit mit einem Board sprechen.</translation>
    </message>
    <message>
        <source>Close the other program (ModemManager is a usual suspect), then connect again.</source>
        <translation>Schließen Sie das andere Programm (oft ist es ModemManager) und verbinden Sie nochmals.</translation>
    </message>
    <message>
        <source>Nothing answers at this network address.</source>
        <translation>Unter dieser Netzadresse antwortet nichts.</translation>
    </message>
    <message>
        <source>Check address and port, and that the bridge or simulator is running.</source>
        <translation>Prüfen Sie Adresse und Port und ob die Brücke oder der Simulator läuft.</translation>
    </message>
    <message>
        <source>The port is open, but no board answers.</source>
        <translation>Der Anschluss ist offen, aber kein Board antwortet.</translation>
    </message>
    <message>
        <source>Check that the board has power, that RX and TX are crossed, and that this is the right port.</source>
        <translation>Prüfen Sie, ob das Board Strom hat, RX und TX gekreuzt sind und dies der richtige Anschluss ist.</translation>
    </message>
    <message>
        <source>Bytes arrive, but they make no sense.</source>
        <translation>Es kommen Bytes, aber sie ergeben keinen Sinn.</translation>
    </message>
    <message>
        <source>This device speaks another protocol.</source>
        <translation>Dieses Gerät spricht ein anderes Protokoll.</translation>
    </message>
    <message>
        <source>It is not a board of the chosen family.</source>
        <translation>Es ist kein Board der gewählten Familie.</translation>
    </message>
    <message>
        <source>Choose the right family, or another port.</source>
        <translation>Wählen Sie die richtige Familie oder einen anderen Anschluss.</translation>
    </message>
    <message>
        <source>This board is open for reading only.</source>
        <translation>Dieses Board ist nur zum Lesen offen.</translation>
    </message>
    <message>
        <source>It is a recording, or its firmware or this value must not be written by this version of the program.</source>
        <translation>Es ist eine Aufzeichnung, oder seine Firmware oder dieser Wert darf von dieser Programmversion nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Connect the board itself, update the program, or change the value with the board maker&apos;s tool.</source>
        <translation>Verbinden Sie das Board selbst, aktualisieren Sie das Programm, oder ändern Sie den Wert mit dem Werkzeug des Herstellers.</translation>
    </message>
    <message>
        <source>The board refused.</source>
        <translation>Das Board hat abgelehnt.</translation>
    </message>
    <message>
        <source>The board&apos;s answer does not match its documentation.</source>
        <translation>Die Antwort des Boards ist nicht, was sein Dokument verspricht.</translation>
    </message>
    <message>
        <source>Try again; if that does not help, the firmware is not supported.</source>
        <translation>Versuchen Sie es nochmals; bleibt es so, wird die Firmware nicht unterstützt.</translation>
    </message>
    <message>
        <source>The value is outside its range.</source>
        <translation>Der Wert liegt außerhalb seines Bereichs.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>This board cannot do that.</source>
        <translation>Dieses Board kann das nicht.</translation>
    </message>
    <message>
        <source>Somebody else changed the board since it was read.</source>
        <translation>Jemand anderes hat das Board seit dem Lesen geändert.</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Read the board again, look at the differences, then write.</source>
        <translation>Lesen Sie das Board neu, sehen Sie die Unterschiede an, dann schreiben Sie.</translation>
    </message>
    <message>
        <source>The board does not hold what was written.</source>
        <translation>Das Board hält nicht, was geschrieben wurde.</translation>
    </message>
    <message>
        <source>The old values were put back as far as the board let us.</source>
        <translation>Die alten Werte wurden zurückgelegt, so weit das Board es zuließ.</translation>
    </message>
    <message>
        <source>Look at the report; try again, or restore the snapshot.</source>
        <translation>Den Bericht ansehen; nochmals versuchen oder die Sicherung wiederherstellen.</translation>
    </message>
    <message>
        <source>The file cannot be used.</source>
        <translation>Die Datei ist nicht zu gebrauchen.</translation>
    </message>
    <message>
        <source>No board is connected.</source>
        <translation>Kein Board ist verbunden.</translation>
    </message>
    <message>
        <source>Connect one, or try the simulated gimbal.</source>
        <translation>Verbinden Sie eines oder probieren Sie den simulierten Gimbal.</translation>
    </message>
    <message>
        <source>No safety copy could be made.</source>
        <translation>Es ließ sich keine Sicherung machen.</translation>
    </message>
    <message>
        <source>Therefore nothing was changed.</source>
        <translation>Darum wurde nichts geändert.</translation>
    </message>
    <message>
        <source>Check that the disk has space and that the folder may be written.</source>
        <translation>Prüfen Sie, ob Platz auf dem Datenträger ist und der Ordner beschrieben werden darf.</translation>
    </message>
    <message>
        <source>Another job is still running.</source>
        <translation>Ein anderer Auftrag läuft noch.</translation>
    </message>
    <message>
        <source>Wait for it or cancel it.</source>
        <translation>Warten Sie, oder brechen Sie ihn ab.</translation>
    </message>
    <message>
        <source>Looking for a board</source>
        <translation>Suche ein Board</translation>
    </message>
    <message>
        <source>Looking for a board at %1</source>
        <translation>Suche ein Board bei %1</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lese %1</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Schreibe %1</translation>
    </message>
    <message>
        <source>Reading back %1</source>
        <translation>Lese zurück: %1</translation>
    </message>
    <message>
        <source>Putting back %1</source>
        <translation>Lege zurück: %1</translation>
    </message>
    <message>
        <source>Calibrating: keep the camera absolutely still</source>
        <translation>Kalibrierung: Kamera völlig still halten</translation>
    </message>
    <message>
        <source>Auto-tune, iteration %1</source>
        <translation>Auto-Abstimmung, Durchgang %1</translation>
    </message>
    <message>
        <source>Steering</source>
        <translation>Steuere</translation>
    </message>
    <message>
        <source>The line cannot carry that much data.</source>
        <translation>So viel trägt die Leitung nicht.</translation>
    </message>
    <message>
        <source>Samples would be lost; nothing was changed.</source>
        <translation>Messwerte gingen verloren; es wurde nichts geändert.</translation>
    </message>
    <message>
        <source>The axis did not follow; the motors were switched off.</source>
        <translation>Die Achse folgte nicht; die Motoren wurden ausgeschaltet.</translation>
    </message>
    <message>
        <source>It moved further than the test allows.</source>
        <translation>Sie bewegte sich weiter, als der Versuch erlaubt.</translation>
    </message>
    <message>
        <source>What the procedure waited for did not happen.</source>
        <translation>Worauf gewartet wurde, ist nicht eingetreten.</translation>
    </message>
    <message>
        <source>This step was given up; nothing was stored.</source>
        <translation>Dieser Schritt wurde aufgegeben; gespeichert wurde nichts.</translation>
    </message>
    <message>
        <source>The details say what was missing. Correct it and repeat the step.</source>
        <translation>Die Einzelheiten sagen, was fehlte. Beheben Sie es und wiederholen Sie den Schritt.</translation>
    </message>
    <message>
        <source>Lay the sensor still on one of its faces</source>
        <translation>Den Sensor still auf eine seiner Flächen legen</translation>
    </message>
    <message>
        <source>Hold the camera level and still</source>
        <translation>Die Kamera waagerecht und still halten</translation>
    </message>
    <message>
        <source>Tilt the camera about 45° down, without rolling it</source>
        <translation>Die Kamera etwa 45° nach unten neigen, ohne sie zu rollen</translation>
    </message>
    <message>
        <source>Connect the battery</source>
        <translation>Akku anschließen</translation>
    </message>
    <message>
        <source>The board starts; keep the camera still</source>
        <translation>Das Board startet; die Kamera still halten</translation>
    </message>
    <message>
        <source>The command reached the board damaged.</source>
        <translation>Der Befehl kam beschädigt beim Board an.</translation>
    </message>
    <message>
        <source>The board discarded it, even when it was repeated; it changed nothing.</source>
        <translation>Das Board hat ihn verworfen, auch bei der Wiederholung; er hat nichts verändert.</translation>
    </message>
    <message>
        <source>The values that were in use could not be put back.</source>
        <translation>Die Werte, die in Gebrauch waren, konnten nicht zurückgesetzt werden.</translation>
    </message>
    <message>
        <source>%1 is written; waiting for the board to restart</source>
        <translation>%1 ist geschrieben; es wird gewartet, bis das Board neu gestartet ist</translation>
    </message>
    <message>
        <source>The board did not confirm that the motors are off.</source>
        <translation>Das Board hat nicht bestätigt, dass die Motoren aus sind.</translation>
    </message>
    <message>
        <source>They may still be running.</source>
        <translation>Sie laufen vielleicht noch.</translation>
    </message>
    <message>
        <source>Hold the camera and disconnect the power.</source>
        <translation>Halten Sie die Kamera und trennen Sie den Strom.</translation>
    </message>
    <message>
        <source>Measuring how the axis follows</source>
        <translation>Messung, wie die Achse folgt</translation>
    </message>
    <message>
        <source>The board is not in the state that this action needs.</source>
        <translation>Das Board ist nicht in dem Zustand, den diese Aktion braucht.</translation>
    </message>
    <message>
        <source>The details say which condition must be met first.</source>
        <translation>Die Einzelheiten sagen, was zuerst so sein muss.</translation>
    </message>
    <message>
        <source>Parts of the board could not be read.</source>
        <translation>Teile des Boards ließen sich nicht lesen.</translation>
    </message>
    <message>
        <source>Nothing is known about the values in them; they are not shown, compared or saved.</source>
        <translation>Über die Werte darin ist nichts bekannt; sie werden nicht angezeigt, verglichen oder gesichert.</translation>
    </message>
    <message>
        <source>The board acknowledged the command but did not carry it out.</source>
        <translation>Das Board hat den Befehl bestätigt, aber nicht ausgeführt.</translation>
    </message>
    <message>
        <source>The details say what is missing, as far as the board tells.</source>
        <translation>Die Einzelheiten sagen, was fehlt, soweit das Board es mitteilt.</translation>
    </message>
    <message>
        <source>There are too few samples.</source>
        <translation>Es sind zu wenige Messwerte.</translation>
    </message>
    <message>
        <source>From so few nothing can be told that would be true.</source>
        <translation>Aus so wenigen lässt sich nichts Verlässliches sagen.</translation>
    </message>
    <message>
        <source>Record longer, or choose channels that were recorded.</source>
        <translation>Länger aufzeichnen oder Kanäle wählen, die aufgezeichnet wurden.</translation>
    </message>
    <message>
        <source>Two values exclude each other.</source>
        <translation>Zwei Werte schließen einander aus.</translation>
    </message>
    <message>
        <source>Change one of the two so that both can hold, then write again.</source>
        <translation>Einen der beiden so ändern, dass beide gelten können, dann noch einmal schreiben.</translation>
    </message>
    <message>
        <source>No live data come.</source>
        <translation>Es kommen keine Live-Daten.</translation>
    </message>
    <message>
        <source>%1 of profile %2</source>
        <translation>%1 von Profil %2</translation>
    </message>
    <message numerus="yes">
        <source>%n verified</source>
        <translation>
            <numerusform>%n bestätigt</numerusform>
            <numerusform>%n bestätigt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n put back</source>
        <translation>
            <numerusform>%n zurückgelegt</numerusform>
            <numerusform>%n zurückgelegt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unknown</source>
        <translation>
            <numerusform>%n unbekannt</numerusform>
            <numerusform>%n unbekannt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not written</source>
        <translation>
            <numerusform>%n nicht geschrieben</numerusform>
            <numerusform>%n nicht geschrieben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n different</source>
        <translation>
            <numerusform>%n anders</numerusform>
            <numerusform>%n anders</numerusform>
        </translation>
    </message>
    <message>
        <source>The write is not complete: %1. </source>
        <translation>Das Schreiben ist nicht vollständig: %1. </translation>
    </message>
    <message numerus="yes">
        <source>What the board holds of %n value(s) could not be read.</source>
        <translation>
            <numerusform>Was das Board von %n Wert hat, ließ sich nicht lesen.</numerusform>
            <numerusform>Was das Board von %n Werten hat, ließ sich nicht lesen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The board was read again: %n value(s) are not as they were before.</source>
        <translation>
            <numerusform>Das Board wurde noch einmal gelesen: %n Wert ist nicht wie zuvor.</numerusform>
            <numerusform>Das Board wurde noch einmal gelesen: %n Werte sind nicht wie zuvor.</numerusform>
        </translation>
    </message>
    <message>
        <source>The board was read again: it holds the old values.</source>
        <translation>Das Board wurde noch einmal gelesen: Es hat die alten Werte.</translation>
    </message>
    <message>
        <source>The board does not use the value that was set.</source>
        <translation>Das Board benutzt den gesetzten Wert nicht.</translation>
    </message>
    <message>
        <source>It confirmed the value and reports another. Nothing that is stored was changed.</source>
        <translation>Es hat den Wert bestätigt und meldet einen anderen. Gespeichertes wurde nicht geändert.</translation>
    </message>
    <message>
        <source>See whether a remote control, a script or another program sets it too, then try again.</source>
        <translation>Prüfen Sie, ob Fernsteuerung, Skript oder ein anderes Programm ihn ebenfalls setzt, und versuchen Sie es dann erneut.</translation>
    </message>
    <message>
        <source>Not one byte came back; the details say what was tried.</source>
        <translation>Kein einziges Byte kam zurück; die Einzelheiten sagen, was versucht wurde.</translation>
    </message>
    <message>
        <source>The connection stands, but no board answers.</source>
        <translation>Die Verbindung steht, aber kein Board antwortet.</translation>
    </message>
    <message>
        <source>Not one byte came back.</source>
        <translation>Kein einziges Byte kam zurück.</translation>
    </message>
    <message>
        <source>Measuring without the notch</source>
        <translation>Messen ohne den Kerbfilter</translation>
    </message>
    <message>
        <source>Measuring with the notch</source>
        <translation>Messen mit dem Kerbfilter</translation>
    </message>
    <message>
        <source>What was entered cannot be used.</source>
        <translation>Die Eingabe lässt sich nicht verwenden.</translation>
    </message>
    <message>
        <source>Correct it, then try again.</source>
        <translation>Berichtigen Sie sie und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>What was entered cannot be used: %1.</source>
        <translation>Die Eingabe lässt sich nicht verwenden: %1.</translation>
    </message>
    <message>
        <source>The value is outside its range: %1.</source>
        <translation>Der Wert liegt außerhalb seines Bereichs: %1.</translation>
    </message>
    <message>
        <source>Nothing was taken from it or saved to it.</source>
        <translation>Nichts wurde daraus übernommen oder darin gesichert.</translation>
    </message>
    <message>
        <source>Use another copy, or choose another file.</source>
        <translation>Verwenden Sie eine andere Kopie, oder wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>The file cannot be used: %1.</source>
        <translation>Die Datei lässt sich nicht verwenden: %1.</translation>
    </message>
    <message>
        <source>The board is not ready for this.</source>
        <translation>Das Board ist dafür nicht bereit.</translation>
    </message>
    <message>
        <source>Nothing was stored. A test needs running motors that hold the camera, and live data; comparing and storing need a board that has started.</source>
        <translation>Nichts wurde gespeichert. Ein Test braucht laufende Motoren, die die Kamera halten, und Live-Daten; Vergleichen und Speichern brauchen ein gestartetes Board.</translation>
    </message>
    <message>
        <source>The details say what is missing. Let the board start and the camera settle, then try again.</source>
        <translation>Die Einzelheiten sagen, was fehlt. Warten Sie, bis das Board gestartet und die Kamera ruhig ist, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>What the board holds now could not be read.</source>
        <translation>Was das Board jetzt enthält, konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The board was read again, but not all of it: what was read is as before.</source>
        <translation>Das Board wurde erneut gelesen, aber nicht vollständig: Was gelesen wurde, ist wie zuvor.</translation>
    </message>
    <message>
        <source>The board was read again: it uses the old values.</source>
        <translation>Das Board wurde erneut gelesen: Es verwendet die alten Werte.</translation>
    </message>
    <message>
        <source>The snapshot holds what was there before: compare, and restore it if need be.</source>
        <translation>Die Sicherung enthält, was vorher da war: Vergleichen Sie, und stellen Sie sie bei Bedarf wieder her.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiterer</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>not read: %1</source>
        <translation>nicht gelesen: %1</translation>
    </message>
    <message>
        <source>snapshot: %1</source>
        <translation>Sicherung: %1</translation>
    </message>
    <message>
        <source>profile names verified</source>
        <translation>Profilnamen bestätigt</translation>
    </message>
    <message>
        <source>profile names unknown</source>
        <translation>Profilnamen unbekannt</translation>
    </message>
    <message>
        <source>profile names not written</source>
        <translation>Profilnamen nicht geschrieben</translation>
    </message>
    <message>
        <source>profile names different</source>
        <translation>Profilnamen abweichend</translation>
    </message>
    <message>
        <source>profile names put back</source>
        <translation>Profilnamen zurückgesetzt</translation>
    </message>
    <message>
        <source>Which names the profiles have now could not be read.</source>
        <translation>Welche Namen die Profile jetzt haben, konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The board was read again: the profile names are not as they were before.</source>
        <translation>Das Board wurde erneut gelesen: Die Profilnamen sind nicht wie zuvor.</translation>
    </message>
    <message>
        <source>profile names on the board: %1</source>
        <translation>Profilnamen auf dem Board: %1</translation>
    </message>
    <message>
        <source>The write is not complete.</source>
        <translation>Das Schreiben ist nicht vollständig.</translation>
    </message>
    <message>
        <source>Which profile is active now could not be read.</source>
        <translation>Welches Profil jetzt aktiv ist, konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The active profile is now %1 instead of %2: the gimbal uses its values.</source>
        <translation>Das aktive Profil ist jetzt %1 statt %2: Der Gimbal verwendet dessen Werte.</translation>
    </message>
    <message>
        <source>The board has not stored everything that it uses.</source>
        <translation>Das Board hat nicht alles gespeichert, was es benutzt.</translation>
    </message>
    <message>
        <source>A restart brings the stored values back.</source>
        <translation>Nach einem Neustart gelten wieder die gespeicherten Werte.</translation>
    </message>
    <message>
        <source>Store once more. If that does not help, save the values into a file.</source>
        <translation>Speichern Sie noch einmal. Hilft das nicht, sichern Sie die Werte in eine Datei.</translation>
    </message>
    <message>
        <source>The board may use other values now; nothing that is stored was changed.</source>
        <translation>Das Board verwendet jetzt womöglich andere Werte; an den gespeicherten hat sich nichts geändert.</translation>
    </message>
    <message>
        <source>The details list what was in use and, where it could be read, what is now. Set it again if you want to keep it.</source>
        <translation>Die Einzelheiten nennen, was in Gebrauch war, und, soweit lesbar, was es jetzt ist. Setzen Sie es erneut, wenn Sie es behalten wollen.</translation>
    </message>
    <message>
        <source>The board restarted by itself.</source>
        <translation>Das Board ist von selbst neu gestartet.</translation>
    </message>
    <message>
        <source>Check its supply voltage and its cables.</source>
        <translation>Prüfen Sie seine Spannungsversorgung und seine Kabel.</translation>
    </message>
    <message>
        <source>%1 in use: %2, before %3</source>
        <translation>%1 in Gebrauch: %2, vorher %3</translation>
    </message>
    <message>
        <source>%1 in use: others</source>
        <translation>%1 in Gebrauch: andere</translation>
    </message>
    <message>
        <source>What was written is in use; whether it is stored could not be read.</source>
        <translation>Was geschrieben wurde, ist in Gebrauch; ob es gespeichert ist, ließ sich nicht lesen.</translation>
    </message>
    <message>
        <source>The board was read again: the old values are stored.</source>
        <translation>Das Board wurde erneut gelesen: Gespeichert sind die alten Werte.</translation>
    </message>
    <message>
        <source>Which values are in use now could not be read.</source>
        <translation>Welche Werte jetzt in Gebrauch sind, ließ sich nicht lesen.</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) in use are not as they were before.</source>
        <translation>
            <numerusform>%n Wert in Gebrauch ist nicht wie zuvor.</numerusform>
            <numerusform>%n Werte in Gebrauch sind nicht wie zuvor.</numerusform>
        </translation>
    </message>
    <message>
        <source>The values do not change.</source>
        <translation>Die Werte ändern sich nicht.</translation>
    </message>
    <message>
        <source>Either nothing moved by as much as the board tells apart, or it sent old values again and again.</source>
        <translation>Entweder bewegte sich nichts um so viel, wie das Board unterscheidet, oder es schickte immer wieder alte Werte.</translation>
    </message>
    <message>
        <source>Let the gimbal work while it is measured: walk with it, or shake its frame.</source>
        <translation>Lassen Sie den Gimbal beim Messen arbeiten: Gehen Sie mit ihm, oder rütteln Sie an seinem Rahmen.</translation>
    </message>
    <message>
        <source>Lower the gains or make the movement smaller, then start the motors again.</source>
        <translation>Nehmen Sie die Verstärkungen zurück oder verkleinern Sie die Bewegung, dann starten Sie die Motoren wieder.</translation>
    </message>
    <message>
        <source>Whether sensors were calibrated cannot be seen from that.</source>
        <translation>Ob Sensoren kalibriert wurden, ist daran nicht zu sehen.</translation>
    </message>
    <message>
        <source>What the board does now is not known: it may go on as before, or have restarted and run its motors.</source>
        <translation>Was das Board jetzt tut, ist nicht bekannt: Es kann weitermachen wie bisher oder neu gestartet sein und seine Motoren laufen lassen.</translation>
    </message>
    <message>
        <source>The board sends none, none that can be read, or the same again and again; what came before is kept.</source>
        <translation>Das Board sendet keine, keine lesbaren oder immer wieder dieselben; was vorher kam, bleibt erhalten.</translation>
    </message>
    <message>
        <source>What was in use without being stored is lost.</source>
        <translation>Was in Gebrauch war, ohne gespeichert zu sein, ist verloren.</translation>
    </message>
    <message>
        <source>Its motors may run again.</source>
        <translation>Seine Motoren laufen womöglich wieder.</translation>
    </message>
    <message>
        <source>Where they are not stored, a restart brings the stored ones back.</source>
        <translation>Wo sie nicht gespeichert sind, bringt ein Neustart die gespeicherten zurück.</translation>
    </message>
    <message>
        <source>not to be written: %1</source>
        <translation>nicht zu schreiben: %1</translation>
    </message>
    <message>
        <source>The board was silent for %1 s during the write and its motors run now, which were off before: it has restarted. What was in use without being stored is lost.</source>
        <translation>Das Board hat während des Schreibens %1 s geschwiegen, und seine Motoren laufen jetzt, die vorher aus waren: Es hat neu gestartet. Was in Gebrauch und nicht gespeichert war, ist verloren.</translation>
    </message>
    <message>
        <source>The board was silent for %1 s during the write. If it has restarted, what was in use without being stored is lost, and its motors may run.</source>
        <translation>Das Board hat während des Schreibens %1 s geschwiegen. Falls es neu gestartet hat, ist verloren, was in Gebrauch und nicht gespeichert war, und seine Motoren laufen vielleicht.</translation>
    </message>
    <message>
        <source>It says that it has not carried out this command.</source>
        <translation>Es meldet, dass es diesen Befehl nicht ausgeführt hat.</translation>
    </message>
    <message>
        <source>The motors run now; before this they were off.</source>
        <translation>Die Motoren laufen jetzt; vorher waren sie aus.</translation>
    </message>
    <message>
        <source>The motors are off now; before this they were running.</source>
        <translation>Die Motoren sind jetzt aus; vorher liefen sie.</translation>
    </message>
    <message>
        <source>The active profile is now %1; before it was %2.</source>
        <translation>Aktiv ist jetzt Profil %1; vorher war es %2.</translation>
    </message>
    <message>
        <source>Whether the values in use are stored now shows only when the board has restarted.</source>
        <translation>Ob die benutzten Werte jetzt gespeichert sind, zeigt sich erst nach einem Neustart des Boards.</translation>
    </message>
    <message>
        <source>The write was disturbed, but all of it is on the board: %1. </source>
        <translation>Das Schreiben wurde gestört, aber alles davon ist auf dem Board: %1. </translation>
    </message>
    <message>
        <source>The board was read again: it holds what was wanted.</source>
        <translation>Das Board wurde noch einmal gelesen: es enthält, was es soll.</translation>
    </message>
    <message>
        <source>The motors are disabled in the board&apos;s volatile memory: it did not obey the ordinary stop.</source>
        <translation>Die Motoren sind im flüchtigen Speicher des Boards abgeschaltet: Dem gewöhnlichen Stopp hat es nicht gehorcht.</translation>
    </message>
    <message>
        <source>Stored now, they would stay disabled; so nothing was changed.</source>
        <translation>Jetzt gespeichert, blieben sie abgeschaltet; deshalb wurde nichts geändert.</translation>
    </message>
    <message>
        <source>Wait until the board reaches standby, or restart it.</source>
        <translation>Warten Sie, bis das Board in Bereitschaft ist, oder starten Sie es neu.</translation>
    </message>
    <message>
        <source>The board goes on with what it was told to end.</source>
        <translation>Das Board macht mit dem weiter, was es beenden sollte.</translation>
    </message>
    <message>
        <source>It may be moving the camera.</source>
        <translation>Es bewegt möglicherweise die Kamera.</translation>
    </message>
    <message>
        <source>Stop the motors.</source>
        <translation>Stoppen Sie die Motoren.</translation>
    </message>
    <message numerus="yes">
        <source>The board was read again: it has stored %n other value(s) than before.</source>
        <translation>
            <numerusform>Das Board wurde noch einmal gelesen: Es hat %n anderen Wert gespeichert als vorher.</numerusform>
            <numerusform>Das Board wurde noch einmal gelesen: Es hat %n andere Werte gespeichert als vorher.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing of it had been sent: the board holds the old values.</source>
        <translation>Davon war noch nichts gesendet: Das Board hat die alten Werte.</translation>
    </message>
    <message>
        <source>Whether it was carried out cannot be seen from that.</source>
        <translation>Ob es ausgeführt wurde, ist daran nicht zu sehen.</translation>
    </message>
    <message>
        <source>Calibrating: leave the drone alone</source>
        <translation>Wird kalibriert: die Drohne in Ruhe lassen</translation>
    </message>
    <message>
        <source>The motor is tested; the drone hears nothing meanwhile</source>
        <translation>Der Motor wird geprüft; die Drohne hört währenddessen nichts</translation>
    </message>
    <message>
        <source>Motor controllers: no signal; the drone hears nothing for 26 s</source>
        <translation>Motorregler: kein Signal; die Drohne hört 26 s lang nichts</translation>
    </message>
    <message>
        <source>Motor controllers: FULL THROTTLE; the drone hears nothing</source>
        <translation>Motorregler: VOLLGAS; die Drohne hört nichts</translation>
    </message>
    <message>
        <source>Motor controllers: zero; the drone hears nothing</source>
        <translation>Motorregler: null; die Drohne hört nichts</translation>
    </message>
    <message>
        <source>Uploading the firmware</source>
        <translation>Die Firmware wird hochgeladen</translation>
    </message>
    <message>
        <source>The firmware is on the drone; waiting for its restart. Do not switch it off</source>
        <translation>Die Firmware ist auf der Drohne; warten auf ihren Neustart. Nicht ausschalten</translation>
    </message>
    <message>
        <source>Check that this is the board&apos;s address and port, that the board behind it has power, and that nobody else is connected to it.</source>
        <translation>Prüfen, ob Adresse und Port die des Boards sind, ob das Board dahinter Strom hat und ob niemand sonst damit verbunden ist.</translation>
    </message>
    <message>
        <source>configuration text</source>
        <translation>Konfigurationstext</translation>
    </message>
    <message>
        <source>gains</source>
        <translation>Reglerwerte</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>The configuration text is written; waiting for the drone to restart</source>
        <translation>Der Konfigurationstext ist auf der Drohne; ihr Neustart wird abgewartet</translation>
    </message>
    <message>
        <source>The board turns the motors and measures them</source>
        <translation>Das Board dreht die Motoren und misst sie</translation>
    </message>
    <message>
        <source>Reading the board&apos;s memory</source>
        <translation>Speicher des Boards wird gelesen</translation>
    </message>
    <message>
        <source>Writing the board&apos;s memory</source>
        <translation>Speicher des Boards wird geschrieben</translation>
    </message>
    <message>
        <source>Reading a file of the board</source>
        <translation>Datei des Boards wird gelesen</translation>
    </message>
    <message>
        <source>Writing a file of the board</source>
        <translation>Datei des Boards wird geschrieben</translation>
    </message>
    <message>
        <source>Asking each address of the bus</source>
        <translation>Jede Adresse des Busses wird gefragt</translation>
    </message>
    <message>
        <source>Sending the rows of the file, each at its time</source>
        <translation>Die Zeilen der Datei werden gesendet, jede zu ihrer Zeit</translation>
    </message>
    <message>
        <source>Script %1 runs: command %2</source>
        <translation>Skript %1 läuft: Befehl %2</translation>
    </message>
    <message>
        <source>It may be busy, restarting, or the cable or the network may be disturbed.</source>
        <translation>Es ist vielleicht beschäftigt, startet neu, oder Kabel oder Netz sind gestört.</translation>
    </message>
    <message>
        <source>Try again; if that does not help, check its cable or network, and its power.</source>
        <translation>Versuchen Sie es nochmals; bleibt es so, prüfen Sie Kabel oder Netz, und den Strom.</translation>
    </message>
    <message>
        <source>Check its cable or network, and its power; the program connects again by itself.</source>
        <translation>Prüfen Sie Kabel oder Netz, und den Strom; das Programm verbindet sich von selbst wieder.</translation>
    </message>
    <message>
        <source>It is another kind of device, or, on a cable, the rate is unknown or the cable is disturbed.</source>
        <translation>Es ist ein anderes Gerät, oder, an einem Kabel, die Rate ist unbekannt oder das Kabel gestört.</translation>
    </message>
    <message>
        <source>Check that this is the board&apos;s port or address; on a cable, check it and its ground.</source>
        <translation>Prüfen Sie, ob dies Port oder Adresse des Boards ist; an einem Kabel auch dieses und die Masse.</translation>
    </message>
    <message>
        <source>The line is disturbed: on a cable, check it, its ground and its rate; in a network, go nearer. Then try again.</source>
        <translation>Die Leitung ist gestört: an einem Kabel prüfen Sie dieses, die Masse und die Rate; in einem Netz gehen Sie näher heran. Dann versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>Read the board again; if parts keep missing, check its cable or network, and its power.</source>
        <translation>Das Board noch einmal lesen; fehlen weiter Teile, Kabel oder Netz und Versorgung prüfen.</translation>
    </message>
    <message>
        <source>Ask for fewer channels or a lower rate; on a cable, set a faster serial speed.</source>
        <translation>Weniger Kanäle oder eine niedrigere Rate verlangen; an einem Kabel eine schnellere serielle Rate einstellen.</translation>
    </message>
    <message>
        <source>Check its cable or network and its power, and that the board still answers; then start again.</source>
        <translation>Kabel oder Netz und Versorgung prüfen, und ob das Board noch antwortet; dann neu beginnen.</translation>
    </message>
    <message>
        <source>Check its cable or network, and its power.</source>
        <translation>Prüfen Sie Kabel oder Netz, und den Strom.</translation>
    </message>
    <message>
        <source>Move the camera slowly as far as it may go, each axis both ways</source>
        <translation>Bewegen Sie die Kamera langsam so weit, wie sie darf, jede Achse in beide Richtungen</translation>
    </message>
    <message>
        <source>The motors run: watching whether an axis runs away</source>
        <translation>Die Motoren laufen: es wird beobachtet, ob eine Achse davonläuft</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Es wird gemessen</translation>
    </message>
    <message>
        <source>The board reads its encoders: leave the camera as it stands</source>
        <translation>Das Board liest seine Geber: lassen Sie die Kamera, wie sie steht</translation>
    </message>
    <message>
        <source>Tilt the frame by hand to all sides</source>
        <translation>Neigen Sie den Rahmen von Hand nach allen Seiten</translation>
    </message>
    <message>
        <source>Take your hands off the camera, keep them beneath it, and tip it lightly</source>
        <translation>Nehmen Sie die Hände von der Kamera, halten Sie sie darunter, und tippen Sie die Kamera leicht an</translation>
    </message>
    <message>
        <source>Hold the camera level and still, until you are asked for something else</source>
        <translation>Die Kamera waagerecht und still halten, bis etwas anderes verlangt wird</translation>
    </message>
    <message>
        <source>Tilt the right side of the camera down by about 45° and hold it there</source>
        <translation>Die rechte Seite der Kamera um etwa 45° nach unten neigen und so halten</translation>
    </message>
    <message>
        <source>Tilt the nose of the camera down by about 45° and hold it there</source>
        <translation>Die Nase der Kamera um etwa 45° nach unten neigen und so halten</translation>
    </message>
    <message>
        <source>the stick for roll</source>
        <translation>den Knüppel für Roll</translation>
    </message>
    <message>
        <source>the stick for pitch</source>
        <translation>den Knüppel für Pitch</translation>
    </message>
    <message>
        <source>the stick for yaw</source>
        <translation>den Knüppel für Yaw</translation>
    </message>
    <message>
        <source>the switch for commands</source>
        <translation>den Schalter für Befehle</translation>
    </message>
    <message>
        <source>Roll: move its stick to the end at which the camera is to tip to the right, and hold it there</source>
        <translation>Roll: den Knüppel zu dem Anschlag bewegen, bei dem die Kamera nach rechts kippen soll, und dort halten</translation>
    </message>
    <message>
        <source>Pitch: move its stick to the end at which the camera is to look down, and hold it there</source>
        <translation>Pitch: den Knüppel zu dem Anschlag bewegen, bei dem die Kamera nach unten blicken soll, und dort halten</translation>
    </message>
    <message>
        <source>Yaw: move its stick to the end at which the camera is to turn to the right, and hold it there</source>
        <translation>Yaw: den Knüppel zu dem Anschlag bewegen, bei dem die Kamera sich nach rechts drehen soll, und dort halten</translation>
    </message>
    <message>
        <source>Commands: move their switch to another position and leave it there</source>
        <translation>Befehle: den Schalter in eine andere Stellung bringen und dort lassen</translation>
    </message>
    <message>
        <source>%1 moves: now to the other end, and hold it there</source>
        <translation>%1 bewegt sich: nun zum anderen Anschlag, und dort halten</translation>
    </message>
    <message>
        <source>Two moved: let go of both, then move one alone</source>
        <translation>Zwei haben sich bewegt: beide loslassen, dann einen allein bewegen</translation>
    </message>
    <message>
        <source>That one steers something else already: let go, then move another one</source>
        <translation>Der steuert schon etwas anderes: loslassen, dann einen anderen bewegen</translation>
    </message>
    <message>
        <source>Does the board follow? Move %1 to an end once more</source>
        <translation>Folgt das Board? Noch einmal %1 zu einem Anschlag bewegen</translation>
    </message>
    <message>
        <source>Let go of all sticks</source>
        <translation>Alle Knüppel loslassen</translation>
    </message>
    <message>
        <source>%1: is it held with a power of %2?</source>
        <translation>%1: wird sie mit einer Leistung von %2 gehalten?</translation>
    </message>
    <message>
        <source>Roll alone, with little power: watching whether it runs away</source>
        <translation>Roll allein, mit wenig Leistung: beobachtet wird, ob sie davonläuft</translation>
    </message>
    <message>
        <source>Pitch alone, with little power: watching whether it runs away</source>
        <translation>Pitch allein, mit wenig Leistung: beobachtet wird, ob sie davonläuft</translation>
    </message>
    <message>
        <source>Yaw alone, with little power: watching whether it runs away</source>
        <translation>Yaw allein, mit wenig Leistung: beobachtet wird, ob sie davonläuft</translation>
    </message>
    <message>
        <source>Measuring how each axis follows a small step</source>
        <translation>Gemessen wird, wie jede Achse einem kleinen Sprung folgt</translation>
    </message>
    <message>
        <source>Searching the board&apos;s files</source>
        <translation>Die Dateien des Boards werden gesucht</translation>
    </message>
    <message>
        <source>Measuring the frequency response</source>
        <translation>Frequenzgang wird gemessen</translation>
    </message>
    <message>
        <source>Searching gains by axis</source>
        <translation>Verstärkungen werden je Achse gesucht</translation>
    </message>
    <message>
        <source>Waiting for events</source>
        <translation>Warten auf Ereignisse</translation>
    </message>
    <message>
        <source>Turn the camera in all directions: %1 of 26 are seen</source>
        <translation>Drehen Sie die Kamera in alle Richtungen: %1 von 26 sind gesehen</translation>
    </message>
</context>
<context>
    <name>EscCard</name>
    <message>
        <source>Motor controllers</source>
        <translation>Motorregler</translation>
    </message>
    <message>
        <source>Calibrate the controllers…</source>
        <translation>Regler kalibrieren…</translation>
    </message>
    <message>
        <source>⚠ All motors get full throttle. Propellers off, drone fixed. It hears nothing for 26 s, also no stop: only its battery ends it.</source>
        <translation>⚠ Alle Motoren bekommen Vollgas. Propeller ab, Drohne befestigt. Sie hört 26 s lang nichts, auch keinen Stopp: Nur ihr Akku beendet es.</translation>
    </message>
    <message>
        <source>No signal, 10 s</source>
        <translation>Kein Signal, 10 s</translation>
    </message>
    <message>
        <source>Full throttle, 8 s</source>
        <translation>Vollgas, 8 s</translation>
    </message>
    <message>
        <source>Zero, 8 s</source>
        <translation>Null, 8 s</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Progress of the calibration</source>
        <translation>Fortschritt der Kalibrierung</translation>
    </message>
</context>
<context>
    <name>FaceList</name>
    <message>
        <source>Z up</source>
        <translation>Z oben</translation>
    </message>
    <message>
        <source>Z down</source>
        <translation>Z unten</translation>
    </message>
    <message>
        <source>X up</source>
        <translation>X oben</translation>
    </message>
    <message>
        <source>X down</source>
        <translation>X unten</translation>
    </message>
    <message>
        <source>Y up</source>
        <translation>Y oben</translation>
    </message>
    <message>
        <source>Y down</source>
        <translation>Y unten</translation>
    </message>
    <message>
        <source>tilted</source>
        <translation>schräg</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
</context>
<context>
    <name>FieldSphereView</name>
    <message>
        <source>Sphere of the magnetic field</source>
        <translation>Kugel des Magnetfelds</translation>
    </message>
    <message>
        <source>%1 of %2 directions are seen.</source>
        <translation>%1 von %2 Richtungen sind gesehen.</translation>
    </message>
    <message>
        <source>no sphere yet</source>
        <translation>noch keine Kugel</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>gesehen</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
</context>
<context>
    <name>FileDialogs</name>
    <message>
        <source>The file is chosen in a window of its own. The motors can be stopped meanwhile, here and there.</source>
        <translation>Die Datei wird in einem eigenen Fenster gewählt. Die Motoren lassen sich währenddessen hier wie dort stoppen.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>There is no such file:</source>
        <translation>Diese Datei gibt es nicht:</translation>
    </message>
    <message>
        <source>Replace “%1”?</source>
        <translation>„%1“ ersetzen?</translation>
    </message>
    <message>
        <source>The folder %1 has a file of this name; what it holds is lost.</source>
        <translation>Der Ordner %1 hat eine Datei dieses Namens; ihr Inhalt geht verloren.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Choose another name…</source>
        <translation>Anderen Namen wählen…</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Behalten</translation>
    </message>
</context>
<context>
    <name>FileFault</name>
    <message>
        <source>a configuration</source>
        <translation>eine Konfiguration</translation>
    </message>
    <message>
        <source>a recording</source>
        <translation>eine Aufzeichnung</translation>
    </message>
    <message>
        <source>a settings file of the manufacturer&apos;s program</source>
        <translation>eine Einstellungsdatei des Programms des Herstellers</translation>
    </message>
    <message>
        <source>a sensor calibration</source>
        <translation>eine Sensorkalibrierung</translation>
    </message>
    <message>
        <source>a measurement (two columns of numbers)</source>
        <translation>eine Messung (zwei Spalten mit Zahlen)</translation>
    </message>
    <message>
        <source>a script</source>
        <translation>ein Skript</translation>
    </message>
    <message>
        <source>a text in UTF-8</source>
        <translation>ein Text in UTF-8</translation>
    </message>
    <message>
        <source>the list of boards</source>
        <translation>die Liste der Boards</translation>
    </message>
    <message>
        <source>a layout of plots</source>
        <translation>eine Anordnung von Diagrammen</translation>
    </message>
    <message>
        <source>the program&apos;s settings</source>
        <translation>die Einstellungen des Programms</translation>
    </message>
    <message>
        <source>a file of this program</source>
        <translation>eine Datei dieses Programms</translation>
    </message>
    <message>
        <source>%1 does not exist.</source>
        <translation>%1 gibt es nicht.</translation>
    </message>
    <message>
        <source>Check the name and the folder.</source>
        <translation>Prüfen Sie Namen und Ordner.</translation>
    </message>
    <message>
        <source>%1 may not be read by this user.</source>
        <translation>%1 darf von diesem Benutzer nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Change the file&apos;s permissions, or choose another file.</source>
        <translation>Ändern Sie die Rechte der Datei, oder wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>%1 may not be written by this user.</source>
        <translation>%1 darf von diesem Benutzer nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Change the permissions, or choose another folder.</source>
        <translation>Ändern Sie die Rechte, oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>The disk is full: %1 could not be written.</source>
        <translation>Der Datenträger ist voll: %1 konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Free some space or choose another disk, then save again.</source>
        <translation>Schaffen Sie Platz, oder wählen Sie einen anderen Datenträger, und sichern Sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 could not be read or written: %2.</source>
        <translation>%1 konnte nicht gelesen oder geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>Check the file and the disk, then try again.</source>
        <translation>Prüfen Sie Datei und Datenträger, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>%1 is empty.</source>
        <translation>%1 ist leer.</translation>
    </message>
    <message>
        <source>Use another copy, or save the file again.</source>
        <translation>Verwenden Sie eine andere Kopie, oder sichern Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1 is cut off: its end is missing.</source>
        <translation>%1 ist abgeschnitten: Das Ende fehlt.</translation>
    </message>
    <message>
        <source>Use another copy: this one was not saved or copied completely.</source>
        <translation>Verwenden Sie eine andere Kopie: Diese wurde nicht vollständig gesichert oder kopiert.</translation>
    </message>
    <message>
        <source>%1 is not %2.</source>
        <translation>%1 ist etwas anderes als %2.</translation>
    </message>
    <message>
        <source>Choose another file.</source>
        <translation>Wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>%1 belongs to boards of another family: %2 instead of %3.</source>
        <translation>%1 gehört zu Boards einer anderen Familie: %2 statt %3.</translation>
    </message>
    <message>
        <source>Choose a file that was saved from a board of the right family.</source>
        <translation>Wählen Sie eine Datei, die von einem Board der richtigen Familie gesichert wurde.</translation>
    </message>
    <message>
        <source>%1 was written by a newer version of the program (format %2; this version reads up to %3).</source>
        <translation>%1 stammt von einer neueren Version des Programms (Format %2; diese Version liest bis %3).</translation>
    </message>
    <message>
        <source>Update the program.</source>
        <translation>Aktualisieren Sie das Programm.</translation>
    </message>
    <message>
        <source>%1: %2 is %3, allowed: %4.</source>
        <translation>%1: %2 ist %3, erlaubt: %4.</translation>
    </message>
    <message>
        <source>Correct the value in the file, or use another copy.</source>
        <translation>Berichtigen Sie den Wert in der Datei, oder verwenden Sie eine andere Kopie.</translation>
    </message>
    <message>
        <source>%1: %2 is “%3”, which is not understood; expected: %4.</source>
        <translation>%1: %2 ist „%3“, was nicht verstanden wird; erwartet: %4.</translation>
    </message>
    <message>
        <source>Correct the entry in the file, or use another copy.</source>
        <translation>Berichtigen Sie den Eintrag in der Datei, oder verwenden Sie eine andere Kopie.</translation>
    </message>
    <message>
        <source>%1 lacks the entry “%2”.</source>
        <translation>%1 enthält den Eintrag „%2“ nicht.</translation>
    </message>
    <message>
        <source>Add the entry, or use another copy.</source>
        <translation>Ergänzen Sie den Eintrag, oder verwenden Sie eine andere Kopie.</translation>
    </message>
    <message>
        <source>%1 is damaged.</source>
        <translation>%1 ist beschädigt.</translation>
    </message>
    <message>
        <source>Use another copy.</source>
        <translation>Verwenden Sie eine andere Kopie.</translation>
    </message>
    <message>
        <source>%1 is too large for %2.</source>
        <translation>%1 ist zu groß; erwartet: %2.</translation>
    </message>
    <message>
        <source>%1 is the very file that is to be copied.</source>
        <translation>%1 ist genau die Datei, die kopiert werden soll.</translation>
    </message>
    <message>
        <source>Choose another name or folder.</source>
        <translation>Wählen Sie einen anderen Namen oder Ordner.</translation>
    </message>
    <message>
        <source>Nothing was copied.</source>
        <translation>Nichts wurde kopiert.</translation>
    </message>
    <message>
        <source>What was to be saved is not, or not completely, in it.</source>
        <translation>Was gesichert werden sollte, steht nicht oder nicht vollständig darin.</translation>
    </message>
    <message>
        <source>Which snapshots belong to which board without a serial number is not known.</source>
        <translation>Welche Sicherungen zu welchem Board ohne Seriennummer gehören, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Default settings are used in their place.</source>
        <translation>Stattdessen gelten die Voreinstellungen.</translation>
    </message>
    <message>
        <source>Nothing was taken from it.</source>
        <translation>Nichts wurde daraus übernommen.</translation>
    </message>
    <message>
        <source>\1 to \2</source>
        <translation>\1 bis \2</translation>
    </message>
    <message>
        <source>The file, line %1,</source>
        <translation>Die Datei, Zeile %1,</translation>
    </message>
    <message>
        <source>The file</source>
        <translation>Die Datei</translation>
    </message>
    <message>
        <source>“%1”, line %2,</source>
        <translation>„%1“, Zeile %2,</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>%1 of profile %2</source>
        <translation>%1 von Profil %2</translation>
    </message>
    <message>
        <source>The folder of %1 does not exist.</source>
        <translation>Den Ordner von %1 gibt es nicht.</translation>
    </message>
    <message>
        <source>%1 belongs to boards of the family “%2”, which this program does not know.</source>
        <translation>%1 gehört zu Boards der Familie „%2“, die dieses Programm nicht kennt.</translation>
    </message>
    <message>
        <source>%1: “%2” is not understood; expected: %3.</source>
        <translation>%1: „%2“ wird nicht verstanden; erwartet: %3.</translation>
    </message>
    <message>
        <source>a list of unwritten edits</source>
        <translation>eine Liste ungeschriebener Änderungen</translation>
    </message>
    <message>
        <source>Unwritten edits of an earlier run cannot be restored from it.</source>
        <translation>Ungeschriebene Änderungen eines früheren Laufs lassen sich daraus nicht wiederherstellen.</translation>
    </message>
    <message>
        <source>%1: %2 stands there twice, first in line %3.</source>
        <translation>%1: %2 steht dort zweimal, zuerst in Zeile %3.</translation>
    </message>
    <message>
        <source>Remove the one that is wrong, or use another copy.</source>
        <translation>Den falschen Eintrag entfernen oder eine andere Kopie verwenden.</translation>
    </message>
    <message>
        <source>a firmware</source>
        <translation>eine Firmware</translation>
    </message>
</context>
<context>
    <name>FilterCurve</name>
    <message>
        <source>Takes out %1 dB at %2 Hz; drawn from %3 to %4 Hz</source>
        <translation>Nimmt %1 dB bei %2 Hz weg; gezeichnet von %3 bis %4 Hz</translation>
    </message>
    <message>
        <source>Not in use</source>
        <translation>Nicht in Gebrauch</translation>
    </message>
</context>
<context>
    <name>FilterRows</name>
    <message>
        <source>In use</source>
        <translation>In Gebrauch</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Frequenz, Hz</translation>
    </message>
    <message>
        <source>Width, Hz</source>
        <translation>Breite, Hz</translation>
    </message>
    <message>
        <source>Depth, dB</source>
        <translation>Tiefe, dB</translation>
    </message>
    <message>
        <source>%1, notch %2</source>
        <translation>%1, Kerbfilter %2</translation>
    </message>
    <message>
        <source>Use this filter</source>
        <translation>Diesen Filter benutzen</translation>
    </message>
    <message>
        <source>No effect while this filter is not in use.</source>
        <translation>Ohne Wirkung, solange dieser Filter nicht in Gebrauch ist.</translation>
    </message>
</context>
<context>
    <name>FirmwareCard</name>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Datei wählen…</translation>
    </message>
    <message>
        <source>Upload…</source>
        <translation>Hochladen…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Replaces the drone&apos;s program and restarts it. The drone tests nothing but the checksum: a file for another board ends it for good.</source>
        <translation>Ersetzt das Programm der Drohne und startet sie neu. Die Drohne prüft nichts als die Prüfsumme: Eine Datei für ein anderes Board beendet sie für immer.</translation>
    </message>
    <message>
        <source>Progress of the upload</source>
        <translation>Fortschritt des Hochladens</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>No file is chosen.</source>
        <translation>Keine Datei gewählt.</translation>
    </message>
    <message>
        <source>%1, checksum %2</source>
        <translation>%1, Prüfsumme %2</translation>
    </message>
    <message>
        <source>All of it is on the drone, which replaces its program and restarts. That cannot be called back and takes up to a minute: do not switch it off.</source>
        <translation>Alles ist auf der Drohne, die ihr Programm ersetzt und neu startet. Das lässt sich nicht zurückrufen und dauert bis zu einer Minute: nicht ausschalten.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>✓ The drone is back with firmware %1 (before: %2). Calibrate it before it flies.</source>
        <translation>✓ Die Drohne ist mit Firmware %1 zurück (vorher: %2). Vor dem Flug kalibrieren.</translation>
    </message>
    <message>
        <source>⚠ The drone is back and tells the same version as before, %1: whether it runs the new firmware is not known.</source>
        <translation>⚠ Die Drohne ist zurück und meldet dieselbe Version wie vorher, %1: Ob sie mit der neuen Firmware läuft, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Its data stream stays silent until it is restarted: switch it off and on.</source>
        <translation>Ihr Datenstrom schweigt, bis sie neu gestartet wird: aus- und einschalten.</translation>
    </message>
    <message>
        <source>✖ The drone was not seen to restart with the new firmware.</source>
        <translation>✖ Die Drohne ist nicht mit der neuen Firmware neu gestartet, soweit zu sehen war.</translation>
    </message>
    <message>
        <source>⚠ The upload was cancelled; the drone runs the firmware that it had.</source>
        <translation>⚠ Das Hochladen wurde abgebrochen; die Drohne läuft mit der Firmware, die sie hatte.</translation>
    </message>
    <message>
        <source>✖ The upload has failed; the drone runs the firmware that it had.</source>
        <translation>✖ Das Hochladen ist misslungen; die Drohne läuft mit der Firmware, die sie hatte.</translation>
    </message>
    <message>
        <source>The firmware was not replaced as far as is known.</source>
        <translation>Die Firmware wurde nicht ersetzt, soweit bekannt.</translation>
    </message>
    <message>
        <source>The drone runs the firmware that it had.</source>
        <translation>Die Drohne läuft mit der Firmware, die sie hatte.</translation>
    </message>
    <message>
        <source>It refused a piece and may have taken its bytes for commands, arming included: keep clear, and look at its state.</source>
        <translation>Sie hat ein Stück abgelehnt und kann seine Bytes für Befehle gehalten haben, auch für das Scharfschalten: Abstand halten und auf ihren Zustand sehen.</translation>
    </message>
    <message>
        <source>✖ Not begun: the battery is low (%1 V). A drone that loses its power while its program is replaced does not start any more. Charge or change the battery first.</source>
        <translation>✖ Nicht begonnen: Der Akku ist schwach (%1 V). Eine Drohne, die den Strom verliert, während ihr Programm ersetzt wird, startet nicht mehr. Laden oder tauschen Sie zuerst den Akku.</translation>
    </message>
</context>
<context>
    <name>FirmwareText</name>
    <message numerus="yes">
        <source>%n parameter(s)</source>
        <translation>
            <numerusform>%n Parameter</numerusform>
            <numerusform>%n Parameter</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n action(s)</source>
        <translation>
            <numerusform>%n Aktion</numerusform>
            <numerusform>%n Aktionen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n live variable(s)</source>
        <translation>
            <numerusform>%n Live-Variable</numerusform>
            <numerusform>%n Live-Variablen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n way(s) of steering</source>
        <translation>
            <numerusform>%n Steuerart</numerusform>
            <numerusform>%n Steuerarten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stream(s)</source>
        <translation>
            <numerusform>%n Datenstrom</numerusform>
            <numerusform>%n Datenströme</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n channel(s) of live data</source>
        <translation>
            <numerusform>%n Kanal mit Live-Daten</numerusform>
            <numerusform>%n Kanäle mit Live-Daten</numerusform>
        </translation>
    </message>
    <message>
        <source>Newer firmware would bring: %1.</source>
        <translation>Neuere Firmware brächte: %1.</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message numerus="yes">
        <source>%n parameter(s) no longer</source>
        <translation>
            <numerusform>%n Parameter nicht mehr</numerusform>
            <numerusform>%n Parameter nicht mehr</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FlightOverview</name>
    <message>
        <source>%1 % (reported: %2)</source>
        <translation>%1 % (gemeldet: %2)</translation>
    </message>
    <message>
        <source>Attitude of the drone</source>
        <translation>Lage der Drohne</translation>
    </message>
    <message>
        <source>Attitude and heading</source>
        <translation>Lage und Kurs</translation>
    </message>
    <message>
        <source>Drawn as the drone tells it. Which sign leans which way is not established: tilt it by hand and compare.</source>
        <translation>Gezeichnet, wie die Drohne es meldet. Welches Vorzeichen sich wohin neigt, ist nicht gesichert: von Hand kippen und vergleichen.</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>What the drone commands, not what turns. Signs as in its mixing; which side is the front is not established.</source>
        <translation>Was die Drohne befiehlt, nicht was sich dreht. Vorzeichen wie in ihrer Mischung; welche Seite vorne ist, ist nicht gesichert.</translation>
    </message>
    <message>
        <source>Battery level</source>
        <translation>Akkustand</translation>
    </message>
    <message>
        <source>Charge drawn</source>
        <translation>Entnommene Ladung</translation>
    </message>
    <message>
        <source>Processor load</source>
        <translation>Prozessorlast</translation>
    </message>
    <message>
        <source>Processor temperature</source>
        <translation>Prozessortemperatur</translation>
    </message>
    <message>
        <source>Control loop</source>
        <translation>Regelschleife</translation>
    </message>
    <message>
        <source>per second</source>
        <translation>pro Sekunde</translation>
    </message>
    <message>
        <source>Drone receives</source>
        <translation>Empfang der Drohne</translation>
    </message>
    <message>
        <source>Level at the drone</source>
        <translation>Pegel an der Drohne</translation>
    </message>
    <message>
        <source>not known (reported: %1)</source>
        <translation>unbekannt (gemeldet: %1)</translation>
    </message>
    <message>
        <source>Calibrate (Actions)…</source>
        <translation>Kalibrieren (Aktionen)…</translation>
    </message>
    <message>
        <source>Drawn as the check of directions has found it (Flight).</source>
        <translation>Gezeichnet, wie die Prüfung der Richtungen es gefunden hat (Flug).</translation>
    </message>
    <message>
        <source>What the drone commands, not what turns. Seen from above, as the check of directions has found it.</source>
        <translation>Was die Drohne befiehlt, nicht was dreht. Von oben gesehen, wie die Prüfung der Richtungen es ergeben hat.</translation>
    </message>
</context>
<context>
    <name>FlightPage</name>
    <message>
        <source>Flight</source>
        <translation>Flug</translation>
    </message>
    <message>
        <source>Set values while it is armed</source>
        <translation>Werte in scharfem Zustand setzen</translation>
    </message>
    <message>
        <source>Hold to arm</source>
        <translation>Halten zum Scharfschalten</translation>
    </message>
    <message>
        <source>■ Disarm</source>
        <translation>■ Entschärfen</translation>
    </message>
    <message>
        <source>Steer with a gamepad</source>
        <translation>Mit einem Gamepad steuern</translation>
    </message>
    <message>
        <source>For experts, in a test stand: gains that are set go to the drone while its motors turn. Without it, setting one disarms first.</source>
        <translation>Für Erfahrene, im Teststand: Reglerwerte gehen zur Drohne, während ihre Motoren drehen. Ohne das entschärft das Setzen zuerst.</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>How long the key has been held</source>
        <translation>Wie lange die Taste gehalten wurde</translation>
    </message>
    <message>
        <source>Hold it for a second, with the throttle at zero. It arms the motors.</source>
        <translation>Eine Sekunde lang halten, mit dem Gas auf null. Das schaltet die Motoren scharf.</translation>
    </message>
    <message>
        <source>Stops the motors: in flight it falls. The space bar does the same.</source>
        <translation>Hält die Motoren an: Im Flug fällt sie. Die Leertaste tut dasselbe.</translation>
    </message>
    <message>
        <source>Attitude</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>Throttle</source>
        <translation>Gas</translation>
    </message>
    <message>
        <source>Sticks</source>
        <translation>Knüppel</translation>
    </message>
    <message>
        <source>Not armed: %1</source>
        <translation>Nicht scharf geschaltet: %1</translation>
    </message>
    <message>
        <source>Not opened: %1</source>
        <translation>Nicht geöffnet: %1</translation>
    </message>
    <message>
        <source>Open a control session?</source>
        <translation>Eine Steuersitzung öffnen?</translation>
    </message>
    <message>
        <source>From then on this program can arm the drone and turn its motors. Stopping them, by the button STOP MOTORS, F12 or the space bar, makes it fall. Nobody may be within reach of a propeller.</source>
        <translation>Von da an kann dieses Programm die Drohne scharf schalten und ihre Motoren drehen. Wer sie anhält, mit dem Knopf MOTOREN STOPPEN, F12 oder der Leertaste, lässt sie fallen. Niemand darf in Reichweite eines Propellers sein.</translation>
    </message>
    <message>
        <source>The propellers are off</source>
        <translation>Die Propeller sind abgenommen</translation>
    </message>
    <message>
        <source>It is held in a test stand</source>
        <translation>Sie wird in einem Teststand gehalten</translation>
    </message>
    <message>
        <source>Do not open</source>
        <translation>Nicht öffnen</translation>
    </message>
    <message>
        <source>Set values while it is armed?</source>
        <translation>Werte in scharfem Zustand setzen?</translation>
    </message>
    <message>
        <source>A wrong gain makes it swing at once, with its propellers turning. Only in a test stand that holds it, with nobody near.</source>
        <translation>Ein falscher Reglerwert lässt sie sofort schwingen, mit drehenden Propellern. Nur in einem Teststand, der sie hält, und wenn niemand in der Nähe ist.</translation>
    </message>
    <message>
        <source>It is held: allow it</source>
        <translation>Sie wird gehalten: erlauben</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>Close the control session</source>
        <translation>Steuersitzung schließen</translation>
    </message>
    <message>
        <source>Open a control session…</source>
        <translation>Steuersitzung öffnen…</translation>
    </message>
    <message>
        <source>No drone is connected.</source>
        <translation>Keine Drohne ist verbunden.</translation>
    </message>
    <message>
        <source>Nothing is sent that steers. Open a control session to arm it from here.</source>
        <translation>Es wird nichts gesendet, was steuert. Um sie von hier scharf zu schalten, eine Steuersitzung öffnen.</translation>
    </message>
    <message>
        <source>Keep holding: it arms after a second.</source>
        <translation>Weiter halten: Nach einer Sekunde wird sie scharf.</translation>
    </message>
    <message>
        <source>It is told to arm.</source>
        <translation>Sie wird scharf geschaltet.</translation>
    </message>
    <message>
        <source>Ready: hold the key for a second to arm it.</source>
        <translation>Bereit: Zum Scharfschalten die Taste eine Sekunde lang halten.</translation>
    </message>
    <message>
        <source>It cannot be armed: %1</source>
        <translation>Sie kann nicht scharf geschaltet werden: %1</translation>
    </message>
    <message>
        <source>there is no link.</source>
        <translation>Es gibt keine Verbindung.</translation>
    </message>
    <message>
        <source>nothing has come from it for a second.</source>
        <translation>Seit einer Sekunde kommt nichts von ihr.</translation>
    </message>
    <message>
        <source>it does not say whether it is armed.</source>
        <translation>Sie sagt nicht, ob sie scharf ist.</translation>
    </message>
    <message>
        <source>its directions have not been checked.</source>
        <translation>Ihre Richtungen sind nicht geprüft.</translation>
    </message>
    <message>
        <source>no control session is open.</source>
        <translation>Keine Steuersitzung ist offen.</translation>
    </message>
    <message>
        <source>it is calibrating.</source>
        <translation>Sie kalibriert gerade.</translation>
    </message>
    <message>
        <source>it is armed already, and not from here.</source>
        <translation>Sie ist schon scharf, und nicht von hier.</translation>
    </message>
    <message>
        <source>its motors are driven although it is disarmed.</source>
        <translation>Ihre Motoren werden angetrieben, obwohl sie entschärft ist.</translation>
    </message>
    <message>
        <source>it is at work: a procedure or a write runs.</source>
        <translation>Sie arbeitet: Ein Ablauf oder ein Schreiben läuft.</translation>
    </message>
    <message>
        <source>its motors are being stopped, and it has not confirmed that.</source>
        <translation>Ihre Motoren werden angehalten, und sie hat das nicht bestätigt.</translation>
    </message>
    <message>
        <source>the throttle is not at zero.</source>
        <translation>Das Gas steht nicht auf null.</translation>
    </message>
    <message>
        <source>the sticks have told nothing for a quarter of a second.</source>
        <translation>Von den Knüppeln kam eine Viertelsekunde lang nichts.</translation>
    </message>
    <message>
        <source>by you.</source>
        <translation>von Ihnen.</translation>
    </message>
    <message>
        <source>it was told to arm, and did not say that it is armed.</source>
        <translation>Sie sollte scharf werden und hat nicht gesagt, dass sie es ist.</translation>
    </message>
    <message>
        <source>it says so itself, and nobody told it to from here.</source>
        <translation>Sie sagt es selbst, und von hier hat es niemand befohlen.</translation>
    </message>
    <message>
        <source>the window was not in front any more.</source>
        <translation>Das Fenster war nicht mehr vorn.</translation>
    </message>
    <message>
        <source>this page was not seen any more.</source>
        <translation>Diese Seite war nicht mehr zu sehen.</translation>
    </message>
    <message>
        <source>the screen was locked.</source>
        <translation>Der Bildschirm wurde gesperrt.</translation>
    </message>
    <message>
        <source>nothing was moved for too long.</source>
        <translation>Zu lange wurde nichts bewegt.</translation>
    </message>
    <message>
        <source>the motors were stopped.</source>
        <translation>Die Motoren wurden angehalten.</translation>
    </message>
    <message>
        <source>values are being set.</source>
        <translation>Werte werden gesetzt.</translation>
    </message>
    <message>
        <source>this program did not send in time.</source>
        <translation>Dieses Programm hat nicht rechtzeitig gesendet.</translation>
    </message>
    <message>
        <source>an error occurred.</source>
        <translation>Ein Fehler ist aufgetreten.</translation>
    </message>
    <message>
        <source>Keys: W and S throttle, A and D yaw, arrows roll and pitch, space disarms.</source>
        <translation>Tasten: W und S Gas, A und D Yaw, Pfeile Roll und Pitch, Leertaste entschärft.</translation>
    </message>
    <message>
        <source>If it is unplugged or falls silent, the drone is disarmed. Its sticks are assigned on the page “Gamepad”.</source>
        <translation>Wird es abgezogen oder verstummt es, wird die Drohne entschärft. Seine Knüppel werden auf der Seite „Gamepad“ zugeordnet.</translation>
    </message>
    <message>
        <source>Calibrate (Actions)…</source>
        <translation>Kalibrieren (Aktionen)…</translation>
    </message>
    <message>
        <source>it is not calibrated.</source>
        <translation>Sie ist nicht kalibriert.</translation>
    </message>
    <message>
        <source>Control has ended: %1</source>
        <translation>Steuerung beendet: %1</translation>
    </message>
    <message>
        <source>the check of its directions is over.</source>
        <translation>die Prüfung ihrer Richtungen ist zu Ende.</translation>
    </message>
    <message>
        <source>Not armed: no button of the gamepad disarms. Assign one on the page “Gamepad”.</source>
        <translation>Nicht scharf geschaltet: kein Knopf des Gamepads entschärft. Weisen Sie auf der Seite „Gamepad“ einen zu.</translation>
    </message>
    <message>
        <source>a stick is not in its middle.</source>
        <translation>ein Knüppel ist nicht in seiner Mitte.</translation>
    </message>
    <message>
        <source>the gamepad has no stick for throttle, roll, pitch or yaw. Assign it on the page “Gamepad”.</source>
        <translation>dem Gamepad fehlt ein Knüppel für Gas, Roll, Pitch oder Yaw. Weisen Sie ihn auf der Seite „Gamepad“ zu.</translation>
    </message>
    <message>
        <source>another ground station talks to it.</source>
        <translation>eine andere Bodenstation spricht mit ihr.</translation>
    </message>
    <message>
        <source>its directions have not been checked with these sticks as they are assigned now.</source>
        <translation>seine Richtungen sind mit diesen Sticks, wie sie jetzt zugewiesen sind, nicht geprüft.</translation>
    </message>
    <message>
        <source>the process that stops it if this program dies (gimbalguard, in this program&apos;s folder) has not started, or has ended.</source>
        <translation>der Prozess, der sie stoppt, wenn dieses Programm abbricht (gimbalguard, im Ordner dieses Programms), ist nicht gestartet oder hat geendet.</translation>
    </message>
    <message>
        <source>its battery is below the limit of the alarm.</source>
        <translation>ihr Akku ist unter der Grenze des Alarms.</translation>
    </message>
    <message>
        <source>it is tilted by more than %1°. Put it level, or hold it in a test stand.</source>
        <translation>sie ist um mehr als %1° geneigt. Stellen Sie sie waagerecht, oder halten Sie sie in einem Teststand.</translation>
    </message>
    <message>
        <source>Armed from here. Leaving this page or window, a question, list or text field that takes the sticks’ place, a lost link and %1 s without a movement disarm it.</source>
        <translation>Von hier scharf geschaltet. Das Verlassen dieser Seite oder dieses Fensters, eine Frage, eine Liste oder ein Textfeld an Stelle der Knüppel, eine verlorene Verbindung und %1 s ohne eine Bewegung entschärfen sie.</translation>
    </message>
    <message>
        <source>nobody has said that it is “%1”, whose directions were checked: another drone may look the same.</source>
        <translation>niemand hat gesagt, dass es „%1“ ist, deren Richtungen geprüft wurden: Eine andere Drohne kann gleich aussehen.</translation>
    </message>
    <message>
        <source>a question, a list or a text field has taken the sticks’ place.</source>
        <translation>Eine Frage, eine Liste oder ein Textfeld ist an die Stelle der Knüppel getreten.</translation>
    </message>
    <message>
        <source>Leave it off</source>
        <translation>Ausgeschaltet lassen</translation>
    </message>
    <message>
        <source>it was armed from here, and does not say that it is disarmed.</source>
        <translation>sie wurde von hier scharf geschaltet und meldet nicht, dass sie entschärft ist.</translation>
    </message>
</context>
<context>
    <name>FootBar</name>
    <message>
        <source>No unwritten changes</source>
        <translation>Keine ungeschriebenen Änderungen</translation>
    </message>
    <message>
        <source>No unwritten changes; whether all that is in use is stored is not known (Tuning compares)</source>
        <translation>Keine ungeschriebenen Änderungen; ob alles gespeichert ist, was in Gebrauch ist, ist nicht bekannt („Abstimmen“ vergleicht)</translation>
    </message>
</context>
<context>
    <name>FrameLogModel</name>
    <message>
        <source>Payload</source>
        <translation>Nutzdaten</translation>
    </message>
    <message>
        <source>Complete frames</source>
        <translation>Ganze Frames</translation>
    </message>
    <message>
        <source>← board</source>
        <translation>← Board</translation>
    </message>
    <message>
        <source>→ board</source>
        <translation>→ Board</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Frame</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>Link ended</source>
        <translation>Verbindung beendet</translation>
    </message>
    <message>
        <source>New link</source>
        <translation>Neue Verbindung</translation>
    </message>
    <message>
        <source>Link lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Verbunden</translation>
    </message>
    <message>
        <source>Board restarts</source>
        <translation>Das Board startet neu</translation>
    </message>
</context>
<context>
    <name>Freshness</name>
    <message>
        <source>No data since %1</source>
        <translation>Keine Daten seit %1</translation>
    </message>
    <message>
        <source>The board sees no sensor</source>
        <translation>Das Board sieht keinen Sensor</translation>
    </message>
    <message>
        <source>Unchanged since %1</source>
        <translation>Unverändert seit %1</translation>
    </message>
    <message>
        <source>Not told before a calibration</source>
        <translation>Erst nach Kalibrierung</translation>
    </message>
</context>
<context>
    <name>FunctionsCard</name>
    <message>
        <source>Functions</source>
        <translation>Funktionen</translation>
    </message>
</context>
<context>
    <name>GainCard</name>
    <message>
        <source>Simplified tuning</source>
        <translation>Vereinfachte Abstimmung</translation>
    </message>
    <message>
        <source>f₀ = √(Ki/Kd) / 2π, d = Kp / (2 √(Kd·Ki)), τ = 1570.8 ms / (1 + Ki)</source>
        <translation>f₀ = √(Ki/Kd) / 2π, d = Kp / (2 √(Kd·Ki)), τ = 1570,8 ms / (1 + Ki)</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Stability</source>
        <translation>Stabilität</translation>
    </message>
    <message>
        <source>Moving a slider sets all three gains: Kd = 0.8 · D/100, Ki = 2000 · S/100, Kp = √(0.5 · Kd · Ki).</source>
        <translation>Ein Regler setzt alle drei Verstärkungen: Kd = 0,8 · D/100, Ki = 2000 · S/100, Kp = √(0,5 · Kd · Ki).</translation>
    </message>
    <message>
        <source>f₀ %1 Hz · d %2 · τ %3 ms</source>
        <translation>f₀ %1 Hz · d %2 · τ %3 ms</translation>
    </message>
</context>
<context>
    <name>GamepadPage</name>
    <message>
        <source>Throttle</source>
        <translation>Gas</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Roll</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Pitch</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Yaw</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Arm (held for a second)</source>
        <translation>Scharf schalten (eine Sekunde halten)</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Entschärfen</translation>
    </message>
    <message>
        <source>To the middle</source>
        <translation>Zur Mitte</translation>
    </message>
    <message>
        <source>Push the stick for the throttle from the bottom all the way up.</source>
        <translation>Schieben Sie den Knüppel für das Gas von ganz unten nach ganz oben.</translation>
    </message>
    <message>
        <source>Push the stick for roll all the way to the right.</source>
        <translation>Drücken Sie den Knüppel für Roll ganz nach rechts.</translation>
    </message>
    <message>
        <source>Push the stick for pitch all the way forward.</source>
        <translation>Drücken Sie den Knüppel für Pitch ganz nach vorn.</translation>
    </message>
    <message>
        <source>Push the stick for yaw all the way to the right.</source>
        <translation>Drücken Sie den Knüppel für Yaw ganz nach rechts.</translation>
    </message>
    <message>
        <source>Push the stick, lever or trigger for the speed all the way to fast.</source>
        <translation>Drücken Sie Knüppel, Hebel oder Trigger für das Tempo ganz auf schnell.</translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation>Gamepad</translation>
    </message>
    <message>
        <source>Assign all sticks</source>
        <translation>Alle Knüppel zuordnen</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Gamepad to use</source>
        <translation>Gamepad, das steuert</translation>
    </message>
    <message>
        <source>Sticks</source>
        <translation>Knüppel</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Totbereich</translation>
    </message>
    <message>
        <source>Expo</source>
        <translation>Expo</translation>
    </message>
    <message>
        <source>Expo makes a stick gentler around its rest; its end stays where it is. Throttle is for drones, speed for gimbals.</source>
        <translation>Expo macht einen Knüppel um die Ruhelage sanfter; sein Ende bleibt, wo es ist. Gas ist für Drohnen, Tempo für Gimbals.</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>%1: inverted</source>
        <translation>%1: umgekehrt</translation>
    </message>
    <message>
        <source>%1: dead band</source>
        <translation>%1: Totbereich</translation>
    </message>
    <message>
        <source>%1: expo</source>
        <translation>%1: Expo</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Zuordnen</translation>
    </message>
    <message>
        <source>Assign %1</source>
        <translation>%1 zuordnen</translation>
    </message>
    <message>
        <source>not assigned</source>
        <translation>nicht zugeordnet</translation>
    </message>
    <message>
        <source>button %1: pressed</source>
        <translation>Taste %1: gedrückt</translation>
    </message>
    <message>
        <source>button %1</source>
        <translation>Taste %1</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>Let go of all sticks and buttons, and pull a throttle that stays down.</source>
        <translation>Lassen Sie alle Knüppel und Tasten los, und ziehen Sie einen Gasknüppel, der stehen bleibt, ganz nach unten.</translation>
    </message>
    <message>
        <source>Press the button for: %1.</source>
        <translation>Drücken Sie die Taste für: %1.</translation>
    </message>
    <message>
        <source>Gamepads cannot be read: %1. Everything else works without. Install the program&apos;s module for gamepads and SDL 2, then open this page again.</source>
        <translation>Gamepads können nicht gelesen werden: %1. Alles andere geht ohne. Installieren Sie das Gamepad-Modul des Programms und SDL 2, und öffnen Sie diese Seite dann noch einmal.</translation>
    </message>
    <message>
        <source>No gamepad is plugged in. Plug one in, it is found by itself.</source>
        <translation>Kein Gamepad ist eingesteckt. Stecken Sie eines ein, es wird von selbst gefunden.</translation>
    </message>
    <message>
        <source>%1 is not heard of any more. Plug it out and in again.</source>
        <translation>Von %1 ist nichts mehr zu hören. Ziehen Sie es ab, und stecken Sie es wieder ein.</translation>
    </message>
    <message>
        <source>%1 is plugged in. Its sticks steer nothing until they are assigned.</source>
        <translation>%1 ist eingesteckt. Seine Knüppel steuern nichts, bevor sie zugeordnet sind.</translation>
    </message>
    <message>
        <source>%1 is ready. It steers only where you arm with it.</source>
        <translation>%1 ist bereit. Es steuert nur dort, wo Sie mit ihm scharf schalten.</translation>
    </message>
    <message>
        <source>Use the default</source>
        <translation>Vorgabe verwenden</translation>
    </message>
    <message>
        <source>Forgets what was assigned for this kind of gamepad</source>
        <translation>Vergisst, was für diese Bauart zugeordnet wurde</translation>
    </message>
    <message>
        <source>%1 is ready with the default for drones: left stick throttle and yaw, right stick roll and pitch. The throttle counts from the stick&apos;s middle up: let go, it is zero. Assign sticks to change that. It steers only where you arm with it.</source>
        <translation>%1 ist bereit, mit der Vorgabe für Drohnen: linker Knüppel Gas und Yaw, rechter Roll und Pitch. Das Gas zählt von der Mitte des Knüppels aufwärts: losgelassen ist es null. Wer es anders will, ordnet Knüppel zu. Es steuert nur dort, wo Sie mit ihm scharf schalten.</translation>
    </message>
    <message>
        <source>%1 is ready with the default for gimbals: the right stick pans and tilts. Assign sticks to change that. It steers only where you arm with it.</source>
        <translation>%1 ist bereit, mit der Vorgabe für Gimbals: der rechte Knüppel schwenkt und neigt. Wer es anders will, ordnet Knüppel zu. Es steuert nur dort, wo Sie mit ihm scharf schalten.</translation>
    </message>
</context>
<context>
    <name>GamepadSteering</name>
    <message>
        <source>Gamepad</source>
        <translation>Gamepad</translation>
    </message>
    <message>
        <source>A gamepad steers while armed. Its sticks are assigned on the page “Gamepad”.</source>
        <translation>Ein Gamepad steuert, solange scharf geschaltet ist. Seine Knüppel werden auf der Seite „Gamepad“ zugeordnet.</translation>
    </message>
    <message>
        <source>Control was disarmed: the gamepad was switched off.</source>
        <translation>Die Steuerung wurde entschärft: Das Gamepad wurde abgewählt.</translation>
    </message>
    <message>
        <source>Not armed: a stick of the gamepad is not at rest. Let go of it, then arm.</source>
        <translation>Nicht scharf: Ein Knüppel des Gamepads ist nicht in Ruhe. Lassen Sie ihn los, und schalten Sie dann scharf.</translation>
    </message>
    <message>
        <source>Control was disarmed: the gamepad has not been heard of for a quarter of a second. Plug it out and in again.</source>
        <translation>Die Steuerung wurde entschärft: Vom Gamepad war eine Viertelsekunde nichts zu hören. Ziehen Sie es ab, und stecken Sie es wieder ein.</translation>
    </message>
    <message>
        <source>Control was disarmed: the gamepad is gone. Plug it in, then arm again.</source>
        <translation>Die Steuerung wurde entschärft: Das Gamepad ist weg. Stecken Sie es ein, und schalten Sie dann wieder scharf.</translation>
    </message>
    <message>
        <source>Gamepads cannot be read: %1. The page “Gamepad” says more.</source>
        <translation>Gamepads können nicht gelesen werden: %1. Mehr dazu auf der Seite „Gamepad“.</translation>
    </message>
    <message>
        <source>No gamepad is plugged in.</source>
        <translation>Kein Gamepad ist eingesteckt.</translation>
    </message>
    <message>
        <source>%1 is not heard of.</source>
        <translation>Von %1 ist nichts zu hören.</translation>
    </message>
    <message>
        <source>%1 is there, but its sticks are not assigned yet. Do that on the page “Gamepad”.</source>
        <translation>%1 ist da, aber seine Knüppel sind noch nicht zugeordnet. Das geht auf der Seite „Gamepad“.</translation>
    </message>
    <message>
        <source>%1 steers.</source>
        <translation>%1 steuert.</translation>
    </message>
    <message>
        <source>%1 steers from the next arming on.</source>
        <translation>%1 steuert ab dem nächsten Scharfschalten.</translation>
    </message>
    <message>
        <source>%1 steers from the next arming on, with the default assignment (page “Gamepad”).</source>
        <translation>%1 steuert ab dem nächsten Scharfschalten, mit der vorgegebenen Zuordnung (Seite „Gamepad“).</translation>
    </message>
</context>
<context>
    <name>GimbalView</name>
    <message>
        <source>The gimbal as a body</source>
        <translation>Der Gimbal als Körper</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Keine Daten</translation>
    </message>
    <message>
        <source>The camera has %1; the frame has %2.</source>
        <translation>Die Kamera hat %1; der Rahmen hat %2.</translation>
    </message>
    <message>
        <source>The camera has %1; nobody measures the frame.</source>
        <translation>Die Kamera hat %1; den Rahmen misst niemand.</translation>
    </message>
    <message>
        <source>No attitude yet</source>
        <translation>Noch keine Lage</translation>
    </message>
    <message>
        <source>The frame is not measured</source>
        <translation>Der Rahmen wird nicht gemessen</translation>
    </message>
</context>
<context>
    <name>GuidePage</name>
    <message>
        <source>Leave out</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>From the beginning…</source>
        <translation>Von vorn beginnen…</translation>
    </message>
    <message>
        <source>Certificate…</source>
        <translation>Zertifikat…</translation>
    </message>
    <message>
        <source>One page with all that was measured and set, and what was left out.</source>
        <translation>Eine Seite mit allem, was gemessen und eingestellt wurde, und was ausgelassen ist.</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>What the step finds appears here.</source>
        <translation>Hier erscheint, was der Schritt findet.</translation>
    </message>
    <message>
        <source>Save the certificate</source>
        <translation>Zertifikat sichern</translation>
    </message>
    <message>
        <source>PDF files (*.pdf);;Web pages (*.html)</source>
        <translation>PDF-Dateien (*.pdf);;Webseiten (*.html)</translation>
    </message>
    <message>
        <source>Progress of the step</source>
        <translation>Fortschritt des Schritts</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 von %2: %3</translation>
    </message>
    <message>
        <source>Before it: %1</source>
        <translation>Vorher: %1</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Aktionen</translation>
    </message>
    <message>
        <source>Auto-tune</source>
        <translation>Auto-Abstimmung</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>The settings as they were are kept in Backups.</source>
        <translation>Die Einstellungen, wie sie waren, liegen unter „Sicherungen“.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Tick what has to be so first.</source>
        <translation>Haken Sie zuerst an, was so sein muss.</translation>
    </message>
    <message>
        <source>“%1” is done. Next: %2.</source>
        <translation>„%1“ ist erledigt. Als Nächstes: %2.</translation>
    </message>
    <message>
        <source>Every step is done or left out: save the certificate.</source>
        <translation>Jeder Schritt ist erledigt oder ausgelassen: sichern Sie das Zertifikat.</translation>
    </message>
    <message>
        <source>Begin the set-up anew?</source>
        <translation>Die Einrichtung von vorn beginnen?</translation>
    </message>
    <message>
        <source>What was found so far is forgotten. The board stays as it is.</source>
        <translation>Was bisher gefunden ist, wird vergessen. Das Board bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>Forget it</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Go on as it is</source>
        <translation>Weitermachen wie bisher</translation>
    </message>
    <message>
        <source>What the hand does with the camera</source>
        <translation>Was die Hand mit der Kamera tut</translation>
    </message>
    <message>
        <source>camera: let go</source>
        <translation>Kamera: losgelassen</translation>
    </message>
    <message>
        <source>camera: held level</source>
        <translation>Kamera: waagerecht gehalten</translation>
    </message>
    <message>
        <source>camera: moved as far as it goes</source>
        <translation>Kamera: so weit bewegt, wie es geht</translation>
    </message>
    <message>
        <source>Where the frame is</source>
        <translation>Wo der Rahmen ist</translation>
    </message>
    <message>
        <source>frame: in your hand</source>
        <translation>Rahmen: in Ihrer Hand</translation>
    </message>
    <message>
        <source>frame: on a stand</source>
        <translation>Rahmen: auf einem Stativ</translation>
    </message>
    <message>
        <source>How the camera is mounted</source>
        <translation>Wie die Kamera montiert ist</translation>
    </message>
    <message>
        <source>camera: far out of balance</source>
        <translation>Kamera: weit außer Balance</translation>
    </message>
    <message>
        <source>camera: balanced on its plate</source>
        <translation>Kamera: auf ihrer Platte ausbalanciert</translation>
    </message>
    <message>
        <source>Gimbal setup</source>
        <translation>Gimbal einrichten</translation>
    </message>
    <message>
        <source>Steps before it are open: %1.</source>
        <translation>Schritte davor sind offen: %1.</translation>
    </message>
    <message>
        <source>More about it: %1…</source>
        <translation>Mehr dazu: %1…</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Weiter: %1</translation>
    </message>
    <message>
        <source>It was cancelled.</source>
        <translation>Es wurde abgebrochen.</translation>
    </message>
    <message>
        <source>A simulated gimbal.</source>
        <translation>Ein simulierter Gimbal.</translation>
    </message>
    <message>
        <source>“%1” was cancelled: its page was left.</source>
        <translation>„%1“ wurde abgebrochen: die Seite wurde verlassen.</translation>
    </message>
    <message>
        <source>camera: right side down</source>
        <translation>Kamera: rechte Seite nach unten</translation>
    </message>
    <message>
        <source>camera: nose down</source>
        <translation>Kamera: Nase nach unten</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
</context>
<context>
    <name>HelpCard</name>
    <message>
        <source>What a value does</source>
        <translation>Was ein Wert bewirkt</translation>
    </message>
    <message>
        <source>Choose a field to see its effect, range, default and the value on the board here.</source>
        <translation>Wählen Sie ein Feld: Wirkung, Bereich, Vorgabe und was das Board hat, stehen dann hier.</translation>
    </message>
    <message>
        <source>On the board</source>
        <translation>Auf dem Board</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation>Gehört zu</translation>
    </message>
    <message>
        <source>the whole board</source>
        <translation>dem ganzen Board</translation>
    </message>
    <message>
        <source>this profile</source>
        <translation>diesem Profil</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>⚠ Risk: a wrong value can make a motor run away or overheat.</source>
        <translation>⚠ Risiko: ein falscher Wert kann einen Motor durchgehen lassen oder überhitzen.</translation>
    </message>
</context>
<context>
    <name>HelpPage</name>
    <message>
        <source>en</source>
        <comment>folder of the help texts</comment>
        <translation>de</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Search all texts (Ctrl+F)</source>
        <translation>Alle Texte durchsuchen (Strg+F)</translation>
    </message>
    <message>
        <source>Search help</source>
        <translation>Hilfe durchsuchen</translation>
    </message>
    <message>
        <source>Topics</source>
        <translation>Themen</translation>
    </message>
    <message>
        <source>Help text</source>
        <translation>Hilfetext</translation>
    </message>
</context>
<context>
    <name>InputBars</name>
    <message>
        <source>No input has a signal.</source>
        <translation>Kein Eingang hat ein Signal.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>LeapText</name>
    <message>
        <source>%1: %2 is %3 times what the board has, %4</source>
        <translation>%1: %2 ist das %3-Fache dessen, was bisher gilt, %4</translation>
    </message>
    <message>
        <source>%1: %2, where the board has 0</source>
        <translation>%1: %2, wo bisher 0 ist</translation>
    </message>
</context>
<context>
    <name>Leaving</name>
    <message>
        <source>A write is running: the program quits when it has ended.</source>
        <translation>Es wird geschrieben: Das Programm endet, sobald das fertig ist.</translation>
    </message>
    <message>
        <source>A write is running: the link ends when it has ended.</source>
        <translation>Es wird geschrieben: Die Verbindung endet, sobald das fertig ist.</translation>
    </message>
    <message>
        <source>The motors are switched off, then the program quits.</source>
        <translation>Die Motoren werden ausgeschaltet, dann endet das Programm.</translation>
    </message>
    <message>
        <source>The program quits when the board has done its work.</source>
        <translation>Das Programm endet, sobald das Board fertig ist.</translation>
    </message>
    <message>
        <source>The link ends when the board has done its work.</source>
        <translation>Die Verbindung endet, sobald das Board fertig ist.</translation>
    </message>
    <message>
        <source>The board is at work</source>
        <translation>Das Board arbeitet</translation>
    </message>
    <message>
        <source>A calibration, a measurement or another procedure has not ended.</source>
        <translation>Eine Kalibrierung, eine Messung oder ein anderer Vorgang läuft noch.</translation>
    </message>
    <message>
        <source>Wait, then quit</source>
        <translation>Abwarten, dann beenden</translation>
    </message>
    <message>
        <source>Wait, then disconnect</source>
        <translation>Abwarten, dann trennen</translation>
    </message>
    <message>
        <source>Cancel it and quit</source>
        <translation>Abbrechen und beenden</translation>
    </message>
    <message>
        <source>Cancel it and disconnect</source>
        <translation>Abbrechen und trennen</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Bleiben</translation>
    </message>
    <message numerus="yes">
        <source>%n change(s) are not on the board.</source>
        <translation>
            <numerusform>%n Änderung ist nicht auf dem Board.</numerusform>
            <numerusform>%n Änderungen sind nicht auf dem Board.</numerusform>
        </translation>
    </message>
    <message>
        <source>Quit and keep for next time</source>
        <translation>Beenden und fürs nächste Mal aufheben</translation>
    </message>
    <message>
        <source>Discard and quit</source>
        <translation>Verwerfen und beenden</translation>
    </message>
    <message>
        <source>Not stored</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>The board uses values that it has not stored. They are lost when it is switched off.</source>
        <translation>Das Board benutzt Werte, die es nicht gespeichert hat. Beim Ausschalten gehen sie verloren.</translation>
    </message>
    <message>
        <source>Store and quit</source>
        <translation>Speichern und beenden</translation>
    </message>
    <message>
        <source>Store and disconnect</source>
        <translation>Speichern und trennen</translation>
    </message>
    <message>
        <source>Quit without storing</source>
        <translation>Beenden, ohne zu speichern</translation>
    </message>
    <message>
        <source>Disconnect without storing</source>
        <translation>Trennen, ohne zu speichern</translation>
    </message>
    <message>
        <source>The motors may be running</source>
        <translation>Die Motoren laufen vielleicht</translation>
    </message>
    <message>
        <source>The board did not confirm that the motors are off.</source>
        <translation>Das Board hat nicht bestätigt, dass die Motoren aus sind.</translation>
    </message>
    <message>
        <source>Quit all the same</source>
        <translation>Trotzdem beenden</translation>
    </message>
    <message>
        <source>Unwritten changes</source>
        <translation>Ungeschriebene Änderungen</translation>
    </message>
    <message>
        <source>The motors are switched off, then the link ends.</source>
        <translation>Die Motoren werden ausgeschaltet, dann endet die Verbindung.</translation>
    </message>
    <message>
        <source>The motors are running</source>
        <translation>Die Motoren laufen</translation>
    </message>
    <message>
        <source>Without this program they go on running, and nothing watches them or can stop them from here.</source>
        <translation>Ohne dieses Programm laufen sie weiter; nichts überwacht sie, und von hier aus lassen sie sich nicht stoppen.</translation>
    </message>
    <message>
        <source>Stop motors and quit</source>
        <translation>Motoren stoppen und beenden</translation>
    </message>
    <message>
        <source>Stop motors and disconnect</source>
        <translation>Motoren stoppen und trennen</translation>
    </message>
    <message>
        <source>Quit and leave them running</source>
        <translation>Beenden und laufen lassen</translation>
    </message>
    <message>
        <source>Disconnect and leave them running</source>
        <translation>Trennen und laufen lassen</translation>
    </message>
    <message>
        <source>The camera may go on moving</source>
        <translation>Die Kamera bewegt sich vielleicht weiter</translation>
    </message>
    <message>
        <source>The board did not confirm that it has stopped turning the camera.</source>
        <translation>Das Board hat nicht bestätigt, dass es die Kamera nicht mehr dreht.</translation>
    </message>
    <message>
        <source>Disconnect all the same</source>
        <translation>Trotzdem trennen</translation>
    </message>
    <message>
        <source>The drone is armed from here.</source>
        <translation>Die Drohne ist von hier scharf geschaltet.</translation>
    </message>
    <message>
        <source>It would go on with its last throttle, and nobody could stop it from here.</source>
        <translation>Sie würde mit ihrem letzten Gas weiterlaufen, und niemand könnte sie von hier anhalten.</translation>
    </message>
    <message>
        <source>Land it and disarm it first, on the page “Flight”.</source>
        <translation>Zuerst landen und entschärfen, auf der Seite „Flug“.</translation>
    </message>
    <message>
        <source>The drone was armed when it was heard last</source>
        <translation>Die Drohne war scharf, als sie zuletzt gehört wurde</translation>
    </message>
    <message>
        <source>The link is lost. The drone does not notice that: it stays armed and goes on with its last throttle until somebody disarms it or its battery is empty. As long as this program runs it looks for the drone, and disarms it as soon as it is heard.</source>
        <translation>Die Verbindung ist weg. Die Drohne merkt das nicht: Sie bleibt scharf und läuft mit ihrem letzten Gas weiter, bis jemand sie entschärft oder ihr Akku leer ist. Solange dieses Programm läuft, sucht es die Drohne und entschärft sie, sobald sie gehört wird.</translation>
    </message>
    <message>
        <source>The drone does not say that it is disarmed and its motors stand.</source>
        <translation>Die Drohne meldet nicht, dass sie entschärft ist und ihre Motoren stehen.</translation>
    </message>
    <message>
        <source>It was armed from here. Without this program nobody would go on stopping it.</source>
        <translation>Sie wurde von hier aus scharf gemacht. Ohne dieses Programm würde sie niemand weiter anhalten.</translation>
    </message>
    <message>
        <source>Stop the motors (F12). If it does not obey, take its battery away: then the link is lost, and the program can be closed.</source>
        <translation>Die Motoren anhalten (F12). Gehorcht sie nicht, den Akku abnehmen: Dann ist die Verbindung weg, und das Programm lässt sich schließen.</translation>
    </message>
    <message>
        <source>The drone may be armed</source>
        <translation>Die Drohne ist vielleicht scharf</translation>
    </message>
    <message>
        <source>It did not confirm that it is disarmed, and may go on with its last throttle.</source>
        <translation>Sie hat nicht bestätigt, dass sie entschärft ist, und behält vielleicht ihr letztes Gas bei.</translation>
    </message>
    <message>
        <source>“%1” has not ended</source>
        <translation>„%1“ läuft noch</translation>
    </message>
    <message>
        <source>It cannot be cancelled from here, and goes on without this program: only taking its battery away ends it before.</source>
        <translation>Das lässt sich von hier nicht abbrechen und läuft ohne dieses Programm weiter: Nur das Abziehen des Akkus beendet es vorher.</translation>
    </message>
</context>
<context>
    <name>LeftSteering</name>
    <message>
        <source>The board turns the target of %1 by about %2 °/s, and nobody steers it here: a remote control does, or a steering command that was never ended. The camera goes on turning.</source>
        <translation>Das Board dreht das Ziel von %1 mit etwa %2 °/s, und hier steuert niemand: Das tut eine Fernsteuerung, oder ein Steuerbefehl, den niemand beendet hat. Die Kamera dreht sich weiter.</translation>
    </message>
    <message>
        <source>End the command</source>
        <translation>Befehl beenden</translation>
    </message>
    <message>
        <source>Stop the motors</source>
        <translation>Motoren stoppen</translation>
    </message>
    <message>
        <source>It is meant</source>
        <translation>So gewollt</translation>
    </message>
</context>
<context>
    <name>LinkBar</name>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Port or address of the board</source>
        <translation>Anschluss oder Adresse des Boards</translation>
    </message>
    <message>
        <source>Port or tcp://host:port</source>
        <translation>Anschluss oder tcp://host:port</translation>
    </message>
    <message>
        <source>Active profile</source>
        <translation>Aktives Profil</translation>
    </message>
    <message>
        <source>Active profile of the board</source>
        <translation>Aktives Profil des Boards</translation>
    </message>
    <message>
        <source>&amp;Profile</source>
        <translation>&amp;Profil</translation>
    </message>
    <message>
        <source>Simulated %1</source>
        <translation>Simulierter %1</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Verbinde…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Link lost, connecting again…</source>
        <translation>Verbindung verloren, verbinde neu…</translation>
    </message>
    <message>
        <source>Give up</source>
        <translation>Aufgeben</translation>
    </message>
    <message>
        <source>%1 · firmware %2</source>
        <translation>%1 · Firmware %2</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>● REC</source>
        <translation>● REC</translation>
    </message>
    <message>
        <source>■ STOP MOTORS</source>
        <translation>■ MOTOREN STOPPEN</translation>
    </message>
    <message>
        <source>▶ Start motors</source>
        <translation>▶ Motoren starten</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>WIEDERGABE</translation>
    </message>
    <message>
        <source>A recording is played: nothing here happens now, and nothing can be changed.</source>
        <translation>Eine Aufzeichnung läuft ab: Nichts hiervon geschieht jetzt, und nichts lässt sich ändern.</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULIERT</translation>
    </message>
    <message>
        <source>A simulated gimbal: no real motor moves.</source>
        <translation>Ein simulierter Gimbal: Kein echter Motor bewegt sich.</translation>
    </message>
    <message>
        <source>READ ONLY</source>
        <translation>NUR LESEN</translation>
    </message>
    <message>
        <source>Nothing can be written to this board.</source>
        <translation>Auf dieses Board kann nichts geschrieben werden.</translation>
    </message>
    <message>
        <source>OFFLINE</source>
        <translation>OFFLINE</translation>
    </message>
    <message>
        <source>No board is connected: what is shown was read before.</source>
        <translation>Kein Board ist verbunden: Was zu sehen ist, wurde vorher gelesen.</translation>
    </message>
    <message>
        <source>No board is connected: what is shown is the file %1.</source>
        <translation>Kein Board ist verbunden: Zu sehen ist die Datei %1.</translation>
    </message>
    <message>
        <source>The link is being recorded to %1</source>
        <translation>Die Verbindung wird in %1 aufgezeichnet</translation>
    </message>
    <message>
        <source>Board restarts, connecting again…</source>
        <translation>Das Board startet neu, verbinde wieder…</translation>
    </message>
    <message>
        <source>Stop motors</source>
        <translation>Motoren stoppen</translation>
    </message>
    <message>
        <source>Start motors</source>
        <translation>Motoren starten</translation>
    </message>
    <message>
        <source>F12 stops the motors from anywhere</source>
        <translation>F12 stoppt die Motoren von überall aus</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Schreibt…</translation>
    </message>
    <message>
        <source>Writing: %1…</source>
        <translation>Schreiben: %1…</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Aufzeichnung %1</translation>
    </message>
    <message>
        <source>■ STOP (deaf: %1 s)</source>
        <translation>■ STOPP (taub: %1 s)</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 unter %2</translation>
    </message>
    <message>
        <source>A simulated drone: no real motor turns.</source>
        <translation>Eine simulierte Drohne: kein echter Motor dreht sich.</translation>
    </message>
    <message>
        <source>The video is being recorded to %1</source>
        <translation>Das Video wird aufgenommen in %1</translation>
    </message>
    <message>
        <source>Serial port, tcp://host:port, udp://host[:port], or a simulated board</source>
        <translation>Serielle Schnittstelle, tcp://host:port, udp://host[:port] oder ein simuliertes Board</translation>
    </message>
    <message>
        <source>F12 stops the motors from anywhere, in flight as well: it falls</source>
        <translation>F12 hält die Motoren von überall an, auch im Flug: sie fällt</translation>
    </message>
</context>
<context>
    <name>LinkHealth</name>
    <message>
        <source>Another ground station talks to the same board.</source>
        <translation>Eine andere Bodenstation spricht mit demselben Board.</translation>
    </message>
    <message>
        <source>The board answers whoever sent last, so answers and live data are missing here, and both can command it.</source>
        <translation>Das Board antwortet dem, der zuletzt gesendet hat: Hier fehlen Antworten und Live-Daten, und beide können ihm etwas befehlen.</translation>
    </message>
    <message>
        <source>End the other program, or this link. Do not arm, write or calibrate meanwhile.</source>
        <translation>Beenden Sie das andere Programm oder diese Verbindung. Schalten Sie so lange nichts scharf, schreiben und kalibrieren Sie nicht.</translation>
    </message>
    <message>
        <source>answers to questions of somebody else: %1</source>
        <translation>Antworten auf fremde Fragen: %1</translation>
    </message>
</context>
<context>
    <name>LinkMarks</name>
    <message>
        <source>Connection lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>Connected again</source>
        <translation>Wieder verbunden</translation>
    </message>
    <message>
        <source>Streams arranged</source>
        <translation>Datenströme eingerichtet</translation>
    </message>
    <message>
        <source>Motors switched off</source>
        <translation>Motoren ausgeschaltet</translation>
    </message>
    <message>
        <source>Motors off: not confirmed</source>
        <translation>Motoren aus: nicht bestätigt</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) written</source>
        <translation>
            <numerusform>%n Wert geschrieben</numerusform>
            <numerusform>%n Werte geschrieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Simulated: %1</source>
        <translation>Simuliert: %1</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiterer</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Profile %1 in use</source>
        <translation>Profil %1 in Gebrauch</translation>
    </message>
    <message>
        <source>The board was silent for %1 s</source>
        <translation>Das Board war %1 s lang still</translation>
    </message>
    <message>
        <source>Board restarted</source>
        <translation>Board neu gestartet</translation>
    </message>
</context>
<context>
    <name>LiveFigures</name>
    <message>
        <source>What the board tells now</source>
        <translation>Was das Board jetzt meldet</translation>
    </message>
</context>
<context>
    <name>MagnetometerCard</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Calibrate the magnetometer</source>
        <translation>Magnetometer kalibrieren</translation>
    </message>
    <message>
        <source>Turn the camera by hand to see what iron does to the field, or calibrate at once. Keep away from iron, cables and motors.</source>
        <translation>Drehen Sie die Kamera von Hand, um zu sehen, was Eisen mit dem Feld macht, oder kalibrieren Sie gleich. Bleiben Sie fern von Eisen, Kabeln und Motoren.</translation>
    </message>
    <message>
        <source>Turn the camera slowly until the cross has been at every empty ring. The board ends by itself.</source>
        <translation>Drehen Sie die Kamera langsam, bis das Kreuz an jedem leeren Ring war. Das Board endet von selbst.</translation>
    </message>
    <message>
        <source>No board is connected.</source>
        <translation>Kein Board ist verbunden.</translation>
    </message>
    <message>
        <source>%1. Waiting until the sensor sends live data again.</source>
        <translation>%1. Gewartet wird, bis der Sensor wieder Live-Daten sendet.</translation>
    </message>
    <message>
        <source>The board has sent no measurement of its magnetometer so far. Without any, nobody sees whether a calibration helps, and none is begun.</source>
        <translation>Das Board hat bisher keine Messung seines Magnetometers gesendet. Ohne eine sieht niemand, ob eine Kalibrierung hilft, und es wird keine begonnen.</translation>
    </message>
    <message>
        <source>No sphere shows yet: turn the camera about another axis as well.</source>
        <translation>Noch zeigt sich keine Kugel: Drehen Sie die Kamera auch um eine andere Achse.</translation>
    </message>
    <message>
        <source>✓ All %1 directions are seen.</source>
        <translation>✓ Alle %1 Richtungen sind gesehen.</translation>
    </message>
    <message>
        <source>%1 of %2 directions are seen. The field has not yet come from: %3.</source>
        <translation>%1 von %2 Richtungen sind gesehen. Noch nicht gekommen ist das Feld aus: %3.</translation>
    </message>
    <message>
        <source>The calibration of the magnetometer was cancelled.</source>
        <translation>Die Kalibrierung des Magnetometers wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The board ends it by itself, with what it has seen by then.</source>
        <translation>Das Board beendet sie von selbst, mit dem, was es bis dahin gesehen hat.</translation>
    </message>
    <message>
        <source>Calibrate again, and turn the camera to all sides.</source>
        <translation>Kalibrieren Sie noch einmal, und drehen Sie die Kamera nach allen Seiten.</translation>
    </message>
    <message>
        <source>The points are what the sensor itself measures: a calibration moves none of them. Whether it helped, the error of the heading tells.</source>
        <translation>Die Punkte sind, was der Sensor selbst misst: Keine Kalibrierung verschiebt sie. Ob sie geholfen hat, sagt der Kursfehler.</translation>
    </message>
    <message>
        <source>Magnetometer: poor, the heading is off by %1°. Repeat it away from iron.</source>
        <translation>Magnetometer: schlecht, der Kurs liegt um %1° daneben. Wiederholen Sie es fern von Eisen.</translation>
    </message>
    <message>
        <source>Magnetometer: calibrated, but its points did not come; the heading alone judges it.</source>
        <translation>Magnetometer: kalibriert, aber seine Punkte kamen nicht an; nur der Kurs beurteilt es.</translation>
    </message>
    <message>
        <source>Magnetometer: poor, the points lie on no sphere. Something made of iron moved, or the field is not the earth&apos;s alone.</source>
        <translation>Magnetometer: schlecht, die Punkte liegen auf keiner Kugel. Etwas aus Eisen hat sich bewegt, oder das Feld ist nicht nur das der Erde.</translation>
    </message>
    <message>
        <source>Magnetometer: good</source>
        <translation>Magnetometer: gut</translation>
    </message>
    <message>
        <source>Magnetometer: usable</source>
        <translation>Magnetometer: brauchbar</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>Error of the heading</source>
        <translation>Kursfehler</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Directions seen</source>
        <translation>Gesehene Richtungen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Field (radius)</source>
        <translation>Feld (Radius)</translation>
    </message>
    <message>
        <source>Centre, %1</source>
        <translation>Mittelpunkt, %1</translation>
    </message>
    <message>
        <source>Shifted by iron</source>
        <translation>Durch Eisen verschoben</translation>
    </message>
    <message>
        <source>Stretched by iron</source>
        <translation>Durch Eisen gestreckt</translation>
    </message>
    <message>
        <source>Off the sphere</source>
        <translation>Neben der Kugel</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Save the configuration</source>
        <translation>Konfiguration sichern</translation>
    </message>
    <message>
        <source>Open a configuration or a recording</source>
        <translation>Konfiguration oder Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Play a recording?</source>
        <translation>Eine Aufzeichnung abspielen?</translation>
    </message>
    <message>
        <source>The link to the board ends before it is played.</source>
        <translation>Vorher endet die Verbindung zum Board.</translation>
    </message>
    <message>
        <source>Disconnect and play</source>
        <translation>Trennen und abspielen</translation>
    </message>
    <message>
        <source>Stay connected</source>
        <translation>Verbunden bleiben</translation>
    </message>
    <message>
        <source>This board has no page “%1”. It has: %2.</source>
        <translation>Dieses Board hat keine Seite „%1“. Es hat: %2.</translation>
    </message>
</context>
<context>
    <name>MessageHistory</name>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Nothing was told yet.</source>
        <translation>Bisher gab es keine Meldung.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
</context>
<context>
    <name>MessageRow</name>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy everything that technical support needs</source>
        <translation>Alles kopieren, was der Support braucht</translation>
    </message>
    <message>
        <source>Close message</source>
        <translation>Meldung schließen</translation>
    </message>
    <message>
        <source>Close (Esc); Ctrl+F6 leads here and back</source>
        <translation>Schließen (Esc); Strg+F6 führt hierher und zurück</translation>
    </message>
</context>
<context>
    <name>MissingText</name>
    <message>
        <source>%1 of all profiles</source>
        <translation>%1 aller Profile</translation>
    </message>
    <message>
        <source>%1 of profile %2</source>
        <translation>%1 von Profil %2</translation>
    </message>
    <message>
        <source>%1 of profiles %2</source>
        <translation>%1 der Profile %2</translation>
    </message>
    <message>
        <source>profile names</source>
        <translation>Profilnamen</translation>
    </message>
</context>
<context>
    <name>MonitorPage</name>
    <message>
        <source>Monitor</source>
        <translation>Monitor</translation>
    </message>
    <message>
        <source>Tick channels on the left to see them here.</source>
        <translation>Haken Sie links Kanäle an, um sie hier zu sehen.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>Gezeigte Zeit</translation>
    </message>
    <message>
        <source>Telemetry channels</source>
        <translation>Telemetriekanäle</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Save samples</source>
        <translation>Messwerte sichern</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>CSV-Dateien (*.csv)</translation>
    </message>
    <message>
        <source>%1 lines saved to %2</source>
        <translation>%1 Zeilen gesichert in %2</translation>
    </message>
    <message>
        <source>polled, up to %1 samples/s</source>
        <translation>abgefragt, bis %1 Werte/s</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 verloren</translation>
    </message>
    <message>
        <source>Record from now on…</source>
        <translation>Ab jetzt aufzeichnen…</translation>
    </message>
    <message>
        <source>Record to a file</source>
        <translation>In eine Datei aufzeichnen</translation>
    </message>
    <message>
        <source>Save the last minutes…</source>
        <translation>Die letzten Minuten sichern…</translation>
    </message>
    <message>
        <source>Save the last minutes</source>
        <translation>Die letzten Minuten sichern</translation>
    </message>
    <message>
        <source>Everything on the link goes into a file that can be opened like the board</source>
        <translation>Alles auf der Leitung kommt in eine Datei, die sich öffnen lässt wie das Board</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Aufzeichnung beenden</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Recordings (*.gimbalrec)</source>
        <translation>Aufzeichnungen (*.gimbalrec)</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>● recording, %1</source>
        <translation>● zeichnet auf, %1</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Streams…</source>
        <translation>Datenströme…</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Hold the picture still while data goes on (Space in the plot). The wheel zooms, dragging moves, Shift and dragging zooms to a box, a click sets the line that differences are counted from. Arrow keys move the cursor, with Ctrl from event to event; End goes on.</source>
        <translation>Hält das Bild an, während die Daten weiterlaufen (Leertaste im Bild). Das Rad zoomt, Ziehen verschiebt, Umschalt und Ziehen zoomt auf einen Rahmen, ein Klick setzt die Linie, von der Unterschiede zählen. Pfeiltasten bewegen den Cursor, mit Strg von Ereignis zu Ereignis; Ende läuft weiter.</translation>
    </message>
    <message>
        <source>Which plots there are and what they show, kept by name</source>
        <translation>Welche Bilder es gibt und was sie zeigen, unter einem Namen behalten</translation>
    </message>
    <message>
        <source>What the board sends, how often, and how much of the line it takes</source>
        <translation>Was das Board wie oft sendet und was das von der Leitung nimmt</translation>
    </message>
    <message>
        <source>Samples as CSV…</source>
        <translation>Messwerte als CSV…</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Bild…</translation>
    </message>
    <message>
        <source>Send to PlotJuggler (UDP)…</source>
        <translation>An PlotJuggler senden (UDP)…</translation>
    </message>
    <message>
        <source>Stop sending to %1</source>
        <translation>Senden an %1 beenden</translation>
    </message>
    <message>
        <source>Save what is seen</source>
        <translation>Sichert, was zu sehen ist</translation>
    </message>
    <message>
        <source>Tick a channel, or drag it into a plot</source>
        <translation>Haken Sie einen Kanal an oder ziehen Sie ihn in ein Bild</translation>
    </message>
    <message>
        <source>Show in plot %1</source>
        <translation>In Bild %1 zeigen</translation>
    </message>
    <message>
        <source>Show in a new plot</source>
        <translation>In einem neuen Bild zeigen</translation>
    </message>
    <message>
        <source>One plot for each unit</source>
        <translation>Ein Bild je Einheit</translation>
    </message>
    <message>
        <source>Keep this layout…</source>
        <translation>Diese Anordnung behalten…</translation>
    </message>
    <message>
        <source>Forget a layout</source>
        <translation>Eine Anordnung vergessen</translation>
    </message>
    <message>
        <source>Layout kept as “%1”.</source>
        <translation>Anordnung als „%1“ behalten.</translation>
    </message>
    <message>
        <source>This board has none of the channels of “%1”.</source>
        <translation>Dieses Board hat keinen der Kanäle von „%1“.</translation>
    </message>
    <message>
        <source>Keep this layout</source>
        <translation>Diese Anordnung behalten</translation>
    </message>
    <message>
        <source>Name; one that exists is replaced</source>
        <translation>Name; ein vorhandener wird ersetzt</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild sichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Send to PlotJuggler</source>
        <translation>An PlotJuggler senden</translation>
    </message>
    <message>
        <source>Address of its UDP server (JSON)</source>
        <translation>Adresse seines UDP-Servers (JSON)</translation>
    </message>
    <message>
        <source>What is ticked now is sent to %1 until you stop it in the same menu.</source>
        <translation>Was jetzt angehakt ist, wird an %1 gesendet, bis Sie es im selben Menü beenden.</translation>
    </message>
    <message>
        <source>%1 % of the line</source>
        <translation>%1 % der Leitung</translation>
    </message>
    <message>
        <source>sent on: %1</source>
        <translation>weitergesendet: %1</translation>
    </message>
    <message>
        <source>Lost: samples that were sent and never arrived. Silent: the board sent nothing at all, as while it calibrates.</source>
        <translation>Verloren: Messwerte, die gesendet wurden und nie ankamen. Still: das Board sandte gar nichts, wie während einer Kalibrierung.</translation>
    </message>
    <message>
        <source>Newest values of the arrays</source>
        <translation>Neueste Werte der Felder</translation>
    </message>
    <message>
        <source>Place in the array</source>
        <translation>Stelle im Feld</translation>
    </message>
    <message>
        <source>%1 s of silence in all</source>
        <translation>insgesamt %1 s Stille</translation>
    </message>
    <message>
        <source>thinned out to %1 samples/s by the slow line</source>
        <translation>auf %1 Messwerte/s ausgedünnt: langsame Leitung</translation>
    </message>
    <message>
        <source>Nothing is sent to %1 any more: the link over which the data came has ended.</source>
        <translation>An %1 wird nichts mehr gesendet: Die Verbindung, über die die Daten kamen, ist beendet.</translation>
    </message>
    <message>
        <source>%1 holds no samples: none came in the time shown.</source>
        <translation>%1 enthält keine Werte: In der gezeigten Zeit kamen keine.</translation>
    </message>
    <message>
        <source>as the board streams it</source>
        <translation>wie das Board sie von sich aus sendet</translation>
    </message>
</context>
<context>
    <name>MotorDiagram</name>
    <message>
        <source>Motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Places and directions follow from the signs of the mixing in the configuration text. The protocol does not tell which side is the front, and which of the two directions is clockwise: compare with the drone.</source>
        <translation>Orte und Drehrichtungen folgen aus den Vorzeichen der Mischung im Konfigurationstext. Welche Seite vorne ist und welche der beiden Richtungen im Uhrzeigersinn läuft, sagt das Protokoll nicht: an der Drohne vergleichen.</translation>
    </message>
    <message>
        <source>motor %1: %2</source>
        <translation>Motor %1: %2</translation>
    </message>
    <message>
        <source>being tested</source>
        <translation>wird geprüft</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>gewählt</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Keine Daten</translation>
    </message>
    <message>
        <source>pitch +</source>
        <translation>Pitch +</translation>
    </message>
    <message>
        <source>pitch −</source>
        <translation>Pitch −</translation>
    </message>
    <message>
        <source>roll −</source>
        <translation>Roll −</translation>
    </message>
    <message>
        <source>roll +</source>
        <translation>Roll +</translation>
    </message>
    <message>
        <source>The drone does not tell its motors yet.</source>
        <translation>Die Drohne meldet ihre Motoren noch nicht.</translation>
    </message>
    <message>
        <source>&gt; %1 %</source>
        <translation>&gt; %1 %</translation>
    </message>
    <message>
        <source>asked about</source>
        <translation>wird nachgefragt</translation>
    </message>
    <message>
        <source>Seen from above, as the check of directions has found it.</source>
        <translation>Von oben gesehen, wie die Prüfung der Richtungen es ergeben hat.</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>rear</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
</context>
<context>
    <name>MovementForm</name>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>How far the axis is moved; as small as can still be told from its noise</source>
        <translation>Wie weit die Achse bewegt wird; so klein, wie es sich von ihrem Rauschen noch unterscheidet</translation>
    </message>
    <message>
        <source>If the axis moves further than this beyond the movement itself, the motors are switched off</source>
        <translation>Geht es weiter als so viel über die Bewegung hinaus, werden die Motoren ausgeschaltet</translation>
    </message>
    <message>
        <source>Movement</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Sprünge</translation>
    </message>
    <message>
        <source>Rest between</source>
        <translation>Ruhe dazwischen</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Stop beyond</source>
        <translation>Abbruch ab</translation>
    </message>
</context>
<context>
    <name>Navigation</name>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <translation>%1 (Strg+%2)</translation>
    </message>
    <message>
        <source>%1, with unwritten changes</source>
        <translation>%1, mit ungeschriebenen Änderungen</translation>
    </message>
</context>
<context>
    <name>NotchAdviser</name>
    <message>
        <source>Notch %1 of %2</source>
        <translation>Kerbfilter %1 von %2</translation>
    </message>
    <message>
        <source>%1, %2 Hz</source>
        <translation>%1, %2 Hz</translation>
    </message>
    <message>
        <source>%1: no notch is offered. Without this line the axis would vibrate %2 % less; the delay would cost more.</source>
        <translation>%1: kein Kerbfilter angeboten. Ohne diese Linie würde die Achse um %2 % weniger vibrieren; die Verzögerung kostete mehr.</translation>
    </message>
    <message>
        <source>%1: no notch is offered. The line is too broad for a resonance: it is what shakes the gimbal, or how the loop reacts to it.</source>
        <translation>%1: kein Kerbfilter angeboten. Die Linie ist zu breit für eine Resonanz: sie ist, was den Gimbal schüttelt, oder wie der Regelkreis darauf antwortet.</translation>
    </message>
    <message>
        <source>%1: no notch is offered. The target itself moves like that.</source>
        <translation>%1: kein Kerbfilter angeboten. Das Ziel selbst bewegt sich so.</translation>
    </message>
    <message>
        <source>%1: no notch is offered. The loop itself amplifies there, as measured on Response: lower P or D of this axis.</source>
        <translation>%1: kein Kerbfilter angeboten. Dort verstärkt der Regelkreis selbst, wie auf Antwort gemessen: P oder D dieser Achse senken.</translation>
    </message>
    <message>
        <source>%1: no notch is offered. It would leave the loop a phase margin of %2° of the %3° measured.</source>
        <translation>%1: kein Kerbfilter angeboten. Er ließe dem Regelkreis eine Phasenreserve von %2° der gemessenen %3°.</translation>
    </message>
    <message>
        <source>%1: may be a resonance or a motor, %2 % of the vibration. A trial shows whether a notch helps.</source>
        <translation>%1: vielleicht eine Resonanz oder ein Motor, %2 % der Vibration. Ein Versuch zeigt, ob ein Kerbfilter hilft.</translation>
    </message>
    <message>
        <source>%1, notch %2: %3 Hz, width %4 Hz, depth %5 dB.</source>
        <translation>%1, Kerbfilter %2: %3 Hz, Breite %4 Hz, Tiefe %5 dB.</translation>
    </message>
    <message>
        <source>%1° at %2 Hz</source>
        <translation>%1° bei %2 Hz</translation>
    </message>
    <message>
        <source>It delays the loop: %1. Every degree is taken from the phase margin.</source>
        <translation>Er verzögert den Regelkreis: %1. Jedes Grad geht von der Phasenreserve ab.</translation>
    </message>
    <message>
        <source>The loop as measured has a phase margin of %1° at %2 Hz; with the notch it has %3°.</source>
        <translation>Der gemessene Regelkreis hat eine Phasenreserve von %1° bei %2 Hz; mit dem Kerbfilter sind es %3°.</translation>
    </message>
    <message>
        <source>How much phase this loop can spare has not been measured (a sweep on Response does), so only the trial shows whether it bears the notch.</source>
        <translation>Wie viel Phase dieser Regelkreis übrig hat, ist nicht gemessen (ein Durchlauf auf Antwort misst es); so zeigt nur der Versuch, ob er den Kerbfilter verträgt.</translation>
    </message>
    <message>
        <source>This board cannot use a notch without storing it. The trial measures for %1 s, writes the notch to profile %2, measures for %1 s again and writes the old values back in any case, at once if an axis begins to oscillate. Leave gimbal and sticks as they are meanwhile.</source>
        <translation>Dieses Board kann keinen Kerbfilter benutzen, ohne ihn zu speichern. Der Versuch misst %1 s, schreibt den Kerbfilter in Profil %2, misst noch einmal %1 s und schreibt die alten Werte in jedem Fall zurück, sofort, wenn eine Achse zu schwingen beginnt. Gimbal und Knüppel bleiben währenddessen, wie sie sind.</translation>
    </message>
    <message>
        <source>Values in use are not stored; a trial would replace them. Store or revert them on Tuning first.</source>
        <translation>Werte im Gebrauch sind nicht gespeichert; ein Versuch würde sie ersetzen. Sie sind zuerst auf Abstimmen zu speichern oder zurückzunehmen.</translation>
    </message>
    <message>
        <source>Trial of a notch begins</source>
        <translation>Versuch eines Kerbfilters beginnt</translation>
    </message>
    <message>
        <source>Trial of a notch is over</source>
        <translation>Versuch eines Kerbfilters ist vorbei</translation>
    </message>
    <message>
        <source>%1 was not tried; nothing was changed on the board.</source>
        <translation>%1 wurde nicht versucht; auf dem Board wurde nichts geändert.</translation>
    </message>
    <message>
        <source>The values from before are back on the board.</source>
        <translation>Die Werte von vorher sind wieder auf dem Board.</translation>
    </message>
    <message>
        <source>The notch could not be taken back; that is done when this board is read again.</source>
        <translation>Der Kerbfilter konnte nicht zurückgenommen werden; das geschieht, wenn dieses Board wieder gelesen wird.</translation>
    </message>
    <message>
        <source>Before and with it, %1 s each: the line %2 and %3 °/s RMS, all vibration %4 and %5 °/s, angle error %6° and %7°.</source>
        <translation>Vorher und damit, je %1 s: die Linie %2 und %3 °/s effektiv, alle Vibration %4 und %5 °/s, Winkelfehler %6° und %7°.</translation>
    </message>
    <message>
        <source>%1 helps.</source>
        <translation>%1 hilft.</translation>
    </message>
    <message>
        <source>Take over as an edit</source>
        <translation>Als Änderung übernehmen</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>Lassen</translation>
    </message>
    <message>
        <source>%1 is not worth its delay.</source>
        <translation>%1 ist seine Verzögerung nicht wert.</translation>
    </message>
    <message>
        <source>%1 makes it worse.</source>
        <translation>%1 macht es schlechter.</translation>
    </message>
    <message>
        <source>%1 makes %2 oscillate (%3 °/s RMS within a quarter of a second; all vibration before: %4 °/s on %5). The trial was ended at once.</source>
        <translation>%1 lässt %2 schwingen (%3 °/s effektiv in einer Viertelsekunde; alle Vibration vorher: %4 °/s auf %5). Der Versuch wurde sofort beendet.</translation>
    </message>
    <message>
        <source>The trial of %1 was ended before it could show anything.</source>
        <translation>Der Versuch mit %1 wurde beendet, bevor er etwas zeigen konnte.</translation>
    </message>
    <message>
        <source>A search, measurement or calibration is running.</source>
        <translation>Eine Suche, Messung oder Kalibrierung läuft.</translation>
    </message>
    <message>
        <source>A trial was cut off, and what was tried is still on the board (%1): the values from before are written back.</source>
        <translation>Ein Versuch wurde abgebrochen, und was versucht wurde, ist noch auf dem Board (%1): die Werte von vorher werden zurückgeschrieben.</translation>
    </message>
</context>
<context>
    <name>Notifications</name>
    <message>
        <source>The board says: %1</source>
        <translation>Das Board meldet: %1</translation>
    </message>
    <message>
        <source>Control was released because the program did not refresh it in time.</source>
        <translation>Die Steuerung wurde abgegeben, weil das Programm sie nicht rechtzeitig erneuert hat.</translation>
    </message>
    <message>
        <source>Recording saved to %1 (%2)</source>
        <translation>Aufzeichnung in %1 gesichert (%2)</translation>
    </message>
    <message>
        <source>The recording has ended.</source>
        <translation>Die Aufzeichnung ist zu Ende.</translation>
    </message>
    <message>
        <source>What was recorded before is in the file. Make room, or choose another place.</source>
        <translation>Was vorher aufgezeichnet wurde, steht in der Datei. Schaffen Sie Platz, oder wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>Connected again.</source>
        <translation>Wieder verbunden.</translation>
    </message>
    <message>
        <source>This is a recording: everything can be looked at, nothing can be changed.</source>
        <translation>Das ist eine Aufzeichnung: alles lässt sich ansehen, nichts ändern.</translation>
    </message>
    <message>
        <source>Live data could not be started. </source>
        <translation>Live-Daten ließen sich nicht starten. </translation>
    </message>
    <message>
        <source>The board did not confirm that the motors are off.</source>
        <translation>Das Board hat nicht bestätigt, dass die Motoren aus sind.</translation>
    </message>
    <message>
        <source>They may still be running.</source>
        <translation>Sie laufen vielleicht noch.</translation>
    </message>
    <message>
        <source>Hold the camera and disconnect the power.</source>
        <translation>Halten Sie die Kamera und trennen Sie den Strom.</translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation>Gesichert in %1</translation>
    </message>
    <message>
        <source>The motors stay disabled until the board restarts.</source>
        <translation>Die Motoren bleiben abgeschaltet, bis das Board neu startet.</translation>
    </message>
    <message>
        <source>Restart the board before you use them, and store nothing before.</source>
        <translation>Das Board neu starten, bevor Sie sie benutzen, und vorher nichts speichern.</translation>
    </message>
    <message>
        <source>This recording is damaged.</source>
        <translation>Diese Aufzeichnung ist beschädigt.</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s) of it cannot be read and are left out, %1 in all.</source>
        <translation>
            <numerusform>%n Teil davon ist nicht lesbar und fehlt, insgesamt %1.</numerusform>
            <numerusform>%n Teile davon sind nicht lesbar und fehlen, insgesamt %1.</numerusform>
        </translation>
    </message>
    <message>
        <source> Its motors were disabled while it was starting and may stay so until it restarts; store nothing before.</source>
        <translation> Seine Motoren wurden beim Starten stillgelegt und bleiben es womöglich bis zu seinem Neustart; vorher nichts speichern.</translation>
    </message>
    <message>
        <source>The board was told to stop.</source>
        <translation>Dem Board wurde gesagt, dass es anhalten soll.</translation>
    </message>
    <message>
        <source>Arm again when the computer is less busy.</source>
        <translation>Schalten Sie wieder scharf, wenn der Rechner weniger zu tun hat.</translation>
    </message>
    <message>
        <source>The motors were switched off.</source>
        <translation>Die Motoren wurden ausgeschaltet.</translation>
    </message>
    <message>
        <source>The board sends data that nobody here has ordered.</source>
        <translation>Das Board sendet Daten, die hier niemand angefordert hat.</translation>
    </message>
    <message>
        <source>An earlier program has left them on; they take room on the line from everything else.</source>
        <translation>Ein früheres Programm hat sie laufen lassen; sie nehmen allem anderen Platz auf der Leitung.</translation>
    </message>
    <message>
        <source>Switch the board off and on again.</source>
        <translation>Das Board aus- und wieder einschalten.</translation>
    </message>
    <message>
        <source>The file is kept in the folder %1.</source>
        <translation>Die Datei ist im Ordner %1 aufgehoben.</translation>
    </message>
    <message>
        <source>New edits take the place of edits of an earlier run, which concern parts of the board that could not be read. Those are kept in %1.</source>
        <translation>Neue Änderungen treten an die Stelle von Änderungen eines früheren Laufs, die Teile des Boards betreffen, die nicht gelesen werden konnten. Diese sind in %1 aufgehoben.</translation>
    </message>
    <message>
        <source>The recording %1 holds no live data: none came while it was made.</source>
        <translation>Die Aufzeichnung %1 enthält keine Live-Daten: Während sie lief, kamen keine.</translation>
    </message>
    <message>
        <source>Live data have stopped while the link is being recorded.</source>
        <translation>Während die Verbindung aufgezeichnet wird, kommen keine Live-Daten mehr.</translation>
    </message>
    <message>
        <source>The recording goes on, and has a gap from here on.</source>
        <translation>Die Aufzeichnung läuft weiter und hat ab hier eine Lücke.</translation>
    </message>
    <message>
        <source>Choose streams on the Monitor, or connect again.</source>
        <translation>Wählen Sie Datenströme auf der Monitorseite, oder verbinden Sie neu.</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>verbindet</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>link lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>Link: %1, %2</source>
        <translation>Verbindung: %1, %2</translation>
    </message>
    <message>
        <source>none used yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>Board: none</source>
        <translation>Board: keines</translation>
    </message>
    <message>
        <source>Board: %1, firmware %2</source>
        <translation>Board: %1, Firmware %2</translation>
    </message>
    <message>
        <source> (read before, or from a file)</source>
        <translation> (früher gelesen, oder aus einer Datei)</translation>
    </message>
    <message>
        <source>Saved to %1, but not everything.</source>
        <translation>In %1 gesichert, aber nicht alles.</translation>
    </message>
    <message>
        <source>The file lacks what could not be read: %1.</source>
        <translation>In der Datei fehlt, was nicht gelesen werden konnte: %1.</translation>
    </message>
    <message>
        <source>Read the board again, then save once more.</source>
        <translation>Lesen Sie das Board erneut, und sichern Sie dann noch einmal.</translation>
    </message>
    <message>
        <source>Unwritten edits would not survive a crash of the program.</source>
        <translation>Ungeschriebene Änderungen würden einen Absturz des Programms nicht überstehen.</translation>
    </message>
    <message>
        <source> Unwritten edits are kept.</source>
        <translation> Ungeschriebene Änderungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>The board did not confirm that it has stopped turning the camera.</source>
        <translation>Das Board hat nicht bestätigt, dass es die Kamera nicht mehr dreht.</translation>
    </message>
    <message>
        <source>The camera may go on moving as it was steered last.</source>
        <translation>Die Kamera bewegt sich vielleicht weiter, wie sie zuletzt gesteuert wurde.</translation>
    </message>
    <message>
        <source>New edits take the place of edits of an earlier run. Those are kept as the snapshot %1.</source>
        <translation>Neue Änderungen treten an die Stelle von Änderungen aus einem früheren Lauf. Diese sind als Sicherung %1 aufgehoben.</translation>
    </message>
    <message>
        <source>Another board answers now: %1. It is read anew; the one before was %2.</source>
        <translation>Jetzt antwortet ein anderes Board: %1. Es wird neu gelesen; das vorherige war %2.</translation>
    </message>
    <message>
        <source>The board has restarted and is back.</source>
        <translation>Das Board ist neu gestartet und wieder da.</translation>
    </message>
    <message>
        <source>The board restarts, as it was told to. The program connects again as soon as it is back.</source>
        <translation>Das Board startet neu, wie verlangt. Das Programm verbindet wieder, sobald es zurück ist.</translation>
    </message>
    <message>
        <source>The program connects again as soon as it is back. Check its supply voltage and its cables.</source>
        <translation>Das Programm verbindet wieder, sobald es zurück ist. Prüfen Sie seine Spannungsversorgung und seine Kabel.</translation>
    </message>
    <message>
        <source>The recording has ended: another board answers on this link. What came from the one before is in %1.</source>
        <translation>Die Aufzeichnung ist zu Ende: Ein anderes Board antwortet auf dieser Verbindung. Was vom vorigen kam, ist in %1.</translation>
    </message>
    <message>
        <source>Stop the motors (F12), once there is a link; or hold the camera and disconnect the power.</source>
        <translation>Stoppen Sie die Motoren (F12), sobald eine Verbindung besteht; oder halten Sie die Kamera fest und trennen Sie die Stromversorgung.</translation>
    </message>
    <message>
        <source>The board restarted by itself and is back. It uses the stored values.</source>
        <translation>Das Board ist von selbst neu gestartet und wieder da. Es benutzt die gespeicherten Werte.</translation>
    </message>
    <message>
        <source>Its motors may run.</source>
        <translation>Seine Motoren laufen vielleicht.</translation>
    </message>
    <message>
        <source>The motors run on although they were told to stop.</source>
        <translation>Die Motoren laufen weiter, obwohl sie ausgeschaltet werden sollten.</translation>
    </message>
    <message>
        <source>The board answers and reports that they run; stopping them is repeated.</source>
        <translation>Das Board antwortet und meldet, dass sie laufen; das Ausschalten wird wiederholt.</translation>
    </message>
    <message>
        <source>There is no connection: nothing was sent to stop motors.</source>
        <translation>Es besteht keine Verbindung: zum Ausschalten der Motoren wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>Motors that run go on running.</source>
        <translation>Motoren, die laufen, laufen weiter.</translation>
    </message>
    <message>
        <source>Connect first, then stop them (F12); or disconnect their power.</source>
        <translation>Verbinden Sie erst und schalten Sie sie dann aus (F12), oder trennen Sie ihren Strom.</translation>
    </message>
    <message>
        <source>No live data have come since %1; the motors ran then.</source>
        <translation>Seit %1 kommen keine Live-Daten; da liefen die Motoren.</translation>
    </message>
    <message>
        <source>They may go on, and nothing is watched: no alarm can tell or stop anything.</source>
        <translation>Sie laufen vielleicht weiter, und nichts wird überwacht: kein Alarm kann warnen oder eingreifen.</translation>
    </message>
    <message>
        <source>Keep clear of the gimbal. Stop the motors (F12), or disconnect the power.</source>
        <translation>Bleiben Sie vom Gimbal weg. Schalten Sie die Motoren aus (F12), oder trennen Sie den Strom.</translation>
    </message>
    <message>
        <source>The recording does not hold an answer to what the program asks.</source>
        <translation>Die Aufzeichnung enthält keine Antwort auf das, was das Programm fragt.</translation>
    </message>
    <message>
        <source>It was not asked while this was recorded, or that part of the file is missing.</source>
        <translation>Es wurde beim Aufzeichnen nicht gefragt, oder dieser Teil der Datei fehlt.</translation>
    </message>
    <message>
        <source>What the recording holds is shown all the same.</source>
        <translation>Was die Aufzeichnung enthält, wird trotzdem gezeigt.</translation>
    </message>
    <message>
        <source>Its first line is damaged.</source>
        <translation>Die erste Zeile ist beschädigt.</translation>
    </message>
    <message>
        <source>The file ends in the middle of a part.</source>
        <translation>Die Datei endet mitten in einem Teil.</translation>
    </message>
    <message>
        <source>No part begins where one should.</source>
        <translation>Wo ein Teil beginnen müsste, beginnt keiner.</translation>
    </message>
    <message>
        <source>A checksum is wrong.</source>
        <translation>Eine Prüfsumme stimmt nicht.</translation>
    </message>
    <message>
        <source>The description of the recording is no JSON.</source>
        <translation>Die Beschreibung der Aufzeichnung ist kein JSON.</translation>
    </message>
    <message>
        <source>A part holds something else than data of the link.</source>
        <translation>Ein Teil enthält etwas anderes als Daten der Verbindung.</translation>
    </message>
    <message>
        <source>Everything else that the file holds is here; where a part is missing, plots have a gap.</source>
        <translation>Alles andere, was die Datei enthält, ist da; wo ein Teil fehlt, haben Kurven eine Lücke.</translation>
    </message>
    <message>
        <source>The board did not obey the ordinary stop, so they were disabled in its volatile memory; it has not reached standby since.</source>
        <translation>Dem gewöhnlichen Stopp hat das Board nicht gehorcht, deshalb wurden sie in seinem flüchtigen Speicher abgeschaltet; in Bereitschaft ist es seither nicht.</translation>
    </message>
    <message>
        <source>The board has stopped turning the camera.</source>
        <translation>Das Board dreht die Kamera nicht mehr.</translation>
    </message>
    <message>
        <source>The board did not answer to the start of its motors.</source>
        <translation>Das Board hat auf den Start seiner Motoren nicht geantwortet.</translation>
    </message>
    <message>
        <source>They may start yet, at any moment.</source>
        <translation>Sie können noch anlaufen, jederzeit.</translation>
    </message>
    <message>
        <source>Keep your hands off the gimbal, or have the motors stopped (F12).</source>
        <translation>Lassen Sie die Hände vom Gimbal, oder stoppen Sie die Motoren (F12).</translation>
    </message>
    <message>
        <source>The connection ended before the motors were seen to stop.</source>
        <translation>Die Verbindung endete, bevor zu sehen war, dass die Motoren stehen.</translation>
    </message>
    <message>
        <source>Keep away from the propellers, and disconnect the battery once they stand.</source>
        <translation>Abstand von den Propellern halten und den Akku abziehen, sobald sie stehen.</translation>
    </message>
    <message>
        <source>The drone is disarmed, and its outputs stand.</source>
        <translation>Die Drohne ist entschärft, und ihre Ausgänge stehen.</translation>
    </message>
    <message>
        <source>The drone did not confirm that it is disarmed.</source>
        <translation>Die Drohne hat nicht bestätigt, dass sie entschärft ist.</translation>
    </message>
    <message>
        <source>It may go on with its last throttle. Disarming it goes on as long as there is a link, and begins again with the next one.</source>
        <translation>Sie läuft vielleicht mit ihrem letzten Gas weiter. Das Entschärfen geht weiter, solange es eine Verbindung gibt, und beginnt mit der nächsten von vorn.</translation>
    </message>
    <message>
        <source>The board does not confirm yet that the motors are off; the command is repeated.</source>
        <translation>Das Board bestätigt noch nicht, dass die Motoren aus sind; der Befehl wird wiederholt.</translation>
    </message>
    <message>
        <source>Keep away from the propellers.</source>
        <translation>Abstand von den Propellern halten.</translation>
    </message>
    <message>
        <source>Hold the camera.</source>
        <translation>Halten Sie die Kamera fest.</translation>
    </message>
    <message>
        <source>The board hears nothing until %1, also no stop. The stop is queued as the first thing that it hears then. To stop it at once, disconnect the battery.</source>
        <translation>Das Board hört bis %1 nichts, auch kein Anhalten. Das Anhalten ist eingereiht und wird als Erstes gehört. Sofort anhalten: den Akku abziehen.</translation>
    </message>
    <message>
        <source>The drone was disarmed, and does not tell what its motors do. See that they stand before you come near.</source>
        <translation>Die Drohne wurde entschärft und meldet nicht, was ihre Motoren tun. Vor dem Herangehen nachsehen, ob sie stehen.</translation>
    </message>
    <message>
        <source>Over this kind of link %1 is asked only if it is named: add ?family=%2 to the address.</source>
        <translation>Über eine solche Verbindung wird %1 nur gefragt, wenn die Adresse die Familie nennt: ?family=%2 anhängen.</translation>
    </message>
    <message>
        <source>%1 is not reached this way; it is usually at %2.</source>
        <translation>%1 ist so nicht zu erreichen; üblich ist %2.</translation>
    </message>
</context>
<context>
    <name>NumberBox</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1. Take %2</source>
        <translation>%1. %2 nehmen</translation>
    </message>
    <message>
        <source>Whole numbers, %1</source>
        <translation>Ganze Zahlen, %1</translation>
    </message>
    <message numerus="yes">
        <source>At most %n decimal(s), %1</source>
        <translation>
            <numerusform>Höchstens %n Nachkommastelle, %1</numerusform>
            <numerusform>Höchstens %n Nachkommastellen, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Can be read as %1 or as %2; %3</source>
        <translation>Lässt sich als %1 oder als %2 lesen; %3</translation>
    </message>
    <message>
        <source>No number; %1. Go back to %2</source>
        <translation>Keine Zahl; %1. Zurück zu %2</translation>
    </message>
</context>
<context>
    <name>OfferBar</name>
    <message numerus="yes">
        <source>%n open question(s)</source>
        <translation>
            <numerusform>%n offene Frage</numerusform>
            <numerusform>%n offene Fragen</numerusform>
        </translation>
    </message>
    <message>
        <source>Fold the question</source>
        <translation>Frage einklappen</translation>
    </message>
    <message>
        <source>Fold the question; it stays open. Ctrl+F6 leads here and back</source>
        <translation>Frage einklappen; sie bleibt offen. Strg+F6 führt hierher und zurück</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Dashboard</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Beobachten</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>Monitor</translation>
    </message>
    <message>
        <source>Debug variables</source>
        <translation>Debug-Variablen</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Set up</source>
        <translation>Einrichten</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profile</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Abstimmen</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Abstimmen</translation>
    </message>
    <message>
        <source>Auto-tune</source>
        <translation>Auto-Abstimmung</translation>
    </message>
    <message>
        <source>Adjustable variables</source>
        <translation>Live-Variablen</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Steuern</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Board</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Aktionen</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Sicherungen</translation>
    </message>
    <message>
        <source>Console</source>
        <translation>Konsole</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Gimbal setup</source>
        <translation>Gimbal einrichten</translation>
    </message>
    <message>
        <source>Scripts</source>
        <translation>Skripte</translation>
    </message>
    <message>
        <source>Documents</source>
        <translation>Dokumente</translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation>Gamepad</translation>
    </message>
    <message>
        <source>Test bench</source>
        <translation>Prüfstand</translation>
    </message>
    <message>
        <source>System</source>
        <translation>System</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Flight</source>
        <translation>Flug</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Black box</source>
        <translation>Blackbox</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Whole board</source>
        <translation>Ganzes Board</translation>
    </message>
</context>
<context>
    <name>ParameterModel</name>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>On the board</source>
        <translation>Auf dem Board</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Schlüssel</translation>
    </message>
</context>
<context>
    <name>ParametersPage</name>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Geändert</translation>
    </message>
    <message>
        <source>Not default</source>
        <translation>Nicht Vorgabe</translation>
    </message>
    <message>
        <source>⚠ Risk</source>
        <translation>⚠ Risiko</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Nothing matches. Change the search, the filters or the level.</source>
        <translation>Nichts passt. Ändern Sie Suche, Filter oder Stufe.</translation>
    </message>
    <message>
        <source>Basic</source>
        <translation>Einfach</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Experte</translation>
    </message>
    <message>
        <source>How much to show</source>
        <translation>Wie viel gezeigt wird</translation>
    </message>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation>Suchen (Strg+F)</translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation>Parameter durchsuchen</translation>
    </message>
    <message>
        <source>Looks in names, keys and help of all parameters</source>
        <translation>Sucht in Namen, Schlüsseln und Hilfe aller Parameter</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>All parameters</source>
        <translation>Alle Parameter</translation>
    </message>
    <message>
        <source>P%1: %2</source>
        <translation>P%1: %2</translation>
    </message>
    <message>
        <source>%1: “%2” is no value of it. The value is as before.</source>
        <translation>%1: „%2“ ist kein Wert dafür. Der Wert ist wie zuvor.</translation>
    </message>
    <message>
        <source>This is %1.
The board uses %2:
show that one.</source>
        <translation>Das ist %1.
Das Board benutzt %2:
dieses zeigen.</translation>
    </message>
    <message>
        <source>%1: “%2” is no value of it (%3). The value is as before.</source>
        <translation>%1: „%2“ ist kein Wert dafür (%3). Der Wert ist wie zuvor.</translation>
    </message>
</context>
<context>
    <name>PictureSettings</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Kontrast</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Sättigung</translation>
    </message>
    <message>
        <source>Sensitivity (ISO)</source>
        <translation>Empfindlichkeit (ISO)</translation>
    </message>
    <message>
        <source>By 100. 0 is automatic.</source>
        <translation>Um 100. 0 ist automatisch.</translation>
    </message>
    <message>
        <source>Shutter</source>
        <translation>Verschluss</translation>
    </message>
    <message>
        <source>By 100. Today&apos;s driver does nothing.</source>
        <translation>Um 100. Der heutige Treiber tut nichts.</translation>
    </message>
    <message>
        <source>The drone does not tell brightness, contrast and saturation: judge by the picture. Nothing here outlasts a restart.</source>
        <translation>Helligkeit, Kontrast und Sättigung nennt die Drohne nicht: nach dem Bild urteilen. Nichts hier übersteht einen Neustart.</translation>
    </message>
    <message>
        <source>Colour and light</source>
        <translation>Farbe und Licht</translation>
    </message>
    <message>
        <source>White balance</source>
        <translation>Weißabgleich</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Next white balance</source>
        <translation>Nächster Weißabgleich</translation>
    </message>
    <message>
        <source>Switches to the next one; the drone tells which.</source>
        <translation>Schaltet zum nächsten weiter; die Drohne sagt, zu welchem.</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Lock white balance</source>
        <translation>Weißabgleich festhalten</translation>
    </message>
    <message>
        <source>Keeps the present gains of red and blue; the drone tells them.</source>
        <translation>Behält die jetzigen Verstärkungen von Rot und Blau; die Drohne nennt sie.</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Next exposure mode</source>
        <translation>Nächste Belichtungsart</translation>
    </message>
    <message>
        <source>Switches to the next one. Today&apos;s driver does not tell which.</source>
        <translation>Schaltet zur nächsten weiter. Der heutige Treiber sagt nicht, zu welcher.</translation>
    </message>
    <message>
        <source>Night mode</source>
        <translation>Nachtmodus</translation>
    </message>
    <message>
        <source>Runs the drone&apos;s own script for it, if there is one. No proof comes back.</source>
        <translation>Startet das eigene Skript der Drohne dafür, falls es eines gibt. Ein Beweis kommt nicht zurück.</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ein</translation>
    </message>
    <message>
        <source>Night mode on</source>
        <translation>Nachtmodus ein</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Night mode off</source>
        <translation>Nachtmodus aus</translation>
    </message>
    <message>
        <source>Lens shading</source>
        <translation>Vignettierung</translation>
    </message>
    <message>
        <source>Set…</source>
        <translation>Setzen…</translation>
    </message>
    <message>
        <source>Set lens shading</source>
        <translation>Vignettierung setzen</translation>
    </message>
    <message>
        <source>Today&apos;s driver does nothing with it.</source>
        <translation>Der heutige Treiber tut nichts damit.</translation>
    </message>
    <message>
        <source>On the drone</source>
        <translation>Auf der Drohne</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Record on the drone</source>
        <translation>Auf der Drohne aufnehmen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Stop recording on the drone</source>
        <translation>Aufnahme auf der Drohne beenden</translation>
    </message>
    <message>
        <source>Take a picture on the drone</source>
        <translation>Foto auf der Drohne machen</translation>
    </message>
    <message>
        <source>Today&apos;s driver does nothing.</source>
        <translation>Der heutige Treiber tut nichts.</translation>
    </message>
    <message>
        <source>The drone confirms recording whatever it does: that is no proof. Its recordings are listed on the page Recordings. Use Record below the picture for a file here.</source>
        <translation>Die Drohne bestätigt eine Aufnahme, was immer sie tut: Das ist kein Beweis. Ihre Aufnahmen stehen auf der Seite Aufnahmen. Eine Datei auf diesem Rechner macht „Aufnehmen“ unter dem Bild.</translation>
    </message>
    <message>
        <source>%1: less</source>
        <translation>%1: weniger</translation>
    </message>
    <message>
        <source>%1: more</source>
        <translation>%1: mehr</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>nicht genannt</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
</context>
<context>
    <name>PlotPanel</name>
    <message>
        <source>What this plot shows and how</source>
        <translation>Was dieses Bild zeigt und wie</translation>
    </message>
    <message>
        <source>Plot menu</source>
        <translation>Menü des Bildes</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Peak to peak</source>
        <translation>Spitze zu Spitze</translation>
    </message>
    <message>
        <source>Samples/s</source>
        <translation>Werte/s</translation>
    </message>
    <message>
        <source>Figures of the visible span</source>
        <translation>Kennzahlen der sichtbaren Spanne</translation>
    </message>
    <message>
        <source>Show figures</source>
        <translation>Kennzahlen zeigen</translation>
    </message>
    <message>
        <source>Each channel on a scale of its own</source>
        <translation>Jeder Kanal mit eigener Skala</translation>
    </message>
    <message>
        <source>Fit the scales (A)</source>
        <translation>Skalen anpassen (A)</translation>
    </message>
    <message>
        <source>Remove the reference line (R)</source>
        <translation>Bezugslinie entfernen (R)</translation>
    </message>
    <message>
        <source>Reference line at the cursor (R)</source>
        <translation>Bezugslinie am Cursor (R)</translation>
    </message>
    <message>
        <source>Remove “%1”</source>
        <translation>„%1“ herausnehmen</translation>
    </message>
    <message>
        <source>Remove this plot</source>
        <translation>Dieses Bild entfernen</translation>
    </message>
</context>
<context>
    <name>PlotStack</name>
    <message>
        <source>Plot %1</source>
        <translation>Bild %1</translation>
    </message>
</context>
<context>
    <name>PlotView</name>
    <message>
        <source>Live plot</source>
        <translation>Live-Kurve</translation>
    </message>
    <message>
        <source>%1 to %2/s</source>
        <translation>%1 bis %2/s</translation>
    </message>
    <message>
        <source>%1/s, true to %2 Hz</source>
        <translation>%1/s, wahr bis %2 Hz</translation>
    </message>
    <message>
        <source>until %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>  Δ %1 s (%2 Hz)</source>
        <translation>  Δ %1 s (%2 Hz)</translation>
    </message>
    <message>
        <source>earlier from %1 to %2 %3</source>
        <translation>vorher von %1 bis %2 %3</translation>
    </message>
    <message>
        <source>no fixed rate</source>
        <translation>ohne feste Rate</translation>
    </message>
    <message>
        <source>no fixed rate, up to %1/s</source>
        <translation>ohne feste Rate, bis %1/s</translation>
    </message>
</context>
<context>
    <name>ProfileModel</name>
    <message>
        <source>● active</source>
        <translation>● aktiv</translation>
    </message>
    <message numerus="yes">
        <source>differs in %n value(s)</source>
        <translation>
            <numerusform>anders in %n Wert</numerusform>
            <numerusform>anders in %n Werten</numerusform>
        </translation>
    </message>
    <message>
        <source>same values</source>
        <translation>gleiche Werte</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>Against the active profile</source>
        <translation>Gegenüber dem aktiven Profil</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>nicht gelesen</translation>
    </message>
    <message numerus="yes">
        <source>%n unwritten</source>
        <translation>
            <numerusform>%n ungeschrieben</numerusform>
            <numerusform>%n ungeschrieben</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ProfilesPage</name>
    <message>
        <source>GimbalDesk configurations (*.json)</source>
        <translation>GimbalDesk-Konfigurationen (*.json)</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profile</translation>
    </message>
    <message>
        <source>Make active</source>
        <translation>Aktiv machen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Copy onto</source>
        <translation>Kopieren auf</translation>
    </message>
    <message>
        <source>Load from file…</source>
        <translation>Aus Datei laden…</translation>
    </message>
    <message>
        <source>Save to file…</source>
        <translation>In Datei sichern…</translation>
    </message>
    <message>
        <source>Load all profiles…</source>
        <translation>Alle Profile laden…</translation>
    </message>
    <message>
        <source>Profile to copy onto</source>
        <translation>Profil, auf das kopiert wird</translation>
    </message>
    <message>
        <source>The board uses this profile from now on</source>
        <translation>Das Board benutzt ab jetzt dieses Profil</translation>
    </message>
    <message>
        <source>Change the name (F2)</source>
        <translation>Namen ändern (F2)</translation>
    </message>
    <message>
        <source>Copy all values of the chosen profile to another one, as an edit that can be undone</source>
        <translation>Übernimmt alle Werte des gewählten Profils in ein anderes, als Änderung, die sich zurücknehmen lässt</translation>
    </message>
    <message>
        <source>Load one profile of a file into the chosen profile, as an edit that can be undone</source>
        <translation>Übernimmt ein Profil einer Datei in das gewählte Profil, als Änderung, die sich zurücknehmen lässt</translation>
    </message>
    <message>
        <source>Load everything in a file, as one edit that can be undone</source>
        <translation>Übernimmt alles aus einer Datei, als eine Änderung, die sich zurücknehmen lässt</translation>
    </message>
    <message>
        <source>Copying, renaming and loading are edits: nothing is on the board before you review and write. Board-wide values (sensors, motors&apos; outputs, ports) belong to no profile and stay.</source>
        <translation>Kopieren, Umbenennen und Laden sind Änderungen: auf dem Board ist erst etwas, wenn Sie prüfen und schreiben. Werte des ganzen Boards (Sensoren, Motorausgänge, Anschlüsse) gehören zu keinem Profil und bleiben.</translation>
    </message>
    <message>
        <source>The name of profile %1 is too long.</source>
        <translation>Der Name von Profil %1 ist zu lang.</translation>
    </message>
    <message>
        <source>Choose a shorter one.</source>
        <translation>Wählen Sie einen kürzeren.</translation>
    </message>
    <message>
        <source>Load a profile</source>
        <translation>Profil laden</translation>
    </message>
    <message>
        <source>Load all profiles</source>
        <translation>Alle Profile laden</translation>
    </message>
    <message>
        <source>Save profiles</source>
        <translation>Profile sichern</translation>
    </message>
    <message>
        <source>Load into profile %1</source>
        <translation>In Profil %1 laden</translation>
    </message>
    <message>
        <source>Profiles of the file</source>
        <translation>Profile der Datei</translation>
    </message>
    <message>
        <source>Which profile of %1?</source>
        <translation>Welches Profil aus %1?</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>Left out, as these values are not allowed: %1.</source>
        <translation>Ausgelassen, weil diese Werte nicht erlaubt sind: %1.</translation>
    </message>
    <message>
        <source>Save all profiles with their unwritten changes</source>
        <translation>Sichert alle Profile mit ihren ungeschriebenen Änderungen</translation>
    </message>
    <message>
        <source>The names could not be read. The board takes all of them at once, so the others would be erased: read the board again (F5) first.</source>
        <translation>Die Namen konnten nicht gelesen werden. Das Board übernimmt alle auf einmal, die übrigen würden also gelöscht: Lesen Sie das Board zuerst erneut (F5).</translation>
    </message>
    <message>
        <source>“%1” has %2 bytes, the board holds %3; an accented letter counts as two.</source>
        <translation>„%1“ hat %2 Bytes, das Board fasst %3; ein Buchstabe mit Akzent zählt als zwei.</translation>
    </message>
</context>
<context>
    <name>Questions</name>
    <message>
        <source>Start the motors?</source>
        <translation>Motoren starten?</translation>
    </message>
    <message>
        <source>The gimbal moves at once. Keep hands and cables clear of it.</source>
        <translation>Der Gimbal bewegt sich sofort. Hände und Kabel fernhalten.</translation>
    </message>
    <message>
        <source>Start motors</source>
        <translation>Motoren starten</translation>
    </message>
    <message>
        <source>Leave them off</source>
        <translation>Aus lassen</translation>
    </message>
    <message>
        <source>Switch to profile %1, %2?</source>
        <translation>Zu Profil %1, %2, wechseln?</translation>
    </message>
    <message>
        <source>Switch profile</source>
        <translation>Profil wechseln</translation>
    </message>
    <message>
        <source>Stay in profile %1</source>
        <translation>Bei Profil %1 bleiben</translation>
    </message>
    <message>
        <source>The sensor is turned over by hand, which motors would work against. Hold the camera: it falls when they let go. They stay off until they are started again.</source>
        <translation>Der Sensor wird von Hand gewendet, dagegen würden die Motoren arbeiten. Die Kamera festhalten: sie fällt, sobald sie loslassen. Sie bleiben aus, bis sie wieder gestartet werden.</translation>
    </message>
    <message>
        <source>Leave them on</source>
        <translation>Eingeschaltet lassen</translation>
    </message>
    <message>
        <source>%1: let the motors go?</source>
        <translation>%1: Dürfen die Motoren loslassen?</translation>
    </message>
    <message>
        <source>The motors are running. They lose their current: hold the camera, it falls when they let go.</source>
        <translation>Die Motoren laufen. Sie verlieren ihren Strom: Kamera festhalten, sie fällt, sobald sie loslassen.</translation>
    </message>
    <message>
        <source>The motors may be running. They lose their current: hold the camera, it falls when they let go.</source>
        <translation>Die Motoren laufen vielleicht. Sie verlieren ihren Strom: Kamera festhalten, sie fällt, sobald sie loslassen.</translation>
    </message>
    <message>
        <source>Do nothing</source>
        <translation>Nichts tun</translation>
    </message>
    <message>
        <source>Stop the motors?</source>
        <translation>Motoren stoppen?</translation>
    </message>
    <message>
        <source>Stop motors</source>
        <translation>Motoren stoppen</translation>
    </message>
    <message>
        <source>The motors are running: other settings act at once.</source>
        <translation>Die Motoren laufen: Andere Einstellungen wirken sofort.</translation>
    </message>
    <message>
        <source>The motors may be running: other settings act at once.</source>
        <translation>Die Motoren laufen vielleicht: Andere Einstellungen wirken sofort.</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) in use are not stored and will be lost: %1</source>
        <translation>
            <numerusform>%n benutzter Wert ist nicht gespeichert und geht verloren: %1</numerusform>
            <numerusform>%n benutzte Werte sind nicht gespeichert und gehen verloren: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Store, then go on</source>
        <translation>Speichern, dann weiter</translation>
    </message>
    <message>
        <source>%1 without storing</source>
        <translation>%1 ohne Speichern</translation>
    </message>
    <message>
        <source>Not armed: a question or a list is open over this page.</source>
        <translation>Nicht scharf geschaltet: über dieser Seite ist eine Frage oder eine Liste offen.</translation>
    </message>
    <message>
        <source>Not set while it is armed: %1. Disarm it first.</source>
        <translation>Nicht gesetzt, solange sie scharf ist: %1. Zuerst entschärfen.</translation>
    </message>
    <message>
        <source>Many times as much?</source>
        <translation>Ein Vielfaches?</translation>
    </message>
    <message>
        <source>%1. With a value far too large it swings or runs away as soon as the motors run.</source>
        <translation>%1. Mit einem viel zu großen Wert schwingt sie oder läuft davon, sobald die Motoren laufen.</translation>
    </message>
    <message>
        <source>Use it all the same</source>
        <translation>Trotzdem verwenden</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>Lassen</translation>
    </message>
</context>
<context>
    <name>RecordingsPage</name>
    <message>
        <source>Recordings</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Neu lesen</translation>
    </message>
    <message>
        <source>Ask the drone for its list once more</source>
        <translation>Die Drohne noch einmal nach ihrer Liste fragen</translation>
    </message>
    <message>
        <source>Recordings on the drone</source>
        <translation>Aufnahmen auf der Drohne</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>The list is all that a drone offers: over this link recordings can neither be downloaded nor deleted. Take them from the memory card, or log in on the drone&apos;s computer.</source>
        <translation>Mehr als die Liste bietet eine Drohne nicht: Über diese Verbindung lassen sich Aufnahmen weder herunterladen noch löschen. Nehmen Sie sie von der Speicherkarte, oder melden Sie sich auf dem Rechner der Drohne an.</translation>
    </message>
    <message>
        <source>The drone has recorded nothing.</source>
        <translation>Die Drohne hat nichts aufgenommen.</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s), %1</source>
        <translation>
            <numerusform>%n Aufnahme, %1</numerusform>
            <numerusform>%n Aufnahmen, %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) of its list could not be read.</source>
        <translation>
            <numerusform>%n Eintrag ihrer Liste ließ sich nicht lesen.</numerusform>
            <numerusform>%n Einträge ihrer Liste ließen sich nicht lesen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Asking the drone…</source>
        <translation>Die Drohne wird gefragt…</translation>
    </message>
    <message>
        <source>It is not connected now.</source>
        <translation>Jetzt ist sie nicht verbunden.</translation>
    </message>
    <message>
        <source>The drone has not told its list.</source>
        <translation>Die Drohne hat ihre Liste nicht erzählt.</translation>
    </message>
    <message>
        <source>Connect a drone to see what it has recorded.</source>
        <translation>Verbinden Sie eine Drohne, um zu sehen, was sie aufgenommen hat.</translation>
    </message>
</context>
<context>
    <name>ReplayBar</name>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Place in the recording</source>
        <translation>Stelle der Aufzeichnung</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Speed of the recording</source>
        <translation>Geschwindigkeit der Aufzeichnung</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>Ende</translation>
    </message>
</context>
<context>
    <name>ResponseCharts</name>
    <message>
        <source>Step response</source>
        <translation>Sprungantwort</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Kohärenz</translation>
    </message>
    <message>
        <source>Arm, then Start: the axis steps back and forth, and its response appears here.</source>
        <translation>Scharf schalten, dann Start: die Achse springt hin und her, und hier steht, wie sie ankommt.</translation>
    </message>
    <message>
        <source>Arm, then Start: the axis sways faster and faster, and how it follows appears here.</source>
        <translation>Scharf schalten, dann Start: die Achse schwingt immer schneller, und hier steht, wie sie folgt.</translation>
    </message>
    <message>
        <source>%g ms</source>
        <translation>%g ms</translation>
    </message>
    <message>
        <source>Share of the way</source>
        <translation>Anteil des Weges</translation>
    </message>
    <message>
        <source>%g Hz</source>
        <translation>%g Hz</translation>
    </message>
    <message>
        <source>Gain, dB</source>
        <translation>Verstärkung, dB</translation>
    </message>
    <message>
        <source>Phase, °</source>
        <translation>Phase, °</translation>
    </message>
</context>
<context>
    <name>ResponsePage</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Scharf schalten</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Gleitsinus</translation>
    </message>
    <message>
        <source>Own motion</source>
        <translation>Eigene Bewegung</translation>
    </message>
    <message>
        <source>Kind of test</source>
        <translation>Art des Versuchs</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren…</translation>
    </message>
    <message>
        <source>A measurement of another tool: a text file with two columns, in;out</source>
        <translation>Eine Messung eines anderen Werkzeugs: eine Textdatei mit zwei Spalten, in;out</translation>
    </message>
    <message>
        <source>Both sides of the chosen measurement as in;out</source>
        <translation>Beide Seiten der gewählten Messung als in;out</translation>
    </message>
    <message>
        <source>Import a measurement</source>
        <translation>Messung importieren</translation>
    </message>
    <message>
        <source>Text files (*.csv *.txt);;All files (*)</source>
        <translation>Textdateien (*.csv *.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export a measurement</source>
        <translation>Messung exportieren</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>CSV-Dateien (*.csv)</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Movement</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Progress of the test</source>
        <translation>Fortschritt des Versuchs</translation>
    </message>
    <message>
        <source>■ Disarm</source>
        <translation>■ Entschärfen</translation>
    </message>
    <message>
        <source>Steer the axis to and fro for a while, by hand controller or on the Control page; then measure.</source>
        <translation>Steuern Sie die Achse eine Weile hin und her, mit der Fernbedienung oder auf der Seite Steuern; dann messen Sie.</translation>
    </message>
    <message>
        <source>The axis is being moved. Keep your hands off the camera.</source>
        <translation>Die Achse wird bewegt. Hände weg von der Kamera.</translation>
    </message>
    <message>
        <source>Armed: Start moves the axis by %1°. Keep clear.</source>
        <translation>Scharf: Start bewegt die Achse um %1°. Abstand halten.</translation>
    </message>
    <message>
        <source>Not armed: nothing moves. The motors must run and hold the camera.</source>
        <translation>Nicht scharf: nichts bewegt sich. Die Motoren müssen laufen und die Kamera halten.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Test of %1 begins</source>
        <translation>Versuch mit %1 beginnt</translation>
    </message>
    <message>
        <source>Test of %1 is over</source>
        <translation>Versuch mit %1 ist zu Ende</translation>
    </message>
    <message>
        <source>Test was ended</source>
        <translation>Versuch wurde beendet</translation>
    </message>
    <message>
        <source>The test was ended; control was given back.</source>
        <translation>Der Versuch wurde beendet; die Steuerung wurde zurückgegeben.</translation>
    </message>
    <message>
        <source>The samples tell nothing about how the axis follows.</source>
        <translation>Die Messwerte sagen nichts darüber, wie die Achse folgt.</translation>
    </message>
    <message>
        <source>Make the movement larger, or give it more time.</source>
        <translation>Vergrößern Sie die Bewegung oder geben Sie ihr mehr Zeit.</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Rise</source>
        <translation>Anstieg</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>Settled after</source>
        <translation>Beruhigt nach</translation>
    </message>
    <message>
        <source>Left over</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>Amplitudenreserve</translation>
    </message>
    <message>
        <source>Bandwidth</source>
        <translation>Bandbreite</translation>
    </message>
    <message>
        <source>Greatest sensitivity</source>
        <translation>Größte Empfindlichkeit</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1° at %2 Hz</source>
        <translation>%1° bei %2 Hz</translation>
    </message>
    <message>
        <source>%1 dB at %2 Hz</source>
        <translation>%1 dB bei %2 Hz</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>The file does not state its rate; %1 samples/s are assumed.</source>
        <translation>Die Datei nennt ihre Rate nicht; %1 Werte/s werden angenommen.</translation>
    </message>
    <message>
        <source>Step: how fast and how calmly the axis arrives. Sweep: margins, by moving it slowly, then ever faster. Own motion: the same from what you steered just now.</source>
        <translation>Sprung: wie schnell und wie ruhig die Achse ankommt. Gleitsinus: Reserven, indem sie langsam und dann immer schneller bewegt wird. Eigene Bewegung: dasselbe aus dem, was Sie eben gesteuert haben.</translation>
    </message>
    <message>
        <source>This board does not report its targets: the line&apos;s delay would be mistaken for its own.</source>
        <translation>Dieses Board nennt seine Ziele nicht: Die Verzögerung der Leitung würde für seine eigene gehalten.</translation>
    </message>
    <message>
        <source>Armed: Start brings the camera to its middle, then moves the axis by %1°. Keep clear.</source>
        <translation>Scharf: Start bringt die Kamera in ihre Mitte und bewegt dann die Achse um %1°. Abstand halten.</translation>
    </message>
    <message>
        <source>The test ended with the link: nothing was measured, and the camera may go on as it was moved last.</source>
        <translation>Der Test endete mit der Verbindung: Es wurde nichts gemessen, und die Kamera bewegt sich vielleicht so weiter wie zuletzt.</translation>
    </message>
</context>
<context>
    <name>ReviewDialog</name>
    <message>
        <source>Review and write</source>
        <translation>Prüfen und schreiben</translation>
    </message>
    <message>
        <source>Changes to write</source>
        <translation>Zu schreibende Änderungen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n Wert</numerusform>
            <numerusform>%n Werte</numerusform>
        </translation>
    </message>
    <message>
        <source>Write %1 to %2 profiles</source>
        <translation>%1 in %2 Profile schreiben</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>%1 schreiben</translation>
    </message>
    <message>
        <source>The board restarts when they are written.</source>
        <translation>Das Board startet neu, wenn sie geschrieben werden.</translation>
    </message>
    <message>
        <source>Some of them are in use only until the board restarts.</source>
        <translation>Einige davon gelten nur, bis das Board neu startet.</translation>
    </message>
    <message>
        <source>Not compared, because it could not be read: %1.</source>
        <translation>Nicht verglichen, weil nicht gelesen: %1.</translation>
    </message>
    <message>
        <source>These values go to the board. They are read back and compared, and a copy of what could be read of the board is kept before the first write.</source>
        <translation>Diese Werte gehen auf das Board. Sie werden zurückgelesen und verglichen, und vor dem ersten Schreiben wird gesichert, was vom Board gelesen werden konnte.</translation>
    </message>
    <message>
        <source>Other values in use</source>
        <translation>Andere Werte in Gebrauch</translation>
    </message>
    <message>
        <source>Leave them in use, without storing them</source>
        <translation>In Gebrauch lassen, nicht speichern</translation>
    </message>
    <message>
        <source>Store them too</source>
        <translation>Mitspeichern</translation>
    </message>
    <message>
        <source>Put the stored values into use first</source>
        <translation>Zuerst die gespeicherten Werte in Gebrauch nehmen</translation>
    </message>
    <message>
        <source>%1: %2 in use, %3 stored</source>
        <translation>%1: %2 in Gebrauch, %3 gespeichert</translation>
    </message>
    <message numerus="yes">
        <source>%n other value(s) in use are not stored:</source>
        <translation>
            <numerusform>%n anderer Wert in Gebrauch ist nicht gespeichert:</numerusform>
            <numerusform>%n andere Werte in Gebrauch sind nicht gespeichert:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiterer</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other value(s) in use are not stored; the board goes back to the stored ones:</source>
        <translation>
            <numerusform>%n anderer Wert in Gebrauch ist nicht gespeichert; das Board kehrt zum gespeicherten zurück:</numerusform>
            <numerusform>%n andere Werte in Gebrauch sind nicht gespeichert; das Board kehrt zu den gespeicherten zurück:</numerusform>
        </translation>
    </message>
    <message>
        <source>These values go to the board. They are read back and compared, and a copy of all settings of the board is kept before the first write.</source>
        <translation>Diese Werte gehen auf das Board. Sie werden zurückgelesen und verglichen, und vor dem ersten Schreiben werden alle Einstellungen des Boards gesichert.</translation>
    </message>
    <message>
        <source>⚠ Some of these values are in the risk class. They act at once where motors run, otherwise when they start: hold the camera, or take it off.</source>
        <translation>⚠ Manche dieser Werte gehören zur Risikoklasse. Laufen die Motoren, wirken sie sofort, sonst beim Anlaufen: Halten Sie die Kamera, oder nehmen Sie sie ab.</translation>
    </message>
    <message>
        <source>Lines that change</source>
        <translation>Zeilen, die sich ändern</translation>
    </message>
    <message>
        <source>⚠ Some of these values are in the risk class: with a wrong one the drone swings at once when it is armed. Try them with the propellers off, or in a test stand.</source>
        <translation>⚠ Einige dieser Werte gehören zur Risikoklasse: mit einem falschen pendelt die Drohne sofort, wenn sie scharf ist. Mit abgenommenen Propellern oder im Teststand ausprobieren.</translation>
    </message>
    <message>
        <source>Line %1: %2.</source>
        <translation>Zeile %1: %2.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>Read without running it, nothing was found against the text. That does not prove that the board starts or flies with it.</source>
        <translation>Gelesen, ohne ihn auszuführen: Gegen den Text wurde nichts gefunden. Das beweist nicht, dass das Board mit ihm startet oder fliegt.</translation>
    </message>
    <message>
        <source>⚠ This speaks against the text:</source>
        <translation>⚠ Das spricht gegen den Text:</translation>
    </message>
</context>
<context>
    <name>ScriptSlotsPage</name>
    <message numerus="yes">
        <source>%n byte(s)</source>
        <translation>
            <numerusform>%n Byte</numerusform>
            <numerusform>%n Bytes</numerusform>
        </translation>
    </message>
    <message>
        <source>Scripts</source>
        <translation>Skripte</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Sichern…</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Run…</source>
        <translation>Ausführen…</translation>
    </message>
    <message>
        <source>Run and follow…</source>
        <translation>Ausführen und verfolgen…</translation>
    </message>
    <message>
        <source>Stop script</source>
        <translation>Skript anhalten</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Neu lesen</translation>
    </message>
    <message>
        <source>Ask the board once more what is in its slots</source>
        <translation>Das Board noch einmal fragen, was in seinen Plätzen ist</translation>
    </message>
    <message>
        <source>Slots</source>
        <translation>Plätze</translation>
    </message>
    <message>
        <source>Slots for scripts</source>
        <translation>Plätze für Skripte</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>Script</source>
        <translation>Skript</translation>
    </message>
    <message>
        <source>Kept from before</source>
        <translation>Aufgehoben</translation>
    </message>
    <message>
        <source>Write a compiled script from a file into the slot, and read it back. A script that runs is stopped first; what is in the slot is kept</source>
        <translation>Ein übersetztes Skript aus einer Datei in den Platz schreiben und zurücklesen. Ein laufendes Skript wird vorher angehalten; was im Platz ist, wird aufgehoben</translation>
    </message>
    <message>
        <source>Copy the script in the slot into a file</source>
        <translation>Das Skript im Platz in eine Datei kopieren</translation>
    </message>
    <message>
        <source>Write what was in the slot before into it again</source>
        <translation>Wieder in den Platz schreiben, was vorher darin war</translation>
    </message>
    <message>
        <source>What runs</source>
        <translation>Was läuft</translation>
    </message>
    <message>
        <source>Start the script in the slot</source>
        <translation>Das Skript im Platz starten</translation>
    </message>
    <message>
        <source>Start the script in the slot and show each command that the board carries out</source>
        <translation>Das Skript im Platz starten und jeden Befehl zeigen, den das Board ausführt</translation>
    </message>
    <message>
        <source>Stop the script that runs; the motors go on</source>
        <translation>Das laufende Skript anhalten; die Motoren laufen weiter</translation>
    </message>
    <message>
        <source>“STOP MOTORS” ends a script that is followed here. One that was started otherwise goes on and may start the motors again: stop it as well.</source>
        <translation>„MOTOREN STOPPEN“ beendet ein Skript, das hier verfolgt wird. Ein anders gestartetes läuft weiter und kann die Motoren wieder starten: Halten Sie es ebenfalls an.</translation>
    </message>
    <message>
        <source>Scripts are stored compiled. This program has no compiler for them and cannot show what one does: it copies them as files, as they are. Compile a script with the maker&apos;s program.</source>
        <translation>Skripte sind übersetzt gespeichert. Dieses Programm hat keinen Übersetzer dafür und kann nicht zeigen, was eines tut: Es kopiert sie als Dateien, wie sie sind. Übersetzen Sie ein Skript mit dem Programm des Herstellers.</translation>
    </message>
    <message>
        <source>Compiled scripts (*.bin);;All files (*)</source>
        <translation>Übersetzte Skripte (*.bin);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Load a script</source>
        <translation>Skript laden</translation>
    </message>
    <message>
        <source>Save the script</source>
        <translation>Skript sichern</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>Nicht bekannt</translation>
    </message>
    <message>
        <source>No command tells whether a script runs that was not started here.</source>
        <translation>Kein Befehl sagt, ob ein Skript läuft, das nicht von hier gestartet wurde.</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>⚠ %1, not certain</source>
        <translation>⚠ %1, nicht sicher</translation>
    </message>
    <message>
        <source>Connect a board to see its scripts.</source>
        <translation>Verbinden Sie ein Board, um seine Skripte zu sehen.</translation>
    </message>
    <message>
        <source>Asking the board…</source>
        <translation>Das Board wird gefragt…</translation>
    </message>
    <message>
        <source>%1 of %2 slots hold a script.</source>
        <translation>%1 von %2 Plätzen enthalten ein Skript.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Slot %1 held this script already.</source>
        <translation>Platz %1 enthielt dieses Skript schon.</translation>
    </message>
    <message>
        <source>Writing slot %1…</source>
        <translation>Platz %1 wird geschrieben…</translation>
    </message>
    <message>
        <source>Slot %1 holds the script, read back byte for byte: %2.</source>
        <translation>Platz %1 enthält das Skript, Byte für Byte zurückgelesen: %2.</translation>
    </message>
    <message>
        <source>Reading slot %1…</source>
        <translation>Platz %1 wird gelesen…</translation>
    </message>
    <message>
        <source>The script in slot %1 is saved: %2.</source>
        <translation>Das Skript in Platz %1 ist gesichert: %2.</translation>
    </message>
    <message>
        <source>Erasing slot %1…</source>
        <translation>Platz %1 wird gelöscht…</translation>
    </message>
    <message>
        <source>Slot %1 is empty now.</source>
        <translation>Platz %1 ist jetzt leer.</translation>
    </message>
    <message>
        <source>The motors may be running.</source>
        <translation>Die Motoren laufen vielleicht.</translation>
    </message>
    <message>
        <source>The motors are running.</source>
        <translation>Die Motoren laufen.</translation>
    </message>
    <message>
        <source>The motors are off now; a script can start them.</source>
        <translation>Die Motoren sind jetzt aus; ein Skript kann sie starten.</translation>
    </message>
    <message>
        <source>Run script %1?</source>
        <translation>Skript %1 ausführen?</translation>
    </message>
    <message>
        <source>Nobody can read in a compiled script what it does: it may turn the camera, start or stop motors and change what is in use.</source>
        <translation>In einem übersetzten Skript kann niemand lesen, was es tut: Es kann die Kamera drehen, Motoren starten oder anhalten und ändern, was gilt.</translation>
    </message>
    <message>
        <source>Keep hands and cables clear.</source>
        <translation>Halten Sie Hände und Kabel fern.</translation>
    </message>
    <message>
        <source>Run script %1</source>
        <translation>Skript %1 ausführen</translation>
    </message>
    <message>
        <source>Do not run it</source>
        <translation>Nicht ausführen</translation>
    </message>
    <message>
        <source>Script %1 runs</source>
        <translation>Skript %1 läuft</translation>
    </message>
    <message>
        <source>The board has told that it began. Its end is not watched from here.</source>
        <translation>Das Board hat gemeldet, dass es begonnen hat. Sein Ende wird von hier nicht verfolgt.</translation>
    </message>
    <message>
        <source>Script %1 was started</source>
        <translation>Skript %1 wurde gestartet</translation>
    </message>
    <message>
        <source>The board confirms it, and nothing shows whether it runs.</source>
        <translation>Das Board bestätigt es, und nichts zeigt, ob es läuft.</translation>
    </message>
    <message>
        <source>Script %1 is started…</source>
        <translation>Skript %1 wird gestartet…</translation>
    </message>
    <message>
        <source>Script %1: command %2</source>
        <translation>Skript %1: Befehl %2</translation>
    </message>
    <message>
        <source>The board tells each command that it carries out.</source>
        <translation>Das Board meldet jeden Befehl, den es ausführt.</translation>
    </message>
    <message numerus="yes">
        <source>No other command for %n second(s): it waits, or has ended.</source>
        <translation>
            <numerusform>Seit %n Sekunde kein weiterer Befehl: Es wartet oder ist zu Ende.</numerusform>
            <numerusform>Seit %n Sekunden kein weiterer Befehl: Es wartet oder ist zu Ende.</numerusform>
        </translation>
    </message>
    <message>
        <source>Its last command was %1.</source>
        <translation>Sein letzter Befehl war %1.</translation>
    </message>
    <message>
        <source>Script %1 has ended</source>
        <translation>Skript %1 ist zu Ende</translation>
    </message>
    <message>
        <source>The board has told so.</source>
        <translation>Das Board hat es gemeldet.</translation>
    </message>
    <message>
        <source>Script %1 tells nothing any more</source>
        <translation>Skript %1 meldet nichts mehr</translation>
    </message>
    <message>
        <source>It has ended, or waits: stop it before you rely on either.</source>
        <translation>Es ist zu Ende oder wartet: Halten Sie es an, bevor Sie sich auf eines davon verlassen.</translation>
    </message>
    <message>
        <source>Script %1 was not started</source>
        <translation>Skript %1 wurde nicht gestartet</translation>
    </message>
    <message>
        <source>Script %1 was stopped</source>
        <translation>Skript %1 wurde angehalten</translation>
    </message>
    <message>
        <source>The link was lost: it may run on. Stop it once the board is back.</source>
        <translation>Die Verbindung ging verloren: Es läuft vielleicht weiter. Halten Sie es an, sobald das Board wieder da ist.</translation>
    </message>
    <message>
        <source>Script %1 broke off</source>
        <translation>Skript %1 brach ab</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>The board has told that a script ended.</source>
        <translation>Das Board hat gemeldet, dass ein Skript zu Ende ging.</translation>
    </message>
    <message>
        <source>Told to stop</source>
        <translation>Halt befohlen</translation>
    </message>
    <message>
        <source>The board confirms it. Whether a script ran before, nothing shows.</source>
        <translation>Das Board bestätigt es. Ob vorher ein Skript lief, zeigt nichts.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Empty the slot. What is in it is kept, and can be restored</source>
        <translation>Den Platz leeren. Was darin ist, wird aufgehoben und lässt sich wiederherstellen</translation>
    </message>
    <message>
        <source>⚠ Writing slot %1 was broken off: what it holds is not certain, and it is not run. Load the script again, restore what was there, or erase it.</source>
        <translation>⚠ Das Schreiben von Platz %1 wurde abgebrochen: Was er enthält, ist nicht sicher, und es wird nicht ausgeführt. Laden Sie das Skript neu, stellen Sie wieder her, was darin war, oder löschen Sie es.</translation>
    </message>
    <message>
        <source>What was in it is kept, and can be restored.</source>
        <translation>Was darin war, ist aufgehoben und lässt sich wiederherstellen.</translation>
    </message>
    <message>
        <source>Commands as the board tells them</source>
        <translation>Befehle, wie das Board sie meldet</translation>
    </message>
    <message>
        <source>Commands of the script</source>
        <translation>Befehle des Skripts</translation>
    </message>
    <message>
        <source>%1 s: command %2</source>
        <translation>%1 s: Befehl %2</translation>
    </message>
</context>
<context>
    <name>ScriptsPage</name>
    <message>
        <source>Scripts</source>
        <translation>Skripte</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Sichern…</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Put the text of a file into this script</source>
        <translation>Den Text einer Datei in dieses Skript übernehmen</translation>
    </message>
    <message>
        <source>Save the text of this script</source>
        <translation>Den Text dieses Skripts sichern</translation>
    </message>
    <message>
        <source>Throw away what was typed since it was taken over</source>
        <translation>Verwerfen, was seit der Übernahme eingegeben wurde</translation>
    </message>
    <message>
        <source>Make the texts an edit of the configuration; nothing is on the board before you review and write</source>
        <translation>Die Texte zu einer Änderung der Konfiguration machen; auf dem Board ist nichts, bevor Sie prüfen und schreiben</translation>
    </message>
    <message>
        <source>Text of the script</source>
        <translation>Text des Skripts</translation>
    </message>
    <message>
        <source>Code of the script</source>
        <translation>Code des Skripts</translation>
    </message>
    <message>
        <source>Memory used</source>
        <translation>Belegter Speicher</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Script %1</source>
        <translation>Skript %1</translation>
    </message>
    <message>
        <source>Connect a board, or open a file, to see its scripts.</source>
        <translation>Verbinden Sie ein Board oder öffnen Sie eine Datei, um ihre Skripte zu sehen.</translation>
    </message>
    <message>
        <source>The scripts of this board cannot be read over this link.</source>
        <translation>Die Skripte dieses Boards lassen sich über diese Verbindung nicht lesen.</translation>
    </message>
    <message>
        <source>%1 of %2 bytes used by all scripts</source>
        <translation>%1 von %2 Bytes von allen Skripten belegt</translation>
    </message>
    <message>
        <source>✓ Nothing is wrong with it. Take it over to have it written.</source>
        <translation>✓ Alles in Ordnung. Übernehmen Sie es, damit es geschrieben wird.</translation>
    </message>
    <message>
        <source>This script is empty. Words are completed while you type.</source>
        <translation>Dieses Skript ist leer. Wörter werden beim Tippen ergänzt.</translation>
    </message>
    <message>
        <source>✓ As in the configuration.</source>
        <translation>✓ Wie in der Konfiguration.</translation>
    </message>
    <message>
        <source>Load a script</source>
        <translation>Skript laden</translation>
    </message>
    <message>
        <source>Scripts (*.%1)</source>
        <translation>Skripte (*.%1)</translation>
    </message>
    <message>
        <source>Save the script</source>
        <translation>Skript sichern</translation>
    </message>
    <message>
        <source>Script %1, line %2: %3</source>
        <translation>Skript %1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>Script %1: %2</source>
        <translation>Skript %1: %2</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>The scripts did not come. Read the board again (F5).</source>
        <translation>Die Skripte kamen nicht an. Lesen Sie das Board erneut (F5).</translation>
    </message>
    <message>
        <source>The board stores no comments. Save the script to a file to keep them.</source>
        <translation>Das Board speichert keine Kommentare. Sichern Sie das Skript in einer Datei, um sie zu behalten.</translation>
    </message>
    <message>
        <source>Discard what was typed?</source>
        <translation>Getipptes verwerfen?</translation>
    </message>
    <message numerus="yes">
        <source>The texts of %n other script(s) that were not taken over are lost as well.</source>
        <translation>
            <numerusform>Der Text %n anderen Skripts, der nicht übernommen wurde, geht ebenfalls verloren.</numerusform>
            <numerusform>Die Texte von %n anderen Skripten, die nicht übernommen wurden, gehen ebenfalls verloren.</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep them</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>No code: a script has a mistake</source>
        <translation>Kein Code: Ein Skript hat einen Fehler</translation>
    </message>
</context>
<context>
    <name>SearchBar</name>
    <message>
        <source>Search in the text</source>
        <translation>Im Text suchen</translation>
    </message>
    <message>
        <source>Previous place</source>
        <translation>Vorige Stelle</translation>
    </message>
    <message>
        <source>Previous place (Shift+F3)</source>
        <translation>Vorige Stelle (Umschalt+F3)</translation>
    </message>
    <message>
        <source>Next place</source>
        <translation>Nächste Stelle</translation>
    </message>
    <message>
        <source>Next place (F3 or Enter)</source>
        <translation>Nächste Stelle (F3 oder Eingabe)</translation>
    </message>
    <message>
        <source>Close the search</source>
        <translation>Suche schließen</translation>
    </message>
    <message>
        <source>Close the search (Esc)</source>
        <translation>Suche schließen (Esc)</translation>
    </message>
    <message>
        <source>Not found</source>
        <translation>Nicht gefunden</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n Stelle</numerusform>
            <numerusform>%n Stellen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SensorCube</name>
    <message>
        <source>Position of the sensor</source>
        <translation>Lage des Sensors</translation>
    </message>
    <message>
        <source>tilted</source>
        <translation>schräg</translation>
    </message>
</context>
<context>
    <name>SensorPage</name>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Load a calibration…</source>
        <translation>Kalibrierung laden…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Sichern…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Camera sensor (Imu)</source>
        <translation>Kamerasensor (Imu)</translation>
    </message>
    <message>
        <source>Frame sensor (Imu2)</source>
        <translation>Rahmensensor (Imu2)</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Look at a calibration from a file before it is stored</source>
        <translation>Eine Kalibrierung aus einer Datei ansehen, bevor sie gespeichert wird</translation>
    </message>
    <message>
        <source>Load a calibration</source>
        <translation>Kalibrierung laden</translation>
    </message>
    <message>
        <source>Save the calibration</source>
        <translation>Kalibrierung sichern</translation>
    </message>
    <message>
        <source>⚠ Take the battery off and work on USB power alone, so that the motors cannot move. Nothing is stored before you have seen the result.</source>
        <translation>⚠ Nehmen Sie den Akku ab und arbeiten Sie nur mit USB-Strom, damit sich die Motoren nicht bewegen. Gespeichert wird erst, wenn Sie das Ergebnis gesehen haben.</translation>
    </message>
    <message>
        <source>Accelerometer, one position</source>
        <translation>Beschleunigungssensor, eine Lage</translation>
    </message>
    <message>
        <source>Finds the zeros of the three axes. Takes two seconds while the sensor lies level and still, as it is mounted. Good enough for a horizon that is a little crooked.</source>
        <translation>Findet die Nullpunkte der drei Achsen. Dauert zwei Sekunden, während der Sensor waagerecht und still liegt, wie er eingebaut ist. Genügt bei einem leicht schiefen Horizont.</translation>
    </message>
    <message>
        <source>Calibrate one position</source>
        <translation>Eine Lage kalibrieren</translation>
    </message>
    <message>
        <source>Accelerometer, six positions</source>
        <translation>Beschleunigungssensor, sechs Lagen</translation>
    </message>
    <message>
        <source>Finds zeros and scales, for a horizon that stays straight at every angle. Each of the sensor&apos;s six faces has to lie up once, in any order. Takes about a minute.</source>
        <translation>Findet Nullpunkte und Maßstäbe, für einen Horizont, der bei jedem Winkel gerade bleibt. Jede der sechs Flächen des Sensors muss einmal oben liegen, in beliebiger Reihenfolge. Dauert etwa eine Minute.</translation>
    </message>
    <message>
        <source>Calibrate six positions</source>
        <translation>Sechs Lagen kalibrieren</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Fortschritt der Messung</translation>
    </message>
    <message>
        <source>Waiting for readings of the sensor.</source>
        <translation>Es wird auf Messwerte des Sensors gewartet.</translation>
    </message>
    <message>
        <source>Lay the sensor on its faces, one after the other, and let it lie still on each.</source>
        <translation>Legen Sie den Sensor nacheinander auf seine Flächen und lassen Sie ihn jedes Mal still liegen.</translation>
    </message>
    <message>
        <source>Let the sensor lie level and still, as it is mounted.</source>
        <translation>Lassen Sie den Sensor waagerecht und still liegen, wie er eingebaut ist.</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>%1 lies still: measuring. Do not touch it.</source>
        <translation>%1 liegt still: Messung läuft. Nicht berühren.</translation>
    </message>
    <message>
        <source>It moves. Waiting until it lies still.</source>
        <translation>Bewegung. Es geht weiter, sobald alles still liegt.</translation>
    </message>
    <message>
        <source>It is tilted. Waiting until one face lies up.</source>
        <translation>Schräg. Es geht weiter, sobald eine Seite oben liegt.</translation>
    </message>
    <message numerus="yes">
        <source>%1 is done. %n face(s) to go: turn the sensor.</source>
        <translation>
            <numerusform>%1 ist fertig. Noch %n Fläche: drehen Sie den Sensor.</numerusform>
            <numerusform>%1 ist fertig. Noch %n Flächen: drehen Sie den Sensor.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 lies up. Waiting until it has been still for a moment.</source>
        <translation>%1. Es geht weiter, sobald alles einen Moment still gelegen hat.</translation>
    </message>
    <message>
        <source>Calibration from the file</source>
        <translation>Kalibrierung aus der Datei</translation>
    </message>
    <message>
        <source>⚠ No working sensor has such values. One of the readings was bad: calibrate again.</source>
        <translation>⚠ So ist kein gesunder Sensor. Eine der Messungen war schlecht: kalibrieren Sie noch einmal.</translation>
    </message>
    <message>
        <source>The calibration is good.</source>
        <translation>Die Kalibrierung ist gut.</translation>
    </message>
    <message>
        <source>The calibration is usable.</source>
        <translation>Die Kalibrierung ist brauchbar.</translation>
    </message>
    <message>
        <source>The calibration is poor: the sensor did not lie square on its faces. Calibrate again.</source>
        <translation>Die Kalibrierung ist schlecht: Flächen lagen nicht gerade. Kalibrieren Sie noch einmal.</translation>
    </message>
    <message>
        <source>The zeros are found.</source>
        <translation>Die Nullpunkte sind gefunden.</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Nullpunkt</translation>
    </message>
    <message>
        <source>Counts per g</source>
        <translation>Zählwerte je g</translation>
    </message>
    <message>
        <source>Quality: %1 g off axis; good is below %2 g.</source>
        <translation>Güte: %1 g neben der Achse; gut ist unter %2 g.</translation>
    </message>
    <message>
        <source>Measured at %1 °C.</source>
        <translation>Gemessen bei %1 °C.</translation>
    </message>
    <message>
        <source>Nothing is on the board yet. Storing replaces the calibration of the sensor chosen above.</source>
        <translation>Auf dem Board ist noch nichts. Speichern ersetzt die Kalibrierung des oben gewählten Sensors.</translation>
    </message>
    <message>
        <source>Store although it is implausible</source>
        <translation>Speichern, obwohl unglaubwürdig</translation>
    </message>
    <message>
        <source>The calibration is stored and read back.</source>
        <translation>Die Kalibrierung ist gespeichert und zurückgelesen.</translation>
    </message>
    <message>
        <source>Store on the board</source>
        <translation>Auf dem Board speichern</translation>
    </message>
    <message>
        <source>%1 of 6 faces were measured; nothing of it is on the board.</source>
        <translation>%1 von 6 Seiten wurden gemessen; auf dem Board ist nichts davon.</translation>
    </message>
    <message>
        <source>Nothing of it is on the board.</source>
        <translation>Auf dem Board ist nichts davon.</translation>
    </message>
    <message>
        <source>The calibration ended with the link.</source>
        <translation>Die Kalibrierung endete mit der Verbindung.</translation>
    </message>
    <message>
        <source>It measures %1 g instead of 1 g, which no sensor at rest does: it is not taken. Let it lie still, or check the sensor.</source>
        <translation>Er misst %1 g statt 1 g, was kein ruhender Sensor tut: Das wird nicht übernommen. Lassen Sie ihn still liegen, oder prüfen Sie den Sensor.</translation>
    </message>
</context>
<context>
    <name>SettingsPage</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Degrees Celsius</source>
        <translation>Grad Celsius</translation>
    </message>
    <message>
        <source>Degrees Fahrenheit</source>
        <translation>Grad Fahrenheit</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>not by Esc</source>
        <translation>nicht durch Esc</translation>
    </message>
    <message>
        <source> °/s</source>
        <translation> °/s</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Look and language</source>
        <translation>Aussehen und Sprache</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Temperatures</source>
        <translation>Temperaturen</translation>
    </message>
    <message>
        <source>Live data</source>
        <translation>Live-Daten</translation>
    </message>
    <message>
        <source>Keep in memory</source>
        <translation>Im Speicher behalten</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Highest speed on Control</source>
        <translation>Höchste Geschwindigkeit</translation>
    </message>
    <message>
        <source>Disarm control after</source>
        <translation>Steuerung entschärfen nach</translation>
    </message>
    <message>
        <source>Always on, and cannot be switched off: a snapshot before the first write, reading back of every byte, F12 for motors off, and control that ends when the program does not refresh it.</source>
        <translation>Immer so und nicht abzuschalten: eine Sicherung vor dem ersten Schreiben, Zurücklesen jedes Bytes, F12 für Motoren aus und eine Steuerung, die endet, wenn das Programm sie nicht erneuert.</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Über</translation>
    </message>
    <message>
        <source>GimbalDesk %1, GPL 3.0 or later. Settings: %2. Snapshots: %3.</source>
        <translation>GimbalDesk %1, GPL 3.0 oder neuer. Einstellungen: %2. Sicherungen: %3.</translation>
    </message>
    <message>
        <source>At most %1 MB with 24 channels at full rate. The last ten minutes of the link itself, for recordings, take up to %2 MB more.</source>
        <translation>Höchstens %1 MB mit 24 Kanälen bei voller Rate. Die letzten zehn Minuten der Leitung selbst, für Aufzeichnungen, brauchen bis zu %2 MB dazu.</translation>
    </message>
    <message>
        <source>Supervisor</source>
        <translation>Aufsicht</translation>
    </message>
    <message>
        <source>The language changes as soon as what runs, or is half done on a page, has ended.</source>
        <translation>Die Sprache wechselt, sobald beendet ist, was läuft oder auf einer Seite halb fertig ist.</translation>
    </message>
    <message>
        <source>Ask before the link ends while motors run</source>
        <translation>Fragen, bevor die Verbindung bei laufenden Motoren endet</translation>
    </message>
    <message>
        <source>Stop the motors when the program is closed</source>
        <translation>Motoren stoppen, wenn das Programm geschlossen wird</translation>
    </message>
    <message>
        <source>Hold Esc to stop the motors</source>
        <translation>Esc halten, um die Motoren zu stoppen</translation>
    </message>
</context>
<context>
    <name>SettingsPicture</name>
    <message>
        <source>%1 · bold differs from the default · GimbalDesk</source>
        <translation>%1 · fett weicht vom Vorgabewert ab · GimbalDesk</translation>
    </message>
    <message>
        <source>not read: %1</source>
        <translation>nicht gelesen: %1</translation>
    </message>
</context>
<context>
    <name>SetupButton</name>
    <message>
        <source>Gimbal setup</source>
        <translation>Gimbal einrichten</translation>
    </message>
    <message>
        <source>Steps of the guided set-up that belong to this page.</source>
        <translation>Schritte der geführten Einrichtung, die zu dieser Seite gehören.</translation>
    </message>
</context>
<context>
    <name>SetupPage</name>
    <message>
        <source>Gimbal setup</source>
        <translation>Gimbal einrichten</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>held level</source>
        <translation>waagerecht gehalten</translation>
    </message>
    <message>
        <source>tilted 45° down</source>
        <translation>45° nach unten geneigt</translation>
    </message>
    <message>
        <source>✖ The link broke; the setup ended here.</source>
        <translation>✖ Die Verbindung ist abgebrochen; die Einrichtung endete hier.</translation>
    </message>
    <message>
        <source>Orientation of the sensors</source>
        <translation>Ausrichtung der Sensoren</translation>
    </message>
    <message>
        <source>Poles of the motors</source>
        <translation>Pole der Motoren</translation>
    </message>
    <message>
        <source>Motor directions: find them</source>
        <translation>Motorrichtungen: finden</translation>
    </message>
    <message>
        <source>Motor directions: keep what was found</source>
        <translation>Motorrichtungen: gefundene behalten</translation>
    </message>
    <message>
        <source>Start positions of pitch and roll</source>
        <translation>Startlagen von Pitch und Roll</translation>
    </message>
    <message>
        <source>Align yaw</source>
        <translation>Yaw ausrichten</translation>
    </message>
    <message>
        <source>How long the position has been held</source>
        <translation>Wie lange es schon so ist, wie es soll</translation>
    </message>
    <message>
        <source>Poles, %1</source>
        <translation>Pole, %1</translation>
    </message>
    <message>
        <source>Turn by %1° to the left</source>
        <translation>Um %1° nach links drehen</translation>
    </message>
    <message>
        <source>Turn by %1° to the right</source>
        <translation>Um %1° nach rechts drehen</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Set the gimbal up after building it, or after changing a motor or a sensor.</source>
        <translation>Richten Sie den Gimbal nach dem Bau ein, oder nachdem Sie einen Motor oder Sensor getauscht haben.</translation>
    </message>
    <message>
        <source>Tick the tasks. The motors are disabled first; you are told before they start. Nothing is stored before the end, so switching the board off takes everything back.</source>
        <translation>Wählen Sie die Aufgaben. Zuerst werden die Motoren stillgelegt; bevor sie starten, wird es gesagt. Gespeichert wird erst am Ende, Ausschalten nimmt also alles zurück.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Disabling the motors.</source>
        <translation>Motoren werden stillgelegt.</translation>
    </message>
    <message>
        <source>Hold the camera level and still.</source>
        <translation>Halten Sie die Kamera waagerecht und still.</translation>
    </message>
    <message>
        <source>How many magnets does each motor bell have?</source>
        <translation>Wie viele Magnete haben die Glocken der Motoren?</translation>
    </message>
    <message>
        <source>Most gimbal motors have 14. A wrong number makes a motor run away.</source>
        <translation>Die meisten Gimbal-Motoren haben 14. Mit einer falschen Zahl läuft ein Motor davon.</translation>
    </message>
    <message>
        <source>Setting the motor directions to automatic detection.</source>
        <translation>Motorrichtungen werden auf Suche gestellt.</translation>
    </message>
    <message>
        <source>Now the motors start. Put the camera into the gimbal, hold the handle still, and connect the battery.</source>
        <translation>Jetzt starten die Motoren. Setzen Sie die Kamera ein, halten Sie den Griff still und schließen Sie den Akku an.</translation>
    </message>
    <message>
        <source>Start the motors</source>
        <translation>Motoren starten</translation>
    </message>
    <message>
        <source>The board starts. Keep the handle still.</source>
        <translation>Das Board startet. Halten Sie den Griff still.</translation>
    </message>
    <message>
        <source>Taking over what the board has found.</source>
        <translation>Übernehme, was das Board gefunden hat.</translation>
    </message>
    <message>
        <source>Turn the camera until it looks straight ahead.</source>
        <translation>Drehen Sie die Kamera, bis sie geradeaus blickt.</translation>
    </message>
    <message>
        <source>Take this position</source>
        <translation>Diese Lage nehmen</translation>
    </message>
    <message>
        <source>Everything is set. Store it, and start the gimbal?</source>
        <translation>Alles ist eingestellt. Speichern und den Gimbal starten?</translation>
    </message>
    <message>
        <source>Start and store</source>
        <translation>Starten und speichern</translation>
    </message>
    <message>
        <source>Starting and storing.</source>
        <translation>Starte und speichere.</translation>
    </message>
    <message>
        <source>The gimbal is set up.</source>
        <translation>Der Gimbal ist eingerichtet.</translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>✓ Motors are disabled.</source>
        <translation>✓ Motoren sind stillgelegt.</translation>
    </message>
    <message>
        <source>✓ Sensor: %1, frame sensor: %2</source>
        <translation>✓ Sensor: %1, Rahmensensor: %2</translation>
    </message>
    <message>
        <source>✓ Sensor: %1</source>
        <translation>✓ Sensor: %1</translation>
    </message>
    <message>
        <source>✓ Poles: roll %1, pitch %2, yaw %3</source>
        <translation>✓ Pole: Roll %1, Pitch %2, Yaw %3</translation>
    </message>
    <message>
        <source>✓ Directions will be found at the start.</source>
        <translation>✓ Richtungen werden beim Start gefunden.</translation>
    </message>
    <message>
        <source>✓ The board works normally.</source>
        <translation>✓ Das Board arbeitet normal.</translation>
    </message>
    <message>
        <source>✓ Directions: roll %1, pitch %2, yaw %3</source>
        <translation>✓ Richtungen: Roll %1, Pitch %2, Yaw %3</translation>
    </message>
    <message>
        <source>✓ Start positions: roll %1, pitch %2</source>
        <translation>✓ Startlagen: Roll %1, Pitch %2</translation>
    </message>
    <message>
        <source>The buttons turn it within %1° either way.</source>
        <translation>Die Knöpfe drehen sie innerhalb von %1° nach beiden Seiten.</translation>
    </message>
    <message>
        <source>✓ Yaw starts at %1.</source>
        <translation>✓ Yaw startet bei %1.</translation>
    </message>
    <message>
        <source>✓ Everything is stored.</source>
        <translation>✓ Alles ist gespeichert.</translation>
    </message>
    <message>
        <source>Cancelled. The values set so far are in use, but not stored.</source>
        <translation>Abgebrochen. Was bis hier eingestellt wurde, ist in Gebrauch, aber nicht gespeichert.</translation>
    </message>
    <message>
        <source>Tilt camera and frame about 45° down, without rolling them.</source>
        <translation>Neigen Sie Kamera und Rahmen etwa 45° nach unten, ohne sie zu rollen.</translation>
    </message>
    <message>
        <source>Hold camera and frame level and still.</source>
        <translation>Halten Sie Kamera und Rahmen waagerecht und still.</translation>
    </message>
    <message>
        <source>The sensor shows x %1 g, y %2 g, z %3 g. %4</source>
        <translation>Der Sensor zeigt x %1 g, y %2 g, z %3 g. %4</translation>
    </message>
    <message>
        <source>Good: hold it so.</source>
        <translation>Gut: so halten.</translation>
    </message>
    <message>
        <source>Waiting until one axis shows the tilt and the other none.</source>
        <translation>Es geht weiter, sobald eine Achse die Neigung zeigt und die andere keine.</translation>
    </message>
    <message>
        <source>Waiting until one axis points straight up.</source>
        <translation>Es geht weiter, sobald eine Achse gerade nach oben zeigt.</translation>
    </message>
    <message>
        <source>Waiting for the battery: connect it, and see that it is charged.</source>
        <translation>Es wird auf den Akku gewartet: Schließen Sie ihn an, und achten Sie darauf, dass er geladen ist.</translation>
    </message>
    <message>
        <source>State: %1. Waiting for normal operation.</source>
        <translation>Zustand: %1. Es geht weiter, sobald das Board normal arbeitet.</translation>
    </message>
    <message>
        <source>The board levels the camera and turns each motor a little to find its direction. Stop motors ends it at any time.</source>
        <translation>Das Board richtet die Kamera waagerecht und dreht jeden Motor ein wenig, um seine Richtung zu finden. „Motoren stoppen“ hält es jederzeit an.</translation>
    </message>
    <message>
        <source>✖ Not everything is stored. Use “Store on the board” below.</source>
        <translation>✖ Nicht alles ist gespeichert. Nutzen Sie unten „Auf dem Board speichern“.</translation>
    </message>
    <message>
        <source>It was starting or storing: what is stored is seen when the board is read again.</source>
        <translation>Es wurde gerade gestartet oder gespeichert: Was gespeichert ist, zeigt sich, wenn das Board wieder gelesen wird.</translation>
    </message>
    <message>
        <source>What was set by then is in use and not stored: a restart of the board takes it back.</source>
        <translation>Was bis dahin gesetzt wurde, ist in Gebrauch und nicht gespeichert: Ein Neustart des Boards nimmt es zurück.</translation>
    </message>
    <message>
        <source>The gimbal setup ended with the link.</source>
        <translation>Das Einrichten des Gimbals endete mit der Verbindung.</translation>
    </message>
    <message>
        <source>What was set by then is lost: the board restarted.</source>
        <translation>Was bis dahin gesetzt war, ist verloren: Das Board ist neu gestartet.</translation>
    </message>
    <message>
        <source>A snapshot of the settings as they were is kept. The motors start.</source>
        <translation>Eine Sicherung der Einstellungen, wie sie waren, wird aufgehoben. Die Motoren starten.</translation>
    </message>
</context>
<context>
    <name>ShareDialog</name>
    <message>
        <source>Share settings</source>
        <translation>Einstellungen teilen</translation>
    </message>
    <message>
        <source>Picture of all values</source>
        <translation>Bild aller Werte</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Sichern…</translation>
    </message>
    <message>
        <source>The picture is in the clipboard.</source>
        <translation>Das Bild ist in der Zwischenablage.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild sichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>With unwritten changes</source>
        <translation>Mit ungeschriebenen Änderungen</translation>
    </message>
    <message>
        <source>All values, for a forum or a colleague.</source>
        <translation>Alle Werte, für ein Forum oder eine Kollegin.</translation>
    </message>
    <message>
        <source>The picture says that they are on it and on no board</source>
        <translation>Das Bild sagt, dass sie darauf sind und auf keinem Board</translation>
    </message>
    <message numerus="yes">
        <source>with %n unwritten change(s)</source>
        <translation>
            <numerusform>mit %n ungeschriebener Änderung</numerusform>
            <numerusform>mit %n ungeschriebenen Änderungen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SignalsPage</name>
    <message>
        <source>Trigger slot %1</source>
        <translation>Auslöser %1</translation>
    </message>
    <message>
        <source>Variable slot %1</source>
        <translation>Variablenplatz %1</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>What is steered by which input</source>
        <translation>Was welcher Eingang steuert</translation>
    </message>
    <message>
        <source>sets %1</source>
        <translation>stellt %1</translation>
    </message>
    <message>
        <source>No slot is in use. What slots do is set under Parameters, “Trigger slots” and “Variable slots”.</source>
        <translation>Kein Platz ist in Gebrauch. Was Plätze tun, wird unter Parameter eingestellt, „Auslöser“ und „Variablenplätze“.</translation>
    </message>
    <message>
        <source>What slots do is set under Parameters, “Trigger slots” and “Variable slots”.</source>
        <translation>Was Plätze tun, wird unter Parameter eingestellt, „Auslöser“ und „Variablenplätze“.</translation>
    </message>
    <message>
        <source>no signal</source>
        <translation>kein Signal</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>All inputs</source>
        <translation>Alle Eingänge</translation>
    </message>
    <message>
        <source>Move a stick: the input whose bar moves is the one to choose.</source>
        <translation>Einen Knüppel bewegen: der Eingang, dessen Balken sich bewegt, ist der richtige.</translation>
    </message>
    <message>
        <source>What the functions get now</source>
        <translation>Was die Funktionen jetzt bekommen</translation>
    </message>
</context>
<context>
    <name>SignsNote</name>
    <message>
        <source>Signs as the drone counts them. On “Flight” they are as the check of directions has found them, the other way round: %1.</source>
        <translation>Vorzeichen, wie die Drohne sie zählt. Auf „Flug“ sind sie so, wie die Prüfung der Richtungen sie gefunden hat, also umgekehrt: %1.</translation>
    </message>
</context>
<context>
    <name>SimulatedHands</name>
    <message>
        <source>Simulated gimbal: your hands</source>
        <translation>Simulierter Gimbal: Ihre Hände</translation>
    </message>
    <message>
        <source>Where the simulated camera is</source>
        <translation>Wo die simulierte Kamera ist</translation>
    </message>
    <message>
        <source>lies still: %1</source>
        <translation>liegt still: %1</translation>
    </message>
    <message>
        <source>in the gimbal, in your hand</source>
        <translation>im Gimbal, in Ihrer Hand</translation>
    </message>
</context>
<context>
    <name>SpectrumChart</name>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>dB</source>
        <translation>dB</translation>
    </message>
    <message>
        <source>dB of (%1)²/Hz</source>
        <translation>dB von (%1)²/Hz</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>%1 RMS</source>
        <translation>%1 RMS</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
</context>
<context>
    <name>SpectrumPage</name>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Peaks</source>
        <translation>Spitzen</translation>
    </message>
    <message>
        <source>Angle error by band</source>
        <translation>Winkelfehler nach Bändern</translation>
    </message>
    <message>
        <source>Gyro</source>
        <translation>Gyroskop</translation>
    </message>
    <message>
        <source>Angle error</source>
        <translation>Winkelfehler</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>What the spectrum is made of</source>
        <translation>Woraus das Spektrum gemacht wird</translation>
    </message>
    <message>
        <source>last %1 s</source>
        <translation>letzte %1 s</translation>
    </message>
    <message>
        <source>Span</source>
        <translation>Spanne</translation>
    </message>
    <message>
        <source>A longer span shows finer lines, a shorter one follows faster</source>
        <translation>Eine längere Spanne zeigt feinere Linien, eine kürzere folgt schneller</translation>
    </message>
    <message>
        <source>Keep the present figures and show how they change</source>
        <translation>Die Zahlen von jetzt merken und zeigen, was sich dagegen ändert</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Waiting for samples at a steady rate</source>
        <translation>Wartet auf Messwerte mit fester Rate</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message numerus="yes">
        <source>%1 samples/s, lines of %2 Hz, %n average(s)</source>
        <translation>
            <numerusform>%1 Werte/s, Linien von %2 Hz, %n Mittelung</numerusform>
            <numerusform>%1 Werte/s, Linien von %2 Hz, %n Mittelungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Band</source>
        <translation>Band</translation>
    </message>
    <message>
        <source>%1° RMS
%2° peak</source>
        <translation>%1° RMS
Spitze %2°</translation>
    </message>
    <message>
        <source>%1° RMS</source>
        <translation>%1° RMS</translation>
    </message>
    <message>
        <source>All notch filters of this axis are in use; change one of them on Parameters.</source>
        <translation>Alle Kerbfilter dieser Achse sind in Gebrauch; ändern Sie einen davon unter Parameter.</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>Lassen</translation>
    </message>
    <message>
        <source>Waterfall, %1</source>
        <translation>Wasserfall, %1</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>How the spectrum is made and drawn</source>
        <translation>Wie das Spektrum entsteht und gezeichnet wird</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Pegel</translation>
    </message>
    <message>
        <source>Decibel</source>
        <translation>Dezibel</translation>
    </message>
    <message>
        <source>RMS of each line</source>
        <translation>Effektivwert jeder Linie</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Hann: the usual one</source>
        <translation>Hann: das übliche</translation>
    </message>
    <message>
        <source>Flat top: true heights of single tones</source>
        <translation>Flat-Top: wahre Höhen einzelner Töne</translation>
    </message>
    <message>
        <source>Rectangular: sharpest, leaks</source>
        <translation>Rechteck: am schärfsten, verschmiert</translation>
    </message>
    <message>
        <source>as held on Monitor, %1 s</source>
        <translation>wie auf Monitor festgehalten, %1 s</translation>
    </message>
    <message>
        <source>%1; anything above %2 Hz shows up lower</source>
        <translation>%1; was über %2 Hz liegt, erscheint tiefer</translation>
    </message>
    <message>
        <source>Sway</source>
        <translation>Schwanken</translation>
    </message>
    <message>
        <source>Wobble</source>
        <translation>Wackeln</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Zittern</translation>
    </message>
    <message>
        <source>Try a notch here…</source>
        <translation>Hier einen Kerbfilter versuchen…</translation>
    </message>
    <message>
        <source>Tries a filter that takes the chosen peak out of the loop, and measures what it does</source>
        <translation>Versucht einen Filter, der die gewählte Spitze aus dem Regelkreis nimmt, und misst, was er bewirkt</translation>
    </message>
    <message>
        <source>End the trial</source>
        <translation>Versuch beenden</translation>
    </message>
    <message>
        <source>A notch is being tried. Leave gimbal and sticks as they are.</source>
        <translation>Ein Kerbfilter wird versucht. Gimbal und Knüppel bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>The motors are off: there is nothing to measure.</source>
        <translation>Die Motoren sind aus: es gibt nichts zu messen.</translation>
    </message>
    <message>
        <source>Try a notch here</source>
        <translation>Hier einen Kerbfilter versuchen</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Versuchen</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>%1, from the board</source>
        <translation>%1, vom Board</translation>
    </message>
</context>
<context>
    <name>StartPage</name>
    <message>
        <source>&amp;Choose a port</source>
        <translation>&amp;Anschluss wählen</translation>
    </message>
    <message>
        <source>&amp;Try the simulated gimbal</source>
        <translation>&amp;Simulierten Gimbal probieren</translation>
    </message>
    <message>
        <source>&amp;Open a file</source>
        <translation>Datei &amp;öffnen</translation>
    </message>
    <message>
        <source>The simulated gimbal shakes, drifts and answers like a real one: a safe place to learn.</source>
        <translation>Der simulierte Gimbal wackelt, driftet und antwortet wie ein echter: ein sicherer Ort zum Lernen.</translation>
    </message>
    <message>
        <source>Board %1, %2</source>
        <translation>Board %1, %2</translation>
    </message>
    <message>
        <source>Look at a snapshot or a saved configuration and edit it without a board, or replay a recording</source>
        <translation>Eine Sicherung oder gespeicherte Konfiguration ansehen und ohne Board bearbeiten, oder eine Aufzeichnung abspielen</translation>
    </message>
    <message>
        <source>Lately:</source>
        <translation>Zuletzt:</translation>
    </message>
    <message>
        <source>Connect to %1</source>
        <translation>Verbinden mit %1</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Unwritten changes of an earlier run:</source>
        <translation>Ungeschriebene Änderungen von früher:</translation>
    </message>
    <message>
        <source>No board yet</source>
        <translation>Noch kein Board</translation>
    </message>
    <message>
        <source>Plug the controller in with USB or a serial adapter, choose its port at the top left and connect. Rate and parity are found by the program. A drone is met in its own wireless network: join it, then choose its address in the same list. Nothing is sent to a port you did not choose, and nothing is written without your review.</source>
        <translation>Schließen Sie den Controller über USB oder einen seriellen Adapter an, wählen Sie links oben seinen Anschluss und verbinden Sie. Rate und Parität findet das Programm. Eine Drohne hat ein eigenes Funknetz: Treten Sie ihm bei und wählen Sie dann ihre Adresse in derselben Liste. An einen Anschluss, den Sie nicht gewählt haben, wird nichts gesendet, und geschrieben wird nur, was Sie gesehen haben.</translation>
    </message>
</context>
<context>
    <name>StatusStrip</name>
    <message>
        <source>no link</source>
        <translation>keine Verbindung</translation>
    </message>
    <message>
        <source>offline: editing %1</source>
        <translation>offline: %1 in Arbeit</translation>
    </message>
    <message>
        <source>%1/s · %2 lost</source>
        <translation>%1/s · %2 verloren</translation>
    </message>
    <message>
        <source>%1 damaged</source>
        <translation>%1 beschädigt</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation>%1 V</translation>
    </message>
    <message>
        <source>no errors</source>
        <translation>keine Fehler</translation>
    </message>
    <message>
        <source>no live data</source>
        <translation>keine Live-Daten</translation>
    </message>
    <message>
        <source>thinned out: slow line</source>
        <translation>ausgedünnt: langsame Leitung</translation>
    </message>
    <message>
        <source>Hold Esc to stop the motors.</source>
        <translation>Esc halten, um die Motoren zu stoppen.</translation>
    </message>
    <message>
        <source>live data stand still</source>
        <translation>Live-Daten stehen still</translation>
    </message>
    <message>
        <source>the recording has ended</source>
        <translation>die Aufzeichnung ist zu Ende</translation>
    </message>
    <message>
        <source>nothing for %1 s</source>
        <translation>seit %1 s nichts</translation>
    </message>
    <message>
        <source>↓ %1 %</source>
        <translation>↓ %1 %</translation>
    </message>
    <message>
        <source>another ground station</source>
        <translation>andere Bodenstation</translation>
    </message>
    <message>
        <source>Weak link: only %1 % of the questions are answered. Commands may be lost as well.</source>
        <translation>Schwache Verbindung: Nur %1 % der Fragen werden beantwortet. Auch Befehle können verloren gehen.</translation>
    </message>
    <message>
        <source>Weak link: the board receives only %1 % of what is sent. Commands may be lost.</source>
        <translation>Schwache Verbindung: Das Board empfängt nur %1 % dessen, was gesendet wird. Befehle können verloren gehen.</translation>
    </message>
    <message>
        <source>Slow link: an answer takes %1 ms. What is shown is old, and a stop comes late.</source>
        <translation>Langsame Verbindung: Eine Antwort braucht %1 ms. Was angezeigt wird, ist alt, und ein Stopp kommt spät.</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>Messages received per second, samples lost, answer time</source>
        <translation>Empfangene Nachrichten je Sekunde, verlorene Messwerte, Antwortzeit</translation>
    </message>
    <message>
        <source>Messages received per second, samples lost, round trip; ↓ share of our questions that are answered, ↑ how well the board receives</source>
        <translation>Empfangene Nachrichten je Sekunde, verlorene Messwerte, Umlaufzeit; ↓ Anteil unserer Fragen, die beantwortet werden, ↑ wie gut das Board empfängt</translation>
    </message>
    <message>
        <source>Messages received per second, round trip; ↓ share of our questions that are answered, ↑ how well the board receives</source>
        <translation>Empfangene Nachrichten je Sekunde, Umlaufzeit; ↓ Anteil unserer Fragen, die beantwortet werden, ↑ wie gut das Board empfängt</translation>
    </message>
    <message>
        <source>weak link</source>
        <translation>schwache Verbindung</translation>
    </message>
    <message>
        <source>Rates and accelerations on all pages are those of this sensor, and calibrations are about it, until another one is selected or the board restarts.</source>
        <translation>Drehraten und Beschleunigungen auf allen Seiten sind die dieses Sensors, und Kalibrierungen gelten ihm, bis ein anderer ausgewählt wird oder das Board neu startet.</translation>
    </message>
    <message>
        <source>sensor shown: %1</source>
        <translation>gezeigter Sensor: %1</translation>
    </message>
</context>
<context>
    <name>StickInputs</name>
    <message>
        <source>What comes in now</source>
        <translation>Was jetzt ankommt</translation>
    </message>
    <message>
        <source>Simulated remote control</source>
        <translation>Simulierte Fernsteuerung</translation>
    </message>
    <message>
        <source>Receiver at the board</source>
        <translation>Empfänger am Board</translation>
    </message>
    <message>
        <source>receiver: none</source>
        <translation>Empfänger: keiner</translation>
    </message>
    <message>
        <source>receiver: a wire for each channel</source>
        <translation>Empfänger: ein Kabel für jeden Kanal</translation>
    </message>
    <message>
        <source>receiver: S-bus</source>
        <translation>Empfänger: S-Bus</translation>
    </message>
    <message>
        <source>Which stick is held at an end</source>
        <translation>Welcher Knüppel am Anschlag gehalten wird</translation>
    </message>
    <message>
        <source>sticks: let go</source>
        <translation>Knüppel: losgelassen</translation>
    </message>
    <message>
        <source>roll stick: right</source>
        <translation>Roll-Knüppel: rechts</translation>
    </message>
    <message>
        <source>roll stick: left</source>
        <translation>Roll-Knüppel: links</translation>
    </message>
    <message>
        <source>pitch stick: down</source>
        <translation>Pitch-Knüppel: nach unten</translation>
    </message>
    <message>
        <source>pitch stick: up</source>
        <translation>Pitch-Knüppel: nach oben</translation>
    </message>
    <message>
        <source>yaw stick: right</source>
        <translation>Yaw-Knüppel: rechts</translation>
    </message>
    <message>
        <source>yaw stick: left</source>
        <translation>Yaw-Knüppel: links</translation>
    </message>
    <message>
        <source>switch: up</source>
        <translation>Schalter: oben</translation>
    </message>
    <message>
        <source>switch: down</source>
        <translation>Schalter: unten</translation>
    </message>
    <message>
        <source>roll and pitch stick at once</source>
        <translation>Roll- und Pitch-Knüppel zugleich</translation>
    </message>
</context>
<context>
    <name>StickStepCard</name>
    <message>
        <source>Step response</source>
        <translation>Sprungantwort</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Push the stick</source>
        <translation>Knüppel drücken</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>What follows the stick</source>
        <translation>Was dem Knüppel folgt</translation>
    </message>
    <message>
        <source>Stabilised, roll and pitch follow the stick by their angle; yaw, and all axes in rate mode, by their rate.</source>
        <translation>Stabilisiert folgen Roll und Pitch dem Knüppel mit dem Winkel; Yaw, und im Ratenmodus alle Achsen, mit der Drehrate.</translation>
    </message>
    <message>
        <source>How far the stick is pushed</source>
        <translation>Wie weit der Knüppel gedrückt wird</translation>
    </message>
    <message>
        <source>Pushes the stick of this axis to both sides by turns, for some seconds. Give it throttle first. A stand has to hold it.</source>
        <translation>Drückt den Knüppel dieser Achse einige Sekunden lang abwechselnd nach beiden Seiten. Vorher Gas geben. Ein Teststand muss sie halten.</translation>
    </message>
    <message>
        <source>Arm it, give it throttle, then push the stick.</source>
        <translation>Scharfschalten, Gas geben, dann den Knüppel drücken.</translation>
    </message>
    <message>
        <source>Gain %1</source>
        <translation>Reglerwert %1</translation>
    </message>
    <message>
        <source>The stick is pushed to both sides.</source>
        <translation>Der Knüppel wird nach beiden Seiten gedrückt.</translation>
    </message>
    <message>
        <source>Broken off: it was disarmed.</source>
        <translation>Abgebrochen: Sie wurde entschärft.</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>nicht erreicht</translation>
    </message>
    <message>
        <source>Rise %1, overshoot %2 %, settled after %3.</source>
        <translation>Anstieg %1, Überschwingen %2 %, beruhigt nach %3.</translation>
    </message>
    <message>
        <source>In the text&apos;s numbers: %1</source>
        <translation>In Zahlen des Textes: %1</translation>
    </message>
    <message>
        <source>Push the stick: throttle first</source>
        <translation>Knüppel drücken: erst Gas geben</translation>
    </message>
    <message>
        <source>%.1f s</source>
        <translation>%.1f s</translation>
    </message>
</context>
<context>
    <name>StreamsDialog</name>
    <message>
        <source>Automatic: what you look at, as fast as the line allows</source>
        <translation>Automatisch: was Sie ansehen, so schnell es die Leitung erlaubt</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Data streams</source>
        <translation>Datenströme</translation>
    </message>
    <message>
        <source>Carries the channels that are shown, at the rate you choose</source>
        <translation>Trägt die Kanäle, die zu sehen sind, so oft Sie wollen</translation>
    </message>
    <message numerus="yes">
        <source>Carries %n channel(s), all of them each time</source>
        <translation>
            <numerusform>Trägt %n Kanal, jedes Mal</numerusform>
            <numerusform>Trägt %n Kanäle, jedes Mal alle</numerusform>
        </translation>
    </message>
    <message>
        <source>as fast as possible</source>
        <translation>so schnell wie möglich</translation>
    </message>
    <message>
        <source> samples/s</source>
        <translation> Werte/s</translation>
    </message>
    <message>
        <source>Rate of %1</source>
        <translation>Rate von %1</translation>
    </message>
    <message>
        <source>Share of the line</source>
        <translation>Anteil der Leitung</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Choose at least one stream.</source>
        <translation>Wählen Sie mindestens einen Datenstrom.</translation>
    </message>
    <message>
        <source>%1 samples/s, %2 bytes each, %3 bytes/s</source>
        <translation>%1 Werte/s zu %2 Byte, %3 Byte/s</translation>
    </message>
    <message>
        <source>%1 of %2 bytes/s, %3 % of the line.</source>
        <translation>%1 von %2 Byte/s, %3 % der Leitung.</translation>
    </message>
    <message>
        <source>%1 bytes/s. This link sets no limit.</source>
        <translation>%1 Byte/s. Diese Verbindung setzt keine Grenze.</translation>
    </message>
    <message>
        <source>That is too much: %1 % may be used, the rest is kept for commands. Lower a rate, look at fewer channels, or set a faster serial speed.</source>
        <translation>Das ist zu viel: %1 % dürfen genutzt werden, der Rest bleibt für Befehle. Senken Sie eine Rate, sehen Sie weniger Kanäle an oder stellen Sie eine schnellere serielle Geschwindigkeit ein.</translation>
    </message>
</context>
<context>
    <name>SupervisorForm</name>
    <message>
        <source> °</source>
        <translation> °</translation>
    </message>
    <message>
        <source> °/s</source>
        <translation> °/s</translation>
    </message>
    <message>
        <source> V</source>
        <translation> V</translation>
    </message>
    <message>
        <source> °C</source>
        <translation> °C</translation>
    </message>
    <message>
        <source>An alarm makes a sound</source>
        <translation>Ein Alarm ist auch zu hören</translation>
    </message>
    <message>
        <source>The program watches live data on every page and tells what goes wrong, with its cause. It can do something about it as well; a board that flies is only warned of.</source>
        <translation>Das Programm beobachtet die Live-Daten auf jeder Seite und sagt, was schiefgeht und warum. Es kann auch eingreifen; bei einem Board, das fliegt, warnt es nur.</translation>
    </message>
    <message>
        <source>Warn</source>
        <translation>Warnen</translation>
    </message>
    <message>
        <source>Revert the last live change</source>
        <translation>Letzte Live-Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>Take it back, else motors off</source>
        <translation>Zurücknehmen, sonst Motoren aus</translation>
    </message>
    <message>
        <source>Motors off</source>
        <translation>Motoren aus</translation>
    </message>
    <message>
        <source>Runaway: away from the target by</source>
        <translation>Durchgehen: weg vom Ziel um</translation>
    </message>
    <message>
        <source>Oscillation: rate of more than (RMS)</source>
        <translation>Schwingen: Drehrate über (RMS)</translation>
    </message>
    <message>
        <source>Low battery: less per cell than</source>
        <translation>Akku schwach: je Zelle unter</translation>
    </message>
    <message>
        <source>Not watched</source>
        <translation>Nicht überwacht</translation>
    </message>
    <message>
        <source>No board is connected</source>
        <translation>Es ist kein Board verbunden</translation>
    </message>
    <message>
        <source>Nothing: all of these can be seen</source>
        <translation>Nichts: all das ist zu sehen</translation>
    </message>
    <message>
        <source>Overheating: sensor or motor hotter than</source>
        <translation>Überhitzung: Sensor oder Motor heißer als</translation>
    </message>
</context>
<context>
    <name>SystemPage</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>System</source>
        <translation>System</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Neu lesen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Ask the drone once more</source>
        <translation>Die Drohne noch einmal fragen</translation>
    </message>
    <message>
        <source>Copy all of it as text</source>
        <translation>Alles als Text kopieren</translation>
    </message>
    <message>
        <source>What the drone tells of itself</source>
        <translation>Was die Drohne von sich erzählt</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Board</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>not told: %1</source>
        <translation>nicht erzählt: %1</translation>
    </message>
    <message>
        <source>It cannot be read as a table; this is what came:</source>
        <translation>Es lässt sich nicht als Tabelle lesen; so kam es:</translation>
    </message>
    <message>
        <source>Asking the drone…</source>
        <translation>Die Drohne wird gefragt…</translation>
    </message>
    <message>
        <source>Connect a drone to see what it tells of its board, sensors and cameras.</source>
        <translation>Verbinden Sie eine Drohne, um zu sehen, was sie von ihrem Board, ihren Sensoren und Kameras erzählt.</translation>
    </message>
    <message>
        <source>As the drone told it on %1.</source>
        <translation>Wie die Drohne es am %1 erzählt hat.</translation>
    </message>
    <message>
        <source>As the drone told it on %1; it is not connected now.</source>
        <translation>Wie die Drohne es am %1 erzählt hat; jetzt ist sie nicht verbunden.</translation>
    </message>
</context>
<context>
    <name>Tables</name>
    <message>
        <source>Roll</source>
        <translation>Roll</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Pitch</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Yaw</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ein</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>1 MHz</source>
        <translation>1 MHz</translation>
    </message>
    <message>
        <source>A motor could not hold the camera.</source>
        <translation>Ein Motor konnte die Kamera nicht halten.</translation>
    </message>
    <message>
        <source>ADC1 (analog)</source>
        <translation>ADC1 (analog)</translation>
    </message>
    <message>
        <source>ADC2 (analog)</source>
        <translation>ADC2 (analog)</translation>
    </message>
    <message>
        <source>ADC3 (analog)</source>
        <translation>ADC3 (analog)</translation>
    </message>
    <message>
        <source>ADC4 (analog)</source>
        <translation>ADC4 (analog)</translation>
    </message>
    <message>
        <source>API channel 1</source>
        <translation>API-Kanal 1</translation>
    </message>
    <message>
        <source>API channel 10</source>
        <translation>API-Kanal 10</translation>
    </message>
    <message>
        <source>API channel 11</source>
        <translation>API-Kanal 11</translation>
    </message>
    <message>
        <source>API channel 12</source>
        <translation>API-Kanal 12</translation>
    </message>
    <message>
        <source>API channel 13</source>
        <translation>API-Kanal 13</translation>
    </message>
    <message>
        <source>API channel 14</source>
        <translation>API-Kanal 14</translation>
    </message>
    <message>
        <source>API channel 15</source>
        <translation>API-Kanal 15</translation>
    </message>
    <message>
        <source>API channel 16</source>
        <translation>API-Kanal 16</translation>
    </message>
    <message>
        <source>API channel 17</source>
        <translation>API-Kanal 17</translation>
    </message>
    <message>
        <source>API channel 18</source>
        <translation>API-Kanal 18</translation>
    </message>
    <message>
        <source>API channel 19</source>
        <translation>API-Kanal 19</translation>
    </message>
    <message>
        <source>API channel 2</source>
        <translation>API-Kanal 2</translation>
    </message>
    <message>
        <source>API channel 20</source>
        <translation>API-Kanal 20</translation>
    </message>
    <message>
        <source>API channel 21</source>
        <translation>API-Kanal 21</translation>
    </message>
    <message>
        <source>API channel 22</source>
        <translation>API-Kanal 22</translation>
    </message>
    <message>
        <source>API channel 23</source>
        <translation>API-Kanal 23</translation>
    </message>
    <message>
        <source>API channel 24</source>
        <translation>API-Kanal 24</translation>
    </message>
    <message>
        <source>API channel 25</source>
        <translation>API-Kanal 25</translation>
    </message>
    <message>
        <source>API channel 26</source>
        <translation>API-Kanal 26</translation>
    </message>
    <message>
        <source>API channel 27</source>
        <translation>API-Kanal 27</translation>
    </message>
    <message>
        <source>API channel 28</source>
        <translation>API-Kanal 28</translation>
    </message>
    <message>
        <source>API channel 29</source>
        <translation>API-Kanal 29</translation>
    </message>
    <message>
        <source>API channel 3</source>
        <translation>API-Kanal 3</translation>
    </message>
    <message>
        <source>API channel 30</source>
        <translation>API-Kanal 30</translation>
    </message>
    <message>
        <source>API channel 31</source>
        <translation>API-Kanal 31</translation>
    </message>
    <message>
        <source>API channel 4</source>
        <translation>API-Kanal 4</translation>
    </message>
    <message>
        <source>API channel 5</source>
        <translation>API-Kanal 5</translation>
    </message>
    <message>
        <source>API channel 6</source>
        <translation>API-Kanal 6</translation>
    </message>
    <message>
        <source>API channel 7</source>
        <translation>API-Kanal 7</translation>
    </message>
    <message>
        <source>API channel 8</source>
        <translation>API-Kanal 8</translation>
    </message>
    <message>
        <source>API channel 9</source>
        <translation>API-Kanal 9</translation>
    </message>
    <message>
        <source>Above yaw</source>
        <translation>Über Yaw</translation>
    </message>
    <message>
        <source>Acceleration limit</source>
        <translation>Beschleunigungsgrenze</translation>
    </message>
    <message>
        <source>Acceleration limit, all axes</source>
        <translation>Beschleunigungsgrenze, alle Achsen</translation>
    </message>
    <message>
        <source>Acceleration limit, pitch</source>
        <translation>Beschleunigungsgrenze, Pitch</translation>
    </message>
    <message>
        <source>Acceleration limit, roll</source>
        <translation>Beschleunigungsgrenze, Roll</translation>
    </message>
    <message>
        <source>Acceleration limit, yaw</source>
        <translation>Beschleunigungsgrenze, Yaw</translation>
    </message>
    <message>
        <source>Acceleration of moves the board makes by itself.</source>
        <translation>Beschleunigung von Bewegungen, die das Board selbst macht.</translation>
    </message>
    <message>
        <source>Acceleration, X</source>
        <translation>Beschleunigung, X</translation>
    </message>
    <message>
        <source>Acceleration, Y</source>
        <translation>Beschleunigung, Y</translation>
    </message>
    <message>
        <source>Acceleration, Z</source>
        <translation>Beschleunigung, Z</translation>
    </message>
    <message>
        <source>Accelerometer low-pass</source>
        <translation>Tiefpass des Beschleunigungssensors</translation>
    </message>
    <message>
        <source>Accelerometer not calibrated</source>
        <translation>Beschleunigungssensor nicht kalibriert</translation>
    </message>
    <message>
        <source>Action for so many presses of the menu button.</source>
        <translation>Aktion für so viele Drücke der Menütaste.</translation>
    </message>
    <message>
        <source>Action when the command channel is high.</source>
        <translation>Aktion, wenn der Befehlskanal hoch ist.</translation>
    </message>
    <message>
        <source>Action when the command channel is in the middle.</source>
        <translation>Aktion, wenn der Befehlskanal in der Mitte ist.</translation>
    </message>
    <message>
        <source>Action when the command channel is low.</source>
        <translation>Aktion, wenn der Befehlskanal niedrig ist.</translation>
    </message>
    <message>
        <source>Action when the menu button is held.</source>
        <translation>Aktion, wenn die Menütaste gehalten wird.</translation>
    </message>
    <message>
        <source>Active profile</source>
        <translation>Aktives Profil</translation>
    </message>
    <message>
        <source>Adaptive PID</source>
        <translation>Adaptives PID</translation>
    </message>
    <message>
        <source>Adaptive PID: rate</source>
        <translation>Adaptives PID: Tempo</translation>
    </message>
    <message>
        <source>Adaptive PID: recovery</source>
        <translation>Adaptives PID: Erholung</translation>
    </message>
    <message>
        <source>Adaptive PID: threshold</source>
        <translation>Adaptives PID: Schwelle</translation>
    </message>
    <message>
        <source>Adaptive gyro trust</source>
        <translation>Adaptives Vertrauen ins Gyroskop</translation>
    </message>
    <message>
        <source>Added to the signal, in 1/128 of half the range.</source>
        <translation>Wird zum Signal addiert, in 1/128 des halben Bereichs.</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Alarm below</source>
        <translation>Alarm unter</translation>
    </message>
    <message>
        <source>All axes</source>
        <translation>Alle Achsen</translation>
    </message>
    <message>
        <source>All profiles</source>
        <translation>Alle Profile</translation>
    </message>
    <message>
        <source>Always calibrate</source>
        <translation>Immer kalibrieren</translation>
    </message>
    <message>
        <source>Analog</source>
        <translation>Analog</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Angle at start</source>
        <translation>Winkel beim Start</translation>
    </message>
    <message>
        <source>Angle between encoder zero and the motor&apos;s field; found by calibration. If it is wrong, the motor runs away.</source>
        <translation>Winkel zwischen Geber-Null und Motorfeld; wird durch Kalibrierung gefunden. Falsch geht der Motor durch.</translation>
    </message>
    <message>
        <source>Angle between frame and camera that the axis does not go above.</source>
        <translation>Winkel zwischen Rahmen und Kamera, über den die Achse nicht hinausgeht.</translation>
    </message>
    <message>
        <source>Angle between frame and camera that the axis does not go below.</source>
        <translation>Winkel zwischen Rahmen und Kamera, unter den die Achse nicht geht.</translation>
    </message>
    <message>
        <source>Angle between magnetic and true north at this place.</source>
        <translation>Winkel zwischen magnetisch und geografisch Nord an diesem Ort.</translation>
    </message>
    <message>
        <source>Angle over which following of roll comes in.</source>
        <translation>Winkel, über den das Folgen von Roll einsetzt.</translation>
    </message>
    <message>
        <source>Angle relative to frame</source>
        <translation>Winkel gegen den Rahmen</translation>
    </message>
    <message>
        <source>Angle, shortest way</source>
        <translation>Winkel, kürzester Weg</translation>
    </message>
    <message>
        <source>Angle: the stick position is the camera angle. Speed: the stick position is the speed.</source>
        <translation>Winkel: die Knüppelstellung ist der Kamerawinkel. Geschwindigkeit: die Knüppelstellung ist die Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>As RC signal</source>
        <translation>Wie RC-Signal</translation>
    </message>
    <message>
        <source>As RC signal, fine</source>
        <translation>Wie RC-Signal, fein</translation>
    </message>
    <message>
        <source>At start</source>
        <translation>Beim Start</translation>
    </message>
    <message>
        <source>Attitude vectors</source>
        <translation>Lagevektoren</translation>
    </message>
    <message>
        <source>Auto PID</source>
        <translation>Auto-PID</translation>
    </message>
    <message>
        <source>Auto PID gain against stability</source>
        <translation>Auto-PID: Verstärkung gegen Stabilität</translation>
    </message>
    <message>
        <source>Auto PID momentum</source>
        <translation>Auto-PID: Trägheit</translation>
    </message>
    <message>
        <source>Auto PID options</source>
        <translation>Auto-PID: Optionen</translation>
    </message>
    <message>
        <source>Auto PID target</source>
        <translation>Auto-PID: Ziel</translation>
    </message>
    <message>
        <source>Auto PID, gain only</source>
        <translation>Auto-PID, nur Verstärkung</translation>
    </message>
    <message>
        <source>Auto-tune PID</source>
        <translation>Auto-Abstimmung PID</translation>
    </message>
    <message>
        <source>Automatic move: acceleration</source>
        <translation>Eigene Bewegung: Beschleunigung</translation>
    </message>
    <message>
        <source>Automatic move: speed</source>
        <translation>Eigene Bewegung: Geschwindigkeit</translation>
    </message>
    <message>
        <source>Axes among which the board chooses by position.</source>
        <translation>Achsen, unter denen das Board nach der Lage wählt.</translation>
    </message>
    <message>
        <source>Axes and options that the automatic tuning on the board starts with.</source>
        <translation>Achsen und Optionen, mit denen die Abstimmung am Board beginnt.</translation>
    </message>
    <message>
        <source>Axes that MAVLink commands steer.</source>
        <translation>Achsen, die MAVLink-Befehle steuern.</translation>
    </message>
    <message>
        <source>Axes whose gains are lowered while they vibrate.</source>
        <translation>Achsen, deren Verstärkung gesenkt wird, solange sie vibrieren.</translation>
    </message>
    <message>
        <source>Axis of the camera that this motor stabilizes.</source>
        <translation>Achse der Kamera, die dieser Motor stabilisiert.</translation>
    </message>
    <message>
        <source>Bad frames received</source>
        <translation>Fehlerhafte Frames empfangen</translation>
    </message>
    <message>
        <source>Balance error, pitch</source>
        <translation>Balancefehler, Pitch</translation>
    </message>
    <message>
        <source>Balance error, roll</source>
        <translation>Balancefehler, Roll</translation>
    </message>
    <message>
        <source>Balance error, yaw</source>
        <translation>Balancefehler, Yaw</translation>
    </message>
    <message>
        <source>Balance the camera, or raise the power of that motor.</source>
        <translation>Balancieren Sie die Kamera aus oder erhöhen Sie die Leistung dieses Motors.</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Akku</translation>
    </message>
    <message>
        <source>Battery voltage at which the alarm sounds; negative = off.</source>
        <translation>Akkuspannung, bei der Alarm ertönt; negativ = aus.</translation>
    </message>
    <message>
        <source>Battery voltage at which the motors are switched off; negative = never.</source>
        <translation>Akkuspannung, bei der die Motoren ausgehen; negativ = nie.</translation>
    </message>
    <message>
        <source>Beeper</source>
        <translation>Piepser</translation>
    </message>
    <message>
        <source>Beeper volume</source>
        <translation>Lautstärke des Piepsers</translation>
    </message>
    <message>
        <source>Below yaw</source>
        <translation>Unter Yaw</translation>
    </message>
    <message>
        <source>Below yaw, PID source</source>
        <translation>Unter Yaw, PID-Quelle</translation>
    </message>
    <message>
        <source>Bind RC receiver</source>
        <translation>RC-Empfänger binden</translation>
    </message>
    <message>
        <source>Bit 3 of the snap byte, without documented meaning. Kept as read.</source>
        <translation>Bit 3 des Rastbytes, ohne beschriebene Bedeutung. Bleibt wie gelesen.</translation>
    </message>
    <message>
        <source>Bit 4, without documented meaning. Kept as read.</source>
        <translation>Bit 4, ohne beschriebene Bedeutung. Bleibt wie gelesen.</translation>
    </message>
    <message>
        <source>Bits 4-7 of the mode byte, without documented meaning. Kept as read.</source>
        <translation>Bits 4-7 des Modusbytes, ohne beschriebene Bedeutung. Bleiben wie gelesen.</translation>
    </message>
    <message>
        <source>Bits 5 and 6 of the type byte, without documented meaning. Kept as read.</source>
        <translation>Bits 5 und 6 des Typbytes, ohne beschriebene Bedeutung. Bleiben wie gelesen.</translation>
    </message>
    <message>
        <source>Bits 7-15, without documented meaning. Kept as read.</source>
        <translation>Bits 7-15, ohne beschriebene Bedeutung. Bleiben wie gelesen.</translation>
    </message>
    <message>
        <source>Blink the battery state</source>
        <translation>Akkuzustand blinken</translation>
    </message>
    <message>
        <source>Blink the profile number</source>
        <translation>Profilnummer blinken</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Board</translation>
    </message>
    <message>
        <source>Board options</source>
        <translation>Board-Optionen</translation>
    </message>
    <message>
        <source>Board state</source>
        <translation>Zustand des Boards</translation>
    </message>
    <message>
        <source>Boost power</source>
        <translation>Zusatzleistung</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Buzzer</source>
        <translation>Summer</translation>
    </message>
    <message>
        <source>By button</source>
        <translation>Per Taste</translation>
    </message>
    <message>
        <source>Calibrate accelerometer</source>
        <translation>Beschleunigungssensor kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate accelerometer (automatic)</source>
        <translation>Beschleunigungssensor kalibrieren (automatisch)</translation>
    </message>
    <message>
        <source>Calibrate accelerometer (temperature)</source>
        <translation>Beschleunigungssensor kalibrieren (Temperatur)</translation>
    </message>
    <message>
        <source>Calibrate external gyroscope</source>
        <translation>Externes Gyroskop kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate follow offset</source>
        <translation>Folgeversatz kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate gyroscope</source>
        <translation>Gyroskop kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate gyroscope (temperature)</source>
        <translation>Gyroskop kalibrieren (Temperatur)</translation>
    </message>
    <message>
        <source>Calibrate magnetometer</source>
        <translation>Magnetometer kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate momentum</source>
        <translation>Trägheit kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate momentum automatically</source>
        <translation>Trägheit automatisch kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate voltage sensor</source>
        <translation>Spannungssensor kalibrieren</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Calibration stimulus</source>
        <translation>Anregung der Kalibrierung</translation>
    </message>
    <message>
        <source>Camera angle taken at power-up.</source>
        <translation>Kamerawinkel beim Einschalten.</translation>
    </message>
    <message>
        <source>Camera angle, pitch</source>
        <translation>Kamerawinkel, Pitch</translation>
    </message>
    <message>
        <source>Camera angle, roll</source>
        <translation>Kamerawinkel, Roll</translation>
    </message>
    <message>
        <source>Camera angle, yaw</source>
        <translation>Kamerawinkel, Yaw</translation>
    </message>
    <message>
        <source>Camera may work upside-down</source>
        <translation>Kamera darf kopfüber arbeiten</translation>
    </message>
    <message>
        <source>Camera, target and motor angles.</source>
        <translation>Kamera-, Ziel- und Motorwinkel.</translation>
    </message>
    <message>
        <source>Camera: photo</source>
        <translation>Kamera: Foto</translation>
    </message>
    <message>
        <source>Camera: record or photo</source>
        <translation>Kamera: Aufnahme oder Foto</translation>
    </message>
    <message>
        <source>Center of the band that is taken out; set it on the resonance of the structure.</source>
        <translation>Mitte des Bandes, das entfernt wird; auf die Resonanz des Aufbaus setzen.</translation>
    </message>
    <message>
        <source>Center yaw</source>
        <translation>Yaw zentrieren</translation>
    </message>
    <message>
        <source>Center yaw at start</source>
        <translation>Yaw beim Start zentrieren</translation>
    </message>
    <message>
        <source>Center yaw, shortest way</source>
        <translation>Yaw zentrieren, kürzester Weg</translation>
    </message>
    <message>
        <source>Check the cable and its ground.</source>
        <translation>Prüfen Sie das Kabel und seine Masse.</translation>
    </message>
    <message>
        <source>Check the sensor cable and its connectors, then restart the board.</source>
        <translation>Prüfen Sie Sensorkabel und Stecker, dann starten Sie das Board neu.</translation>
    </message>
    <message>
        <source>Check the values before writing any.</source>
        <translation>Prüfen Sie die Werte, bevor Sie welche schreiben.</translation>
    </message>
    <message>
        <source>Clock of an SPI encoder; for an I2C driver the type of its own encoder.</source>
        <translation>Takt eines SPI-Gebers; bei einem I2C-Treiber die Art seines eigenen Gebers.</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Compensate from</source>
        <translation>Ausgleichen ab</translation>
    </message>
    <message>
        <source>Component ID of the gimbal; 154 is the standard one.</source>
        <translation>Komponenten-ID des Gimbals; 154 ist üblich.</translation>
    </message>
    <message>
        <source>Confirmation</source>
        <translation>Bestätigung</translation>
    </message>
    <message>
        <source>Control in camera axes</source>
        <translation>Steuerung in Kameraachsen</translation>
    </message>
    <message>
        <source>Cooling factor</source>
        <translation>Abkühlfaktor</translation>
    </message>
    <message>
        <source>Corrects the neutral point of following, where the magnets do not meet the frame exactly.</source>
        <translation>Berichtigt den Neutralpunkt des Folgens, wo die Magnete nicht genau zum Rahmen passen.</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>Current at which power is lowered; 0 = no limit.</source>
        <translation>Strom, bei dem die Leistung gesenkt wird; 0 = keine Grenze.</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>Stromgrenze</translation>
    </message>
    <message>
        <source>Cycle time</source>
        <translation>Taktzeit</translation>
    </message>
    <message>
        <source>D low-pass frequency, pitch</source>
        <translation>D-Tiefpassfrequenz, Pitch</translation>
    </message>
    <message>
        <source>D low-pass frequency, roll</source>
        <translation>D-Tiefpassfrequenz, Roll</translation>
    </message>
    <message>
        <source>D low-pass frequency, yaw</source>
        <translation>D-Tiefpassfrequenz, Yaw</translation>
    </message>
    <message>
        <source>D, pitch</source>
        <translation>D, Pitch</translation>
    </message>
    <message>
        <source>D, roll</source>
        <translation>D, Roll</translation>
    </message>
    <message>
        <source>D, yaw</source>
        <translation>D, Yaw</translation>
    </message>
    <message>
        <source>D-term low-pass</source>
        <translation>Tiefpass des D-Anteils</translation>
    </message>
    <message>
        <source>DSM2 11 ms 10 bit</source>
        <translation>DSM2 11 ms 10 bit</translation>
    </message>
    <message>
        <source>DSM2 11 ms 11 bit</source>
        <translation>DSM2 11 ms 11 bit</translation>
    </message>
    <message>
        <source>DSM2 22 ms 10 bit</source>
        <translation>DSM2 22 ms 10 bit</translation>
    </message>
    <message>
        <source>DSM2 22 ms 11 bit</source>
        <translation>DSM2 22 ms 11 bit</translation>
    </message>
    <message>
        <source>DSMX 11 ms 10 bit</source>
        <translation>DSMX 11 ms 10 bit</translation>
    </message>
    <message>
        <source>DSMX 11 ms 11 bit</source>
        <translation>DSMX 11 ms 11 bit</translation>
    </message>
    <message>
        <source>DSMX 22 ms 10 bit</source>
        <translation>DSMX 22 ms 10 bit</translation>
    </message>
    <message>
        <source>DSMX 22 ms 11 bit</source>
        <translation>DSMX 22 ms 11 bit</translation>
    </message>
    <message>
        <source>Damps the response. Too little overshoots, too much makes the structure ring at a high tone.</source>
        <translation>Dämpft die Antwort. Zu wenig schwingt über, zu viel lässt den Aufbau hell klingen.</translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation>Totbereich</translation>
    </message>
    <message>
        <source>Decay</source>
        <translation>Abklingen</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>Depth of the notch; negative makes it a peak.</source>
        <translation>Tiefe der Kerbe; negativ wird sie zur Spitze.</translation>
    </message>
    <message>
        <source>Detect</source>
        <translation>Erkennen</translation>
    </message>
    <message>
        <source>Detect ADC1</source>
        <translation>ADC1 erkennen</translation>
    </message>
    <message>
        <source>Detect ADC2</source>
        <translation>ADC2 erkennen</translation>
    </message>
    <message>
        <source>Detect ADC3</source>
        <translation>ADC3 erkennen</translation>
    </message>
    <message>
        <source>Detect briefcase mode</source>
        <translation>Koffermodus erkennen</translation>
    </message>
    <message>
        <source>Detect upside-down frame</source>
        <translation>Rahmen kopfüber erkennen</translation>
    </message>
    <message>
        <source>Do not check encoder limits</source>
        <translation>Gebergrenzen nicht prüfen</translation>
    </message>
    <message>
        <source>Do not test the encoder at start.</source>
        <translation>Den Geber beim Start nicht prüfen.</translation>
    </message>
    <message>
        <source>Do not use the accelerometer</source>
        <translation>Beschleunigungssensor nicht benutzen</translation>
    </message>
    <message>
        <source>Doubles the rate of the sensor bus; needs short, good cables.</source>
        <translation>Verdoppelt die Rate des Sensorbusses; braucht kurze, gute Kabel.</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Electrical field offset</source>
        <translation>Elektrischer Feldversatz</translation>
    </message>
    <message>
        <source>Ellipticity</source>
        <translation>Elliptizität</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Not-Halt</translation>
    </message>
    <message>
        <source>Emergency stop (cause 61)</source>
        <translation>Not-Halt (Ursache 61)</translation>
    </message>
    <message>
        <source>Emergency stop (cause 62)</source>
        <translation>Not-Halt (Ursache 62)</translation>
    </message>
    <message>
        <source>Emergency stop (cause 63)</source>
        <translation>Not-Halt (Ursache 63)</translation>
    </message>
    <message>
        <source>Emergency stop cause</source>
        <translation>Ursache des Not-Halts</translation>
    </message>
    <message>
        <source>Emergency stop: CAN hardware</source>
        <translation>Not-Halt: CAN-Hardware</translation>
    </message>
    <message>
        <source>Emergency stop: I2C errors</source>
        <translation>Not-Halt: I2C-Fehler</translation>
    </message>
    <message>
        <source>Emergency stop: IMU lost</source>
        <translation>Not-Halt: IMU verloren</translation>
    </message>
    <message>
        <source>Emergency stop: bad IMU</source>
        <translation>Not-Halt: schlechte IMU</translation>
    </message>
    <message>
        <source>Emergency stop: calibration failed</source>
        <translation>Not-Halt: Kalibrierung misslungen</translation>
    </message>
    <message>
        <source>Emergency stop: driver fault</source>
        <translation>Not-Halt: Treiberfehler</translation>
    </message>
    <message>
        <source>Emergency stop: driver too hot</source>
        <translation>Not-Halt: Treiber zu heiß</translation>
    </message>
    <message>
        <source>Emergency stop: encoder and IMU disagree</source>
        <translation>Not-Halt: Geber und IMU widersprechen sich</translation>
    </message>
    <message>
        <source>Emergency stop: encoder scale</source>
        <translation>Not-Halt: Gebermaßstab</translation>
    </message>
    <message>
        <source>Emergency stop: endless restarts</source>
        <translation>Not-Halt: endlose Neustarts</translation>
    </message>
    <message>
        <source>Emergency stop: internal fault</source>
        <translation>Not-Halt: innerer Fehler</translation>
    </message>
    <message>
        <source>Emergency stop: memory</source>
        <translation>Not-Halt: Speicher</translation>
    </message>
    <message>
        <source>Emergency stop: motor blocked</source>
        <translation>Not-Halt: Motor blockiert</translation>
    </message>
    <message>
        <source>Emergency stop: motor poles or inversion</source>
        <translation>Not-Halt: Motorpole oder Richtung</translation>
    </message>
    <message>
        <source>Emergency stop: motor too hot</source>
        <translation>Not-Halt: Motor zu heiß</translation>
    </message>
    <message>
        <source>Emergency stop: overload too long</source>
        <translation>Not-Halt: zu lange überlastet</translation>
    </message>
    <message>
        <source>Emergency stop: too hot</source>
        <translation>Not-Halt: zu heiß</translation>
    </message>
    <message>
        <source>Emergency stop: wrong start position</source>
        <translation>Not-Halt: falsche Startlage</translation>
    </message>
    <message>
        <source>Encoder bus speed</source>
        <translation>Bustakt der Geber</translation>
    </message>
    <message>
        <source>Encoder gear ratio</source>
        <translation>Getriebe des Gebers</translation>
    </message>
    <message>
        <source>Encoder offset</source>
        <translation>Geberversatz</translation>
    </message>
    <message>
        <source>Encoder reading in the normal position; found by calibration.</source>
        <translation>Geberwert in Normallage; wird durch Kalibrierung gefunden.</translation>
    </message>
    <message>
        <source>Encoder type</source>
        <translation>Gebertyp</translation>
    </message>
    <message>
        <source>Encoder type, further bits</source>
        <translation>Gebertyp, weitere Bits</translation>
    </message>
    <message>
        <source>Encoders</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>Ends of travel that count as parking position.</source>
        <translation>Enden des Wegs, die als Parklage gelten.</translation>
    </message>
    <message>
        <source>Entering parking position</source>
        <translation>Eintritt in Parklage</translation>
    </message>
    <message>
        <source>Environment temperature unknown</source>
        <translation>Umgebungstemperatur unbekannt</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Estimates acceleration of the frame from a motion model.</source>
        <translation>Schätzt die Beschleunigung des Rahmens aus einem Bewegungsmodell.</translation>
    </message>
    <message>
        <source>Estimates the frame&apos;s tilt from the motors&apos; positions.</source>
        <translation>Schätzt die Neigung des Rahmens aus den Motorlagen.</translation>
    </message>
    <message>
        <source>Euler order</source>
        <translation>Euler-Reihenfolge</translation>
    </message>
    <message>
        <source>Even parity</source>
        <translation>Gerade Parität</translation>
    </message>
    <message>
        <source>Events that are signalled on the interrupt pin.</source>
        <translation>Ereignisse, die am Interrupt-Pin gemeldet werden.</translation>
    </message>
    <message>
        <source>Events that make a sound, and whether the motors make it.</source>
        <translation>Ereignisse, die tönen, und ob die Motoren das tun.</translation>
    </message>
    <message>
        <source>Exponential curve</source>
        <translation>Exponentialkurve</translation>
    </message>
    <message>
        <source>Extended low-pass range</source>
        <translation>Erweiterter Tiefpassbereich</translation>
    </message>
    <message>
        <source>External LED pin</source>
        <translation>Pin für externe LED</translation>
    </message>
    <message>
        <source>Factory defaults</source>
        <translation>Werkseinstellungen</translation>
    </message>
    <message>
        <source>Fast I2C (800 kHz)</source>
        <translation>Schneller I2C (800 kHz)</translation>
    </message>
    <message>
        <source>Filters</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filters and limits</source>
        <translation>Filter und Grenzen</translation>
    </message>
    <message>
        <source>Filters in use</source>
        <translation>Benutzte Filter</translation>
    </message>
    <message>
        <source>Fine adjustment</source>
        <translation>Feineinstellung</translation>
    </message>
    <message>
        <source>Firmware and tool differ</source>
        <translation>Firmware und Werkzeug passen nicht</translation>
    </message>
    <message>
        <source>Flight controller</source>
        <translation>Flugregler</translation>
    </message>
    <message>
        <source>Flight controller below middle motor</source>
        <translation>Flugregler unter dem mittleren Motor</translation>
    </message>
    <message>
        <source>Flight controller below outer motor</source>
        <translation>Flugregler unter dem äußeren Motor</translation>
    </message>
    <message>
        <source>Flight controller gain</source>
        <translation>Verstärkung des Flugreglers</translation>
    </message>
    <message>
        <source>Flight controller input, pitch</source>
        <translation>Flugreglereingang, Pitch</translation>
    </message>
    <message>
        <source>Flight controller input, roll</source>
        <translation>Flugreglereingang, Roll</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Follow dead band</source>
        <translation>Totbereich des Folgens</translation>
    </message>
    <message>
        <source>Follow exponential curve</source>
        <translation>Exponentialkurve des Folgens</translation>
    </message>
    <message>
        <source>Follow flight controller</source>
        <translation>Flugregler folgen</translation>
    </message>
    <message>
        <source>Follow inner dead band</source>
        <translation>Innerer Totbereich des Folgens</translation>
    </message>
    <message>
        <source>Follow lock offset correction</source>
        <translation>Versatzausgleich der Folgesperre</translation>
    </message>
    <message>
        <source>Follow low-pass, pitch</source>
        <translation>Folge-Tiefpass, Pitch</translation>
    </message>
    <message>
        <source>Follow low-pass, roll</source>
        <translation>Folge-Tiefpass, Roll</translation>
    </message>
    <message>
        <source>Follow low-pass, yaw</source>
        <translation>Folge-Tiefpass, Yaw</translation>
    </message>
    <message>
        <source>Follow mode</source>
        <translation>Folgemodus</translation>
    </message>
    <message>
        <source>Follow off/on</source>
        <translation>Folgen aus/ein</translation>
    </message>
    <message>
        <source>Follow pitch and roll</source>
        <translation>Pitch und Roll folgen</translation>
    </message>
    <message>
        <source>Follow range, pitch</source>
        <translation>Folgebereich, Pitch</translation>
    </message>
    <message>
        <source>Follow range, roll</source>
        <translation>Folgebereich, Roll</translation>
    </message>
    <message>
        <source>Follow range, yaw</source>
        <translation>Folgebereich, Yaw</translation>
    </message>
    <message>
        <source>Follow rate</source>
        <translation>Folgeanteil</translation>
    </message>
    <message>
        <source>Follow roll mix, range</source>
        <translation>Roll-Mischung beim Folgen, Bereich</translation>
    </message>
    <message>
        <source>Follow roll mix, start</source>
        <translation>Roll-Mischung beim Folgen, Beginn</translation>
    </message>
    <message>
        <source>Follow speed, pitch</source>
        <translation>Folgegeschwindigkeit, Pitch</translation>
    </message>
    <message>
        <source>Follow speed, roll</source>
        <translation>Folgegeschwindigkeit, Roll</translation>
    </message>
    <message>
        <source>Follow speed, yaw</source>
        <translation>Folgegeschwindigkeit, Yaw</translation>
    </message>
    <message>
        <source>Follow uses the frame IMU</source>
        <translation>Folgen benutzt die Rahmen-IMU</translation>
    </message>
    <message>
        <source>Follow yaw</source>
        <translation>Yaw folgen</translation>
    </message>
    <message>
        <source>Forced follow on/off</source>
        <translation>Erzwungenes Folgen ein/aus</translation>
    </message>
    <message>
        <source>Form of the command</source>
        <translation>Form des Befehls</translation>
    </message>
    <message>
        <source>Format of the Spektrum satellite receiver.</source>
        <translation>Format des Spektrum-Satelliten.</translation>
    </message>
    <message>
        <source>Frame IMU</source>
        <translation>Rahmen-IMU</translation>
    </message>
    <message>
        <source>Frame IMU feed-forward</source>
        <translation>Vorsteuerung der Rahmen-IMU</translation>
    </message>
    <message>
        <source>Frame IMU low-pass</source>
        <translation>Tiefpass der Rahmen-IMU</translation>
    </message>
    <message>
        <source>Frame IMU temperature</source>
        <translation>Temperatur der Rahmen-IMU</translation>
    </message>
    <message>
        <source>Frame IMU: axis right</source>
        <translation>Rahmen-IMU: Achse nach rechts</translation>
    </message>
    <message>
        <source>Frame IMU: axis up</source>
        <translation>Rahmen-IMU: Achse nach oben</translation>
    </message>
    <message>
        <source>Frame IMU: place</source>
        <translation>Rahmen-IMU: Ort</translation>
    </message>
    <message>
        <source>Frame angle at which following reaches full speed.</source>
        <translation>Rahmenwinkel, bei dem das Folgen volle Geschwindigkeit erreicht.</translation>
    </message>
    <message>
        <source>Frame angle, pitch</source>
        <translation>Rahmenwinkel, Pitch</translation>
    </message>
    <message>
        <source>Frame angle, roll</source>
        <translation>Rahmenwinkel, Roll</translation>
    </message>
    <message>
        <source>Frame angle, yaw</source>
        <translation>Rahmenwinkel, Yaw</translation>
    </message>
    <message>
        <source>Frame angles from motors</source>
        <translation>Rahmenwinkel aus Motoren</translation>
    </message>
    <message>
        <source>Frame heading angle (0.1°)</source>
        <translation>Kurswinkel des Rahmens (0,1°)</translation>
    </message>
    <message>
        <source>Frame is upside-down</source>
        <translation>Rahmen ist kopfüber</translation>
    </message>
    <message>
        <source>Frame motion around the neutral point that is not followed.</source>
        <translation>Rahmenbewegung um den Neutralpunkt, der nicht gefolgt wird.</translation>
    </message>
    <message>
        <source>Frame upside-down</source>
        <translation>Rahmen kopfüber</translation>
    </message>
    <message>
        <source>Frequency above which the controller no longer reacts. Lower is quieter and slower.</source>
        <translation>Frequenz, über der der Regler nicht mehr antwortet. Niedriger ist leiser und langsamer.</translation>
    </message>
    <message>
        <source>Further board options</source>
        <translation>Weitere Board-Optionen</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Gain against stability</source>
        <translation>Verstärkung gegen Stabilität</translation>
    </message>
    <message>
        <source>Gain of the outer loop, from angle error to wanted speed.</source>
        <translation>Verstärkung der äußeren Schleife, vom Winkelfehler zur Sollgeschwindigkeit.</translation>
    </message>
    <message>
        <source>Geared encoder</source>
        <translation>Geber am Getriebe</translation>
    </message>
    <message>
        <source>Gearing</source>
        <translation>Getriebe</translation>
    </message>
    <message>
        <source>Gravity error</source>
        <translation>Schwerkraftfehler</translation>
    </message>
    <message>
        <source>Gravity vector, x</source>
        <translation>Schwerkraftvektor, x</translation>
    </message>
    <message>
        <source>Gravity vector, y</source>
        <translation>Schwerkraftvektor, y</translation>
    </message>
    <message>
        <source>Gravity vector, z</source>
        <translation>Schwerkraftvektor, z</translation>
    </message>
    <message>
        <source>Gyro calibration at start</source>
        <translation>Gyroskop beim Start kalibrieren</translation>
    </message>
    <message>
        <source>Gyro dead band</source>
        <translation>Totbereich des Gyroskops</translation>
    </message>
    <message>
        <source>Gyro heading correction (0.001)</source>
        <translation>Kurskorrektur des Gyroskops (0,001)</translation>
    </message>
    <message>
        <source>Gyro sensitivity</source>
        <translation>Empfindlichkeit des Gyroskops</translation>
    </message>
    <message>
        <source>Gyro trust</source>
        <translation>Vertrauen ins Gyroskop</translation>
    </message>
    <message>
        <source>Gyro, pitch</source>
        <translation>Gyroskop, Pitch</translation>
    </message>
    <message>
        <source>Gyro, roll</source>
        <translation>Gyroskop, Roll</translation>
    </message>
    <message>
        <source>Gyro, yaw</source>
        <translation>Gyroskop, Yaw</translation>
    </message>
    <message>
        <source>Heading correction factor</source>
        <translation>Faktor der Kurskorrektur</translation>
    </message>
    <message>
        <source>Heading error</source>
        <translation>Kursfehler</translation>
    </message>
    <message>
        <source>Heading vector, x</source>
        <translation>Kursvektor, x</translation>
    </message>
    <message>
        <source>Heading vector, y</source>
        <translation>Kursvektor, y</translation>
    </message>
    <message>
        <source>Heading vector, z</source>
        <translation>Kursvektor, z</translation>
    </message>
    <message>
        <source>Heating factor</source>
        <translation>Erwärmungsfaktor</translation>
    </message>
    <message>
        <source>High</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Home position</source>
        <translation>Grundstellung</translation>
    </message>
    <message>
        <source>Home position of motors</source>
        <translation>Grundstellung der Motoren</translation>
    </message>
    <message>
        <source>Home position, shortest way</source>
        <translation>Grundstellung, kürzester Weg</translation>
    </message>
    <message>
        <source>How fast gains are lowered.</source>
        <translation>Wie schnell Verstärkungen gesenkt werden.</translation>
    </message>
    <message>
        <source>How fast the camera follows the frame.</source>
        <translation>Wie schnell die Kamera dem Rahmen folgt.</translation>
    </message>
    <message>
        <source>How fast this motor is taken to cool down.</source>
        <translation>Wie schnell dieser Motor als abgekühlt gilt.</translation>
    </message>
    <message>
        <source>How fast this motor is taken to warm up; 0 = no heat model.</source>
        <translation>Wie schnell dieser Motor als erwärmt gilt; 0 = kein Wärmemodell.</translation>
    </message>
    <message>
        <source>How long a time-lapse move takes.</source>
        <translation>Wie lange eine Zeitrafferbewegung dauert.</translation>
    </message>
    <message>
        <source>How long the camera must be held before its new position is taken over.</source>
        <translation>Wie lange die Kamera gehalten werden muss, bis die neue Lage gilt.</translation>
    </message>
    <message>
        <source>How much is still followed inside the dead band.</source>
        <translation>Wie viel im Totbereich noch gefolgt wird.</translation>
    </message>
    <message>
        <source>How much the gyroscope counts against the accelerometer. More suits vehicles, less suits tripods.</source>
        <translation>Wie viel das Gyroskop gegen den Beschleunigungssensor zählt. Mehr passt zu Fahrzeugen, weniger zu Stativen.</translation>
    </message>
    <message>
        <source>How much the inertia depends on the camera&apos;s position.</source>
        <translation>Wie stark die Trägheit von der Lage der Kamera abhängt.</translation>
    </message>
    <message>
        <source>How slowly gains come back; more is slower.</source>
        <translation>Wie langsam Verstärkungen zurückkommen; mehr ist langsamer.</translation>
    </message>
    <message>
        <source>How strongly the heading follows the magnetometer.</source>
        <translation>Wie stark der Kurs dem Magnetometer folgt.</translation>
    </message>
    <message>
        <source>I, pitch</source>
        <translation>I, Pitch</translation>
    </message>
    <message>
        <source>I, roll</source>
        <translation>I, Roll</translation>
    </message>
    <message>
        <source>I, yaw</source>
        <translation>I, Yaw</translation>
    </message>
    <message>
        <source>I2C driver 1</source>
        <translation>I2C-Treiber 1</translation>
    </message>
    <message>
        <source>I2C driver 2</source>
        <translation>I2C-Treiber 2</translation>
    </message>
    <message>
        <source>I2C driver 3</source>
        <translation>I2C-Treiber 3</translation>
    </message>
    <message>
        <source>I2C driver 4</source>
        <translation>I2C-Treiber 4</translation>
    </message>
    <message>
        <source>I2C errors</source>
        <translation>I2C-Fehler</translation>
    </message>
    <message>
        <source>IMU angle correction, pitch (0.01°)</source>
        <translation>IMU-Winkelkorrektur, Pitch (0,01°)</translation>
    </message>
    <message>
        <source>IMU angle correction, roll (0.01°)</source>
        <translation>IMU-Winkelkorrektur, Roll (0,01°)</translation>
    </message>
    <message>
        <source>IMU temperature</source>
        <translation>IMU-Temperatur</translation>
    </message>
    <message>
        <source>Ignore limits</source>
        <translation>Grenzen nicht beachten</translation>
    </message>
    <message>
        <source>Inertia of the axis as measured by calibration.</source>
        <translation>Trägheit der Achse, wie die Kalibrierung sie maß.</translation>
    </message>
    <message>
        <source>Inertial sensors</source>
        <translation>Inertialsensoren</translation>
    </message>
    <message>
        <source>Input that carries the flight controller&apos;s angle.</source>
        <translation>Eingang mit dem Winkel des Flugreglers.</translation>
    </message>
    <message>
        <source>Input that controls this axis.</source>
        <translation>Eingang, der diese Achse steuert.</translation>
    </message>
    <message>
        <source>Input that is corrected.</source>
        <translation>Eingang, der berichtigt wird.</translation>
    </message>
    <message>
        <source>Input whose pulses step the signal.</source>
        <translation>Eingang, dessen Impulse das Signal schrittweise ändern.</translation>
    </message>
    <message>
        <source>Input whose three positions run the commands low, middle and high.</source>
        <translation>Eingang, dessen drei Stellungen die Befehle niedrig, Mitte und hoch auslösen.</translation>
    </message>
    <message>
        <source>Integral part of the outer loop.</source>
        <translation>Integralanteil der äußeren Schleife.</translation>
    </message>
    <message>
        <source>Internal I2C pull-ups</source>
        <translation>Innere I2C-Pull-ups</translation>
    </message>
    <message>
        <source>Interrupt events</source>
        <translation>Interrupt-Ereignisse</translation>
    </message>
    <message>
        <source>Interrupt pin</source>
        <translation>Interrupt-Pin</translation>
    </message>
    <message>
        <source>Interrupt, further bits</source>
        <translation>Interrupt, weitere Bits</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Invert RC pitch</source>
        <translation>RC-Pitch umkehren</translation>
    </message>
    <message>
        <source>Invert RC roll</source>
        <translation>RC-Roll umkehren</translation>
    </message>
    <message>
        <source>Invert RC when upside-down</source>
        <translation>RC kopfüber umkehren</translation>
    </message>
    <message>
        <source>Invert RC yaw</source>
        <translation>RC-Yaw umkehren</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>Jerk limit</source>
        <translation>Ruckgrenze</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Length of a note</source>
        <translation>Länge eines Tons</translation>
    </message>
    <message>
        <source>Let the motors cool, then lower the power.</source>
        <translation>Lassen Sie die Motoren abkühlen, dann senken Sie die Leistung.</translation>
    </message>
    <message>
        <source>Level of the input that makes a step.</source>
        <translation>Pegel des Eingangs, der einen Schritt macht.</translation>
    </message>
    <message>
        <source>Level pitch</source>
        <translation>Pitch waagerecht</translation>
    </message>
    <message>
        <source>Level roll</source>
        <translation>Roll waagerecht</translation>
    </message>
    <message>
        <source>Level roll and pitch</source>
        <translation>Roll und Pitch waagerecht</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Limits how fast commanded motion speeds up; 0 = no limit.</source>
        <translation>Begrenzt, wie schnell befohlene Bewegung schneller wird; 0 = keine Grenze.</translation>
    </message>
    <message>
        <source>Limits how fast commanded motion speeds up; 0 = no limit. Replaced by the limit per axis.</source>
        <translation>Begrenzt, wie schnell befohlene Bewegung schneller wird; 0 = keine Grenze. Ersetzt durch die Grenze je Achse.</translation>
    </message>
    <message>
        <source>List debug variables</source>
        <translation>Debug-Variablen auflisten</translation>
    </message>
    <message>
        <source>Live values in the board&apos;s memory.</source>
        <translation>Werte in Gebrauch im Speicher des Boards.</translation>
    </message>
    <message>
        <source>Load backup set</source>
        <translation>Sicherungssatz laden</translation>
    </message>
    <message>
        <source>Load profile set 1</source>
        <translation>Profilsatz laden: 1</translation>
    </message>
    <message>
        <source>Load profile set 2</source>
        <translation>Profilsatz laden: 2</translation>
    </message>
    <message>
        <source>Load profile set 3</source>
        <translation>Profilsatz laden: 3</translation>
    </message>
    <message>
        <source>Load profile set 4</source>
        <translation>Profilsatz laden: 4</translation>
    </message>
    <message>
        <source>Load profile set 5</source>
        <translation>Profilsatz laden: 5</translation>
    </message>
    <message>
        <source>Look down</source>
        <translation>Nach unten sehen</translation>
    </message>
    <message>
        <source>Loudness of the sounds made by the motors.</source>
        <translation>Lautstärke der Töne, die die Motoren machen.</translation>
    </message>
    <message>
        <source>Low</source>
        <translation>Niedrig</translation>
    </message>
    <message>
        <source>Low (audible)</source>
        <translation>Niedrig (hörbar)</translation>
    </message>
    <message>
        <source>Low-pass</source>
        <translation>Tiefpass</translation>
    </message>
    <message>
        <source>Low-pass filter of following; more is smoother and later.</source>
        <translation>Tiefpass des Folgens; mehr ist weicher und später.</translation>
    </message>
    <message>
        <source>Low-pass filter of the stick signal; more is smoother and later.</source>
        <translation>Tiefpass des Knüppelsignals; mehr ist weicher und später.</translation>
    </message>
    <message>
        <source>Low-pass filter of the stick signal; more is smoother and later. Above 15 only with the extended range.</source>
        <translation>Tiefpass des Knüppelsignals; mehr ist weicher und später. Über 15 nur mit erweitertem Bereich.</translation>
    </message>
    <message>
        <source>Low-pass frequency</source>
        <translation>Tiefpassfrequenz</translation>
    </message>
    <message>
        <source>Low-pass frequency, pitch</source>
        <translation>Tiefpassfrequenz, Pitch</translation>
    </message>
    <message>
        <source>Low-pass frequency, roll</source>
        <translation>Tiefpassfrequenz, Roll</translation>
    </message>
    <message>
        <source>Low-pass frequency, yaw</source>
        <translation>Tiefpassfrequenz, Yaw</translation>
    </message>
    <message>
        <source>Lower end of the range that remote control can reach.</source>
        <translation>Unteres Ende des Bereichs, den die Fernsteuerung erreicht.</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Untere Grenze</translation>
    </message>
    <message>
        <source>MA3 10 bit</source>
        <translation>MA3 10 bit</translation>
    </message>
    <message>
        <source>MA3 12 bit</source>
        <translation>MA3 12 bit</translation>
    </message>
    <message>
        <source>MAVLink</source>
        <translation>MAVLink</translation>
    </message>
    <message>
        <source>MAVLink channel %1: component ID</source>
        <translation>MAVLink-Kanal %1: Komponenten-ID</translation>
    </message>
    <message>
        <source>MAVLink channel %1: options</source>
        <translation>MAVLink-Kanal %1: Optionen</translation>
    </message>
    <message>
        <source>MAVLink channel %1: port</source>
        <translation>MAVLink-Kanal %1: Anschluss</translation>
    </message>
    <message>
        <source>MAVLink channel %1: system ID</source>
        <translation>MAVLink-Kanal %1: System-ID</translation>
    </message>
    <message>
        <source>MAVLink control</source>
        <translation>MAVLink-Steuerung</translation>
    </message>
    <message>
        <source>MAVLink control mode</source>
        <translation>MAVLink-Steuerungsart</translation>
    </message>
    <message>
        <source>Magnetic declination</source>
        <translation>Missweisung</translation>
    </message>
    <message>
        <source>Magnetic link</source>
        <translation>Magnetische Kopplung</translation>
    </message>
    <message>
        <source>Magnetic link (old)</source>
        <translation>Magnetische Kopplung (alt)</translation>
    </message>
    <message>
        <source>Magnetometer on the frame</source>
        <translation>Magnetometer am Rahmen</translation>
    </message>
    <message>
        <source>Magnetometer trust</source>
        <translation>Magnetometervertrauen</translation>
    </message>
    <message>
        <source>Magnetometer, pitch</source>
        <translation>Magnetometer, Pitch</translation>
    </message>
    <message>
        <source>Magnetometer, roll</source>
        <translation>Magnetometer, Roll</translation>
    </message>
    <message>
        <source>Magnetometer, yaw</source>
        <translation>Magnetometer, Yaw</translation>
    </message>
    <message>
        <source>Magnetometer: axis right</source>
        <translation>Magnetometer: Achse nach rechts</translation>
    </message>
    <message>
        <source>Magnetometer: axis up</source>
        <translation>Magnetometer: Achse nach oben</translation>
    </message>
    <message>
        <source>Main IMU</source>
        <translation>Haupt-IMU</translation>
    </message>
    <message>
        <source>Main IMU: axis right</source>
        <translation>Haupt-IMU: Achse nach rechts</translation>
    </message>
    <message>
        <source>Main IMU: axis up</source>
        <translation>Haupt-IMU: Achse nach oben</translation>
    </message>
    <message>
        <source>Make a sound</source>
        <translation>Ton geben</translation>
    </message>
    <message>
        <source>Makes a profile the active one.</source>
        <translation>Macht ein Profil zum aktiven.</translation>
    </message>
    <message>
        <source>Makes following soft near the neutral point and fast far from it.</source>
        <translation>Macht das Folgen nahe am Neutralpunkt weich und weit davon schnell.</translation>
    </message>
    <message>
        <source>Makes the middle of the stick finer.</source>
        <translation>Macht die Mitte des Knüppels feiner.</translation>
    </message>
    <message>
        <source>Matches the flight controller&apos;s angle signal to the frame; found by calibration.</source>
        <translation>Passt das Winkelsignal des Flugreglers an den Rahmen an; wird durch Kalibrierung gefunden.</translation>
    </message>
    <message>
        <source>Maximum angle</source>
        <translation>Größter Winkel</translation>
    </message>
    <message>
        <source>Measured voltage</source>
        <translation>Gemessene Spannung</translation>
    </message>
    <message>
        <source>Measures the zero of the gyroscope. The camera must stand absolutely still.</source>
        <translation>Misst den Nullpunkt des Gyroskops. Die Kamera muss völlig still stehen.</translation>
    </message>
    <message>
        <source>Menu button disables follow</source>
        <translation>Menütaste schaltet Folgen ab</translation>
    </message>
    <message>
        <source>Menu button press</source>
        <translation>Druck auf die Menütaste</translation>
    </message>
    <message>
        <source>Menu button, long press</source>
        <translation>Menütaste, langer Druck</translation>
    </message>
    <message>
        <source>Menu command</source>
        <translation>Menübefehl</translation>
    </message>
    <message>
        <source>Minimum angle</source>
        <translation>Kleinster Winkel</translation>
    </message>
    <message>
        <source>Mix into</source>
        <translation>Mischen in</translation>
    </message>
    <message>
        <source>Mix rate</source>
        <translation>Mischanteil</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Mode, further bits</source>
        <translation>Modus, weitere Bits</translation>
    </message>
    <message>
        <source>Model of the encoder on this axis. If it is wrong, the motor runs away.</source>
        <translation>Modell des Gebers an dieser Achse. Falsch geht der Motor durch.</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>Momentum assumed by automatic tuning; 0 = found by itself.</source>
        <translation>Trägheit für die Auto-Abstimmung; 0 = selbst finden.</translation>
    </message>
    <message>
        <source>Momentum feed-forward</source>
        <translation>Vorsteuerung der Trägheit</translation>
    </message>
    <message>
        <source>More gives higher gains and less reserve.</source>
        <translation>Mehr gibt höhere Verstärkung und weniger Reserve.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Motor angle that the axis does not go above.</source>
        <translation>Motorwinkel, über den die Achse nicht hinausgeht.</translation>
    </message>
    <message>
        <source>Motor angle that the axis does not go below.</source>
        <translation>Motorwinkel, unter den die Achse nicht geht.</translation>
    </message>
    <message>
        <source>Motor angle, pitch</source>
        <translation>Motorwinkel, Pitch</translation>
    </message>
    <message>
        <source>Motor angle, roll</source>
        <translation>Motorwinkel, Roll</translation>
    </message>
    <message>
        <source>Motor angle, yaw</source>
        <translation>Motorwinkel, Yaw</translation>
    </message>
    <message>
        <source>Motor connector that drives this axis. If it is wrong, an axis turns the wrong motor.</source>
        <translation>Motorstecker, der diese Achse treibt. Falsch dreht eine Achse den falschen Motor.</translation>
    </message>
    <message>
        <source>Motor lost steps</source>
        <translation>Motor hat Schritte verloren</translation>
    </message>
    <message>
        <source>Motor power is not set</source>
        <translation>Motorleistung ist nicht gesetzt</translation>
    </message>
    <message>
        <source>Motor power, pitch</source>
        <translation>Motorleistung, Pitch</translation>
    </message>
    <message>
        <source>Motor power, roll</source>
        <translation>Motorleistung, Roll</translation>
    </message>
    <message>
        <source>Motor power, yaw</source>
        <translation>Motorleistung, Yaw</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>Motors off</source>
        <translation>Motoren aus</translation>
    </message>
    <message>
        <source>Motors off at start</source>
        <translation>Motoren beim Start aus</translation>
    </message>
    <message>
        <source>Motors off below</source>
        <translation>Motoren aus unter</translation>
    </message>
    <message>
        <source>Motors on</source>
        <translation>Motoren ein</translation>
    </message>
    <message>
        <source>Motors on/off</source>
        <translation>Motoren ein/aus</translation>
    </message>
    <message>
        <source>Motors running</source>
        <translation>Motoren laufen</translation>
    </message>
    <message>
        <source>Motors: safe stop</source>
        <translation>Motoren: sicherer Halt</translation>
    </message>
    <message>
        <source>Motors: safe stop/on</source>
        <translation>Motoren: sicherer Halt/ein</translation>
    </message>
    <message>
        <source>Mounting angle of the middle motor.</source>
        <translation>Einbauwinkel des mittleren Motors.</translation>
    </message>
    <message>
        <source>Mounting angle of the outer motor.</source>
        <translation>Einbauwinkel des äußeren Motors.</translation>
    </message>
    <message>
        <source>Moves the camera for a time, then gives control back.</source>
        <translation>Bewegt die Kamera eine Zeit lang und gibt dann die Steuerung zurück.</translation>
    </message>
    <message>
        <source>Moves the middle of the stick signal.</source>
        <translation>Verschiebt die Mitte des Knüppelsignals.</translation>
    </message>
    <message>
        <source>Multiplies P, I and D together; turn this one first.</source>
        <translation>Vervielfacht P, I und D zusammen; hieran zuerst drehen.</translation>
    </message>
    <message>
        <source>Names and types of the board&apos;s inner variables.</source>
        <translation>Namen und Typen der inneren Variablen des Boards.</translation>
    </message>
    <message>
        <source>No IMU</source>
        <translation>Keine IMU</translation>
    </message>
    <message>
        <source>No action</source>
        <translation>Keine Aktion</translation>
    </message>
    <message>
        <source>No power manager</source>
        <translation>Kein Leistungswächter</translation>
    </message>
    <message>
        <source>Normal PWM</source>
        <translation>Normales PWM</translation>
    </message>
    <message>
        <source>Not used</source>
        <translation>Nicht benutzt</translation>
    </message>
    <message>
        <source>Not used by current firmware.</source>
        <translation>Von heutiger Firmware nicht benutzt.</translation>
    </message>
    <message>
        <source>Notch %1 frequency</source>
        <translation>Kerbe %1: Frequenz</translation>
    </message>
    <message>
        <source>Notch %1 gain</source>
        <translation>Kerbe %1: Tiefe</translation>
    </message>
    <message>
        <source>Notch %1 width</source>
        <translation>Kerbe %1: Breite</translation>
    </message>
    <message>
        <source>Notch 1</source>
        <translation>Kerbe 1</translation>
    </message>
    <message>
        <source>Notch 2</source>
        <translation>Kerbe 2</translation>
    </message>
    <message>
        <source>Notch 3</source>
        <translation>Kerbe 3</translation>
    </message>
    <message>
        <source>Notes of a melody (Hz, comma between)</source>
        <translation>Töne einer Melodie (Hz, Komma dazwischen)</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Number of magnet poles of the motor. If it is wrong, gains are off by the same factor and steps are lost.</source>
        <translation>Zahl der Magnetpole des Motors. Falsch sind die Verstärkungen um denselben Faktor falsch, und Schritte gehen verloren.</translation>
    </message>
    <message>
        <source>Number of steps over the whole range.</source>
        <translation>Zahl der Schritte über den ganzen Bereich.</translation>
    </message>
    <message>
        <source>Numbers (comma between)</source>
        <translation>Nummern (Komma dazwischen)</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>On-board IMU may be main</source>
        <translation>IMU des Boards darf Haupt-IMU sein</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Options of this profile.</source>
        <translation>Optionen dieses Profils.</translation>
    </message>
    <message>
        <source>Options that hold for all profiles.</source>
        <translation>Optionen, die für alle Profile gelten.</translation>
    </message>
    <message>
        <source>Order of Euler angles</source>
        <translation>Reihenfolge der Euler-Winkel</translation>
    </message>
    <message>
        <source>Order of motors</source>
        <translation>Reihenfolge der Motoren</translation>
    </message>
    <message>
        <source>Order of rotations in which angles and targets are expressed.</source>
        <translation>Reihenfolge der Drehungen, in der Winkel und Ziele ausgedrückt sind.</translation>
    </message>
    <message>
        <source>Order of the motors, counted from the camera outwards.</source>
        <translation>Reihenfolge der Motoren, von der Kamera nach außen gezählt.</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Sonstiges</translation>
    </message>
    <message>
        <source>Outer I</source>
        <translation>Äußeres I</translation>
    </message>
    <message>
        <source>Outer P</source>
        <translation>Äußeres P</translation>
    </message>
    <message>
        <source>Outer P, pitch</source>
        <translation>Äußeres P, Pitch</translation>
    </message>
    <message>
        <source>Outer P, roll</source>
        <translation>Äußeres P, Roll</translation>
    </message>
    <message>
        <source>Outer P, yaw</source>
        <translation>Äußeres P, Yaw</translation>
    </message>
    <message>
        <source>Outer motor turns freely</source>
        <translation>Äußerer Motor dreht frei</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Overheating stops motors</source>
        <translation>Überhitzung hält Motoren an</translation>
    </message>
    <message>
        <source>Overload time</source>
        <translation>Überlastzeit</translation>
    </message>
    <message>
        <source>Overwrites a profile, or everything, with defaults.</source>
        <translation>Überschreibt ein Profil, oder alles, mit Werkseinstellungen.</translation>
    </message>
    <message>
        <source>P, pitch</source>
        <translation>P, Pitch</translation>
    </message>
    <message>
        <source>P, roll</source>
        <translation>P, Roll</translation>
    </message>
    <message>
        <source>P, yaw</source>
        <translation>P, Yaw</translation>
    </message>
    <message>
        <source>PID gain, pitch</source>
        <translation>PID-Verstärkung, Pitch</translation>
    </message>
    <message>
        <source>PID gain, roll</source>
        <translation>PID-Verstärkung, Roll</translation>
    </message>
    <message>
        <source>PID gain, yaw</source>
        <translation>PID-Verstärkung, Yaw</translation>
    </message>
    <message>
        <source>PWM frequency</source>
        <translation>PWM-Frequenz</translation>
    </message>
    <message>
        <source>Parking position</source>
        <translation>Parklage</translation>
    </message>
    <message>
        <source>Pin that repeats the status LED.</source>
        <translation>Pin, der die Status-LED wiederholt.</translation>
    </message>
    <message>
        <source>Pin that signals events to another device.</source>
        <translation>Pin, der einem anderen Gerät Ereignisse meldet.</translation>
    </message>
    <message>
        <source>Pitch (motor), roll, yaw (motor)</source>
        <translation>Pitch (Motor), Roll, Yaw (Motor)</translation>
    </message>
    <message>
        <source>Pitch +</source>
        <translation>Pitch +</translation>
    </message>
    <message>
        <source>Pitch angle from which the roll axis begins to follow.</source>
        <translation>Pitch-Winkel, ab dem die Roll-Achse zu folgen beginnt.</translation>
    </message>
    <message>
        <source>Pitch port</source>
        <translation>Pitch</translation>
    </message>
    <message>
        <source>Pitch −</source>
        <translation>Pitch −</translation>
    </message>
    <message>
        <source>Pitch, roll, yaw</source>
        <translation>Pitch, Roll, Yaw</translation>
    </message>
    <message>
        <source>Poles</source>
        <translation>Pole</translation>
    </message>
    <message>
        <source>Poles are not calibrated</source>
        <translation>Pole sind nicht kalibriert</translation>
    </message>
    <message>
        <source>Port on which this MAVLink channel works.</source>
        <translation>Anschluss, an dem dieser MAVLink-Kanal arbeitet.</translation>
    </message>
    <message>
        <source>Ports</source>
        <translation>Anschlüsse</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Power added to bring a motor back that lost its step.</source>
        <translation>Zusätzliche Leistung, um einen Motor zurückzuholen, der Schritte verlor.</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Profile (0 = active)</source>
        <translation>Profil (0 = aktives)</translation>
    </message>
    <message>
        <source>Profile of this block</source>
        <translation>Profil dieses Blocks</translation>
    </message>
    <message>
        <source>Profile options</source>
        <translation>Profiloptionen</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profile</translation>
    </message>
    <message>
        <source>Protection is active</source>
        <translation>Schutz hat angesprochen</translation>
    </message>
    <message>
        <source>Pulse rate of the servo outputs. Analog servos want 50 Hz.</source>
        <translation>Pulsrate der Servoausgänge. Analoge Servos wollen 50 Hz.</translation>
    </message>
    <message>
        <source>RC calibration</source>
        <translation>RC-Kalibrierung</translation>
    </message>
    <message>
        <source>RC calibration %1: offset</source>
        <translation>RC-Kalibrierung %1: Versatz</translation>
    </message>
    <message>
        <source>RC calibration %1: scale above zero</source>
        <translation>RC-Kalibrierung %1: Maßstab über null</translation>
    </message>
    <message>
        <source>RC calibration %1: scale below zero</source>
        <translation>RC-Kalibrierung %1: Maßstab unter null</translation>
    </message>
    <message>
        <source>RC calibration %1: source</source>
        <translation>RC-Kalibrierung %1: Quelle</translation>
    </message>
    <message>
        <source>RC channel 1</source>
        <translation>RC-Kanal 1</translation>
    </message>
    <message>
        <source>RC channel 10</source>
        <translation>RC-Kanal 10</translation>
    </message>
    <message>
        <source>RC channel 11</source>
        <translation>RC-Kanal 11</translation>
    </message>
    <message>
        <source>RC channel 12</source>
        <translation>RC-Kanal 12</translation>
    </message>
    <message>
        <source>RC channel 13</source>
        <translation>RC-Kanal 13</translation>
    </message>
    <message>
        <source>RC channel 14</source>
        <translation>RC-Kanal 14</translation>
    </message>
    <message>
        <source>RC channel 15</source>
        <translation>RC-Kanal 15</translation>
    </message>
    <message>
        <source>RC channel 16</source>
        <translation>RC-Kanal 16</translation>
    </message>
    <message>
        <source>RC channel 17</source>
        <translation>RC-Kanal 17</translation>
    </message>
    <message>
        <source>RC channel 18</source>
        <translation>RC-Kanal 18</translation>
    </message>
    <message>
        <source>RC channel 19</source>
        <translation>RC-Kanal 19</translation>
    </message>
    <message>
        <source>RC channel 2</source>
        <translation>RC-Kanal 2</translation>
    </message>
    <message>
        <source>RC channel 20</source>
        <translation>RC-Kanal 20</translation>
    </message>
    <message>
        <source>RC channel 21</source>
        <translation>RC-Kanal 21</translation>
    </message>
    <message>
        <source>RC channel 22</source>
        <translation>RC-Kanal 22</translation>
    </message>
    <message>
        <source>RC channel 23</source>
        <translation>RC-Kanal 23</translation>
    </message>
    <message>
        <source>RC channel 24</source>
        <translation>RC-Kanal 24</translation>
    </message>
    <message>
        <source>RC channel 25</source>
        <translation>RC-Kanal 25</translation>
    </message>
    <message>
        <source>RC channel 26</source>
        <translation>RC-Kanal 26</translation>
    </message>
    <message>
        <source>RC channel 27</source>
        <translation>RC-Kanal 27</translation>
    </message>
    <message>
        <source>RC channel 28</source>
        <translation>RC-Kanal 28</translation>
    </message>
    <message>
        <source>RC channel 29</source>
        <translation>RC-Kanal 29</translation>
    </message>
    <message>
        <source>RC channel 3</source>
        <translation>RC-Kanal 3</translation>
    </message>
    <message>
        <source>RC channel 30</source>
        <translation>RC-Kanal 30</translation>
    </message>
    <message>
        <source>RC channel 31</source>
        <translation>RC-Kanal 31</translation>
    </message>
    <message>
        <source>RC channel 4</source>
        <translation>RC-Kanal 4</translation>
    </message>
    <message>
        <source>RC channel 5</source>
        <translation>RC-Kanal 5</translation>
    </message>
    <message>
        <source>RC channel 6</source>
        <translation>RC-Kanal 6</translation>
    </message>
    <message>
        <source>RC channel 7</source>
        <translation>RC-Kanal 7</translation>
    </message>
    <message>
        <source>RC channel 8</source>
        <translation>RC-Kanal 8</translation>
    </message>
    <message>
        <source>RC channel 9</source>
        <translation>RC-Kanal 9</translation>
    </message>
    <message>
        <source>RC channels</source>
        <translation>RC-Kanäle</translation>
    </message>
    <message>
        <source>RC command high</source>
        <translation>RC-Befehl hoch</translation>
    </message>
    <message>
        <source>RC command low</source>
        <translation>RC-Befehl niedrig</translation>
    </message>
    <message>
        <source>RC command middle</source>
        <translation>RC-Befehl Mitte</translation>
    </message>
    <message>
        <source>RC dead band</source>
        <translation>RC-Totbereich</translation>
    </message>
    <message>
        <source>RC dead band, pitch</source>
        <translation>RC-Totbereich, Pitch</translation>
    </message>
    <message>
        <source>RC dead band, yaw</source>
        <translation>RC-Totbereich, Yaw</translation>
    </message>
    <message>
        <source>RC exponential curve</source>
        <translation>RC-Exponentialkurve</translation>
    </message>
    <message>
        <source>RC exponential curve, pitch</source>
        <translation>RC-Exponentialkurve, Pitch</translation>
    </message>
    <message>
        <source>RC exponential curve, yaw</source>
        <translation>RC-Exponentialkurve, Yaw</translation>
    </message>
    <message>
        <source>RC input, command</source>
        <translation>RC-Eingang, Befehl</translation>
    </message>
    <message>
        <source>RC input, pitch</source>
        <translation>RC-Eingang, Pitch</translation>
    </message>
    <message>
        <source>RC input, roll</source>
        <translation>RC-Eingang, Roll</translation>
    </message>
    <message>
        <source>RC input, yaw</source>
        <translation>RC-Eingang, Yaw</translation>
    </message>
    <message>
        <source>RC keeps mix rate</source>
        <translation>RC behält Mischanteil</translation>
    </message>
    <message>
        <source>RC keeps position at start</source>
        <translation>RC behält Lage beim Start</translation>
    </message>
    <message>
        <source>RC limit, pitch, lower</source>
        <translation>RC-Grenze, Pitch, unten</translation>
    </message>
    <message>
        <source>RC limit, pitch, upper</source>
        <translation>RC-Grenze, Pitch, oben</translation>
    </message>
    <message>
        <source>RC limit, roll, lower</source>
        <translation>RC-Grenze, Roll, unten</translation>
    </message>
    <message>
        <source>RC limit, roll, upper</source>
        <translation>RC-Grenze, Roll, oben</translation>
    </message>
    <message>
        <source>RC limit, yaw, lower</source>
        <translation>RC-Grenze, Yaw, unten</translation>
    </message>
    <message>
        <source>RC limit, yaw, upper</source>
        <translation>RC-Grenze, Yaw, oben</translation>
    </message>
    <message>
        <source>RC low-pass, pitch</source>
        <translation>RC-Tiefpass, Pitch</translation>
    </message>
    <message>
        <source>RC low-pass, roll</source>
        <translation>RC-Tiefpass, Roll</translation>
    </message>
    <message>
        <source>RC low-pass, yaw</source>
        <translation>RC-Tiefpass, Yaw</translation>
    </message>
    <message>
        <source>RC mode, pitch</source>
        <translation>RC-Modus, Pitch</translation>
    </message>
    <message>
        <source>RC mode, roll</source>
        <translation>RC-Modus, Roll</translation>
    </message>
    <message>
        <source>RC mode, yaw</source>
        <translation>RC-Modus, Yaw</translation>
    </message>
    <message>
        <source>RC serial</source>
        <translation>RC seriell</translation>
    </message>
    <message>
        <source>RC serial speed</source>
        <translation>Rate RC seriell</translation>
    </message>
    <message>
        <source>RC signal, FC pitch</source>
        <translation>RC-Signal, FC-Pitch</translation>
    </message>
    <message>
        <source>RC signal, FC roll</source>
        <translation>RC-Signal, FC-Roll</translation>
    </message>
    <message>
        <source>RC signal, command</source>
        <translation>RC-Signal, Befehl</translation>
    </message>
    <message>
        <source>RC signal, pitch</source>
        <translation>RC-Signal, Pitch</translation>
    </message>
    <message>
        <source>RC signal, roll</source>
        <translation>RC-Signal, Roll</translation>
    </message>
    <message>
        <source>RC signal, yaw</source>
        <translation>RC-Signal, Yaw</translation>
    </message>
    <message>
        <source>RC speed, pitch</source>
        <translation>RC-Geschwindigkeit, Pitch</translation>
    </message>
    <message>
        <source>RC speed, roll</source>
        <translation>RC-Geschwindigkeit, Roll</translation>
    </message>
    <message>
        <source>RC speed, yaw</source>
        <translation>RC-Geschwindigkeit, Yaw</translation>
    </message>
    <message>
        <source>RC trim, pitch</source>
        <translation>RC-Trimmung, Pitch</translation>
    </message>
    <message>
        <source>RC trim, roll</source>
        <translation>RC-Trimmung, Roll</translation>
    </message>
    <message>
        <source>RC trim, yaw</source>
        <translation>RC-Trimmung, Yaw</translation>
    </message>
    <message>
        <source>RLS Orbis</source>
        <translation>RLS Orbis</translation>
    </message>
    <message>
        <source>RLS Orbis PWM</source>
        <translation>RLS Orbis PWM</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Raster of positions the axis snaps to.</source>
        <translation>Raster der Lagen, in die die Achse einrastet.</translation>
    </message>
    <message>
        <source>Rate inside the dead band</source>
        <translation>Anteil im Totbereich</translation>
    </message>
    <message>
        <source>Rate of the RC serial port after the next restart.</source>
        <translation>Rate des RC-Anschlusses nach dem nächsten Neustart.</translation>
    </message>
    <message>
        <source>Rate of the first UART after the next restart. The USB port is not affected.</source>
        <translation>Rate des ersten UART nach dem nächsten Neustart. Den USB-Anschluss kümmert das nicht.</translation>
    </message>
    <message>
        <source>Rate of the second UART after the next restart.</source>
        <translation>Rate des zweiten UART nach dem nächsten Neustart.</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Read adjustable variables</source>
        <translation>Live-Variablen lesen</translation>
    </message>
    <message>
        <source>Read angles</source>
        <translation>Winkel lesen</translation>
    </message>
    <message>
        <source>Read debug variables</source>
        <translation>Debug-Variablen lesen</translation>
    </message>
    <message>
        <source>Release control at the end</source>
        <translation>Steuerung am Ende abgeben</translation>
    </message>
    <message>
        <source>Remember last profile</source>
        <translation>Letztes Profil merken</translation>
    </message>
    <message>
        <source>Remote control</source>
        <translation>Fernsteuerung</translation>
    </message>
    <message>
        <source>Remote control axis that the flight controller signal is added to.</source>
        <translation>Achse der Fernsteuerung, zu der das Flugreglersignal addiert wird.</translation>
    </message>
    <message>
        <source>Remote control turns about the camera&apos;s own axes.</source>
        <translation>Fernsteuerung dreht um die Achsen der Kamera.</translation>
    </message>
    <message>
        <source>Remove the cause, then restart the board.</source>
        <translation>Beheben Sie die Ursache, dann starten Sie das Board neu.</translation>
    </message>
    <message>
        <source>Removes what remains of an error over time. Too much sways slowly.</source>
        <translation>Beseitigt, was von einem Fehler auf Dauer bleibt. Zu viel schwankt langsam.</translation>
    </message>
    <message>
        <source>Repeat time-lapse</source>
        <translation>Zeitraffer wiederholen</translation>
    </message>
    <message>
        <source>Replaced by the fine magnetic link.</source>
        <translation>Ersetzt durch die feine magnetische Kopplung.</translation>
    </message>
    <message>
        <source>Report progress</source>
        <translation>Fortschritt melden</translation>
    </message>
    <message>
        <source>Reset IMU</source>
        <translation>IMU zurücksetzen</translation>
    </message>
    <message>
        <source>Reset board</source>
        <translation>Board zurücksetzen</translation>
    </message>
    <message>
        <source>Resistance of the motor&apos;s windings, for the current estimate.</source>
        <translation>Widerstand der Motorwicklungen, für die Stromschätzung.</translation>
    </message>
    <message>
        <source>Restart after emergency stop</source>
        <translation>Neustart nach Not-Halt</translation>
    </message>
    <message>
        <source>Restart board</source>
        <translation>Board neu starten</translation>
    </message>
    <message>
        <source>Restart the board.</source>
        <translation>Starten Sie das Board neu.</translation>
    </message>
    <message>
        <source>Retracted position</source>
        <translation>Eingezogene Lage</translation>
    </message>
    <message>
        <source>Roll +</source>
        <translation>Roll +</translation>
    </message>
    <message>
        <source>Roll and pitch</source>
        <translation>Roll und Pitch</translation>
    </message>
    <message>
        <source>Roll and pitch: how much the flight controller&apos;s angle is followed. Yaw: not 0 = follow the frame.</source>
        <translation>Roll und Pitch: wie viel dem Winkel des Flugreglers gefolgt wird. Yaw: nicht 0 = dem Rahmen folgen.</translation>
    </message>
    <message>
        <source>Roll mix range</source>
        <translation>Bereich der Roll-Mischung</translation>
    </message>
    <message>
        <source>Roll mix start</source>
        <translation>Beginn der Roll-Mischung</translation>
    </message>
    <message>
        <source>Roll port</source>
        <translation>Roll</translation>
    </message>
    <message>
        <source>Roll −</source>
        <translation>Roll −</translation>
    </message>
    <message>
        <source>Roll, pitch (motor), yaw (motor)</source>
        <translation>Roll, Pitch (Motor), Yaw (Motor)</translation>
    </message>
    <message>
        <source>Roll, pitch, yaw</source>
        <translation>Roll, Pitch, Yaw</translation>
    </message>
    <message>
        <source>Roll, yaw, pitch</source>
        <translation>Roll, Yaw, Pitch</translation>
    </message>
    <message>
        <source>Rotate when upside-down</source>
        <translation>Kopfüber drehen</translation>
    </message>
    <message>
        <source>Rotate yaw 180 deg</source>
        <translation>Yaw um 180 Grad drehen</translation>
    </message>
    <message>
        <source>Rotate yaw 180 deg, relative to frame</source>
        <translation>Yaw um 180 Grad drehen, gegen den Rahmen</translation>
    </message>
    <message>
        <source>Rotation below this is taken for noise, in gyro units.</source>
        <translation>Drehung darunter gilt als Rauschen, in Einheiten des Gyroskops.</translation>
    </message>
    <message>
        <source>Run script 1</source>
        <translation>Skript ausführen: 1</translation>
    </message>
    <message>
        <source>Run script 10</source>
        <translation>Skript ausführen: 10</translation>
    </message>
    <message>
        <source>Run script 2</source>
        <translation>Skript ausführen: 2</translation>
    </message>
    <message>
        <source>Run script 3</source>
        <translation>Skript ausführen: 3</translation>
    </message>
    <message>
        <source>Run script 4</source>
        <translation>Skript ausführen: 4</translation>
    </message>
    <message>
        <source>Run script 5</source>
        <translation>Skript ausführen: 5</translation>
    </message>
    <message>
        <source>Run script 6</source>
        <translation>Skript ausführen: 6</translation>
    </message>
    <message>
        <source>Run script 7</source>
        <translation>Skript ausführen: 7</translation>
    </message>
    <message>
        <source>Run script 8</source>
        <translation>Skript ausführen: 8</translation>
    </message>
    <message>
        <source>Run script 9</source>
        <translation>Skript ausführen: 9</translation>
    </message>
    <message>
        <source>Run the accelerometer calibration.</source>
        <translation>Kalibrieren Sie den Beschleunigungssensor.</translation>
    </message>
    <message>
        <source>Runs a command of the board&apos;s menu.</source>
        <translation>Führt einen Befehl des Board-Menüs aus.</translation>
    </message>
    <message>
        <source>S-bus</source>
        <translation>S-bus</translation>
    </message>
    <message>
        <source>Save backup automatically</source>
        <translation>Sicherung automatisch speichern</translation>
    </message>
    <message>
        <source>Save statistics</source>
        <translation>Statistik speichern</translation>
    </message>
    <message>
        <source>Search limits of pitch</source>
        <translation>Grenzen von Pitch suchen</translation>
    </message>
    <message>
        <source>Search limits of roll</source>
        <translation>Grenzen von Roll suchen</translation>
    </message>
    <message>
        <source>Search limits of yaw</source>
        <translation>Grenzen von Yaw suchen</translation>
    </message>
    <message>
        <source>Second signal that the start-up action depends on.</source>
        <translation>Zweites Signal, von dem die Startaktion abhängt.</translation>
    </message>
    <message>
        <source>Selected IMU</source>
        <translation>Gewählte IMU</translation>
    </message>
    <message>
        <source>Send debug data</source>
        <translation>Debug-Daten senden</translation>
    </message>
    <message>
        <source>Send heartbeat</source>
        <translation>Heartbeat senden</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Sensor mounting correction</source>
        <translation>Korrektur des Sensoreinbaus</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>Serial API</source>
        <translation>Serielle API</translation>
    </message>
    <message>
        <source>Serial error</source>
        <translation>Serieller Fehler</translation>
    </message>
    <message>
        <source>Serial speed</source>
        <translation>Serielle Rate</translation>
    </message>
    <message>
        <source>Service</source>
        <translation>Wartung</translation>
    </message>
    <message>
        <source>Servo mode off</source>
        <translation>Servomodus aus</translation>
    </message>
    <message>
        <source>Servo mode on</source>
        <translation>Servomodus ein</translation>
    </message>
    <message>
        <source>Servo mode on/off</source>
        <translation>Servomodus ein/aus</translation>
    </message>
    <message>
        <source>Servo output %1: source</source>
        <translation>Servoausgang %1: Quelle</translation>
    </message>
    <message>
        <source>Servo rate</source>
        <translation>Servorate</translation>
    </message>
    <message>
        <source>Set RC trim</source>
        <translation>RC-Trimmung setzen</translation>
    </message>
    <message>
        <source>Set adjustable variable</source>
        <translation>Live-Variable setzen</translation>
    </message>
    <message>
        <source>Set poles and direction of each motor.</source>
        <translation>Setzen Sie Pole und Richtung jedes Motors.</translation>
    </message>
    <message>
        <source>Set the power of each motor on the Parameters page.</source>
        <translation>Setzen Sie die Leistung jedes Motors auf der Seite „Parameter“.</translation>
    </message>
    <message>
        <source>Set tilt angles by hand</source>
        <translation>Neigung von Hand setzen</translation>
    </message>
    <message>
        <source>Set tilt angles by hand, do not save</source>
        <translation>Neigung von Hand setzen, nicht speichern</translation>
    </message>
    <message>
        <source>Set-by-hand time</source>
        <translation>Zeit für Setzen von Hand</translation>
    </message>
    <message>
        <source>Shake amplitude, pitch</source>
        <translation>Rüttelstärke, Pitch</translation>
    </message>
    <message>
        <source>Shake amplitude, roll</source>
        <translation>Rüttelstärke, Roll</translation>
    </message>
    <message>
        <source>Shake amplitude, yaw</source>
        <translation>Rüttelstärke, Yaw</translation>
    </message>
    <message>
        <source>Shake frequency</source>
        <translation>Rüttelfrequenz</translation>
    </message>
    <message>
        <source>Shake frequency range</source>
        <translation>Bereich der Rüttelfrequenz</translation>
    </message>
    <message>
        <source>Shake frequency shift, pitch</source>
        <translation>Verschiebung der Rüttelfrequenz, Pitch</translation>
    </message>
    <message>
        <source>Shake frequency shift, roll</source>
        <translation>Verschiebung der Rüttelfrequenz, Roll</translation>
    </message>
    <message>
        <source>Shake frequency shift, yaw</source>
        <translation>Verschiebung der Rüttelfrequenz, Yaw</translation>
    </message>
    <message>
        <source>Shake generator</source>
        <translation>Rüttelgenerator</translation>
    </message>
    <message>
        <source>Shake generator off</source>
        <translation>Rüttelgenerator aus</translation>
    </message>
    <message>
        <source>Shake generator on</source>
        <translation>Rüttelgenerator ein</translation>
    </message>
    <message>
        <source>Shake master gain</source>
        <translation>Gesamtstärke des Rüttelns</translation>
    </message>
    <message>
        <source>Shake pause (ms)</source>
        <translation>Rüttelpause (ms)</translation>
    </message>
    <message>
        <source>Shake pause balance</source>
        <translation>Balance der Rüttelpausen</translation>
    </message>
    <message>
        <source>Shake pause randomness</source>
        <translation>Zufall der Rüttelpausen</translation>
    </message>
    <message>
        <source>Shake resonance gain, pitch</source>
        <translation>Rüttelresonanz, Pitch</translation>
    </message>
    <message>
        <source>Shake resonance gain, roll</source>
        <translation>Rüttelresonanz, Roll</translation>
    </message>
    <message>
        <source>Shake resonance gain, yaw</source>
        <translation>Rüttelresonanz, Yaw</translation>
    </message>
    <message>
        <source>Share of the flight controller signal added to a remote control axis; 63 = all of it.</source>
        <translation>Anteil des Flugreglersignals, der zu einer Fernsteuerachse kommt; 63 = alles.</translation>
    </message>
    <message>
        <source>Share of the move spent speeding up and slowing down.</source>
        <translation>Anteil der Bewegung für Anfahren und Bremsen.</translation>
    </message>
    <message>
        <source>Share of the supply voltage a motor may get. Too little loses steps, too much overheats the motor.</source>
        <translation>Anteil der Versorgungsspannung, den ein Motor bekommt. Zu wenig verliert Schritte, zu viel überhitzt den Motor.</translation>
    </message>
    <message>
        <source>Signal level of the condition, in tenths of the RC range.</source>
        <translation>Signalpegel der Bedingung, in Zehnteln des RC-Bereichs.</translation>
    </message>
    <message>
        <source>Signal level of the second condition.</source>
        <translation>Signalpegel der zweiten Bedingung.</translation>
    </message>
    <message>
        <source>Signal on RC_ROLL</source>
        <translation>Signal an RC_ROLL</translation>
    </message>
    <message>
        <source>Signal that the start-up action depends on.</source>
        <translation>Signal, von dem die Startaktion abhängt.</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Skip detection</source>
        <translation>Erkennung überspringen</translation>
    </message>
    <message>
        <source>Skip when moving</source>
        <translation>Überspringen, wenn bewegt</translation>
    </message>
    <message>
        <source>Small correction for a sensor that is not mounted quite straight.</source>
        <translation>Kleine Korrektur für einen Sensor, der nicht ganz gerade sitzt.</translation>
    </message>
    <message>
        <source>Smooth gimbal-lock transition</source>
        <translation>Sanfter Übergang bei Gimbal-Lock</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Smooths the D term alone; 0 = off. Lower lets D be higher before noise is heard.</source>
        <translation>Glättet nur den D-Anteil; 0 = aus. Niedriger erlaubt mehr D, bevor es rauscht.</translation>
    </message>
    <message>
        <source>Smooths the accelerometer against vibration and accelerated motion; 0 = off.</source>
        <translation>Glättet den Beschleunigungssensor gegen Vibration und beschleunigte Bewegung; 0 = aus.</translation>
    </message>
    <message>
        <source>Smooths the frame sensor.</source>
        <translation>Glättet den Rahmensensor.</translation>
    </message>
    <message>
        <source>Snap angle</source>
        <translation>Rastwinkel</translation>
    </message>
    <message>
        <source>Snap options</source>
        <translation>Rastoptionen</translation>
    </message>
    <message>
        <source>Snap to fixed position</source>
        <translation>In feste Lage einrasten</translation>
    </message>
    <message>
        <source>Snap, further bit</source>
        <translation>Rasten, weiteres Bit</translation>
    </message>
    <message>
        <source>Softens the start and end of commanded motion.</source>
        <translation>Macht Anfang und Ende befohlener Bewegung weich.</translation>
    </message>
    <message>
        <source>Software limit width, pitch</source>
        <translation>Breite der Softwaregrenze, Pitch</translation>
    </message>
    <message>
        <source>Software limit width, roll</source>
        <translation>Breite der Softwaregrenze, Roll</translation>
    </message>
    <message>
        <source>Software limit width, yaw</source>
        <translation>Breite der Softwaregrenze, Yaw</translation>
    </message>
    <message>
        <source>Software limit, pitch, lower</source>
        <translation>Softwaregrenze, Pitch, unten</translation>
    </message>
    <message>
        <source>Software limit, pitch, upper</source>
        <translation>Softwaregrenze, Pitch, oben</translation>
    </message>
    <message>
        <source>Software limit, roll, lower</source>
        <translation>Softwaregrenze, Roll, unten</translation>
    </message>
    <message>
        <source>Software limit, roll, upper</source>
        <translation>Softwaregrenze, Roll, oben</translation>
    </message>
    <message>
        <source>Software limit, yaw, lower</source>
        <translation>Softwaregrenze, Yaw, unten</translation>
    </message>
    <message>
        <source>Software limit, yaw, upper</source>
        <translation>Softwaregrenze, Yaw, oben</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Sound by the motors</source>
        <translation>Ton durch die Motoren</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Source of commands</source>
        <translation>Quelle der Befehle</translation>
    </message>
    <message>
        <source>Source of the flight controller signal</source>
        <translation>Quelle des Flugreglersignals</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Speed and angle</source>
        <translation>Geschwindigkeit und Winkel</translation>
    </message>
    <message>
        <source>Speed of motion at full stick, and the default speed of commanded moves.</source>
        <translation>Geschwindigkeit bei vollem Knüppel und übliche Geschwindigkeit befohlener Bewegungen.</translation>
    </message>
    <message>
        <source>Speed of moves the board makes by itself, such as going home.</source>
        <translation>Geschwindigkeit von Bewegungen, die das Board selbst macht, etwa zur Grundstellung.</translation>
    </message>
    <message>
        <source>Spektrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Spektrum mode</source>
        <translation>Spektrum-Modus</translation>
    </message>
    <message>
        <source>Spektrum power</source>
        <translation>Spektrum-Stromversorgung</translation>
    </message>
    <message>
        <source>Stabilization</source>
        <translation>Stabilisierung</translation>
    </message>
    <message>
        <source>Stabilization works about the camera&apos;s own axes.</source>
        <translation>Stabilisierung wirkt um die Achsen der Kamera.</translation>
    </message>
    <message>
        <source>Stabilize in camera axes</source>
        <translation>In Kameraachsen stabilisieren</translation>
    </message>
    <message>
        <source>Stabilized axis</source>
        <translation>Stabilisierte Achse</translation>
    </message>
    <message>
        <source>Stabilized axis, automatic</source>
        <translation>Stabilisierte Achse, automatisch</translation>
    </message>
    <message>
        <source>Standard sound or melody; helps to find the right board.</source>
        <translation>Standardton oder Melodie; hilft, das richtige Board zu finden.</translation>
    </message>
    <message>
        <source>Start from current gains</source>
        <translation>Von jetzigen Werten ausgehen</translation>
    </message>
    <message>
        <source>Start in neutral position</source>
        <translation>In Neutrallage starten</translation>
    </message>
    <message>
        <source>Start time-lapse</source>
        <translation>Zeitraffer starten</translation>
    </message>
    <message>
        <source>Start-up</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Start-up action %1</source>
        <translation>Startaktion %1</translation>
    </message>
    <message>
        <source>Start-up condition A%1: source</source>
        <translation>Startbedingung A%1: Quelle</translation>
    </message>
    <message>
        <source>Start-up condition A%1: threshold</source>
        <translation>Startbedingung A%1: Schwelle</translation>
    </message>
    <message>
        <source>Start-up condition B%1: source</source>
        <translation>Startbedingung B%1: Quelle</translation>
    </message>
    <message>
        <source>Start-up condition B%1: threshold</source>
        <translation>Startbedingung B%1: Schwelle</translation>
    </message>
    <message>
        <source>Starts stabilization.</source>
        <translation>Beginnt die Stabilisierung.</translation>
    </message>
    <message>
        <source>Steer</source>
        <translation>Lenken</translation>
    </message>
    <message>
        <source>Step signal %1: further bit</source>
        <translation>Schrittsignal %1: weiteres Bit</translation>
    </message>
    <message>
        <source>Step signal %1: needs button</source>
        <translation>Schrittsignal %1: braucht Taste</translation>
    </message>
    <message>
        <source>Step signal %1: source</source>
        <translation>Schrittsignal %1: Quelle</translation>
    </message>
    <message>
        <source>Step signal %1: start at zero</source>
        <translation>Schrittsignal %1: beginnt bei null</translation>
    </message>
    <message>
        <source>Step signal %1: steps</source>
        <translation>Schrittsignal %1: Schritte</translation>
    </message>
    <message>
        <source>Step signal %1: trigger</source>
        <translation>Schrittsignal %1: Auslöser</translation>
    </message>
    <message>
        <source>Step signal 1</source>
        <translation>Schrittsignal 1</translation>
    </message>
    <message>
        <source>Step signal 2</source>
        <translation>Schrittsignal 2</translation>
    </message>
    <message>
        <source>Step signal 3</source>
        <translation>Schrittsignal 3</translation>
    </message>
    <message>
        <source>Step signal 4</source>
        <translation>Schrittsignal 4</translation>
    </message>
    <message>
        <source>Step signal 5</source>
        <translation>Schrittsignal 5</translation>
    </message>
    <message>
        <source>Step signal 6</source>
        <translation>Schrittsignal 6</translation>
    </message>
    <message>
        <source>Step signals</source>
        <translation>Schrittsignale</translation>
    </message>
    <message>
        <source>Steps only while the menu button is held.</source>
        <translation>Schritte nur, solange die Menütaste gehalten wird.</translation>
    </message>
    <message>
        <source>Stick movement around the middle that is ignored.</source>
        <translation>Knüppelbewegung um die Mitte, die nicht zählt.</translation>
    </message>
    <message>
        <source>Stiffness of the motor&apos;s magnetic field as measured by calibration.</source>
        <translation>Steifigkeit des Motorfelds, wie die Kalibrierung sie maß.</translation>
    </message>
    <message>
        <source>Stop script</source>
        <translation>Skript anhalten</translation>
    </message>
    <message>
        <source>Stores the live values in the active profile.</source>
        <translation>Speichert die Werte in Gebrauch im aktiven Profil.</translation>
    </message>
    <message>
        <source>Strength of the motion used to measure the momentum.</source>
        <translation>Stärke der Bewegung, mit der die Trägheit gemessen wird.</translation>
    </message>
    <message>
        <source>Strength of the response to an angle error. Too little is soft, too much vibrates.</source>
        <translation>Stärke der Antwort auf einen Winkelfehler. Zu wenig ist weich, zu viel vibriert.</translation>
    </message>
    <message>
        <source>Stretches the lower half of the signal.</source>
        <translation>Streckt die untere Hälfte des Signals.</translation>
    </message>
    <message>
        <source>Stretches the upper half of the signal.</source>
        <translation>Streckt die obere Hälfte des Signals.</translation>
    </message>
    <message>
        <source>Swap RC pitch and roll</source>
        <translation>RC-Pitch und -Roll tauschen</translation>
    </message>
    <message>
        <source>Swap RC serial and UART2</source>
        <translation>RC seriell und UART2 tauschen</translation>
    </message>
    <message>
        <source>Swap RC yaw and roll</source>
        <translation>RC-Yaw und -Roll tauschen</translation>
    </message>
    <message>
        <source>Swap frame and main IMU</source>
        <translation>Rahmen- und Haupt-IMU tauschen</translation>
    </message>
    <message>
        <source>Switch roll 90 deg</source>
        <translation>Roll um 90 Grad wechseln</translation>
    </message>
    <message>
        <source>Switch yaw 180 deg, relative to frame</source>
        <translation>Yaw um 180 Grad wechseln, gegen den Rahmen</translation>
    </message>
    <message>
        <source>Switches all motors off at once.</source>
        <translation>Schaltet alle Motoren sofort aus.</translation>
    </message>
    <message>
        <source>Switches the controller&apos;s own I2C pull-up resistors on; helps on long sensor cables.</source>
        <translation>Schaltet die I2C-Pull-ups des Controllers ein; hilft bei langen Sensorkabeln.</translation>
    </message>
    <message>
        <source>Switching frequency of the motor drivers. Low is efficient and audible.</source>
        <translation>Schaltfrequenz der Motortreiber. Niedrig ist sparsam und hörbar.</translation>
    </message>
    <message>
        <source>System ID of the gimbal.</source>
        <translation>System-ID des Gimbals.</translation>
    </message>
    <message>
        <source>System error</source>
        <translation>Systemfehler</translation>
    </message>
    <message>
        <source>System error bits</source>
        <translation>Systemfehlerbits</translation>
    </message>
    <message>
        <source>Take position as home</source>
        <translation>Lage als Grundstellung nehmen</translation>
    </message>
    <message>
        <source>Takes the present position as the neutral point of following.</source>
        <translation>Nimmt die jetzige Lage als Neutralpunkt des Folgens.</translation>
    </message>
    <message>
        <source>Target angle, pitch</source>
        <translation>Zielwinkel, Pitch</translation>
    </message>
    <message>
        <source>Target angle, roll</source>
        <translation>Zielwinkel, Roll</translation>
    </message>
    <message>
        <source>Target angle, yaw</source>
        <translation>Zielwinkel, Yaw</translation>
    </message>
    <message>
        <source>Target speed, pitch</source>
        <translation>Zielgeschwindigkeit, Pitch</translation>
    </message>
    <message>
        <source>Target speed, roll</source>
        <translation>Zielgeschwindigkeit, Roll</translation>
    </message>
    <message>
        <source>Target speed, yaw</source>
        <translation>Zielgeschwindigkeit, Yaw</translation>
    </message>
    <message>
        <source>Tells the board the true battery voltage.</source>
        <translation>Sagt dem Board die wahre Akkuspannung.</translation>
    </message>
    <message>
        <source>The board does not see its motion sensor, so it cannot stabilize.</source>
        <translation>Das Board sieht seinen Bewegungssensor nicht und kann nicht stabilisieren.</translation>
    </message>
    <message>
        <source>The board expects another version of its configuration tool.</source>
        <translation>Das Board erwartet eine andere Version seines Werkzeugs.</translation>
    </message>
    <message>
        <source>The board received damaged commands.</source>
        <translation>Das Board hat beschädigte Befehle empfangen.</translation>
    </message>
    <message>
        <source>The board searches gains by moving the camera.</source>
        <translation>Das Board sucht Verstärkungen, indem es die Kamera bewegt.</translation>
    </message>
    <message>
        <source>The encoder turns faster or slower than the axis.</source>
        <translation>Der Geber dreht schneller oder langsamer als die Achse.</translation>
    </message>
    <message>
        <source>The firmware found a fault in itself.</source>
        <translation>Die Firmware fand einen Fehler in sich.</translation>
    </message>
    <message>
        <source>The horizon will be tilted.</source>
        <translation>Der Horizont wird schief sein.</translation>
    </message>
    <message>
        <source>The motors have no power and the camera hangs free.</source>
        <translation>Die Motoren haben keine Kraft, und die Kamera hängt frei.</translation>
    </message>
    <message>
        <source>The motors may turn the wrong way.</source>
        <translation>Die Motoren drehen vielleicht falsch herum.</translation>
    </message>
    <message>
        <source>The profile in use when the block was read, counted from 0.</source>
        <translation>Das Profil, das beim Lesen in Gebrauch war, von 0 gezählt.</translation>
    </message>
    <message>
        <source>The profile this block of values belongs to.</source>
        <translation>Das Profil, zu dem dieser Block gehört.</translation>
    </message>
    <message>
        <source>The sensor that calibration works on.</source>
        <translation>Der Sensor, den die Kalibrierung betrifft.</translation>
    </message>
    <message>
        <source>The signal is zero after power-up.</source>
        <translation>Das Signal ist nach dem Einschalten null.</translation>
    </message>
    <message>
        <source>Tilt of the middle motor</source>
        <translation>Neigung des mittleren Motors</translation>
    </message>
    <message>
        <source>Tilt of the outer motor</source>
        <translation>Neigung des äußeren Motors</translation>
    </message>
    <message>
        <source>Time at full power after which motors are switched off; 0 = never.</source>
        <translation>Zeit bei voller Leistung, nach der Motoren ausgehen; 0 = nie.</translation>
    </message>
    <message>
        <source>Time until the board restarts by itself; 0 = stays off.</source>
        <translation>Zeit, bis das Board von selbst neu startet; 0 = bleibt aus.</translation>
    </message>
    <message>
        <source>Time-lapse acceleration part</source>
        <translation>Beschleunigungsteil des Zeitraffers</translation>
    </message>
    <message>
        <source>Time-lapse duration</source>
        <translation>Dauer des Zeitraffers</translation>
    </message>
    <message>
        <source>Time-lapse keeps frame heading</source>
        <translation>Zeitraffer behält den Rahmenkurs</translation>
    </message>
    <message>
        <source>Time-lapse step 1</source>
        <translation>Zeitraffer Schritt 1</translation>
    </message>
    <message>
        <source>Time-lapse time (s)</source>
        <translation>Zeitrafferzeit (s)</translation>
    </message>
    <message>
        <source>Trim</source>
        <translation>Trimmung</translation>
    </message>
    <message>
        <source>Tripod mode off</source>
        <translation>Stativmodus aus</translation>
    </message>
    <message>
        <source>Tripod mode on</source>
        <translation>Stativmodus ein</translation>
    </message>
    <message>
        <source>Tune the low-pass filter</source>
        <translation>Tiefpass mit abstimmen</translation>
    </message>
    <message>
        <source>Turns of the encoder per turn of the motor.</source>
        <translation>Umdrehungen des Gebers je Umdrehung des Motors.</translation>
    </message>
    <message>
        <source>Turns of the motor per turn of the axis; 1 = direct drive.</source>
        <translation>Umdrehungen des Motors je Umdrehung der Achse; 1 = Direktantrieb.</translation>
    </message>
    <message>
        <source>Reverses the direction of this remote control axis.</source>
        <translation>Kehrt die Richtung dieser Fernsteuerachse um.</translation>
    </message>
    <message>
        <source>Turns the motor the other way. If it is wrong, the camera runs away from its target as soon as motors start.</source>
        <translation>Dreht den Motor andersherum. Falsch läuft die Kamera von ihrem Ziel weg, sobald Motoren anlaufen.</translation>
    </message>
    <message>
        <source>UART2 speaks the serial API</source>
        <translation>UART2 spricht die serielle API</translation>
    </message>
    <message>
        <source>UART2 speed</source>
        <translation>Rate UART2</translation>
    </message>
    <message>
        <source>UART3 speaks the serial API</source>
        <translation>UART3 spricht die serielle API</translation>
    </message>
    <message>
        <source>Ultra high</source>
        <translation>Sehr hoch</translation>
    </message>
    <message>
        <source>Untwist cables</source>
        <translation>Kabel entwirren</translation>
    </message>
    <message>
        <source>Upper end of the range that remote control can reach.</source>
        <translation>Oberes Ende des Bereichs, den die Fernsteuerung erreicht.</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Obere Grenze</translation>
    </message>
    <message>
        <source>Use motion model</source>
        <translation>Bewegungsmodell benutzen</translation>
    </message>
    <message>
        <source>Use profile</source>
        <translation>Profil benutzen</translation>
    </message>
    <message>
        <source>Use profile 1</source>
        <translation>Profil benutzen: 1</translation>
    </message>
    <message>
        <source>Use profile 2</source>
        <translation>Profil benutzen: 2</translation>
    </message>
    <message>
        <source>Use profile 3</source>
        <translation>Profil benutzen: 3</translation>
    </message>
    <message>
        <source>Use profile 4</source>
        <translation>Profil benutzen: 4</translation>
    </message>
    <message>
        <source>Use profile 5</source>
        <translation>Profil benutzen: 5</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Values of the board&apos;s inner variables.</source>
        <translation>Werte der inneren Variablen des Boards.</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variablen</translation>
    </message>
    <message>
        <source>Vibration level at which gains are lowered.</source>
        <translation>Vibration, bei der Verstärkungen gesenkt werden.</translation>
    </message>
    <message>
        <source>Voltage of the full battery: power is raised as it falls; negative = off.</source>
        <translation>Spannung des vollen Akkus: die Leistung steigt, wenn sie fällt; negativ = aus.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>What kind of signal the RC_ROLL pin carries.</source>
        <translation>Welche Art Signal der Pin RC_ROLL führt.</translation>
    </message>
    <message>
        <source>What the camera follows in pitch and roll.</source>
        <translation>Wem die Kamera in Pitch und Roll folgt.</translation>
    </message>
    <message>
        <source>When and how the axis snaps.</source>
        <translation>Wann und wie die Achse einrastet.</translation>
    </message>
    <message>
        <source>Where the second sensor is mounted.</source>
        <translation>Wo der zweite Sensor sitzt.</translation>
    </message>
    <message>
        <source>Whether the gyroscope is calibrated each time the board starts; it must then stand still.</source>
        <translation>Ob das Gyroskop bei jedem Start kalibriert wird; dann muss es still stehen.</translation>
    </message>
    <message>
        <source>Which axis of the frame sensor points right.</source>
        <translation>Welche Achse des Rahmensensors nach rechts zeigt.</translation>
    </message>
    <message>
        <source>Which axis of the frame sensor points up.</source>
        <translation>Welche Achse des Rahmensensors nach oben zeigt.</translation>
    </message>
    <message>
        <source>Which axis of the magnetometer points right.</source>
        <translation>Welche Achse des Magnetometers nach rechts zeigt.</translation>
    </message>
    <message>
        <source>Which axis of the magnetometer points up.</source>
        <translation>Welche Achse des Magnetometers nach oben zeigt.</translation>
    </message>
    <message>
        <source>Which axis printed on the sensor board points right, seen from behind the camera.</source>
        <translation>Welche auf dem Sensor gedruckte Achse nach rechts zeigt, von hinter der Kamera gesehen.</translation>
    </message>
    <message>
        <source>Which axis printed on the sensor board points up. If it is wrong, the camera turns over.</source>
        <translation>Welche auf dem Sensor gedruckte Achse nach oben zeigt. Falsch kippt die Kamera um.</translation>
    </message>
    <message>
        <source>Which of the filters of this axis work.</source>
        <translation>Welche Filter dieser Achse arbeiten.</translation>
    </message>
    <message>
        <source>Width of the band at -3 dB.</source>
        <translation>Breite des Bandes bei -3 dB.</translation>
    </message>
    <message>
        <source>Winding resistance</source>
        <translation>Wicklungswiderstand</translation>
    </message>
    <message>
        <source>Yaw +</source>
        <translation>Yaw +</translation>
    </message>
    <message>
        <source>Yaw port</source>
        <translation>Yaw</translation>
    </message>
    <message>
        <source>Yaw −</source>
        <translation>Yaw −</translation>
    </message>
    <message>
        <source>Yaw, pitch, roll</source>
        <translation>Yaw, Pitch, Roll</translation>
    </message>
    <message>
        <source>Yaw, roll, pitch</source>
        <translation>Yaw, Roll, Pitch</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>angle-frame</source>
        <translation>Winkel gegen Rahmen</translation>
    </message>
    <message>
        <source>calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>confirm</source>
        <translation>Bestätigung</translation>
    </message>
    <message>
        <source>copy-to-sensor</source>
        <translation>in den Sensor kopieren</translation>
    </message>
    <message>
        <source>erase-eeprom</source>
        <translation>EEPROM löschen</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>extended</source>
        <translation>erweitert</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>intro</source>
        <translation>Begrüßung</translation>
    </message>
    <message>
        <source>main</source>
        <translation>Haupt</translation>
    </message>
    <message>
        <source>melody</source>
        <translation>Melodie</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>profile1</source>
        <translation>Profil 1</translation>
    </message>
    <message>
        <source>profile2</source>
        <translation>Profil 2</translation>
    </message>
    <message>
        <source>profile3</source>
        <translation>Profil 3</translation>
    </message>
    <message>
        <source>profile4</source>
        <translation>Profil 4</translation>
    </message>
    <message>
        <source>profile5</source>
        <translation>Profil 5</translation>
    </message>
    <message>
        <source>rc</source>
        <translation>RC</translation>
    </message>
    <message>
        <source>reset-all</source>
        <translation>alles zurücksetzen</translation>
    </message>
    <message>
        <source>restore-factory</source>
        <translation>Werkskalibrierung</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>gewählter</translation>
    </message>
    <message>
        <source>simple</source>
        <translation>einfach</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>speed-angle</source>
        <translation>Geschwindigkeit und Winkel</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>temperature-off</source>
        <translation>Temperatur aus</translation>
    </message>
    <message>
        <source>temperature-on</source>
        <translation>Temperatur ein</translation>
    </message>
    <message>
        <source>Profile %1</source>
        <translation>Profil %1</translation>
    </message>
    <message>
        <source>Analogue input 1</source>
        <translation>Analogeingang 1</translation>
    </message>
    <message>
        <source>Analogue input 2</source>
        <translation>Analogeingang 2</translation>
    </message>
    <message>
        <source>Analogue input 3</source>
        <translation>Analogeingang 3</translation>
    </message>
    <message>
        <source>Analogue input 4</source>
        <translation>Analogeingang 4</translation>
    </message>
    <message>
        <source>Attitude checks</source>
        <translation>Lageprüfung</translation>
    </message>
    <message>
        <source>Attitude quaternions</source>
        <translation>Lagequaternionen</translation>
    </message>
    <message>
        <source>Attitude reference, frame IMU</source>
        <translation>Lagebezug, Rahmen-IMU</translation>
    </message>
    <message>
        <source>Attitude reference, main IMU</source>
        <translation>Lagebezug, Haupt-IMU</translation>
    </message>
    <message>
        <source>CAN error flags</source>
        <translation>CAN-Fehlerbits</translation>
    </message>
    <message>
        <source>Calibration in progress</source>
        <translation>Laufende Kalibrierung</translation>
    </message>
    <message>
        <source>Camera against frame, quaternion w</source>
        <translation>Kamera gegen Rahmen, Quaternion w</translation>
    </message>
    <message>
        <source>Camera against frame, quaternion x</source>
        <translation>Kamera gegen Rahmen, Quaternion x</translation>
    </message>
    <message>
        <source>Camera against frame, quaternion y</source>
        <translation>Kamera gegen Rahmen, Quaternion y</translation>
    </message>
    <message>
        <source>Camera against frame, quaternion z</source>
        <translation>Kamera gegen Rahmen, Quaternion z</translation>
    </message>
    <message>
        <source>Camera angle, 20 bits, pitch</source>
        <translation>Kamerawinkel, 20 Bit, Pitch</translation>
    </message>
    <message>
        <source>Camera angle, 20 bits, roll</source>
        <translation>Kamerawinkel, 20 Bit, Roll</translation>
    </message>
    <message>
        <source>Camera angle, 20 bits, yaw</source>
        <translation>Kamerawinkel, 20 Bit, Yaw</translation>
    </message>
    <message>
        <source>Camera angle, floating point, pitch</source>
        <translation>Kamerawinkel, Gleitkomma, Pitch</translation>
    </message>
    <message>
        <source>Camera angle, floating point, roll</source>
        <translation>Kamerawinkel, Gleitkomma, Roll</translation>
    </message>
    <message>
        <source>Camera angle, floating point, yaw</source>
        <translation>Kamerawinkel, Gleitkomma, Yaw</translation>
    </message>
    <message>
        <source>Camera attitude, quaternion w</source>
        <translation>Kameralage, Quaternion w</translation>
    </message>
    <message>
        <source>Camera attitude, quaternion x</source>
        <translation>Kameralage, Quaternion x</translation>
    </message>
    <message>
        <source>Camera attitude, quaternion y</source>
        <translation>Kameralage, Quaternion y</translation>
    </message>
    <message>
        <source>Camera attitude, quaternion z</source>
        <translation>Kameralage, Quaternion z</translation>
    </message>
    <message>
        <source>Distance to the lower limit, pitch</source>
        <translation>Abstand zur unteren Grenze, Pitch</translation>
    </message>
    <message>
        <source>Distance to the lower limit, roll</source>
        <translation>Abstand zur unteren Grenze, Roll</translation>
    </message>
    <message>
        <source>Distance to the lower limit, yaw</source>
        <translation>Abstand zur unteren Grenze, Yaw</translation>
    </message>
    <message>
        <source>Distance to the upper limit, pitch</source>
        <translation>Abstand zur oberen Grenze, Pitch</translation>
    </message>
    <message>
        <source>Distance to the upper limit, roll</source>
        <translation>Abstand zur oberen Grenze, Roll</translation>
    </message>
    <message>
        <source>Distance to the upper limit, yaw</source>
        <translation>Abstand zur oberen Grenze, Yaw</translation>
    </message>
    <message>
        <source>Encoder, pitch</source>
        <translation>Encoder, Pitch</translation>
    </message>
    <message>
        <source>Encoder, roll</source>
        <translation>Encoder, Roll</translation>
    </message>
    <message>
        <source>Encoder, yaw</source>
        <translation>Encoder, Yaw</translation>
    </message>
    <message>
        <source>External IMU, bad packets</source>
        <translation>Externe IMU, fehlerhafte Pakete</translation>
    </message>
    <message>
        <source>External IMU, gravity error</source>
        <translation>Externe IMU, Schwerkraftfehler</translation>
    </message>
    <message>
        <source>External IMU, heading error</source>
        <translation>Externe IMU, Kursfehler</translation>
    </message>
    <message>
        <source>External IMU, packets</source>
        <translation>Externe IMU, Pakete</translation>
    </message>
    <message>
        <source>External IMU, status</source>
        <translation>Externe IMU, Status</translation>
    </message>
    <message>
        <source>Flags of the power manager</source>
        <translation>Bits der Leistungsverwaltung</translation>
    </message>
    <message>
        <source>Follow distance, pitch</source>
        <translation>Folgeabstand, Pitch</translation>
    </message>
    <message>
        <source>Follow distance, roll</source>
        <translation>Folgeabstand, Roll</translation>
    </message>
    <message>
        <source>Follow distance, yaw</source>
        <translation>Folgeabstand, Yaw</translation>
    </message>
    <message>
        <source>Fourth motor, angle error</source>
        <translation>Vierter Motor, Winkelfehler</translation>
    </message>
    <message>
        <source>Fourth motor, controller output</source>
        <translation>Vierter Motor, Reglerausgang</translation>
    </message>
    <message>
        <source>Fourth motor, feed-forward speed</source>
        <translation>Vierter Motor, Vorsteuergeschwindigkeit</translation>
    </message>
    <message>
        <source>Frame-camera angle, 20 bits, pitch</source>
        <translation>Winkel Rahmen–Kamera, 20 Bit, Pitch</translation>
    </message>
    <message>
        <source>Frame-camera angle, 20 bits, roll</source>
        <translation>Winkel Rahmen–Kamera, 20 Bit, Roll</translation>
    </message>
    <message>
        <source>Frame-camera angle, 20 bits, yaw</source>
        <translation>Winkel Rahmen–Kamera, 20 Bit, Yaw</translation>
    </message>
    <message>
        <source>Gravity error, frame IMU</source>
        <translation>Schwerkraftfehler, Rahmen-IMU</translation>
    </message>
    <message>
        <source>Gravity error, main IMU</source>
        <translation>Schwerkraftfehler, Haupt-IMU</translation>
    </message>
    <message>
        <source>Heading error, frame IMU</source>
        <translation>Kursfehler, Rahmen-IMU</translation>
    </message>
    <message>
        <source>Heading error, main IMU</source>
        <translation>Kursfehler, Haupt-IMU</translation>
    </message>
    <message>
        <source>High resolution</source>
        <translation>Hohe Auflösung</translation>
    </message>
    <message>
        <source>Motor current, pitch</source>
        <translation>Motorstrom, Pitch</translation>
    </message>
    <message>
        <source>Motor current, roll</source>
        <translation>Motorstrom, Roll</translation>
    </message>
    <message>
        <source>Motor current, yaw</source>
        <translation>Motorstrom, Yaw</translation>
    </message>
    <message>
        <source>Motor driver flags, pitch</source>
        <translation>Motortreiberbits, Pitch</translation>
    </message>
    <message>
        <source>Motor driver flags, roll</source>
        <translation>Motortreiberbits, Roll</translation>
    </message>
    <message>
        <source>Motor driver flags, yaw</source>
        <translation>Motortreiberbits, Yaw</translation>
    </message>
    <message>
        <source>Motor output, pitch</source>
        <translation>Motorausgang, Pitch</translation>
    </message>
    <message>
        <source>Motor output, roll</source>
        <translation>Motorausgang, Roll</translation>
    </message>
    <message>
        <source>Motor output, yaw</source>
        <translation>Motorausgang, Yaw</translation>
    </message>
    <message>
        <source>Motor temperature, pitch</source>
        <translation>Motortemperatur, Pitch</translation>
    </message>
    <message>
        <source>Motor temperature, roll</source>
        <translation>Motortemperatur, Roll</translation>
    </message>
    <message>
        <source>Motor temperature, yaw</source>
        <translation>Motortemperatur, Yaw</translation>
    </message>
    <message>
        <source>Rate between frame and camera, pitch</source>
        <translation>Drehrate zwischen Rahmen und Kamera, Pitch</translation>
    </message>
    <message>
        <source>Rate between frame and camera, roll</source>
        <translation>Drehrate zwischen Rahmen und Kamera, Roll</translation>
    </message>
    <message>
        <source>Rate between frame and camera, yaw</source>
        <translation>Drehrate zwischen Rahmen und Kamera, Yaw</translation>
    </message>
    <message>
        <source>Script variable 1</source>
        <translation>Skriptvariable 1</translation>
    </message>
    <message>
        <source>Script variable 1, whole number</source>
        <translation>Skriptvariable 1, ganzzahlig</translation>
    </message>
    <message>
        <source>Script variable 10</source>
        <translation>Skriptvariable 10</translation>
    </message>
    <message>
        <source>Script variable 10, whole number</source>
        <translation>Skriptvariable 10, ganzzahlig</translation>
    </message>
    <message>
        <source>Script variable 2</source>
        <translation>Skriptvariable 2</translation>
    </message>
    <message>
        <source>Script variable 2, whole number</source>
        <translation>Skriptvariable 2, ganzzahlig</translation>
    </message>
    <message>
        <source>Script variable 3</source>
        <translation>Skriptvariable 3</translation>
    </message>
    <message>
        <source>Script variable 3, whole number</source>
        <translation>Skriptvariable 3, ganzzahlig</translation>
    </message>
    <message>
        <source>Script variable 4</source>
        <translation>Skriptvariable 4</translation>
    </message>
    <message>
        <source>Script variable 4, whole number</source>
        <translation>Skriptvariable 4, ganzzahlig</translation>
    </message>
    <message>
        <source>Script variable 5</source>
        <translation>Skriptvariable 5</translation>
    </message>
    <message>
        <source>Script variable 5, whole number</source>
        <translation>Skriptvariable 5, ganzzahlig</translation>
    </message>
    <message>
        <source>Script variable 6</source>
        <translation>Skriptvariable 6</translation>
    </message>
    <message>
        <source>Script variable 6, whole number</source>
        <translation>Skriptvariable 6, ganzzahlig</translation>
    </message>
    <message>
        <source>Script variable 7</source>
        <translation>Skriptvariable 7</translation>
    </message>
    <message>
        <source>Script variable 7, whole number</source>
        <translation>Skriptvariable 7, ganzzahlig</translation>
    </message>
    <message>
        <source>Script variable 8</source>
        <translation>Skriptvariable 8</translation>
    </message>
    <message>
        <source>Script variable 8, whole number</source>
        <translation>Skriptvariable 8, ganzzahlig</translation>
    </message>
    <message>
        <source>Script variable 9</source>
        <translation>Skriptvariable 9</translation>
    </message>
    <message>
        <source>Script variable 9, whole number</source>
        <translation>Skriptvariable 9, ganzzahlig</translation>
    </message>
    <message>
        <source>Script variables</source>
        <translation>Skriptvariablen</translation>
    </message>
    <message>
        <source>State of the power manager</source>
        <translation>Zustand der Leistungsverwaltung</translation>
    </message>
    <message>
        <source>Supply current</source>
        <translation>Versorgungsstrom</translation>
    </message>
    <message>
        <source>Supply voltage</source>
        <translation>Versorgungsspannung</translation>
    </message>
    <message>
        <source>System state flags</source>
        <translation>Systemzustandsbits</translation>
    </message>
    <message>
        <source>Target angle, 20 bits, pitch</source>
        <translation>Zielwinkel, 20 Bit, Pitch</translation>
    </message>
    <message>
        <source>Target angle, 20 bits, roll</source>
        <translation>Zielwinkel, 20 Bit, Roll</translation>
    </message>
    <message>
        <source>Target angle, 20 bits, yaw</source>
        <translation>Zielwinkel, 20 Bit, Yaw</translation>
    </message>
    <message>
        <source>Target attitude, quaternion w</source>
        <translation>Ziellage, Quaternion w</translation>
    </message>
    <message>
        <source>Target attitude, quaternion x</source>
        <translation>Ziellage, Quaternion x</translation>
    </message>
    <message>
        <source>Target attitude, quaternion y</source>
        <translation>Ziellage, Quaternion y</translation>
    </message>
    <message>
        <source>Target attitude, quaternion z</source>
        <translation>Ziellage, Quaternion z</translation>
    </message>
    <message>
        <source>CAN error counter</source>
        <translation>CAN-Fehlerzähler</translation>
    </message>
    <message>
        <source>I2C error counter</source>
        <translation>I2C-Fehlerzähler</translation>
    </message>
    <message>
        <source>Lower target limit from outside, pitch</source>
        <translation>Untere Zielgrenze von außen, Pitch</translation>
    </message>
    <message>
        <source>Lower target limit from outside, roll</source>
        <translation>Untere Zielgrenze von außen, Roll</translation>
    </message>
    <message>
        <source>Lower target limit from outside, yaw</source>
        <translation>Untere Zielgrenze von außen, Yaw</translation>
    </message>
    <message>
        <source>Serial error counter</source>
        <translation>Serieller Fehlerzähler</translation>
    </message>
    <message>
        <source>Upper target limit from outside, pitch</source>
        <translation>Obere Zielgrenze von außen, Pitch</translation>
    </message>
    <message>
        <source>Upper target limit from outside, roll</source>
        <translation>Obere Zielgrenze von außen, Roll</translation>
    </message>
    <message>
        <source>Upper target limit from outside, yaw</source>
        <translation>Obere Zielgrenze von außen, Yaw</translation>
    </message>
    <message>
        <source>-x0°</source>
        <translation>-x0°</translation>
    </message>
    <message>
        <source>-x180°</source>
        <translation>-x180°</translation>
    </message>
    <message>
        <source>-x270°</source>
        <translation>-x270°</translation>
    </message>
    <message>
        <source>-x90°</source>
        <translation>-x90°</translation>
    </message>
    <message>
        <source>-y0°</source>
        <translation>-y0°</translation>
    </message>
    <message>
        <source>-y180°</source>
        <translation>-y180°</translation>
    </message>
    <message>
        <source>-y270°</source>
        <translation>-y270°</translation>
    </message>
    <message>
        <source>-y90°</source>
        <translation>-y90°</translation>
    </message>
    <message>
        <source>-z0°</source>
        <translation>-z0°</translation>
    </message>
    <message>
        <source>-z180°</source>
        <translation>-z180°</translation>
    </message>
    <message>
        <source>-z270°</source>
        <translation>-z270°</translation>
    </message>
    <message>
        <source>-z90°</source>
        <translation>-z90°</translation>
    </message>
    <message>
        <source>1.5 ms</source>
        <translation>1.5 ms</translation>
    </message>
    <message>
        <source>10 Hz</source>
        <translation>10 Hz</translation>
    </message>
    <message>
        <source>10 ms</source>
        <translation>10 ms</translation>
    </message>
    <message>
        <source>100 ms</source>
        <translation>100 ms</translation>
    </message>
    <message>
        <source>12 ms</source>
        <translation>12 ms</translation>
    </message>
    <message>
        <source>1520 us 250 Hz</source>
        <translation>1520 us 250 Hz</translation>
    </message>
    <message>
        <source>1520 us 55 Hz</source>
        <translation>1520 us 55 Hz</translation>
    </message>
    <message>
        <source>188 Hz</source>
        <translation>188 Hz</translation>
    </message>
    <message>
        <source>2.9 V/cell</source>
        <translation>2.9 V/Zelle</translation>
    </message>
    <message>
        <source>20 Hz</source>
        <translation>20 Hz</translation>
    </message>
    <message>
        <source>22 ms</source>
        <translation>22 ms</translation>
    </message>
    <message>
        <source>25 ms</source>
        <translation>25 ms</translation>
    </message>
    <message>
        <source>256 Hz</source>
        <translation>256 Hz</translation>
    </message>
    <message>
        <source>3.0 V/cell</source>
        <translation>3.0 V/Zelle</translation>
    </message>
    <message>
        <source>3.0 ms</source>
        <translation>3.0 ms</translation>
    </message>
    <message>
        <source>3.1 V/cell</source>
        <translation>3.1 V/Zelle</translation>
    </message>
    <message>
        <source>3.2 V/cell</source>
        <translation>3.2 V/Zelle</translation>
    </message>
    <message>
        <source>3.3 V/cell</source>
        <translation>3.3 V/Zelle</translation>
    </message>
    <message>
        <source>3.4 V/cell</source>
        <translation>3.4 V/Zelle</translation>
    </message>
    <message>
        <source>3.5 V/cell</source>
        <translation>3.5 V/Zelle</translation>
    </message>
    <message>
        <source>4 ms</source>
        <translation>4 ms</translation>
    </message>
    <message>
        <source>4.5 ms</source>
        <translation>4.5 ms</translation>
    </message>
    <message>
        <source>42 Hz</source>
        <translation>42 Hz</translation>
    </message>
    <message>
        <source>46 ms</source>
        <translation>46 ms</translation>
    </message>
    <message>
        <source>5 Hz</source>
        <translation>5 Hz</translation>
    </message>
    <message>
        <source>50 ms</source>
        <translation>50 ms</translation>
    </message>
    <message>
        <source>6.0 ms</source>
        <translation>6.0 ms</translation>
    </message>
    <message>
        <source>7.5 ms</source>
        <translation>7.5 ms</translation>
    </message>
    <message>
        <source>9 ms</source>
        <translation>9 ms</translation>
    </message>
    <message>
        <source>94 ms</source>
        <translation>94 ms</translation>
    </message>
    <message>
        <source>98 Hz</source>
        <translation>98 Hz</translation>
    </message>
    <message>
        <source>A stick has to move this far before anything changes.</source>
        <translation>Ein Knüppel muss sich so weit bewegen, bevor sich etwas ändert.</translation>
    </message>
    <message>
        <source>A value of a layout that this program has no table for.</source>
        <translation>Ein Wert eines Layouts, zu dem dieses Programm keine Tabelle hat.</translation>
    </message>
    <message>
        <source>Above it the accelerometer is trusted less. 0 switches that off.</source>
        <translation>Darüber wird dem Beschleunigungssensor weniger vertraut. 0 schaltet das aus.</translation>
    </message>
    <message>
        <source>Absolute: the stick sets the angle. Relative: it sets the speed.</source>
        <translation>Absolut: der Knüppel gibt den Winkel vor. Relativ: er gibt die Geschwindigkeit vor.</translation>
    </message>
    <message>
        <source>Acceleration compensation</source>
        <translation>Beschleunigungsausgleich</translation>
    </message>
    <message>
        <source>Acceleration threshold</source>
        <translation>Beschleunigungsschwelle</translation>
    </message>
    <message>
        <source>Acceleration threshold of the IMU</source>
        <translation>Beschleunigungsschwelle der IMU</translation>
    </message>
    <message>
        <source>Accelerometer noise</source>
        <translation>Rauschen des Beschleunigungssensors</translation>
    </message>
    <message>
        <source>An acceleration that differs from gravity by this much is not used. 0 uses all.</source>
        <translation>Eine Beschleunigung, die so weit von der Schwerkraft abweicht, wird nicht verwendet. 0 verwendet alle.</translation>
    </message>
    <message>
        <source>Angle of the middle</source>
        <translation>Winkel der Mitte</translation>
    </message>
    <message>
        <source>Angle offset</source>
        <translation>Winkelversatz</translation>
    </message>
    <message>
        <source>Angle, within the limits of the sticks</source>
        <translation>Winkel, in den Grenzen der Knüppel</translation>
    </message>
    <message>
        <source>Angle, without limits</source>
        <translation>Winkel, ohne Grenzen</translation>
    </message>
    <message>
        <source>Attitude time constant</source>
        <translation>Zeitkonstante der Lage</translation>
    </message>
    <message>
        <source>Auto finds it at each start, with a little movement. A wrong one makes the motor run away.</source>
        <translation>Auto findet sie bei jedem Start mit einer kleinen Bewegung. Eine falsche lässt den Motor durchgehen.</translation>
    </message>
    <message>
        <source>Aux-0 latch</source>
        <translation>Aux-0 latch</translation>
    </message>
    <message>
        <source>Aux-0 step</source>
        <translation>Aux-0 step</translation>
    </message>
    <message>
        <source>Aux-0 switch</source>
        <translation>Aux-0 switch</translation>
    </message>
    <message>
        <source>Aux-01 latch</source>
        <translation>Aux-01 latch</translation>
    </message>
    <message>
        <source>Aux-01 switch</source>
        <translation>Aux-01 switch</translation>
    </message>
    <message>
        <source>Aux-012 latch</source>
        <translation>Aux-012 latch</translation>
    </message>
    <message>
        <source>Aux-012 switch</source>
        <translation>Aux-012 switch</translation>
    </message>
    <message>
        <source>Aux-1 latch</source>
        <translation>Aux-1 latch</translation>
    </message>
    <message>
        <source>Aux-1 step</source>
        <translation>Aux-1 step</translation>
    </message>
    <message>
        <source>Aux-1 switch</source>
        <translation>Aux-1 switch</translation>
    </message>
    <message>
        <source>Aux-2 latch</source>
        <translation>Aux-2 latch</translation>
    </message>
    <message>
        <source>Aux-2 step</source>
        <translation>Aux-2 step</translation>
    </message>
    <message>
        <source>Aux-2 switch</source>
        <translation>Aux-2 switch</translation>
    </message>
    <message>
        <source>Beep with the motors</source>
        <translation>Mit den Motoren piepen</translation>
    </message>
    <message>
        <source>Below it the board warns and takes the motors back.</source>
        <translation>Darunter warnt das Board und nimmt die Motoren zurück.</translation>
    </message>
    <message>
        <source>Brings the camera back to its middle.</source>
        <translation>Bringt die Kamera in ihre Mitte zurück.</translation>
    </message>
    <message>
        <source>But latch</source>
        <translation>But latch</translation>
    </message>
    <message>
        <source>But step</source>
        <translation>But step</translation>
    </message>
    <message>
        <source>But switch</source>
        <translation>But switch</translation>
    </message>
    <message>
        <source>By infrared, as the camera model is set.</source>
        <translation>Über Infrarot, wie das Kameramodell eingestellt ist.</translation>
    </message>
    <message>
        <source>Camera IMU orientation</source>
        <translation>Ausrichtung der Kamera-IMU</translation>
    </message>
    <message>
        <source>Camera action 1</source>
        <translation>Kameraaktion 1</translation>
    </message>
    <message>
        <source>Camera action 2</source>
        <translation>Kameraaktion 2</translation>
    </message>
    <message>
        <source>Camera input</source>
        <translation>Kameraeingang</translation>
    </message>
    <message>
        <source>Camera model</source>
        <translation>Kameramodell</translation>
    </message>
    <message>
        <source>Canon</source>
        <translation>Canon</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>Centrifugal correction</source>
        <translation>Fliehkraftausgleich</translation>
    </message>
    <message>
        <source>Check its cable, or switch it off in the setup.</source>
        <translation>Prüfen Sie ihr Kabel, oder schalten Sie sie in der Einrichtung ab.</translation>
    </message>
    <message>
        <source>Check the sensor cable and keep it away from motors.</source>
        <translation>Prüfen Sie das Sensorkabel und halten Sie es von den Motoren fern.</translation>
    </message>
    <message>
        <source>Chooses the case that a script runs.</source>
        <translation>Wählt den Fall, den ein Skript ausführt.</translation>
    </message>
    <message>
        <source>Connect the battery.</source>
        <translation>Schließen Sie den Akku an.</translation>
    </message>
    <message>
        <source>Controller output, pitch</source>
        <translation>Reglerausgang, Pitch</translation>
    </message>
    <message>
        <source>Controller output, roll</source>
        <translation>Reglerausgang, Roll</translation>
    </message>
    <message>
        <source>Controller output, yaw</source>
        <translation>Reglerausgang, Yaw</translation>
    </message>
    <message>
        <source>Copies the directions that were found into the parameters; in RAM.</source>
        <translation>Übernimmt die gefundenen Drehrichtungen in die Parameter; im RAM.</translation>
    </message>
    <message>
        <source>Copies where the motor stands now; in RAM.</source>
        <translation>Übernimmt, wo der Motor jetzt steht; im RAM.</translation>
    </message>
    <message>
        <source>Copies where the motors stand now; in RAM.</source>
        <translation>Übernimmt, wo die Motoren jetzt stehen; im RAM.</translation>
    </message>
    <message>
        <source>Counts of both sensors before calibration.</source>
        <translation>Rohwerte beider Sensoren vor der Kalibrierung.</translation>
    </message>
    <message>
        <source>Damping. Raise it until the motor buzzes, then take a third of it away.</source>
        <translation>Dämpfung. Erhöhen, bis der Motor brummt, dann ein Drittel wegnehmen.</translation>
    </message>
    <message>
        <source>Dead band of sticks</source>
        <translation>Totbereich der Knüppel</translation>
    </message>
    <message>
        <source>Erase the memory</source>
        <translation>Speicher löschen</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Experte</translation>
    </message>
    <message>
        <source>Feed-forward low-pass</source>
        <translation>Tiefpass der Vorsteuerung</translation>
    </message>
    <message>
        <source>Frame IMU orientation</source>
        <translation>Ausrichtung der Rahmen-IMU</translation>
    </message>
    <message>
        <source>Function inputs</source>
        <translation>Funktionseingänge</translation>
    </message>
    <message>
        <source>Functions</source>
        <translation>Funktionen</translation>
    </message>
    <message>
        <source>Gimbal configuration</source>
        <translation>Gimbal-Einrichtung</translation>
    </message>
    <message>
        <source>Gyro low-pass</source>
        <translation>Gyro-Tiefpass</translation>
    </message>
    <message>
        <source>Gyro, about forward (roll)</source>
        <translation>Gyro, um vorn (Roll)</translation>
    </message>
    <message>
        <source>Gyro, about left (pitch)</source>
        <translation>Gyro, um links (Pitch)</translation>
    </message>
    <message>
        <source>Gyro, about up (yaw)</source>
        <translation>Gyro, um oben (Yaw)</translation>
    </message>
    <message>
        <source>Hardware reset</source>
        <translation>Hardware-Reset</translation>
    </message>
    <message>
        <source>Highest angle</source>
        <translation>Höchster Winkel</translation>
    </message>
    <message>
        <source>Highest speed of steering. 0 sets no limit.</source>
        <translation>Höchste Geschwindigkeit beim Steuern. 0 setzt keine Grenze.</translation>
    </message>
    <message>
        <source>Highest voltage at the motor. As little as holds the camera in a wind; more heats the motor.</source>
        <translation>Höchste Spannung am Motor. So wenig, wie die Kamera im Wind hält; mehr erhitzt den Motor.</translation>
    </message>
    <message>
        <source>Hold the camera still and restart the board.</source>
        <translation>Halten Sie die Kamera still und starten Sie das Board neu.</translation>
    </message>
    <message>
        <source>Hold to pan transition</source>
        <translation>Übergang von Halten zu Folgen</translation>
    </message>
    <message>
        <source>How accelerations of the carrier are told from gravity.</source>
        <translation>Wie Beschleunigungen des Trägers von der Schwerkraft unterschieden werden.</translation>
    </message>
    <message>
        <source>How fast an error that stays is taken away. Too much sways slowly.</source>
        <translation>Wie schnell ein bleibender Fehler ausgeregelt wird. Zu viel schwankt langsam.</translation>
    </message>
    <message>
        <source>How fast the camera follows the handle in pan mode. 0 holds.</source>
        <translation>Wie schnell die Kamera dem Griff im Pan-Modus folgt. 0 hält.</translation>
    </message>
    <message>
        <source>How long a change from hold to pan takes.</source>
        <translation>Wie lange ein Wechsel von Halten zu Folgen dauert.</translation>
    </message>
    <message>
        <source>How long the accelerometer is trusted less after a disturbance.</source>
        <translation>Wie lange dem Beschleunigungssensor nach einer Störung weniger vertraut wird.</translation>
    </message>
    <message>
        <source>How long the accelerometer takes to correct the angles. Short in slow, long in fast motion.</source>
        <translation>Wie lange der Beschleunigungssensor braucht, um die Winkel zu berichtigen. Kurz bei langsamer, lang bei schneller Bewegung.</translation>
    </message>
    <message>
        <source>How much of a falling battery voltage is made up for at the motors.</source>
        <translation>Wie viel einer sinkenden Akkuspannung an den Motoren ausgeglichen wird.</translation>
    </message>
    <message>
        <source>How much of the force in a turn is made up for.</source>
        <translation>Wie viel der Kraft in einer Kurve ausgeglichen wird.</translation>
    </message>
    <message>
        <source>How much softer following is near the middle.</source>
        <translation>Wie viel weicher das Folgen nahe der Mitte ist.</translation>
    </message>
    <message>
        <source>How much vertical accelerations count.</source>
        <translation>Wie viel senkrechte Beschleunigungen zählen.</translation>
    </message>
    <message>
        <source>How softly steering begins and ends. 0 sets no limit.</source>
        <translation>Wie weich das Steuern beginnt und endet. 0 setzt keine Grenze.</translation>
    </message>
    <message>
        <source>How the sensor at the camera is mounted: which of its axes point forward, left and up. A wrong one makes the camera swing away.</source>
        <translation>Wie der Sensor an der Kamera sitzt: welche seiner Achsen nach vorn, links und oben zeigen. Eine falsche lässt die Kamera ausschwenken.</translation>
    </message>
    <message>
        <source>How the sensor at the frame is mounted.</source>
        <translation>Wie der Sensor am Rahmen sitzt.</translation>
    </message>
    <message>
        <source>How the sensor at the frame is used.</source>
        <translation>Wie der Sensor am Rahmen verwendet wird.</translation>
    </message>
    <message>
        <source>How the third sensor is mounted.</source>
        <translation>Wie der dritte Sensor sitzt.</translation>
    </message>
    <message>
        <source>Hysteresis of sticks</source>
        <translation>Hysterese der Knüppel</translation>
    </message>
    <message>
        <source>Hysteresis of the pan dead band</source>
        <translation>Hysterese des Pan-Totbereichs</translation>
    </message>
    <message>
        <source>IMU error</source>
        <translation>IMU-Fehler</translation>
    </message>
    <message>
        <source>IMU mapping</source>
        <translation>IMU-Zuordnung</translation>
    </message>
    <message>
        <source>Imu3 = NT Imu2</source>
        <translation>Imu3 = NT Imu2</translation>
    </message>
    <message>
        <source>Imu3 = on-board Imu2</source>
        <translation>Imu3 = on-board Imu2</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Eingang</translation>
    </message>
    <message>
        <source>Input, pitch</source>
        <translation>Eingang, Pitch</translation>
    </message>
    <message>
        <source>Input, roll</source>
        <translation>Eingang, Roll</translation>
    </message>
    <message>
        <source>Input, yaw</source>
        <translation>Eingang, Yaw</translation>
    </message>
    <message>
        <source>Leaves standby.</source>
        <translation>Verlässt die Bereitschaft.</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>Leveling failed</source>
        <translation>Ausrichten fehlgeschlagen</translation>
    </message>
    <message>
        <source>Levels the gimbal anew.</source>
        <translation>Richtet den Gimbal neu aus.</translation>
    </message>
    <message>
        <source>Limits how fast following changes.</source>
        <translation>Begrenzt, wie schnell sich das Folgen ändert.</translation>
    </message>
    <message>
        <source>Logging</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Low voltage limit</source>
        <translation>Untere Spannungsgrenze</translation>
    </message>
    <message>
        <source>Low-pass of analogue sticks</source>
        <translation>Tiefpass analoger Knüppel</translation>
    </message>
    <message>
        <source>Low-pass of the pan dead band</source>
        <translation>Tiefpass des Pan-Totbereichs</translation>
    </message>
    <message>
        <source>Low-pass of the sensor</source>
        <translation>Tiefpass des Sensors</translation>
    </message>
    <message>
        <source>Lowest angle</source>
        <translation>Niedrigster Winkel</translation>
    </message>
    <message>
        <source>M0=pitch , M1=roll</source>
        <translation>M0=pitch , M1=roll</translation>
    </message>
    <message>
        <source>M0=roll , M1=pitch</source>
        <translation>M0=roll , M1=pitch</translation>
    </message>
    <message>
        <source>MAVLink component</source>
        <translation>MAVLink-Komponente</translation>
    </message>
    <message>
        <source>MAVLink heartbeat</source>
        <translation>MAVLink-Heartbeat</translation>
    </message>
    <message>
        <source>MAVLink system</source>
        <translation>MAVLink-System</translation>
    </message>
    <message>
        <source>Magnets in the bell of the motor. A wrong number makes the motor run away.</source>
        <translation>Magnete in der Glocke des Motors. Eine falsche Zahl lässt den Motor durchgehen.</translation>
    </message>
    <message>
        <source>Makes a servo signal at the board&apos;s port.</source>
        <translation>Erzeugt ein Servosignal am Anschluss des Boards.</translation>
    </message>
    <message>
        <source>Makes the measured battery voltage right.</source>
        <translation>Macht die gemessene Akkuspannung richtig.</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Motor direction</source>
        <translation>Motordrehrichtung</translation>
    </message>
    <message>
        <source>Motor mapping</source>
        <translation>Motorzuordnung</translation>
    </message>
    <message>
        <source>Motor poles</source>
        <translation>Motorpole</translation>
    </message>
    <message>
        <source>Motor power</source>
        <translation>Motorleistung</translation>
    </message>
    <message>
        <source>Motor usage</source>
        <translation>Motorverwendung</translation>
    </message>
    <message>
        <source>Moves the middle of the stick.</source>
        <translation>Verschiebt die Mitte des Knüppels.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name the board</source>
        <translation>Board benennen</translation>
    </message>
    <message>
        <source>Nikon</source>
        <translation>Nikon</translation>
    </message>
    <message>
        <source>No battery</source>
        <translation>Kein Akku</translation>
    </message>
    <message>
        <source>Normal stabilizes. Disabled leaves the motor without current.</source>
        <translation>Normal stabilisiert. Abgeschaltet lässt den Motor stromlos.</translation>
    </message>
    <message>
        <source>Number of the word</source>
        <translation>Nummer des Worts</translation>
    </message>
    <message>
        <source>Of the servo output.</source>
        <translation>Des Servoausgangs.</translation>
    </message>
    <message>
        <source>One of the four that are set up.</source>
        <translation>Eine der vier eingerichteten.</translation>
    </message>
    <message>
        <source>PWM output</source>
        <translation>PWM-Ausgang</translation>
    </message>
    <message>
        <source>PWM output input</source>
        <translation>Eingang des PWM-Ausgangs</translation>
    </message>
    <message>
        <source>PWM output, highest</source>
        <translation>PWM-Ausgang, höchster Wert</translation>
    </message>
    <message>
        <source>PWM output, lowest</source>
        <translation>PWM-Ausgang, niedrigster Wert</translation>
    </message>
    <message>
        <source>PWM output, middle</source>
        <translation>PWM-Ausgang, Mitte</translation>
    </message>
    <message>
        <source>PWM output, speed limit</source>
        <translation>PWM-Ausgang, Geschwindigkeitsgrenze</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Pan</translation>
    </message>
    <message>
        <source>Pan dead band</source>
        <translation>Pan-Totbereich</translation>
    </message>
    <message>
        <source>Pan expo</source>
        <translation>Pan-Expo</translation>
    </message>
    <message>
        <source>Pan limiter</source>
        <translation>Pan-Begrenzer</translation>
    </message>
    <message>
        <source>Pan mode</source>
        <translation>Pan-Modus</translation>
    </message>
    <message>
        <source>Pan mode (pitch roll yaw)</source>
        <translation>Pan-Modus (Pitch Roll Yaw)</translation>
    </message>
    <message>
        <source>Pan mode 1</source>
        <translation>Pan-Modus 1</translation>
    </message>
    <message>
        <source>Pan mode 2</source>
        <translation>Pan-Modus 2</translation>
    </message>
    <message>
        <source>Pan mode 3</source>
        <translation>Pan-Modus 3</translation>
    </message>
    <message>
        <source>Pan mode input</source>
        <translation>Eingang des Pan-Modus</translation>
    </message>
    <message>
        <source>Pan mode setting</source>
        <translation>Pan-Modus-Einstellung</translation>
    </message>
    <message>
        <source>Pan mode, default</source>
        <translation>Pan-Modus, Vorgabe</translation>
    </message>
    <message>
        <source>Pan speed</source>
        <translation>Pan-Geschwindigkeit</translation>
    </message>
    <message>
        <source>Panasonic</source>
        <translation>Panasonic</translation>
    </message>
    <message>
        <source>Pitch (0 = middle)</source>
        <translation>Pitch (0 = Mitte)</translation>
    </message>
    <message>
        <source>Plain commands work again on this port at once. In RAM; store it to keep it.</source>
        <translation>Einfache Befehle wirken an diesem Anschluss sofort wieder. Im RAM; zum Behalten speichern.</translation>
    </message>
    <message>
        <source>Pot-0</source>
        <translation>Pot-0</translation>
    </message>
    <message>
        <source>Pot-1</source>
        <translation>Pot-1</translation>
    </message>
    <message>
        <source>Pot-2</source>
        <translation>Pot-2</translation>
    </message>
    <message>
        <source>Pulse</source>
        <translation>Puls</translation>
    </message>
    <message>
        <source>Puts the defaults into use; stored values stay until you store.</source>
        <translation>Nimmt die Vorgaben in Gebrauch; gespeicherte Werte bleiben, bis Sie speichern.</translation>
    </message>
    <message>
        <source>Puts the stored value of one parameter into use again.</source>
        <translation>Nimmt den gespeicherten Wert eines Parameters wieder in Gebrauch.</translation>
    </message>
    <message>
        <source>Puts the stored values into use again; what was not stored is gone.</source>
        <translation>Nimmt die gespeicherten Werte wieder in Gebrauch; was nicht gespeichert war, ist weg.</translation>
    </message>
    <message>
        <source>RC inputs</source>
        <translation>RC-Eingänge</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Raw words</source>
        <translation>Rohe Worte</translation>
    </message>
    <message>
        <source>Rc-0</source>
        <translation>Rc-0</translation>
    </message>
    <message>
        <source>Rc-1</source>
        <translation>Rc-1</translation>
    </message>
    <message>
        <source>Rc-2</source>
        <translation>Rc-2</translation>
    </message>
    <message>
        <source>Rc2-0</source>
        <translation>Rc2-0</translation>
    </message>
    <message>
        <source>Rc2-1</source>
        <translation>Rc2-1</translation>
    </message>
    <message>
        <source>Rc2-2</source>
        <translation>Rc2-2</translation>
    </message>
    <message>
        <source>Rc2-3</source>
        <translation>Rc2-3</translation>
    </message>
    <message>
        <source>Re-center</source>
        <translation>Zentrieren</translation>
    </message>
    <message>
        <source>Re-center input</source>
        <translation>Eingang zum Zentrieren</translation>
    </message>
    <message>
        <source>Read calibration</source>
        <translation>Kalibrierung lesen</translation>
    </message>
    <message>
        <source>Read raw sensors</source>
        <translation>Rohe Sensoren lesen</translation>
    </message>
    <message>
        <source>Read status</source>
        <translation>Status lesen</translation>
    </message>
    <message>
        <source>Recovery time of the accelerometer</source>
        <translation>Erholzeit des Beschleunigungssensors</translation>
    </message>
    <message>
        <source>Release the camera</source>
        <translation>Kamera auslösen</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neustart</translation>
    </message>
    <message>
        <source>Roll (0 = middle)</source>
        <translation>Roll (0 = Mitte)</translation>
    </message>
    <message>
        <source>Run a script</source>
        <translation>Skript ausführen</translation>
    </message>
    <message>
        <source>STorM32-Link, yaw</source>
        <translation>STorM32-Link, Yaw</translation>
    </message>
    <message>
        <source>Script</source>
        <translation>Skript</translation>
    </message>
    <message>
        <source>Scripts</source>
        <translation>Skripte</translation>
    </message>
    <message>
        <source>Second IMU</source>
        <translation>Zweite IMU</translation>
    </message>
    <message>
        <source>Second IMU error</source>
        <translation>Fehler der zweiten IMU</translation>
    </message>
    <message>
        <source>Sensor bus errors</source>
        <translation>Sensorbusfehler</translation>
    </message>
    <message>
        <source>Set angles</source>
        <translation>Winkel setzen</translation>
    </message>
    <message>
        <source>Set stick positions</source>
        <translation>Knüppelstellungen setzen</translation>
    </message>
    <message>
        <source>Set the serial rate</source>
        <translation>Serielle Rate setzen</translation>
    </message>
    <message>
        <source>Sets the servo output.</source>
        <translation>Setzt den Servoausgang.</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Einrichtung</translation>
    </message>
    <message>
        <source>Shot</source>
        <translation>Auslösung</translation>
    </message>
    <message>
        <source>Smooths joysticks and potentiometers.</source>
        <translation>Glättet Joysticks und Potentiometer.</translation>
    </message>
    <message>
        <source>Smooths the accelerometer.</source>
        <translation>Glättet den Beschleunigungssensor.</translation>
    </message>
    <message>
        <source>Smooths what the dead band lets through.</source>
        <translation>Glättet, was der Totbereich durchlässt.</translation>
    </message>
    <message>
        <source>Smooths what the frame&apos;s sensor adds.</source>
        <translation>Glättet, was der Sensor am Rahmen beiträgt.</translation>
    </message>
    <message>
        <source>A stick has no effect this close to its middle.</source>
        <translation>So weit um seine Mitte bewirkt ein Knüppel nichts.</translation>
    </message>
    <message>
        <source>Sony Nex</source>
        <translation>Sony Nex</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Geschwindigkeitsgrenze</translation>
    </message>
    <message>
        <source>Standby</source>
        <translation>Bereitschaft</translation>
    </message>
    <message>
        <source>Standby input</source>
        <translation>Eingang der Bereitschaft</translation>
    </message>
    <message>
        <source>Standby: all motors are without current.</source>
        <translation>Bereitschaft: alle Motoren sind stromlos.</translation>
    </message>
    <message>
        <source>Start position</source>
        <translation>Startposition</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>State, status bits, bus errors and voltage.</source>
        <translation>Zustand, Statusbits, Busfehler und Spannung.</translation>
    </message>
    <message>
        <source>Status bits</source>
        <translation>Statusbits</translation>
    </message>
    <message>
        <source>Status bits 2</source>
        <translation>Statusbits 2</translation>
    </message>
    <message>
        <source>Steering does not take the camera beyond.</source>
        <translation>Steuern bringt die Kamera nicht darüber hinaus.</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Stored at once; takes effect when the board is switched on again.</source>
        <translation>Sofort gespeichert; wirkt, wenn das Board wieder eingeschaltet wird.</translation>
    </message>
    <message>
        <source>Strength of the answer to an angle error. Too little is soft, too much vibrates.</source>
        <translation>Stärke der Antwort auf einen Winkelfehler. Zu wenig ist weich, zu viel vibriert.</translation>
    </message>
    <message>
        <source>Switch the heartbeat off</source>
        <translation>Heartbeat ausschalten</translation>
    </message>
    <message>
        <source>Switches standby on or off.</source>
        <translation>Schaltet die Bereitschaft ein oder aus.</translation>
    </message>
    <message>
        <source>Take RC trims</source>
        <translation>RC-Trimmung übernehmen</translation>
    </message>
    <message>
        <source>Take motor directions</source>
        <translation>Motordrehrichtungen übernehmen</translation>
    </message>
    <message>
        <source>Take start position, yaw</source>
        <translation>Startposition übernehmen, Yaw</translation>
    </message>
    <message>
        <source>Take start positions, pitch and roll</source>
        <translation>Startpositionen übernehmen, Pitch und Roll</translation>
    </message>
    <message>
        <source>Takes noise from the gyro. A lower one delays the control loop.</source>
        <translation>Nimmt Rauschen vom Gyro. Ein tieferer verzögert den Regelkreis.</translation>
    </message>
    <message>
        <source>Takes the sticks&apos; present positions as their middle; in RAM.</source>
        <translation>Nimmt die jetzigen Knüppelstellungen als ihre Mitte; im RAM.</translation>
    </message>
    <message>
        <source>The board did not find its level at the start.</source>
        <translation>Das Board hat beim Start die Waagerechte nicht gefunden.</translation>
    </message>
    <message>
        <source>The board&apos;s component number.</source>
        <translation>Die Komponentennummer des Boards.</translation>
    </message>
    <message>
        <source>The board&apos;s system number.</source>
        <translation>Die Systemnummer des Boards.</translation>
    </message>
    <message>
        <source>The camera does not follow until the handle has turned this far.</source>
        <translation>Die Kamera folgt erst, wenn sich der Griff so weit gedreht hat.</translation>
    </message>
    <message>
        <source>The camera goes on following until the handle is this far inside the dead band.</source>
        <translation>Die Kamera folgt weiter, bis der Griff so weit innerhalb des Totbereichs ist.</translation>
    </message>
    <message>
        <source>The camera is released again after this time. 0 switches that off.</source>
        <translation>Die Kamera wird nach dieser Zeit wieder ausgelöst. 0 schaltet das aus.</translation>
    </message>
    <message>
        <source>The filter inside the motion sensor. A lower one delays the control loop.</source>
        <translation>Der Filter im Bewegungssensor. Ein tieferer verzögert den Regelkreis.</translation>
    </message>
    <message>
        <source>The motion sensor answers, but not well.</source>
        <translation>Der Bewegungssensor antwortet, aber nicht gut.</translation>
    </message>
    <message>
        <source>The motors have no supply; settings can still be changed.</source>
        <translation>Die Motoren haben keine Versorgung; Einstellungen lassen sich trotzdem ändern.</translation>
    </message>
    <message>
        <source>The next start begins with defaults. Values in use stay until then.</source>
        <translation>Der nächste Start beginnt mit Vorgaben. Werte in Gebrauch bleiben bis dahin.</translation>
    </message>
    <message>
        <source>The receiver at the board&apos;s port, whose channels serve as inputs.</source>
        <translation>Der Empfänger am Anschluss des Boards, dessen Kanäle als Eingänge dienen.</translation>
    </message>
    <message>
        <source>The sensor at the frame answers, but not well.</source>
        <translation>Der Sensor am Rahmen antwortet, aber nicht gut.</translation>
    </message>
    <message>
        <source>Third IMU</source>
        <translation>Dritte IMU</translation>
    </message>
    <message>
        <source>Third IMU orientation</source>
        <translation>Ausrichtung der dritten IMU</translation>
    </message>
    <message>
        <source>Time between pictures</source>
        <translation>Zeit zwischen Bildern</translation>
    </message>
    <message>
        <source>Trust in the accelerometer</source>
        <translation>Vertrauen in den Beschleunigungssensor</translation>
    </message>
    <message>
        <source>Turns the camera to these angles; down, right and left are positive.</source>
        <translation>Dreht die Kamera auf diese Winkel; unten, rechts und links sind positiv.</translation>
    </message>
    <message>
        <source>Turns the level of this axis a little, to make up for a sensor that sits askew.</source>
        <translation>Dreht die Waagerechte dieser Achse ein wenig, um einen schief sitzenden Sensor auszugleichen.</translation>
    </message>
    <message>
        <source>Up direction, X</source>
        <translation>Richtung nach oben, X</translation>
    </message>
    <message>
        <source>Up direction, Y</source>
        <translation>Richtung nach oben, Y</translation>
    </message>
    <message>
        <source>Up direction, Z</source>
        <translation>Richtung nach oben, Z</translation>
    </message>
    <message>
        <source>Up to 16 letters; stored at once.</source>
        <translation>Bis zu 16 Buchstaben; sofort gespeichert.</translation>
    </message>
    <message>
        <source>Use all motors, restart</source>
        <translation>Alle Motoren verwenden, Neustart</translation>
    </message>
    <message>
        <source>Virtual channels</source>
        <translation>Virtuelle Kanäle</translation>
    </message>
    <message>
        <source>Virtual-1</source>
        <translation>Virtual-1</translation>
    </message>
    <message>
        <source>Virtual-10</source>
        <translation>Virtual-10</translation>
    </message>
    <message>
        <source>Virtual-11</source>
        <translation>Virtual-11</translation>
    </message>
    <message>
        <source>Virtual-12</source>
        <translation>Virtual-12</translation>
    </message>
    <message>
        <source>Virtual-13</source>
        <translation>Virtual-13</translation>
    </message>
    <message>
        <source>Virtual-14</source>
        <translation>Virtual-14</translation>
    </message>
    <message>
        <source>Virtual-15</source>
        <translation>Virtual-15</translation>
    </message>
    <message>
        <source>Virtual-16</source>
        <translation>Virtual-16</translation>
    </message>
    <message>
        <source>Virtual-2</source>
        <translation>Virtual-2</translation>
    </message>
    <message>
        <source>Virtual-3</source>
        <translation>Virtual-3</translation>
    </message>
    <message>
        <source>Virtual-4</source>
        <translation>Virtual-4</translation>
    </message>
    <message>
        <source>Virtual-5</source>
        <translation>Virtual-5</translation>
    </message>
    <message>
        <source>Virtual-6</source>
        <translation>Virtual-6</translation>
    </message>
    <message>
        <source>Virtual-7</source>
        <translation>Virtual-7</translation>
    </message>
    <message>
        <source>Virtual-8</source>
        <translation>Virtual-8</translation>
    </message>
    <message>
        <source>Virtual-9</source>
        <translation>Virtual-9</translation>
    </message>
    <message>
        <source>Voltage calibration</source>
        <translation>Spannungskalibrierung</translation>
    </message>
    <message>
        <source>Voltage correction</source>
        <translation>Spannungsausgleich</translation>
    </message>
    <message>
        <source>Weight of vertical acceleration</source>
        <translation>Gewicht senkrechter Beschleunigung</translation>
    </message>
    <message>
        <source>What brings the camera back to its middle.</source>
        <translation>Was die Kamera in ihre Mitte zurückbringt.</translation>
    </message>
    <message>
        <source>What chooses the case of the script that runs.</source>
        <translation>Was den Fall des laufenden Skripts wählt.</translation>
    </message>
    <message>
        <source>What is written by a logger on the NT bus.</source>
        <translation>Was ein Logger am NT-Bus schreibt.</translation>
    </message>
    <message>
        <source>What releases the camera.</source>
        <translation>Was die Kamera auslöst.</translation>
    </message>
    <message>
        <source>What steers this axis.</source>
        <translation>Was diese Achse steuert.</translation>
    </message>
    <message>
        <source>What switches between the pan modes.</source>
        <translation>Was zwischen den Pan-Modi umschaltet.</translation>
    </message>
    <message>
        <source>What switches the motors off and on.</source>
        <translation>Was die Motoren aus- und einschaltet.</translation>
    </message>
    <message>
        <source>What the accelerometer shows at rest.</source>
        <translation>Was der Beschleunigungssensor in Ruhe zeigt.</translation>
    </message>
    <message>
        <source>What the camera is told at the input&apos;s first position.</source>
        <translation>Was der Kamera in der ersten Stellung des Eingangs gesagt wird.</translation>
    </message>
    <message>
        <source>What the camera is told at the input&apos;s second position.</source>
        <translation>Was der Kamera in der zweiten Stellung des Eingangs gesagt wird.</translation>
    </message>
    <message>
        <source>Events that the motors sound for.</source>
        <translation>Wofür die Motoren tönen.</translation>
    </message>
    <message>
        <source>What the serial port sends by itself. While it does, it answers MAVLink only: this program then goes the long way round.</source>
        <translation>Was der serielle Anschluss von selbst sendet. Solange er das tut, antwortet er nur auf MAVLink: dieses Programm nimmt dann den Umweg.</translation>
    </message>
    <message>
        <source>What the servo output follows.</source>
        <translation>Wem der Servoausgang folgt.</translation>
    </message>
    <message>
        <source>Where the camera points when no stick is moved.</source>
        <translation>Wohin die Kamera zeigt, wenn kein Knüppel bewegt ist.</translation>
    </message>
    <message>
        <source>Where the motor stands at the start when it is used by position. Take it over with the action, rather than by hand.</source>
        <translation>Wo der Motor beim Start steht, wenn er nach Position verwendet wird. Lieber mit der Aktion übernehmen als von Hand.</translation>
    </message>
    <message>
        <source>Which axes follow the handle (pan) and which keep their direction (hold): pitch, roll, yaw.</source>
        <translation>Welche Achsen dem Griff folgen (pan) und welche ihre Richtung halten (hold): Pitch, Roll, Yaw.</translation>
    </message>
    <message>
        <source>Which axes follow the handle, until it is changed back.</source>
        <translation>Welche Achsen dem Griff folgen, bis es zurückgestellt wird.</translation>
    </message>
    <message>
        <source>Which motor is at which connector. A wrong one makes the motors run away.</source>
        <translation>Welcher Motor an welchem Anschluss ist. Eine falsche lässt die Motoren durchgehen.</translation>
    </message>
    <message>
        <source>Which sensor is at which bus. A wrong one makes the camera swing away.</source>
        <translation>Welcher Sensor an welchem Bus ist. Eine falsche lässt die Kamera ausschwenken.</translation>
    </message>
    <message>
        <source>Which sensor serves as the third one.</source>
        <translation>Welcher Sensor als dritter dient.</translation>
    </message>
    <message>
        <source>Whose remote control is imitated.</source>
        <translation>Wessen Fernauslöser nachgeahmt wird.</translation>
    </message>
    <message>
        <source>Within the limits of the sticks</source>
        <translation>In den Grenzen der Knüppel</translation>
    </message>
    <message>
        <source>Yaw (0 = middle)</source>
        <translation>Yaw (0 = Mitte)</translation>
    </message>
    <message>
        <source>Zeros and scales of both sensors.</source>
        <translation>Nullpunkte und Maßstäbe beider Sensoren.</translation>
    </message>
    <message>
        <source>absolute</source>
        <translation>absolut</translation>
    </message>
    <message>
        <source>absolute centered</source>
        <translation>absolut zentriert</translation>
    </message>
    <message>
        <source>advanced</source>
        <translation>erweitert</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>as set</source>
        <translation>wie eingestellt</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>basic</source>
        <translation>einfach</translation>
    </message>
    <message>
        <source>basic + accgyro</source>
        <translation>basic + accgyro</translation>
    </message>
    <message>
        <source>basic + accgyro_raw</source>
        <translation>basic + accgyro_raw</translation>
    </message>
    <message>
        <source>basic + pid</source>
        <translation>basic + pid</translation>
    </message>
    <message>
        <source>basic + pid + accgyro</source>
        <translation>basic + pid + accgyro</translation>
    </message>
    <message>
        <source>basic + pid + ag_raw</source>
        <translation>basic + pid + ag_raw</translation>
    </message>
    <message>
        <source>default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>abgeschaltet</translation>
    </message>
    <message>
        <source>emit heartbeat</source>
        <translation>Heartbeat senden</translation>
    </message>
    <message>
        <source>full</source>
        <translation>voll</translation>
    </message>
    <message>
        <source>full v1</source>
        <translation>full v1</translation>
    </message>
    <message>
        <source>full v1 xy</source>
        <translation>full v1 xy</translation>
    </message>
    <message>
        <source>full xy</source>
        <translation>full xy</translation>
    </message>
    <message>
        <source>heartbeat + attitude</source>
        <translation>Heartbeat + Lage</translation>
    </message>
    <message>
        <source>hold hold hold</source>
        <translation>hold hold hold</translation>
    </message>
    <message>
        <source>hold hold pan</source>
        <translation>hold hold pan</translation>
    </message>
    <message>
        <source>hold pan pan</source>
        <translation>hold pan pan</translation>
    </message>
    <message>
        <source>hott sumd</source>
        <translation>hott sumd</translation>
    </message>
    <message>
        <source>level</source>
        <translation>waagerecht</translation>
    </message>
    <message>
        <source>light</source>
        <translation>leicht</translation>
    </message>
    <message>
        <source>light xy</source>
        <translation>light xy</translation>
    </message>
    <message>
        <source>no heartbeat</source>
        <translation>kein Heartbeat</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>none, Imu2=on-board</source>
        <translation>keine, Imu2=auf dem Board</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>pan hold hold</source>
        <translation>pan hold hold</translation>
    </message>
    <message>
        <source>pan hold pan</source>
        <translation>pan hold pan</translation>
    </message>
    <message>
        <source>pan pan pan</source>
        <translation>pan pan pan</translation>
    </message>
    <message>
        <source>pitch yaw roll</source>
        <translation>pitch yaw roll</translation>
    </message>
    <message>
        <source>relative</source>
        <translation>relativ</translation>
    </message>
    <message>
        <source>relative turn around</source>
        <translation>relativ mit Umdrehen</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>umgekehrt</translation>
    </message>
    <message>
        <source>roll yaw pitch</source>
        <translation>roll yaw pitch</translation>
    </message>
    <message>
        <source>sbus</source>
        <translation>sbus</translation>
    </message>
    <message>
        <source>shutter</source>
        <translation>Auslöser</translation>
    </message>
    <message>
        <source>shutter delay</source>
        <translation>Auslöser verzögert</translation>
    </message>
    <message>
        <source>shutter-delayed</source>
        <translation>Auslöser verzögert</translation>
    </message>
    <message>
        <source>spektrum 10 bit</source>
        <translation>spektrum 10 bit</translation>
    </message>
    <message>
        <source>spektrum 11 bit</source>
        <translation>spektrum 11 bit</translation>
    </message>
    <message>
        <source>srxl</source>
        <translation>srxl</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>standard</translation>
    </message>
    <message>
        <source>startup pos</source>
        <translation>Startposition</translation>
    </message>
    <message>
        <source>sum ppm 10</source>
        <translation>sum ppm 10</translation>
    </message>
    <message>
        <source>sum ppm 12</source>
        <translation>sum ppm 12</translation>
    </message>
    <message>
        <source>sum ppm 6</source>
        <translation>sum ppm 6</translation>
    </message>
    <message>
        <source>sum ppm 7</source>
        <translation>sum ppm 7</translation>
    </message>
    <message>
        <source>sum ppm 8</source>
        <translation>sum ppm 8</translation>
    </message>
    <message>
        <source>video on/off</source>
        <translation>Video ein/aus</translation>
    </message>
    <message>
        <source>video-off</source>
        <translation>Video aus</translation>
    </message>
    <message>
        <source>video-on</source>
        <translation>Video ein</translation>
    </message>
    <message>
        <source>x0°</source>
        <translation>x0°</translation>
    </message>
    <message>
        <source>x180°</source>
        <translation>x180°</translation>
    </message>
    <message>
        <source>x270°</source>
        <translation>x270°</translation>
    </message>
    <message>
        <source>x90°</source>
        <translation>x90°</translation>
    </message>
    <message>
        <source>y0°</source>
        <translation>y0°</translation>
    </message>
    <message>
        <source>y180°</source>
        <translation>y180°</translation>
    </message>
    <message>
        <source>y270°</source>
        <translation>y270°</translation>
    </message>
    <message>
        <source>y90°</source>
        <translation>y90°</translation>
    </message>
    <message>
        <source>yaw pitch roll</source>
        <translation>yaw pitch roll</translation>
    </message>
    <message>
        <source>yaw roll pitch</source>
        <translation>yaw roll pitch</translation>
    </message>
    <message>
        <source>z0°</source>
        <translation>z0°</translation>
    </message>
    <message>
        <source>z180°</source>
        <translation>z180°</translation>
    </message>
    <message>
        <source>z270°</source>
        <translation>z270°</translation>
    </message>
    <message>
        <source>z90°</source>
        <translation>z90°</translation>
    </message>
    <message>
        <source>No effect while “%1” is “%2”.</source>
        <translation>Ohne Wirkung, solange „%1“ auf „%2“ steht.</translation>
    </message>
    <message>
        <source>All three motor usages become disabled; in RAM.</source>
        <translation>Alle drei Motoren werden stillgelegt; im RAM.</translation>
    </message>
    <message>
        <source>Auto lets the board find it at the next start; in RAM.</source>
        <translation>Mit „auto“ findet sie das Board beim nächsten Start; im RAM.</translation>
    </message>
    <message>
        <source>Average of a sensor</source>
        <translation>Mittelwert eines Sensors</translation>
    </message>
    <message>
        <source>Calibrate an accelerometer, one position</source>
        <translation>Beschleunigungssensor kalibrieren, eine Lage</translation>
    </message>
    <message>
        <source>Calibrate an accelerometer, six positions</source>
        <translation>Beschleunigungssensor kalibrieren, sechs Lagen</translation>
    </message>
    <message>
        <source>Compare with what is stored</source>
        <translation>Mit dem Gespeicherten vergleichen</translation>
    </message>
    <message>
        <source>Copies what the board has found and where the motors stand; in RAM.</source>
        <translation>Übernimmt, was das Board gefunden hat und wo die Motoren stehen; im RAM.</translation>
    </message>
    <message>
        <source>Direction of all motors</source>
        <translation>Richtung aller Motoren</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>Finds its zeros while it lies still on one face. Do it with the motors off, on USB power.</source>
        <translation>Findet seine Nullpunkte, während er still auf einer Fläche liegt. Mit Motoren aus, nur mit USB-Strom.</translation>
    </message>
    <message>
        <source>Hold the camera level, then tilt it 45° down. Sets the orientation of each sensor; in RAM.</source>
        <translation>Kamera waagerecht halten, dann 45° nach unten neigen. Setzt die Ausrichtung jedes Sensors; im RAM.</translation>
    </message>
    <message>
        <source>Imu</source>
        <translation>Imu</translation>
    </message>
    <message>
        <source>Imu2</source>
        <translation>Imu2</translation>
    </message>
    <message>
        <source>Input of script %1</source>
        <translation>Eingang von Skript %1</translation>
    </message>
    <message>
        <source>Magnets in the bells, even numbers; in RAM.</source>
        <translation>Magnete in den Glocken, gerade Zahlen; im RAM.</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>Reloads what is stored for a moment, puts what is in use back and tells what differs.</source>
        <translation>Lädt für einen Moment das Gespeicherte, setzt das Verwendete zurück und sagt, was sich unterscheidet.</translation>
    </message>
    <message>
        <source>Scale X</source>
        <translation>Maßstab X</translation>
    </message>
    <message>
        <source>Scale Y</source>
        <translation>Maßstab Y</translation>
    </message>
    <message>
        <source>Scale Z</source>
        <translation>Maßstab Z</translation>
    </message>
    <message>
        <source>Set up: begin to align yaw</source>
        <translation>Einrichten: Yaw ausrichten beginnen</translation>
    </message>
    <message>
        <source>Set up: direction of all motors</source>
        <translation>Einrichten: Richtung aller Motoren</translation>
    </message>
    <message>
        <source>Set up: disable the motors</source>
        <translation>Einrichten: Motoren stilllegen</translation>
    </message>
    <message>
        <source>Set up: enable the motors and start</source>
        <translation>Einrichten: Motoren freigeben und starten</translation>
    </message>
    <message>
        <source>Set up: end aligning yaw</source>
        <translation>Einrichten: Yaw ausrichten beenden</translation>
    </message>
    <message>
        <source>Set up: find the orientation of the sensors</source>
        <translation>Einrichten: Ausrichtung der Sensoren finden</translation>
    </message>
    <message>
        <source>Set up: poles of the motors</source>
        <translation>Einrichten: Pole der Motoren</translation>
    </message>
    <message>
        <source>Set up: take directions and start positions</source>
        <translation>Einrichten: Richtungen und Startlagen übernehmen</translation>
    </message>
    <message>
        <source>Set up: turn yaw</source>
        <translation>Einrichten: Yaw drehen</translation>
    </message>
    <message>
        <source>Start positions</source>
        <translation>Startlagen</translation>
    </message>
    <message>
        <source>Steers yaw by its offset only.</source>
        <translation>Steuert Yaw nur über seinen Versatz.</translation>
    </message>
    <message>
        <source>Stick positions</source>
        <translation>Knüppelstellungen</translation>
    </message>
    <message>
        <source>Store the result</source>
        <translation>Ergebnis speichern</translation>
    </message>
    <message>
        <source>Take the position over</source>
        <translation>Lage übernehmen</translation>
    </message>
    <message>
        <source>Takes where yaw stands as its start position; in RAM.</source>
        <translation>Übernimmt, wo Yaw steht, als Startlage; im RAM.</translation>
    </message>
    <message>
        <source>Turns the camera to this angle.</source>
        <translation>Dreht die Kamera auf diesen Winkel.</translation>
    </message>
    <message>
        <source>Waits for the battery, starts the board and waits until it works normally.</source>
        <translation>Wartet auf den Akku, startet das Board und wartet, bis es normal arbeitet.</translation>
    </message>
    <message>
        <source>What an accelerometer shows over many readings, in counts.</source>
        <translation>Was ein Beschleunigungssensor über viele Messwerte zeigt, in Zählwerten.</translation>
    </message>
    <message>
        <source>Write a calibration</source>
        <translation>Kalibrierung schreiben</translation>
    </message>
    <message>
        <source>Zero X</source>
        <translation>Nullpunkt X</translation>
    </message>
    <message>
        <source>Zero Y</source>
        <translation>Nullpunkt Y</translation>
    </message>
    <message>
        <source>Zero Z</source>
        <translation>Nullpunkt Z</translation>
    </message>
    <message>
        <source>Zeros and scales of one accelerometer; stored at once.</source>
        <translation>Nullpunkte und Maßstäbe eines Beschleunigungssensors; sofort gespeichert.</translation>
    </message>
    <message>
        <source>This board sends a MAVLink heartbeat and therefore answers no plain commands on this port. It is reached through MAVLink: that is slower, and scripts cannot be read.</source>
        <translation>Dieses Board sendet einen MAVLink-Heartbeat und antwortet an diesem Anschluss deshalb nicht auf einfache Befehle. Es wird über MAVLink erreicht: das ist langsamer, und Skripte sind nicht lesbar.</translation>
    </message>
    <message>
        <source>start motors</source>
        <translation>Motoren starten</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>beruhigen</translation>
    </message>
    <message>
        <source>find motor directions</source>
        <translation>Motorrichtungen finden</translation>
    </message>
    <message>
        <source>relevel</source>
        <translation>neu richten</translation>
    </message>
    <message>
        <source>standby</source>
        <translation>Bereitschaft</translation>
    </message>
    <message>
        <source>fast level</source>
        <translation>schnell richten</translation>
    </message>
    <message>
        <source>service mode</source>
        <translation>Wartung</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Camera sensor</source>
        <translation>Kamerasensor</translation>
    </message>
    <message>
        <source>Frame sensor</source>
        <translation>Rahmensensor</translation>
    </message>
    <message>
        <source>on the board</source>
        <translation>auf dem Board</translation>
    </message>
    <message>
        <source>external</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>Magnetometer</source>
        <translation>Magnetometer</translation>
    </message>
    <message>
        <source>unused</source>
        <translation>unbenutzt</translation>
    </message>
    <message>
        <source>STorM32-Link</source>
        <translation>STorM32-Link</translation>
    </message>
    <message>
        <source>Following axes</source>
        <translation>Folgende Achsen</translation>
    </message>
    <message>
        <source>Re-centering</source>
        <translation>Kehrt zur Mitte</translation>
    </message>
    <message>
        <source>IR camera</source>
        <translation>IR-Kamera</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>Input of pan mode</source>
        <translation>Eingang Pan-Modus</translation>
    </message>
    <message>
        <source>Input of standby</source>
        <translation>Eingang Bereitschaft</translation>
    </message>
    <message>
        <source>Input of IR camera</source>
        <translation>Eingang IR-Kamera</translation>
    </message>
    <message>
        <source>Input of re-center</source>
        <translation>Eingang Re-center</translation>
    </message>
    <message>
        <source>Input of script 1</source>
        <translation>Eingang Skript 1</translation>
    </message>
    <message>
        <source>Input of script 2</source>
        <translation>Eingang Skript 2</translation>
    </message>
    <message>
        <source>Input of script 3</source>
        <translation>Eingang Skript 3</translation>
    </message>
    <message>
        <source>Input of script 4</source>
        <translation>Eingang Skript 4</translation>
    </message>
    <message>
        <source>it is too long</source>
        <translation>es ist zu lang</translation>
    </message>
    <message>
        <source>a quote is not closed</source>
        <translation>ein Anführungszeichen ist nicht geschlossen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a statement</source>
        <translation>„%1“ ist keine Anweisung</translation>
    </message>
    <message>
        <source>%1 is shown only; use %2</source>
        <translation>%1 wird nur angezeigt; nehmen Sie %2</translation>
    </message>
    <message>
        <source>firmware 0.%1 does not know %2</source>
        <translation>Firmware 0.%1 kennt %2 nicht</translation>
    </message>
    <message>
        <source>%1 takes %2 values, not %3</source>
        <translation>%1 hat %2 Werte, nicht %3</translation>
    </message>
    <message>
        <source>%1 is there already</source>
        <translation>%1 ist schon da</translation>
    </message>
    <message>
        <source>%1 has to come before %2</source>
        <translation>%1 muss vor %2 stehen</translation>
    </message>
    <message>
        <source>there is no parameter “%1”</source>
        <translation>es gibt keinen Parameter „%1“</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has to be a whole number</source>
        <translation>„%1“ muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>%1 is outside %2 to %3</source>
        <translation>%1 liegt außerhalb von %2 bis %3</translation>
    </message>
    <message>
        <source>with it the scripts need %1 bytes; there are %2</source>
        <translation>mit ihm brauchen die Skripte %1 Bytes; es gibt %2</translation>
    </message>
    <message>
        <source>Sets all motors to normal use and restarts: the motors start.</source>
        <translation>Setzt alle Motoren auf normale Verwendung und startet neu: die Motoren laufen an.</translation>
    </message>
    <message>
        <source>no number</source>
        <translation>keine Zahl</translation>
    </message>
    <message>
        <source>Steers like a receiver would: 700 to 2300 µs, 0 for the middle. An axis without a value stays as it is.</source>
        <translation>Steuert wie ein Empfänger: 700 bis 2300 µs, 0 für die Mitte. Eine Achse ohne Wert bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>all profiles</source>
        <translation>alle Profile</translation>
    </message>
    <message>
        <source>Changes a value in volatile memory; lost at the next start unless stored.</source>
        <translation>Ändert einen Wert im flüchtigen Speicher; beim nächsten Start verloren, wenn nicht gespeichert.</translation>
    </message>
    <message>
        <source>Menu button, five presses</source>
        <translation>Menütaste, fünfmal drücken</translation>
    </message>
    <message>
        <source>Menu button, four presses</source>
        <translation>Menütaste, viermal drücken</translation>
    </message>
    <message>
        <source>Menu button, one press</source>
        <translation>Menütaste, einmal drücken</translation>
    </message>
    <message>
        <source>Menu button, three presses</source>
        <translation>Menütaste, dreimal drücken</translation>
    </message>
    <message>
        <source>Menu button, two presses</source>
        <translation>Menütaste, zweimal drücken</translation>
    </message>
    <message>
        <source>Revert all values</source>
        <translation>Alle Werte zurücknehmen</translation>
    </message>
    <message>
        <source>Revert one value</source>
        <translation>Einen Wert zurücknehmen</translation>
    </message>
    <message>
        <source>Store variables</source>
        <translation>Variablen speichern</translation>
    </message>
    <message>
        <source>Stores all values in use, scripts included.</source>
        <translation>Speichert alle Werte in Gebrauch, samt Skripten.</translation>
    </message>
    <message>
        <source>Virtual channel 1</source>
        <translation>Virtueller Kanal 1</translation>
    </message>
    <message>
        <source>Virtual channel 10</source>
        <translation>Virtueller Kanal 10</translation>
    </message>
    <message>
        <source>Virtual channel 11</source>
        <translation>Virtueller Kanal 11</translation>
    </message>
    <message>
        <source>Virtual channel 12</source>
        <translation>Virtueller Kanal 12</translation>
    </message>
    <message>
        <source>Virtual channel 13</source>
        <translation>Virtueller Kanal 13</translation>
    </message>
    <message>
        <source>Virtual channel 14</source>
        <translation>Virtueller Kanal 14</translation>
    </message>
    <message>
        <source>Virtual channel 15</source>
        <translation>Virtueller Kanal 15</translation>
    </message>
    <message>
        <source>Virtual channel 16</source>
        <translation>Virtueller Kanal 16</translation>
    </message>
    <message>
        <source>Virtual channel 17</source>
        <translation>Virtueller Kanal 17</translation>
    </message>
    <message>
        <source>Virtual channel 18</source>
        <translation>Virtueller Kanal 18</translation>
    </message>
    <message>
        <source>Virtual channel 19</source>
        <translation>Virtueller Kanal 19</translation>
    </message>
    <message>
        <source>Virtual channel 2</source>
        <translation>Virtueller Kanal 2</translation>
    </message>
    <message>
        <source>Virtual channel 20</source>
        <translation>Virtueller Kanal 20</translation>
    </message>
    <message>
        <source>Virtual channel 21</source>
        <translation>Virtueller Kanal 21</translation>
    </message>
    <message>
        <source>Virtual channel 22</source>
        <translation>Virtueller Kanal 22</translation>
    </message>
    <message>
        <source>Virtual channel 23</source>
        <translation>Virtueller Kanal 23</translation>
    </message>
    <message>
        <source>Virtual channel 24</source>
        <translation>Virtueller Kanal 24</translation>
    </message>
    <message>
        <source>Virtual channel 25</source>
        <translation>Virtueller Kanal 25</translation>
    </message>
    <message>
        <source>Virtual channel 26</source>
        <translation>Virtueller Kanal 26</translation>
    </message>
    <message>
        <source>Virtual channel 27</source>
        <translation>Virtueller Kanal 27</translation>
    </message>
    <message>
        <source>Virtual channel 28</source>
        <translation>Virtueller Kanal 28</translation>
    </message>
    <message>
        <source>Virtual channel 29</source>
        <translation>Virtueller Kanal 29</translation>
    </message>
    <message>
        <source>Virtual channel 3</source>
        <translation>Virtueller Kanal 3</translation>
    </message>
    <message>
        <source>Virtual channel 30</source>
        <translation>Virtueller Kanal 30</translation>
    </message>
    <message>
        <source>Virtual channel 31</source>
        <translation>Virtueller Kanal 31</translation>
    </message>
    <message>
        <source>Virtual channel 32</source>
        <translation>Virtueller Kanal 32</translation>
    </message>
    <message>
        <source>Virtual channel 4</source>
        <translation>Virtueller Kanal 4</translation>
    </message>
    <message>
        <source>Virtual channel 5</source>
        <translation>Virtueller Kanal 5</translation>
    </message>
    <message>
        <source>Virtual channel 6</source>
        <translation>Virtueller Kanal 6</translation>
    </message>
    <message>
        <source>Virtual channel 7</source>
        <translation>Virtueller Kanal 7</translation>
    </message>
    <message>
        <source>Virtual channel 8</source>
        <translation>Virtueller Kanal 8</translation>
    </message>
    <message>
        <source>Virtual channel 9</source>
        <translation>Virtueller Kanal 9</translation>
    </message>
    <message>
        <source>Virtual channel whose signal is put out on this servo pin.</source>
        <translation>Virtueller Kanal, dessen Signal an diesem Servopin ausgegeben wird.</translation>
    </message>
    <message>
        <source>Word %1</source>
        <translation>Wort %1</translation>
    </message>
    <message>
        <source>Finds zeros and scales; each face has to lie up once. Switches the motors off and leaves them off: hold the camera.</source>
        <translation>Findet Nullpunkte und Skalierungen; jede Seite muss einmal oben liegen. Schaltet die Motoren aus und lässt sie aus: Halten Sie die Kamera fest.</translation>
    </message>
    <message>
        <source>Measures the accelerometer in this position. The sensor must be still, and level unless it is one of six positions: for those the motors are switched off and left off, so hold the camera.</source>
        <translation>Misst den Beschleunigungssensor in dieser Lage. Der Sensor muss still liegen, und waagerecht, wenn es nicht eine von sechs Lagen ist: Für diese werden die Motoren ausgeschaltet und bleiben aus, halten Sie also die Kamera fest.</translation>
    </message>
    <message>
        <source>One of six positions, motors off</source>
        <translation>Eine von sechs Lagen, Motoren aus</translation>
    </message>
    <message>
        <source>“%1” cannot be %2</source>
        <translation>„%1“ kann nicht %2 sein</translation>
    </message>
    <message>
        <source>Start motors</source>
        <translation>Motoren starten</translation>
    </message>
    <message>
        <source>Stop motors</source>
        <translation>Motoren stoppen</translation>
    </message>
    <message>
        <source>Ends a search of gains that may still be going on, and proves it.</source>
        <translation>Beendet eine Suche nach Verstärkungen, die womöglich noch läuft, und weist das nach.</translation>
    </message>
    <message>
        <source>Like switching off and on: motors go off, then start by themselves.</source>
        <translation>Wie Aus- und Einschalten: Die Motoren gehen aus und laufen dann von selbst an.</translation>
    </message>
    <message>
        <source>Restarts the controller with the stored values; motors go off, then start by themselves.</source>
        <translation>Startet den Controller mit den gespeicherten Werten neu; die Motoren gehen aus und laufen dann von selbst an.</translation>
    </message>
    <message>
        <source>Restarts the controller; motors go off, and may start by themselves afterwards.</source>
        <translation>Startet den Controller neu; die Motoren gehen aus und laufen danach vielleicht von selbst an.</translation>
    </message>
    <message>
        <source>Stop auto-tune</source>
        <translation>Auto-Abstimmung beenden</translation>
    </message>
    <message>
        <source>a board cannot hold %1: the nearest is %2</source>
        <translation>ein Board kann %1 nicht halten: am nächsten ist %2</translation>
    </message>
    <message>
        <source>Emergency stop: CAN bus off, inside</source>
        <translation>Not-Halt: CAN-Bus innen abgeschaltet</translation>
    </message>
    <message>
        <source>Emergency stop: CAN bus off, outside</source>
        <translation>Not-Halt: CAN-Bus außen abgeschaltet</translation>
    </message>
    <message>
        <source>Emergency stop: CAN driver does not answer</source>
        <translation>Not-Halt: CAN-Treiber antwortet nicht</translation>
    </message>
    <message>
        <source>Emergency stop: CAN driver: controller too hot</source>
        <translation>Not-Halt: CAN-Treiber: Controller zu heiß</translation>
    </message>
    <message>
        <source>Emergency stop: CAN driver: emergency pin</source>
        <translation>Not-Halt: CAN-Treiber: Not-Aus-Eingang</translation>
    </message>
    <message>
        <source>Emergency stop: CAN driver: field-oriented control</source>
        <translation>Not-Halt: CAN-Treiber: feldorientierte Regelung</translation>
    </message>
    <message>
        <source>Emergency stop: CAN driver: lasting over-current</source>
        <translation>Not-Halt: CAN-Treiber: anhaltender Überstrom</translation>
    </message>
    <message>
        <source>Emergency stop: CAN driver: motor too hot</source>
        <translation>Not-Halt: CAN-Treiber: Motor zu heiß</translation>
    </message>
    <message>
        <source>Emergency stop: CAN driver: over-current</source>
        <translation>Not-Halt: CAN-Treiber: Überstrom</translation>
    </message>
    <message>
        <source>Emergency stop: CAN driver: parameters</source>
        <translation>Not-Halt: CAN-Treiber: Parameter</translation>
    </message>
    <message>
        <source>Emergency stop: CAN driver: several faults</source>
        <translation>Not-Halt: CAN-Treiber: mehrere Fehler</translation>
    </message>
    <message>
        <source>Emergency stop: CAN driver: under-voltage</source>
        <translation>Not-Halt: CAN-Treiber: Unterspannung</translation>
    </message>
    <message>
        <source>Emergency stop: analogue inputs</source>
        <translation>Not-Halt: Analogeingänge</translation>
    </message>
    <message>
        <source>Emergency stop: battery setting</source>
        <translation>Not-Halt: Akku-Einstellung</translation>
    </message>
    <message>
        <source>Emergency stop: calibration of the driver</source>
        <translation>Not-Halt: Kalibrierung des Treibers</translation>
    </message>
    <message>
        <source>Emergency stop: calibration with motors off</source>
        <translation>Not-Halt: Kalibrierung bei ausgeschalteten Motoren</translation>
    </message>
    <message>
        <source>Emergency stop: clock crystal</source>
        <translation>Not-Halt: Taktquarz</translation>
    </message>
    <message>
        <source>Emergency stop: data of the encoder too late</source>
        <translation>Not-Halt: Encoderdaten zu spät</translation>
    </message>
    <message>
        <source>Emergency stop: driver licence</source>
        <translation>Not-Halt: Lizenz des Treibers</translation>
    </message>
    <message>
        <source>Emergency stop: encoder missing</source>
        <translation>Not-Halt: Encoder fehlt</translation>
    </message>
    <message>
        <source>Emergency stop: encoder type</source>
        <translation>Not-Halt: Encodertyp</translation>
    </message>
    <message>
        <source>Emergency stop: external IMU lost</source>
        <translation>Not-Halt: externe IMU verloren</translation>
    </message>
    <message>
        <source>Emergency stop: frame IMU lost</source>
        <translation>Not-Halt: Rahmen-IMU verloren</translation>
    </message>
    <message>
        <source>Emergency stop: link on the CAN bus lost</source>
        <translation>Not-Halt: Verbindung am CAN-Bus verloren</translation>
    </message>
    <message>
        <source>Emergency stop: magnetometer lost</source>
        <translation>Not-Halt: Magnetometer verloren</translation>
    </message>
    <message>
        <source>Emergency stop: not in its normal position</source>
        <translation>Not-Halt: nicht in normaler Lage</translation>
    </message>
    <message>
        <source>Emergency stop: over-current</source>
        <translation>Not-Halt: Überstrom</translation>
    </message>
    <message>
        <source>Emergency stop: over-speed</source>
        <translation>Not-Halt: Überdrehzahl</translation>
    </message>
    <message>
        <source>Emergency stop: parameters of the external IMU</source>
        <translation>Not-Halt: Parameter der externen IMU</translation>
    </message>
    <message>
        <source>Emergency stop: parameters were changed</source>
        <translation>Not-Halt: Parameter wurden geändert</translation>
    </message>
    <message>
        <source>Emergency stop: self-calibration of the encoder</source>
        <translation>Not-Halt: Selbstkalibrierung des Encoders</translation>
    </message>
    <message>
        <source>Emergency stop: serial number on the CAN bus</source>
        <translation>Not-Halt: Seriennummer am CAN-Bus</translation>
    </message>
    <message>
        <source>Emergency stop: serial numbers on the CAN bus differ</source>
        <translation>Not-Halt: Seriennummern am CAN-Bus verschieden</translation>
    </message>
    <message>
        <source>Emergency stop: stage of the driver&apos;s start</source>
        <translation>Not-Halt: Startstufe des Treibers</translation>
    </message>
    <message>
        <source>Emergency stop: start of the motor driver</source>
        <translation>Not-Halt: Start des Motortreibers</translation>
    </message>
    <message>
        <source>Emergency stop: stored parameters</source>
        <translation>Not-Halt: gespeicherte Parameter</translation>
    </message>
    <message>
        <source>Emergency stop: stored variables</source>
        <translation>Not-Halt: gespeicherte Variablen</translation>
    </message>
    <message>
        <source>Emergency stop: time-out</source>
        <translation>Not-Halt: Zeitüberschreitung</translation>
    </message>
    <message>
        <source>Emergency stop: type of the external IMU</source>
        <translation>Not-Halt: Typ der externen IMU</translation>
    </message>
    <message>
        <source>Emergency stop: unsafe voltage</source>
        <translation>Not-Halt: unsichere Spannung</translation>
    </message>
    <message>
        <source>Emergency stop: version on the CAN bus</source>
        <translation>Not-Halt: Version am CAN-Bus</translation>
    </message>
    <message>
        <source>Emergency stop: watchdog</source>
        <translation>Not-Halt: Watchdog</translation>
    </message>
    <message>
        <source>The board says that it switches the motors off then.</source>
        <translation>Das Board schaltet dann nach eigenen Angaben die Motoren aus.</translation>
    </message>
    <message>
        <source>The motor drivers switch off to save themselves.</source>
        <translation>Die Motortreiber schalten ab, um sich zu schützen.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>not present</source>
        <translation>nicht vorhanden</translation>
    </message>
    <message>
        <source>A step of its own table, from 1.</source>
        <translation>Eine Stufe seiner eigenen Tabelle, ab 1.</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Acceleration x</source>
        <translation>Beschleunigung x</translation>
    </message>
    <message>
        <source>Acceleration y</source>
        <translation>Beschleunigung y</translation>
    </message>
    <message>
        <source>Acceleration z</source>
        <translation>Beschleunigung z</translation>
    </message>
    <message>
        <source>All motors get full throttle for 8 s. The drone hears nothing for 26 s, also no stop.</source>
        <translation>Alle Motoren bekommen 8 s lang Vollgas. Die Drohne hört 26 s lang nichts, auch keinen Stopp.</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>Armed, calibrated, battery, link.</source>
        <translation>Scharf, kalibriert, Akku, Verbindung.</translation>
    </message>
    <message>
        <source>At 5 % for 5 s. The drone hears nothing for 8 s, also no stop.</source>
        <translation>Mit 5 % für 5 s. Die Drohne hört 8 s lang nichts, auch keinen Stopp.</translation>
    </message>
    <message>
        <source>Attitude</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Attitude and sensors in each packet.</source>
        <translation>Lage und Sensoren in jedem Paket.</translation>
    </message>
    <message>
        <source>Band</source>
        <translation>Band</translation>
    </message>
    <message>
        <source>Band and channel.</source>
        <translation>Band und Kanal.</translation>
    </message>
    <message>
        <source>Battery level</source>
        <translation>Akkustand</translation>
    </message>
    <message>
        <source>Boscam A</source>
        <translation>Boscam A</translation>
    </message>
    <message>
        <source>Boscam B</source>
        <translation>Boscam B</translation>
    </message>
    <message>
        <source>Boscam E</source>
        <translation>Boscam E</translation>
    </message>
    <message>
        <source>Calibrate all sensors</source>
        <translation>Alle Sensoren kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate motor controllers</source>
        <translation>Motorregler kalibrieren</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>Kalibriert</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>Wird kalibriert</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Camera settings</source>
        <translation>Kameraeinstellungen</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Change the picture</source>
        <translation>Bild ändern</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Channel and power.</source>
        <translation>Kanal und Leistung.</translation>
    </message>
    <message>
        <source>Charge drawn</source>
        <translation>Entnommene Ladung</translation>
    </message>
    <message>
        <source>Configuration</source>
        <translation>Konfiguration</translation>
    </message>
    <message>
        <source>Configuration text</source>
        <translation>Konfigurationstext</translation>
    </message>
    <message>
        <source>Confirmed by the drone, and not applied.</source>
        <translation>Von der Drohne bestätigt und nicht angewendet.</translation>
    </message>
    <message>
        <source>Control loop</source>
        <translation>Regelschleife</translation>
    </message>
    <message>
        <source>Counts the charge from 0 and the cells anew.</source>
        <translation>Zählt die Ladung ab 0 und die Zellen neu.</translation>
    </message>
    <message>
        <source>Disarmed</source>
        <translation>Entschärft</translation>
    </message>
    <message>
        <source>Disarms and stops all motors, in flight as well: it falls.</source>
        <translation>Entschärft sie und hält alle Motoren an, auch im Flug: sie fällt.</translation>
    </message>
    <message>
        <source>Drone</source>
        <translation>Drohne</translation>
    </message>
    <message>
        <source>FatShark</source>
        <translation>FatShark</translation>
    </message>
    <message>
        <source>Flight mode</source>
        <translation>Flugmodus</translation>
    </message>
    <message>
        <source>Full telemetry</source>
        <translation>Volle Telemetrie</translation>
    </message>
    <message>
        <source>Gyro x</source>
        <translation>Gyro x</translation>
    </message>
    <message>
        <source>Gyro y</source>
        <translation>Gyro y</translation>
    </message>
    <message>
        <source>Gyro z</source>
        <translation>Gyro z</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Horizon</source>
        <translation>Horizont</translation>
    </message>
    <message>
        <source>How hard they work against a change of the rate. In the drone&apos;s own numbers.</source>
        <translation>Wie stark sie gegen eine Änderung der Drehrate arbeiten. In den Zahlen der Drohne.</translation>
    </message>
    <message>
        <source>How hard they work against an error that stays. In the drone&apos;s own numbers.</source>
        <translation>Wie stark sie gegen einen bleibenden Fehler arbeiten. In den Zahlen der Drohne.</translation>
    </message>
    <message>
        <source>Keeps the present one.</source>
        <translation>Behält den jetzigen.</translation>
    </message>
    <message>
        <source>Let it lie level and still.</source>
        <translation>Waagerecht und ruhig liegen lassen.</translation>
    </message>
    <message>
        <source>Let it lie still. A drone without a full calibration does that one instead.</source>
        <translation>Ruhig liegen lassen. Eine Drohne ohne vollständige Kalibrierung macht stattdessen diese.</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Lock white balance</source>
        <translation>Weißabgleich festhalten</translation>
    </message>
    <message>
        <source>Magnetometer x</source>
        <translation>Magnetometer x</translation>
    </message>
    <message>
        <source>Magnetometer y</source>
        <translation>Magnetometer y</translation>
    </message>
    <message>
        <source>Magnetometer z</source>
        <translation>Magnetometer z</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Motor 1</source>
        <translation>Motor 1</translation>
    </message>
    <message>
        <source>Motor 2</source>
        <translation>Motor 2</translation>
    </message>
    <message>
        <source>Motor 3</source>
        <translation>Motor 3</translation>
    </message>
    <message>
        <source>Motor 4</source>
        <translation>Motor 4</translation>
    </message>
    <message>
        <source>Motor 5</source>
        <translation>Motor 5</translation>
    </message>
    <message>
        <source>Motor 6</source>
        <translation>Motor 6</translation>
    </message>
    <message>
        <source>Motor 7</source>
        <translation>Motor 7</translation>
    </message>
    <message>
        <source>Motor 8</source>
        <translation>Motor 8</translation>
    </message>
    <message>
        <source>Motors driven</source>
        <translation>Motoren angetrieben</translation>
    </message>
    <message>
        <source>Names and sizes of what the drone has recorded.</source>
        <translation>Namen und Größen dessen, was die Drohne aufgenommen hat.</translation>
    </message>
    <message>
        <source>New battery</source>
        <translation>Neuer Akku</translation>
    </message>
    <message>
        <source>Next white balance</source>
        <translation>Nächster Weißabgleich</translation>
    </message>
    <message>
        <source>Not calibrated</source>
        <translation>Nicht kalibriert</translation>
    </message>
    <message>
        <source>Notch spectrum pitch</source>
        <translation>Kerbspektrum Pitch</translation>
    </message>
    <message>
        <source>Notch spectrum roll</source>
        <translation>Kerbspektrum Roll</translation>
    </message>
    <message>
        <source>Notch spectrum yaw</source>
        <translation>Kerbspektrum Yaw</translation>
    </message>
    <message>
        <source>Outer D</source>
        <translation>Äußeres D</translation>
    </message>
    <message>
        <source>Pitch rate</source>
        <translation>Drehrate Pitch</translation>
    </message>
    <message>
        <source>Pitch rate for D</source>
        <translation>Drehrate Pitch für D</translation>
    </message>
    <message>
        <source>Processor load</source>
        <translation>Prozessorlast</translation>
    </message>
    <message>
        <source>Processor temperature</source>
        <translation>Prozessortemperatur</translation>
    </message>
    <message>
        <source>RaceBand</source>
        <translation>RaceBand</translation>
    </message>
    <message>
        <source>Rate controller</source>
        <translation>Drehratenregler</translation>
    </message>
    <message>
        <source>Rates</source>
        <translation>Drehraten</translation>
    </message>
    <message>
        <source>Receive level</source>
        <translation>Empfangspegel</translation>
    </message>
    <message>
        <source>Receive quality</source>
        <translation>Empfangsqualität</translation>
    </message>
    <message>
        <source>Record on the drone</source>
        <translation>Auf der Drohne aufnehmen</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Roll rate</source>
        <translation>Drehrate Roll</translation>
    </message>
    <message>
        <source>Roll rate for D</source>
        <translation>Drehrate Roll für D</translation>
    </message>
    <message>
        <source>Sensitivity and shutter.</source>
        <translation>Empfindlichkeit und Belichtungszeit.</translation>
    </message>
    <message>
        <source>Set channel</source>
        <translation>Kanal setzen</translation>
    </message>
    <message>
        <source>Set clock</source>
        <translation>Uhr stellen</translation>
    </message>
    <message>
        <source>Set power</source>
        <translation>Leistung setzen</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Stabilised also starts the attitude anew.</source>
        <translation>Stabilisiert beginnt auch die Lage neu.</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Store gains</source>
        <translation>Verstärkungen speichern</translation>
    </message>
    <message>
        <source>Switches to the next one and tells which.</source>
        <translation>Schaltet zum nächsten und sagt, welcher es ist.</translation>
    </message>
    <message>
        <source>System</source>
        <translation>System</translation>
    </message>
    <message>
        <source>Test bench</source>
        <translation>Prüfstand</translation>
    </message>
    <message>
        <source>The drone confirms these gains, and does not apply them: today&apos;s firmware always reports 0. They stand in the configuration text.</source>
        <translation>Die Drohne bestätigt diese Verstärkungen und wendet sie nicht an: die heutige Firmware meldet immer 0. Sie stehen im Konfigurationstext.</translation>
    </message>
    <message>
        <source>The drone confirms whatever it does.</source>
        <translation>Die Drohne bestätigt es, was sie auch tut.</translation>
    </message>
    <message>
        <source>The propellers are off</source>
        <translation>Die Propeller sind abgenommen</translation>
    </message>
    <message>
        <source>Thrust</source>
        <translation>Schub</translation>
    </message>
    <message>
        <source>To the time of this computer.</source>
        <translation>Auf die Zeit dieses Rechners.</translation>
    </message>
    <message>
        <source>Turn one motor</source>
        <translation>Einen Motor drehen</translation>
    </message>
    <message>
        <source>Until it is switched off.</source>
        <translation>Bis es abgeschaltet wird.</translation>
    </message>
    <message>
        <source>Video transmitter</source>
        <translation>Videosender</translation>
    </message>
    <message>
        <source>What the drone takes for level is turned by this. It forgets it when it restarts.</source>
        <translation>Um so viel wird verdreht, was die Drohne für waagerecht hält. Beim Neustart vergisst sie es.</translation>
    </message>
    <message>
        <source>What the drone tells of its board.</source>
        <translation>Was die Drohne über ihr Board sagt.</translation>
    </message>
    <message>
        <source>What the drone tells of its cameras.</source>
        <translation>Was die Drohne über ihre Kameras sagt.</translation>
    </message>
    <message>
        <source>What the drone tells of its sensors.</source>
        <translation>Was die Drohne über ihre Sensoren sagt.</translation>
    </message>
    <message>
        <source>Writes the gains in use into the configuration text, one number each, and uploads it: the drone restarts.</source>
        <translation>Schreibt die benutzten Verstärkungen in den Konfigurationstext, je eine Zahl, und lädt ihn hoch: die Drohne startet neu.</translation>
    </message>
    <message>
        <source>Yaw rate</source>
        <translation>Drehrate Yaw</translation>
    </message>
    <message>
        <source>Yaw rate for D</source>
        <translation>Drehrate Yaw für D</translation>
    </message>
    <message>
        <source>brightness.down</source>
        <translation>dunkler</translation>
    </message>
    <message>
        <source>brightness.up</source>
        <translation>heller</translation>
    </message>
    <message>
        <source>calibrating</source>
        <translation>kalibriert gerade</translation>
    </message>
    <message>
        <source>contrast.down</source>
        <translation>weniger Kontrast</translation>
    </message>
    <message>
        <source>contrast.up</source>
        <translation>mehr Kontrast</translation>
    </message>
    <message>
        <source>drone</source>
        <translation>Drohne</translation>
    </message>
    <message>
        <source>iso.down</source>
        <translation>unempfindlicher</translation>
    </message>
    <message>
        <source>iso.up</source>
        <translation>empfindlicher</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>Drehrate</translation>
    </message>
    <message>
        <source>saturation.down</source>
        <translation>weniger Sättigung</translation>
    </message>
    <message>
        <source>saturation.up</source>
        <translation>mehr Sättigung</translation>
    </message>
    <message>
        <source>stabilised</source>
        <translation>stabilisiert</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Replaces the drone&apos;s program by a file, and restarts it. Broken off, its stream is silent until it is switched off and on.</source>
        <translation>Ersetzt das Programm der Drohne durch eine Datei und startet sie neu. Nach einem Abbruch schweigt ihr Datenstrom, bis sie aus- und eingeschaltet wird.</translation>
    </message>
    <message>
        <source>The file was made for this drone, and its battery lasts</source>
        <translation>Die Datei ist für diese Drohne gemacht, und ihr Akku hält durch</translation>
    </message>
    <message>
        <source>Upload firmware</source>
        <translation>Firmware hochladen</translation>
    </message>
    <message>
        <source>a zero byte</source>
        <translation>ein Null-Byte</translation>
    </message>
    <message>
        <source>there is no memory to check the text</source>
        <translation>es gibt keinen Speicher, um den Text zu prüfen</translation>
    </message>
    <message>
        <source>the drone&apos;s Lua does not know \u{}</source>
        <translation>das Lua der Drohne kennt \u{} nicht</translation>
    </message>
    <message>
        <source>How hard the motors work against an error of the rate. In the drone&apos;s own numbers: the value of the configuration text times its scale.</source>
        <translation>Wie stark die Motoren einem Fehler der Drehrate entgegenarbeiten. In den eigenen Zahlen der Drohne: der Wert des Konfigurationstexts mal seinem Faktor.</translation>
    </message>
    <message>
        <source>Base and strength count in 32nds. Kept only if all six of them are other than 0. Today&apos;s driver does nothing.</source>
        <translation>Basis und Stärke zählen in Zweiunddreißigsteln. Sie werden nur behalten, wenn alle sechs ungleich 0 sind. Der heutige Treiber tut nichts.</translation>
    </message>
    <message>
        <source>Blue, base</source>
        <translation>Blau, Basis</translation>
    </message>
    <message>
        <source>Blue, radius</source>
        <translation>Blau, Radius</translation>
    </message>
    <message>
        <source>Blue, strength</source>
        <translation>Blau, Stärke</translation>
    </message>
    <message>
        <source>By one step; what it is cannot be read. Today&apos;s driver does nothing for the shutter.</source>
        <translation>Um eine Stufe; der Wert lässt sich nicht auslesen. Für den Verschluss tut der heutige Treiber nichts.</translation>
    </message>
    <message>
        <source>Green, base</source>
        <translation>Grün, Basis</translation>
    </message>
    <message>
        <source>Green, radius</source>
        <translation>Grün, Radius</translation>
    </message>
    <message>
        <source>Green, strength</source>
        <translation>Grün, Stärke</translation>
    </message>
    <message>
        <source>Lens shading</source>
        <translation>Vignettierung</translation>
    </message>
    <message>
        <source>Next exposure mode</source>
        <translation>Nächste Belichtungsart</translation>
    </message>
    <message>
        <source>Night mode</source>
        <translation>Nachtmodus</translation>
    </message>
    <message>
        <source>Red, base</source>
        <translation>Rot, Basis</translation>
    </message>
    <message>
        <source>Red, radius</source>
        <translation>Rot, Radius</translation>
    </message>
    <message>
        <source>Red, strength</source>
        <translation>Rot, Stärke</translation>
    </message>
    <message>
        <source>Runs the drone&apos;s own script for it, if there is one. The drone repeats what it was told, which proves nothing.</source>
        <translation>Startet das eigene Skript der Drohne dafür, falls es eines gibt. Die Drohne wiederholt, was ihr gesagt wurde; das beweist nichts.</translation>
    </message>
    <message>
        <source>Set lens shading</source>
        <translation>Vignettierung setzen</translation>
    </message>
    <message>
        <source>Switches to the next one and tells which. Today&apos;s driver tells nothing.</source>
        <translation>Schaltet zur nächsten weiter und sagt, zu welcher. Der heutige Treiber sagt nichts.</translation>
    </message>
    <message>
        <source>Take a picture on the drone</source>
        <translation>Foto auf der Drohne machen</translation>
    </message>
    <message>
        <source>Today&apos;s driver does nothing.</source>
        <translation>Der heutige Treiber tut nichts.</translation>
    </message>
    <message>
        <source>What today&apos;s driver tells means nothing.</source>
        <translation>Was der heutige Treiber nennt, bedeutet nichts.</translation>
    </message>
    <message>
        <source>shutter.down</source>
        <translation>Verschluss −</translation>
    </message>
    <message>
        <source>shutter.up</source>
        <translation>Verschluss +</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>Laufzeit hin und zurück</translation>
    </message>
    <message>
        <source>it sets nothing; the drone would not start with it</source>
        <translation>er setzt nichts; die Drohne würde damit nicht starten</translation>
    </message>
    <message>
        <source>The generation of its protocol is not one that may be steered (F or G): a packet of another one could be taken for commands.</source>
        <translation>Die Generation ihres Protokolls darf nicht gesteuert werden (nur F und G): Ein Paket einer anderen könnte als Befehl verstanden werden.</translation>
    </message>
    <message>
        <source>Nothing is steered over TCP: if the link closes, the motors go on turning, and disarming does not stop them. Connect by UDP to fly.</source>
        <translation>Über TCP wird nichts gesteuert: Schließt sich die Verbindung, drehen die Motoren weiter, und Entschärfen hält sie nicht an. Zum Fliegen über UDP verbinden.</translation>
    </message>
    <message>
        <source>⚠ Not possible: %1.</source>
        <translation>⚠ Nicht möglich: %1.</translation>
    </message>
    <message>
        <source>⚠ Contradicts “%1” (%2): %3.</source>
        <translation>⚠ Widerspricht „%1“ (%2): %3.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing, which closes &apos;%2&apos; of line %3</source>
        <translation>es fehlt „%1“, das „%2“ aus Zeile %3 schließt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing before &apos;%4&apos;, which closes &apos;%2&apos; of line %3</source>
        <translation>vor „%4“ fehlt „%1“, das „%2“ aus Zeile %3 schließt</translation>
    </message>
    <message>
        <source>a name or &apos;...&apos; is missing</source>
        <translation>ein Name oder „...“ fehlt</translation>
    </message>
    <message>
        <source>a name or &apos;...&apos; is missing before &apos;%1&apos;</source>
        <translation>vor „%1“ fehlt ein Name oder „...“</translation>
    </message>
    <message>
        <source>&apos;=&apos; or &apos;in&apos; is missing</source>
        <translation>„=“ oder „in“ fehlt</translation>
    </message>
    <message>
        <source>&apos;=&apos; or &apos;in&apos; is missing before &apos;%1&apos;</source>
        <translation>vor „%1“ fehlt „=“ oder „in“</translation>
    </message>
    <message>
        <source>the arguments of a call are missing</source>
        <translation>die Argumente eines Aufrufs fehlen</translation>
    </message>
    <message>
        <source>the arguments of a call are missing before &apos;%1&apos;</source>
        <translation>vor „%1“ fehlen die Argumente eines Aufrufs</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing</source>
        <translation>„%1“ fehlt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing before &apos;%2&apos;</source>
        <translation>vor „%2“ fehlt „%1“</translation>
    </message>
    <message>
        <source>a symbol that cannot stand here</source>
        <translation>ein Zeichen, das hier nicht stehen kann</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot stand here</source>
        <translation>„%1“ kann hier nicht stehen</translation>
    </message>
    <message>
        <source>this is not a statement</source>
        <translation>das ist keine Anweisung</translation>
    </message>
    <message>
        <source>this is not a statement: &apos;%1&apos;</source>
        <translation>das ist keine Anweisung: „%1“</translation>
    </message>
    <message>
        <source>this is not a number</source>
        <translation>das ist keine Zahl</translation>
    </message>
    <message>
        <source>this is not a number: &apos;%1&apos;</source>
        <translation>das ist keine Zahl: „%1“</translation>
    </message>
    <message>
        <source>a string does not end</source>
        <translation>eine Zeichenkette endet nicht</translation>
    </message>
    <message>
        <source>a string does not end: &apos;%1&apos;</source>
        <translation>eine Zeichenkette endet nicht: „%1“</translation>
    </message>
    <message>
        <source>a comment does not end</source>
        <translation>ein Kommentar endet nicht</translation>
    </message>
    <message>
        <source>a comment does not end: &apos;%1&apos;</source>
        <translation>ein Kommentar endet nicht: „%1“</translation>
    </message>
    <message>
        <source>an escape that this Lua does not know</source>
        <translation>eine Zeichenumschreibung, die dieses Lua nicht kennt</translation>
    </message>
    <message>
        <source>an escape that this Lua does not know: &apos;%1&apos;</source>
        <translation>eine Zeichenumschreibung, die dieses Lua nicht kennt: „%1“</translation>
    </message>
    <message>
        <source>Follow pitch</source>
        <translation>Pitch folgen</translation>
    </message>
    <message>
        <source>Follow yaw and pitch</source>
        <translation>Yaw und Pitch folgen</translation>
    </message>
    <message>
        <source>Pitch (°, °/s or RC, by mode)</source>
        <translation>Pitch (°, °/s oder RC, je nach Modus)</translation>
    </message>
    <message>
        <source>Roll (°, °/s or RC, by mode)</source>
        <translation>Roll (°, °/s oder RC, je nach Modus)</translation>
    </message>
    <message>
        <source>Yaw (°, °/s or RC, by mode)</source>
        <translation>Yaw (°, °/s oder RC, je nach Modus)</translation>
    </message>
    <message>
        <source>one axis of a sensor cannot point both up and to the right</source>
        <translation>eine Achse eines Sensors kann nicht zugleich nach oben und nach rechts zeigen</translation>
    </message>
    <message>
        <source>this order is for boards with two axes</source>
        <translation>diese Reihenfolge ist für Boards mit zwei Achsen</translation>
    </message>
    <message>
        <source>this pin carries a receiver&apos;s serial signal, and no pulses</source>
        <translation>dieser Anschluss führt das serielle Signal eines Empfängers und keine Pulse</translation>
    </message>
    <message>
        <source>this pin puts out a servo&apos;s signal, so it cannot be an input</source>
        <translation>dieser Anschluss gibt ein Servosignal aus und kann kein Eingang sein</translation>
    </message>
    <message>
        <source>two motors cannot be at the same output</source>
        <translation>zwei Motoren können nicht am selben Ausgang sein</translation>
    </message>
    <message>
        <source>0 to 255 on a logarithmic scale of 255 steps.</source>
        <translation>0 bis 255 auf einer logarithmischen Skala mit 255 Schritten.</translation>
    </message>
    <message>
        <source>0.1 to 50 on a logarithmic scale of 255 steps.</source>
        <translation>0,1 bis 50 auf einer logarithmischen Skala mit 255 Schritten.</translation>
    </message>
    <message>
        <source>Above the outer motor</source>
        <translation>Über dem äußeren Motor</translation>
    </message>
    <message>
        <source>Acceleration limit by itself: pitch</source>
        <translation>Beschleunigungsgrenze von selbst: Pitch</translation>
    </message>
    <message>
        <source>Acceleration limit by itself: roll</source>
        <translation>Beschleunigungsgrenze von selbst: Roll</translation>
    </message>
    <message>
        <source>Acceleration limit by itself: yaw</source>
        <translation>Beschleunigungsgrenze von selbst: Yaw</translation>
    </message>
    <message>
        <source>Acceleration limit by momentum</source>
        <translation>Beschleunigungsgrenze nach Trägheit</translation>
    </message>
    <message>
        <source>Accelerometer compensation only</source>
        <translation>Nur Ausgleich der Beschleunigung</translation>
    </message>
    <message>
        <source>Added to the measured angle.</source>
        <translation>Wird zum gemessenen Winkel addiert.</translation>
    </message>
    <message>
        <source>After so long a motion by itself is given up.</source>
        <translation>Nach dieser Zeit wird eine selbsttätige Bewegung aufgegeben.</translation>
    </message>
    <message>
        <source>Analog input %1: replacement</source>
        <translation>Analogeingang %1: Ersatz</translation>
    </message>
    <message>
        <source>Angle from which on another axis takes over.</source>
        <translation>Winkel, ab dem eine andere Achse übernimmt.</translation>
    </message>
    <message>
        <source>Angle of the motor when the gimbal is retracted.</source>
        <translation>Winkel des Motors, wenn der Gimbal eingezogen ist.</translation>
    </message>
    <message>
        <source>Attitude sensor outside the board.</source>
        <translation>Lagesensor außerhalb des Boards.</translation>
    </message>
    <message>
        <source>Axis of the external sensor that points right.</source>
        <translation>Achse des äußeren Sensors, die nach rechts zeigt.</translation>
    </message>
    <message>
        <source>Axis of the external sensor that points up.</source>
        <translation>Achse des äußeren Sensors, die nach oben zeigt.</translation>
    </message>
    <message>
        <source>Below the middle motor</source>
        <translation>Unter dem mittleren Motor</translation>
    </message>
    <message>
        <source>Below the outer motor</source>
        <translation>Unter dem äußeren Motor</translation>
    </message>
    <message>
        <source>Bits 6 and 7, without documented meaning. Kept as read.</source>
        <translation>Bits 6 und 7, ohne beschriebene Bedeutung. Bleiben wie gelesen.</translation>
    </message>
    <message>
        <source>Bits of the encoder beyond 12.</source>
        <translation>Bits des Encoders über 12 hinaus.</translation>
    </message>
    <message>
        <source>CAN sensor&apos;s servo %1</source>
        <translation>Servo %1 des CAN-Sensors</translation>
    </message>
    <message>
        <source>CAN sensor&apos;s servo 1 as duty cycle</source>
        <translation>Servo 1 des CAN-Sensors als Tastverhältnis</translation>
    </message>
    <message>
        <source>CAN sensor&apos;s servo 2 as duty cycle</source>
        <translation>Servo 2 des CAN-Sensors als Tastverhältnis</translation>
    </message>
    <message>
        <source>CAN sensor&apos;s servos: rate</source>
        <translation>Servos des CAN-Sensors: Rate</translation>
    </message>
    <message>
        <source>Calibrate gyroscope in tripod mode</source>
        <translation>Gyroskop im Stativmodus kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate momentum in normal position</source>
        <translation>Trägheit in Normallage kalibrieren</translation>
    </message>
    <message>
        <source>Channel whose signal this servo output gives.</source>
        <translation>Kanal, dessen Signal dieser Servoausgang ausgibt.</translation>
    </message>
    <message>
        <source>Correct long errors: pitch</source>
        <translation>Lange Fehler ausgleichen: Pitch</translation>
    </message>
    <message>
        <source>Correct long errors: roll</source>
        <translation>Lange Fehler ausgleichen: Roll</translation>
    </message>
    <message>
        <source>Correct long errors: yaw</source>
        <translation>Lange Fehler ausgleichen: Yaw</translation>
    </message>
    <message>
        <source>Correction of its mounting angle.</source>
        <translation>Korrektur seines Einbauwinkels.</translation>
    </message>
    <message>
        <source>Correction of the middle motor</source>
        <translation>Korrektur des mittleren Motors</translation>
    </message>
    <message>
        <source>Correction of the pitch angle</source>
        <translation>Korrektur des Pitchwinkels</translation>
    </message>
    <message>
        <source>Correction of the roll angle</source>
        <translation>Korrektur des Rollwinkels</translation>
    </message>
    <message>
        <source>Corrects the gyroscope</source>
        <translation>Korrigiert das Gyroskop</translation>
    </message>
    <message>
        <source>Corrects the heading</source>
        <translation>Korrigiert den Kurs</translation>
    </message>
    <message>
        <source>Corrects the horizon</source>
        <translation>Korrigiert den Horizont</translation>
    </message>
    <message>
        <source>Current at which the power switch opens.</source>
        <translation>Strom, bei dem der Leistungsschalter öffnet.</translation>
    </message>
    <message>
        <source>Dead band of its own, where the profile&apos;s options say so.</source>
        <translation>Eigener Totbereich, wo die Profiloptionen es sagen.</translation>
    </message>
    <message>
        <source>Dead band of pitch</source>
        <translation>Totbereich von Pitch</translation>
    </message>
    <message>
        <source>Dead band of yaw</source>
        <translation>Totbereich von Yaw</translation>
    </message>
    <message>
        <source>Delay of the motors at start</source>
        <translation>Verzögerung der Motoren beim Start</translation>
    </message>
    <message>
        <source>Do not follow at start</source>
        <translation>Beim Start nicht folgen</translation>
    </message>
    <message>
        <source>Do not follow pitch</source>
        <translation>Pitch nicht folgen</translation>
    </message>
    <message>
        <source>Do not push at the soft limit: pitch</source>
        <translation>An der weichen Grenze nicht drücken: Pitch</translation>
    </message>
    <message>
        <source>Do not push at the soft limit: roll</source>
        <translation>An der weichen Grenze nicht drücken: Roll</translation>
    </message>
    <message>
        <source>Do not push at the soft limit: yaw</source>
        <translation>An der weichen Grenze nicht drücken: Yaw</translation>
    </message>
    <message>
        <source>Expo curve of its own, where the profile&apos;s options say so.</source>
        <translation>Eigene Exponentialkurve, wo die Profiloptionen es sagen.</translation>
    </message>
    <message>
        <source>Expo of pitch</source>
        <translation>Exponentialkurve von Pitch</translation>
    </message>
    <message>
        <source>Expo of yaw</source>
        <translation>Exponentialkurve von Yaw</translation>
    </message>
    <message>
        <source>Extended range of acceleration limits</source>
        <translation>Erweiterter Bereich der Beschleunigungsgrenzen</translation>
    </message>
    <message>
        <source>External buzzer: pin</source>
        <translation>Äußerer Summer: Pin</translation>
    </message>
    <message>
        <source>External motor %1: driver</source>
        <translation>Äußerer Motor %1: Treiber</translation>
    </message>
    <message>
        <source>External sensor</source>
        <translation>Äußerer Sensor</translation>
    </message>
    <message>
        <source>External sensor as reference</source>
        <translation>Äußerer Sensor als Bezug</translation>
    </message>
    <message>
        <source>External sensor: alignment</source>
        <translation>Äußerer Sensor: Ausrichtung</translation>
    </message>
    <message>
        <source>External sensor: axis that points right</source>
        <translation>Äußerer Sensor: Achse nach rechts</translation>
    </message>
    <message>
        <source>External sensor: axis that points up</source>
        <translation>Äußerer Sensor: Achse nach oben</translation>
    </message>
    <message>
        <source>External sensor: further bits</source>
        <translation>Äußerer Sensor: weitere Bits</translation>
    </message>
    <message>
        <source>External sensor: gyroscope correction</source>
        <translation>Äußerer Sensor: Korrektur des Gyroskops</translation>
    </message>
    <message>
        <source>External sensor: start-up delay</source>
        <translation>Äußerer Sensor: Startverzögerung</translation>
    </message>
    <message>
        <source>External sensor: use</source>
        <translation>Äußerer Sensor: Verwendung</translation>
    </message>
    <message>
        <source>Extra button %1: bit 5</source>
        <translation>Zusatztaster %1: Bit 5</translation>
    </message>
    <message>
        <source>Extra button %1: inverted</source>
        <translation>Zusatztaster %1: umgekehrt</translation>
    </message>
    <message>
        <source>Extra button %1: latching</source>
        <translation>Zusatztaster %1: rastend</translation>
    </message>
    <message>
        <source>Extra button %1: pin</source>
        <translation>Zusatztaster %1: Pin</translation>
    </message>
    <message>
        <source>Further options of the board.</source>
        <translation>Weitere Optionen des Boards.</translation>
    </message>
    <message>
        <source>Further options of this profile.</source>
        <translation>Weitere Optionen dieses Profils.</translation>
    </message>
    <message>
        <source>General options 3</source>
        <translation>Allgemeine Optionen 3</translation>
    </message>
    <message>
        <source>General options 4</source>
        <translation>Allgemeine Optionen 4</translation>
    </message>
    <message>
        <source>Heading of tripod mode</source>
        <translation>Kurs des Stativmodus</translation>
    </message>
    <message>
        <source>Heat the CAN sensor</source>
        <translation>CAN-Sensor heizen</translation>
    </message>
    <message>
        <source>How differently the axes shake.</source>
        <translation>Wie verschieden die Achsen rütteln.</translation>
    </message>
    <message>
        <source>How far the camera is shaken, as if held in a hand.</source>
        <translation>Wie weit die Kamera gerüttelt wird, wie von einer Hand gehalten.</translation>
    </message>
    <message>
        <source>How fast an axis comes back that was pushed beyond its limit.</source>
        <translation>Wie schnell eine Achse zurückkommt, die über ihre Grenze geschoben wurde.</translation>
    </message>
    <message>
        <source>How fast it corrects the board&apos;s gyroscope.</source>
        <translation>Wie schnell er das Gyroskop des Boards korrigiert.</translation>
    </message>
    <message>
        <source>How fast the middle motor leaves an unfavourable position.</source>
        <translation>Wie schnell der mittlere Motor eine ungünstige Lage verlässt.</translation>
    </message>
    <message>
        <source>How irregular the pauses are.</source>
        <translation>Wie unregelmäßig die Pausen sind.</translation>
    </message>
    <message>
        <source>How long the board waits for it after the start.</source>
        <translation>Wie lange das Board nach dem Start auf ihn wartet.</translation>
    </message>
    <message>
        <source>How long the button is held to switch off.</source>
        <translation>Wie lange der Taster zum Ausschalten gehalten wird.</translation>
    </message>
    <message>
        <source>How long the button is held to switch on.</source>
        <translation>Wie lange der Taster zum Einschalten gehalten wird.</translation>
    </message>
    <message>
        <source>How long the motors wait after the start.</source>
        <translation>Wie lange die Motoren nach dem Start warten.</translation>
    </message>
    <message>
        <source>How many times faster the fastest shake is.</source>
        <translation>Wievielmal schneller das schnellste Rütteln ist.</translation>
    </message>
    <message>
        <source>How much one frequency stands out.</source>
        <translation>Wie sehr eine Frequenz hervorsticht.</translation>
    </message>
    <message>
        <source>How much weaker the shake is in a pause.</source>
        <translation>Wie viel schwächer das Rütteln in einer Pause ist.</translation>
    </message>
    <message>
        <source>How still it has to be for tripod mode to begin by itself.</source>
        <translation>Wie ruhig es sein muss, damit der Stativmodus von selbst beginnt.</translation>
    </message>
    <message>
        <source>How the encoder counts whole turns: not, or with 12, 16, 20 or 24 bits.</source>
        <translation>Wie der Encoder ganze Umdrehungen zählt: nicht, oder mit 12, 16, 20 oder 24 Bits.</translation>
    </message>
    <message>
        <source>InertialSense uAHRS</source>
        <translation>InertialSense uAHRS</translation>
    </message>
    <message>
        <source>Limits the current while switching on.</source>
        <translation>Begrenzt den Strom beim Einschalten.</translation>
    </message>
    <message>
        <source>Linearized encoder of pitch</source>
        <translation>Linearisierter Encoder von Pitch</translation>
    </message>
    <message>
        <source>Linearized encoder of roll</source>
        <translation>Linearisierter Encoder von Roll</translation>
    </message>
    <message>
        <source>Linearized encoder of yaw</source>
        <translation>Linearisierter Encoder von Yaw</translation>
    </message>
    <message>
        <source>Low-pass: damping</source>
        <translation>Tiefpass: Dämpfung</translation>
    </message>
    <message>
        <source>MAVLink 1</source>
        <translation>MAVLink 1</translation>
    </message>
    <message>
        <source>MAVLink 2</source>
        <translation>MAVLink 2</translation>
    </message>
    <message>
        <source>MAVLink yaw is absolute</source>
        <translation>MAVLink-Yaw ist absolut</translation>
    </message>
    <message>
        <source>Main sensor</source>
        <translation>Hauptsensor</translation>
    </message>
    <message>
        <source>May pass the limit: pitch</source>
        <translation>Darf die Grenze überschreiten: Pitch</translation>
    </message>
    <message>
        <source>May pass the limit: roll</source>
        <translation>Darf die Grenze überschreiten: Roll</translation>
    </message>
    <message>
        <source>May pass the limit: yaw</source>
        <translation>Darf die Grenze überschreiten: Yaw</translation>
    </message>
    <message>
        <source>Menu command that is run when the signal comes into this fifth of its range.</source>
        <translation>Menübefehl, der läuft, wenn das Signal in dieses Fünftel seines Bereichs kommt.</translation>
    </message>
    <message>
        <source>Model of the frame sensor</source>
        <translation>Modell des Rahmensensors</translation>
    </message>
    <message>
        <source>Model of the main sensor</source>
        <translation>Modell des Hauptsensors</translation>
    </message>
    <message>
        <source>Motors off when retracted</source>
        <translation>Motoren aus, wenn eingezogen</translation>
    </message>
    <message>
        <source>Multi-turn bits</source>
        <translation>Bits für Umdrehungen</translation>
    </message>
    <message>
        <source>Neutral point of following; replaces the coarse one from 2.70 on.</source>
        <translation>Neutralpunkt des Folgens; ersetzt ab 2.70 den groben.</translation>
    </message>
    <message>
        <source>No Bluetooth</source>
        <translation>Kein Bluetooth</translation>
    </message>
    <message>
        <source>Not set</source>
        <translation>Nicht gesetzt</translation>
    </message>
    <message>
        <source>Number of the driver at the CAN bus; 0 = none.</source>
        <translation>Nummer des Treibers am CAN-Bus; 0 = keiner.</translation>
    </message>
    <message>
        <source>Offset of following</source>
        <translation>Versatz des Folgens</translation>
    </message>
    <message>
        <source>Own dead band and expo for pitch and yaw</source>
        <translation>Eigener Totbereich und eigene Exponentialkurve für Pitch und Yaw</translation>
    </message>
    <message>
        <source>Pin at which this button is.</source>
        <translation>Pin, an dem dieser Taster liegt.</translation>
    </message>
    <message>
        <source>Pin of a buzzer outside the board.</source>
        <translation>Pin eines Summers außerhalb des Boards.</translation>
    </message>
    <message>
        <source>Pitch motor disabled</source>
        <translation>Pitchmotor abgeschaltet</translation>
    </message>
    <message>
        <source>Place of the external sensor</source>
        <translation>Ort des äußeren Sensors</translation>
    </message>
    <message>
        <source>Port at which the external sensor is.</source>
        <translation>Anschluss, an dem der äußere Sensor liegt.</translation>
    </message>
    <message>
        <source>Port of the external sensor</source>
        <translation>Anschluss des äußeren Sensors</translation>
    </message>
    <message>
        <source>Power switch: delay of switching off</source>
        <translation>Leistungsschalter: Ausschaltverzögerung</translation>
    </message>
    <message>
        <source>Power switch: delay of switching on</source>
        <translation>Leistungsschalter: Einschaltverzögerung</translation>
    </message>
    <message>
        <source>Power switch: limiter</source>
        <translation>Leistungsschalter: Begrenzer</translation>
    </message>
    <message>
        <source>Power switch: over-current</source>
        <translation>Leistungsschalter: Überstrom</translation>
    </message>
    <message>
        <source>Power switch: shunt</source>
        <translation>Leistungsschalter: Messwiderstand</translation>
    </message>
    <message>
        <source>Pressed and released are exchanged.</source>
        <translation>Gedrückt und losgelassen sind vertauscht.</translation>
    </message>
    <message>
        <source>Priority of low angles: pitch</source>
        <translation>Vorrang kleiner Winkel: Pitch</translation>
    </message>
    <message>
        <source>Priority of low angles: roll</source>
        <translation>Vorrang kleiner Winkel: Roll</translation>
    </message>
    <message>
        <source>Priority of low angles: yaw</source>
        <translation>Vorrang kleiner Winkel: Yaw</translation>
    </message>
    <message>
        <source>Profile 1</source>
        <translation>Profil 1</translation>
    </message>
    <message>
        <source>Profile 2</source>
        <translation>Profil 2</translation>
    </message>
    <message>
        <source>Profile 3</source>
        <translation>Profil 3</translation>
    </message>
    <message>
        <source>Profile 4</source>
        <translation>Profil 4</translation>
    </message>
    <message>
        <source>Profile 5</source>
        <translation>Profil 5</translation>
    </message>
    <message>
        <source>Profile at start</source>
        <translation>Profil beim Start</translation>
    </message>
    <message>
        <source>Profile options 2</source>
        <translation>Profiloptionen 2</translation>
    </message>
    <message>
        <source>Profile options 3</source>
        <translation>Profiloptionen 3</translation>
    </message>
    <message>
        <source>Profile that is in use after the start.</source>
        <translation>Profil, das nach dem Start in Gebrauch ist.</translation>
    </message>
    <message>
        <source>Pulses per second.</source>
        <translation>Pulse je Sekunde.</translation>
    </message>
    <message>
        <source>Quality of the low-pass filter; more damps it more.</source>
        <translation>Güte des Tiefpasses; mehr dämpft ihn mehr.</translation>
    </message>
    <message>
        <source>RC while retracted</source>
        <translation>RC im eingezogenen Zustand</translation>
    </message>
    <message>
        <source>Range before a limit in which motion is slowed down.</source>
        <translation>Bereich vor einer Grenze, in dem die Bewegung gebremst wird.</translation>
    </message>
    <message>
        <source>Recover a lost sensor</source>
        <translation>Verlorenen Sensor wiederfinden</translation>
    </message>
    <message>
        <source>Replaces the main sensor</source>
        <translation>Ersetzt den Hauptsensor</translation>
    </message>
    <message>
        <source>Resistance by which the current is measured.</source>
        <translation>Widerstand, über den der Strom gemessen wird.</translation>
    </message>
    <message>
        <source>Resolution beyond 12 bits</source>
        <translation>Auflösung über 12 Bits hinaus</translation>
    </message>
    <message>
        <source>Retract the shortest way</source>
        <translation>Auf dem kürzesten Weg einziehen</translation>
    </message>
    <message>
        <source>Roll motor disabled</source>
        <translation>Rollmotor abgeschaltet</translation>
    </message>
    <message>
        <source>Sensor at the CAN bus</source>
        <translation>Sensor am CAN-Bus</translation>
    </message>
    <message>
        <source>Serves as frame sensor</source>
        <translation>Dient als Rahmensensor</translation>
    </message>
    <message>
        <source>Servo 1 as duty cycle</source>
        <translation>Servo 1 als Tastverhältnis</translation>
    </message>
    <message>
        <source>Servo 2 as duty cycle</source>
        <translation>Servo 2 als Tastverhältnis</translation>
    </message>
    <message>
        <source>Servo 3 as duty cycle</source>
        <translation>Servo 3 als Tastverhältnis</translation>
    </message>
    <message>
        <source>Servo 4 as duty cycle</source>
        <translation>Servo 4 als Tastverhältnis</translation>
    </message>
    <message>
        <source>Servo mode</source>
        <translation>Servomodus</translation>
    </message>
    <message>
        <source>Servo mode: outer I (logarithmic)</source>
        <translation>Servomodus: äußeres I (logarithmisch)</translation>
    </message>
    <message>
        <source>Servo mode: outer P (logarithmic)</source>
        <translation>Servomodus: äußeres P (logarithmisch)</translation>
    </message>
    <message>
        <source>Shake: amplitude</source>
        <translation>Rütteln: Stärke</translation>
    </message>
    <message>
        <source>Shake: attenuation in pauses</source>
        <translation>Rütteln: Abschwächung in Pausen</translation>
    </message>
    <message>
        <source>Shake: base frequency</source>
        <translation>Rütteln: Grundfrequenz</translation>
    </message>
    <message>
        <source>Shake: frequency of resonance</source>
        <translation>Rütteln: Resonanzfrequenz</translation>
    </message>
    <message>
        <source>Shake: period of pauses</source>
        <translation>Rütteln: Abstand der Pausen</translation>
    </message>
    <message>
        <source>Shake: randomness of pauses</source>
        <translation>Rütteln: Zufälligkeit der Pausen</translation>
    </message>
    <message>
        <source>Shake: range of frequencies</source>
        <translation>Rütteln: Frequenzbereich</translation>
    </message>
    <message>
        <source>Shake: resonance</source>
        <translation>Rütteln: Resonanz</translation>
    </message>
    <message>
        <source>Shake: share of pauses</source>
        <translation>Rütteln: Anteil der Pausen</translation>
    </message>
    <message>
        <source>Shake: shift of frequency</source>
        <translation>Rütteln: Frequenzverschiebung</translation>
    </message>
    <message>
        <source>Shake: variation of phase</source>
        <translation>Rütteln: Phasenunterschied</translation>
    </message>
    <message>
        <source>Shakes this axis slower or faster, a third to three times.</source>
        <translation>Rüttelt diese Achse langsamer oder schneller, ein Drittel bis dreimal.</translation>
    </message>
    <message>
        <source>Share of the period that is pause.</source>
        <translation>Anteil des Abstands, der Pause ist.</translation>
    </message>
    <message>
        <source>Share of the variable&apos;s own range.</source>
        <translation>Anteil am eigenen Bereich der Variable.</translation>
    </message>
    <message>
        <source>Shortest way: pitch</source>
        <translation>Kürzester Weg: Pitch</translation>
    </message>
    <message>
        <source>Shortest way: roll</source>
        <translation>Kürzester Weg: Roll</translation>
    </message>
    <message>
        <source>Shortest way: yaw</source>
        <translation>Kürzester Weg: Yaw</translation>
    </message>
    <message>
        <source>Signal that runs menu commands; each fifth of its range has one.</source>
        <translation>Signal, das Menübefehle ausführt; jedes Fünftel seines Bereichs hat einen.</translation>
    </message>
    <message>
        <source>Signal that sets an adjustable variable continuously.</source>
        <translation>Signal, das eine einstellbare Variable stufenlos setzt.</translation>
    </message>
    <message>
        <source>Signal that takes the place of this analog input.</source>
        <translation>Signal, das an die Stelle dieses Analogeingangs tritt.</translation>
    </message>
    <message>
        <source>Slowest frequency of the shake.</source>
        <translation>Langsamste Frequenz des Rüttelns.</translation>
    </message>
    <message>
        <source>Soft limit of middle motor upside-down</source>
        <translation>Weiche Grenze des mittleren Motors kopfüber</translation>
    </message>
    <message>
        <source>Soft limit of outer motor upside-down</source>
        <translation>Weiche Grenze des äußeren Motors kopfüber</translation>
    </message>
    <message>
        <source>Soft limit: width</source>
        <translation>Weiche Grenze: Breite</translation>
    </message>
    <message>
        <source>Speed of the way back from a limit</source>
        <translation>Geschwindigkeit des Rückwegs von einer Grenze</translation>
    </message>
    <message>
        <source>Start inverted, bit 0</source>
        <translation>Umgekehrt starten, Bit 0</translation>
    </message>
    <message>
        <source>Start inverted, bit 1</source>
        <translation>Umgekehrt starten, Bit 1</translation>
    </message>
    <message>
        <source>The button stays where it was put.</source>
        <translation>Der Taster bleibt, wo er hingestellt wurde.</translation>
    </message>
    <message>
        <source>The frequency that stands out.</source>
        <translation>Die Frequenz, die hervorsticht.</translation>
    </message>
    <message>
        <source>The signal multiplies the stored value instead of replacing it.</source>
        <translation>Das Signal vervielfacht den gespeicherten Wert, statt ihn zu ersetzen.</translation>
    </message>
    <message>
        <source>Threshold angle</source>
        <translation>Schwellwinkel</translation>
    </message>
    <message>
        <source>Time from one pause to the next.</source>
        <translation>Zeit von einer Pause zur nächsten.</translation>
    </message>
    <message>
        <source>Time limit of automatic motion</source>
        <translation>Zeitgrenze selbsttätiger Bewegung</translation>
    </message>
    <message>
        <source>Trigger %1: fourth fifth</source>
        <translation>Auslöser %1: viertes Fünftel</translation>
    </message>
    <message>
        <source>Trigger %1: highest fifth</source>
        <translation>Auslöser %1: oberstes Fünftel</translation>
    </message>
    <message>
        <source>Trigger %1: lowest fifth</source>
        <translation>Auslöser %1: unterstes Fünftel</translation>
    </message>
    <message>
        <source>Trigger %1: middle</source>
        <translation>Auslöser %1: Mitte</translation>
    </message>
    <message>
        <source>Trigger %1: second fifth</source>
        <translation>Auslöser %1: zweites Fünftel</translation>
    </message>
    <message>
        <source>Trigger %1: signal</source>
        <translation>Auslöser %1: Signal</translation>
    </message>
    <message>
        <source>Trigger slots</source>
        <translation>Auslöser</translation>
    </message>
    <message>
        <source>Tripod mode by itself</source>
        <translation>Stativmodus von selbst</translation>
    </message>
    <message>
        <source>Tripod mode: threshold</source>
        <translation>Stativmodus: Schwelle</translation>
    </message>
    <message>
        <source>Type of an external sensor at the CAN bus.</source>
        <translation>Art eines äußeren Sensors am CAN-Bus.</translation>
    </message>
    <message>
        <source>Type of the frame sensor; 0 = found by itself.</source>
        <translation>Art des Rahmensensors; 0 = wird selbst gefunden.</translation>
    </message>
    <message>
        <source>Type of the main sensor; 0 = found by itself.</source>
        <translation>Art des Hauptsensors; 0 = wird selbst gefunden.</translation>
    </message>
    <message>
        <source>UART2 at its other pins</source>
        <translation>UART2 an seinen anderen Pins</translation>
    </message>
    <message>
        <source>Updates while upside-down</source>
        <translation>Aktualisiert auch kopfüber</translation>
    </message>
    <message>
        <source>Variable slots</source>
        <translation>Variablenplätze</translation>
    </message>
    <message>
        <source>Variable that the signal sets.</source>
        <translation>Variable, die das Signal setzt.</translation>
    </message>
    <message>
        <source>VectorNav VN-200</source>
        <translation>VectorNav VN-200</translation>
    </message>
    <message>
        <source>What the external sensor is used for.</source>
        <translation>Wofür der äußere Sensor verwendet wird.</translation>
    </message>
    <message>
        <source>Where on the gimbal the external sensor is mounted.</source>
        <translation>Wo am Gimbal der äußere Sensor sitzt.</translation>
    </message>
    <message>
        <source>Without documented meaning. Kept as read.</source>
        <translation>Ohne beschriebene Bedeutung. Bleibt wie gelesen.</translation>
    </message>
    <message>
        <source>Yaw motor disabled</source>
        <translation>Yawmotor abgeschaltet</translation>
    </message>
    <message>
        <source>128 bytes that the board keeps for others.</source>
        <translation>128 Byte, die das Board für andere aufhebt.</translation>
    </message>
    <message>
        <source>Also from another board</source>
        <translation>Auch von einem anderen Board</translation>
    </message>
    <message>
        <source>Bytes (hex)</source>
        <translation>Bytes (hex)</translation>
    </message>
    <message>
        <source>Copies a file of the board&apos;s file system.</source>
        <translation>Kopiert eine Datei aus dem Dateisystem des Boards.</translation>
    </message>
    <message>
        <source>Erase a file of the board</source>
        <translation>Datei des Boards löschen</translation>
    </message>
    <message>
        <source>Find poles and direction</source>
        <translation>Pole und Drehrichtung finden</translation>
    </message>
    <message>
        <source>Give a signal</source>
        <translation>Signal geben</translation>
    </message>
    <message>
        <source>Gives a signal at a virtual channel for a time; then it counts as lost.</source>
        <translation>Gibt eine Zeit lang ein Signal an einem virtuellen Kanal; danach gilt es als verloren.</translation>
    </message>
    <message>
        <source>Hours of work, starts, shocks, currents and temperatures that the board counts.</source>
        <translation>Betriebsstunden, Starts, Stöße, Ströme und Temperaturen, die das Board zählt.</translation>
    </message>
    <message>
        <source>Load a file into the board</source>
        <translation>Datei auf das Board laden</translation>
    </message>
    <message>
        <source>Measure magnetic link</source>
        <translation>Magnetische Bindung messen</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Pin</translation>
    </message>
    <message>
        <source>Profile sets</source>
        <translation>Profilsätze</translation>
    </message>
    <message>
        <source>Pulses at the servo pins; 0 holds a pin low, -1 frees it.</source>
        <translation>Pulse an den Servopins; 0 hält einen Pin auf low, -1 gibt ihn frei.</translation>
    </message>
    <message>
        <source>Read signals</source>
        <translation>Signale lesen</translation>
    </message>
    <message>
        <source>Read statistics</source>
        <translation>Statistik lesen</translation>
    </message>
    <message>
        <source>Read user data</source>
        <translation>Benutzerdaten lesen</translation>
    </message>
    <message>
        <source>Replaces the 128 bytes that the board keeps for others.</source>
        <translation>Ersetzt die 128 Byte, die das Board für andere aufhebt.</translation>
    </message>
    <message>
        <source>Run script</source>
        <translation>Skript ausführen</translation>
    </message>
    <message>
        <source>Save a file of the board</source>
        <translation>Datei des Boards sichern</translation>
    </message>
    <message>
        <source>Select sensor</source>
        <translation>Sensor wählen</translation>
    </message>
    <message>
        <source>Servo 1 (FC_ROLL)</source>
        <translation>Servo 1 (FC_ROLL)</translation>
    </message>
    <message>
        <source>Servo 2 (FC_PITCH)</source>
        <translation>Servo 2 (FC_PITCH)</translation>
    </message>
    <message>
        <source>Servo 3 (RC_PITCH)</source>
        <translation>Servo 3 (RC_PITCH)</translation>
    </message>
    <message>
        <source>Servo 4 (AUX1)</source>
        <translation>Servo 4 (AUX1)</translation>
    </message>
    <message>
        <source>Set pin</source>
        <translation>Pin setzen</translation>
    </message>
    <message>
        <source>Set servo outputs</source>
        <translation>Servoausgänge setzen</translation>
    </message>
    <message>
        <source>Sets an output pin. A pin that is an input is not set.</source>
        <translation>Setzt einen Ausgangspin. Ein Pin, der Eingang ist, wird nicht gesetzt.</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>Starts or stops a script that is in the board.</source>
        <translation>Startet oder beendet ein Skript, das auf dem Board liegt.</translation>
    </message>
    <message>
        <source>Takes a file out of the board&apos;s file system.</source>
        <translation>Nimmt eine Datei aus dem Dateisystem des Boards.</translation>
    </message>
    <message>
        <source>The board moves each motor to measure how stiffly its magnets hold.</source>
        <translation>Das Board bewegt jeden Motor und misst, wie fest seine Magnete halten.</translation>
    </message>
    <message>
        <source>The board turns each motor to find its number of poles and its direction.</source>
        <translation>Das Board dreht jeden Motor und findet seine Polzahl und Drehrichtung.</translation>
    </message>
    <message>
        <source>The camera is balanced and can turn freely</source>
        <translation>Die Kamera ist ausbalanciert und kann sich frei drehen</translation>
    </message>
    <message>
        <source>What comes in at the inputs that functions are mapped to.</source>
        <translation>Was an den Eingängen ankommt, denen Funktionen zugeordnet sind.</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>Which sensor calibrations and readings are about.</source>
        <translation>Um welchen Sensor es bei Kalibrierungen und Messwerten geht.</translation>
    </message>
    <message>
        <source>Write user data</source>
        <translation>Benutzerdaten schreiben</translation>
    </message>
    <message>
        <source>Writes a file into the board&apos;s file system and compares it.</source>
        <translation>Schreibt eine Datei in das Dateisystem des Boards und vergleicht sie.</translation>
    </message>
    <message>
        <source>backup</source>
        <translation>Reserve</translation>
    </message>
    <message>
        <source>buzzer</source>
        <translation>Summer</translation>
    </message>
    <message>
        <source>can-driver</source>
        <translation>CAN-Treiber</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>leeren</translation>
    </message>
    <message>
        <source>cogging</source>
        <translation>Rastmoment</translation>
    </message>
    <message>
        <source>debug</source>
        <translation>mit Fehlersuche</translation>
    </message>
    <message>
        <source>floating</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>high</source>
        <translation>high</translation>
    </message>
    <message>
        <source>imu-calibration</source>
        <translation>Sensorkalibrierung</translation>
    </message>
    <message>
        <source>load</source>
        <translation>laden</translation>
    </message>
    <message>
        <source>look-up-table</source>
        <translation>Wertetabelle</translation>
    </message>
    <message>
        <source>low</source>
        <translation>low</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>profile-set</source>
        <translation>Profilsatz</translation>
    </message>
    <message>
        <source>script</source>
        <translation>Skript</translation>
    </message>
    <message>
        <source>spektrum-power</source>
        <translation>Spektrum-Strom</translation>
    </message>
    <message>
        <source>start</source>
        <translation>starten</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>beenden</translation>
    </message>
    <message>
        <source>tuning</source>
        <translation>Abstimmung</translation>
    </message>
    <message>
        <source>Menu command that is run at start.</source>
        <translation>Menübefehl, der beim Start ausgeführt wird.</translation>
    </message>
    <message>
        <source>Start-up action %1: with button</source>
        <translation>Startaktion %1: mit Taste</translation>
    </message>
    <message>
        <source>The action is run only if the menu button is held at start.</source>
        <translation>Die Aktion läuft nur, wenn beim Start die Menütaste gehalten wird.</translation>
    </message>
    <message>
        <source>Stores all five profiles in a slot of the board, loads or clears it.</source>
        <translation>Speichert alle fünf Profile in einem Platz des Boards, lädt oder leert ihn.</translation>
    </message>
    <message>
        <source>store</source>
        <translation>speichern</translation>
    </message>
    <message>
        <source>Slot %1: at highest signal</source>
        <translation>Platz %1: beim höchsten Signal</translation>
    </message>
    <message>
        <source>Slot %1: at lowest signal</source>
        <translation>Platz %1: beim tiefsten Signal</translation>
    </message>
    <message>
        <source>Slot %1: multiply</source>
        <translation>Platz %1: vervielfachen</translation>
    </message>
    <message>
        <source>Slot %1: signal</source>
        <translation>Platz %1: Signal</translation>
    </message>
    <message>
        <source>Slot %1: variable</source>
        <translation>Platz %1: Variable</translation>
    </message>
    <message>
        <source>Address (7 bits)</source>
        <translation>Adresse (7 Bit)</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>Buses</source>
        <translation>Busse</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>Feed from a file</source>
        <translation>Aus einer Datei einspeisen</translation>
    </message>
    <message>
        <source>Finds the devices on an I2C bus of the board.</source>
        <translation>Findet die Geräte an einem I2C-Bus des Boards.</translation>
    </message>
    <message>
        <source>I know this device and what the register does</source>
        <translation>Ich kenne dieses Gerät und weiß, was das Register bewirkt</translation>
    </message>
    <message>
        <source>Motors go off, and the board waits for firmware from the maker&apos;s program. This program has none and cannot end it: only switching the board off and on does.</source>
        <translation>Die Motoren gehen aus, und das Board wartet auf Firmware aus dem Programm des Herstellers. Dieses Programm hat keine und kann das nicht beenden: nur Aus- und Einschalten des Boards kann es.</translation>
    </message>
    <message>
        <source>Read attitude vectors</source>
        <translation>Lagevektoren lesen</translation>
    </message>
    <message>
        <source>Read registers</source>
        <translation>Register lesen</translation>
    </message>
    <message>
        <source>Read slots</source>
        <translation>Plätze lesen</translation>
    </message>
    <message>
        <source>Reads registers of a device on an I2C bus. Some devices change by being read.</source>
        <translation>Liest Register eines Geräts an einem I2C-Bus. Manche Geräte ändern sich, wenn sie gelesen werden.</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>Search a bus</source>
        <translation>Einen Bus absuchen</translation>
    </message>
    <message>
        <source>Sends rows of a CSV file at their time: what a flight controller tells of the frame (helper), a correction of the gyroscope (gyro), or the attitude of another sensor (attitude).</source>
        <translation>Sendet Zeilen einer CSV-Datei zu ihrer Zeit: was ein Flugregler vom Rahmen meldet (helper), eine Korrektur des Gyroskops (gyro) oder die Lage eines anderen Sensors (attitude).</translation>
    </message>
    <message>
        <source>Start the boot loader</source>
        <translation>Bootloader starten</translation>
    </message>
    <message>
        <source>The board can be switched off and on</source>
        <translation>Das Board lässt sich aus- und einschalten</translation>
    </message>
    <message>
        <source>Virtual channels (1 roll, 2 pitch, 3 yaw)</source>
        <translation>Virtuelle Kanäle (1 Roll, 2 Pitch, 3 Yaw)</translation>
    </message>
    <message>
        <source>What comes in at the slots of adjustable variables and menu commands, and what it sets.</source>
        <translation>Was an den Plätzen für Variablen und Menübefehle ankommt, und was es stellt.</translation>
    </message>
    <message>
        <source>What the file holds</source>
        <translation>Was die Datei enthält</translation>
    </message>
    <message>
        <source>Where gravity and north are, as a sensor sees them.</source>
        <translation>Wo Schwerkraft und Norden sind, wie ein Sensor sie sieht.</translation>
    </message>
    <message>
        <source>Write registers</source>
        <translation>Register schreiben</translation>
    </message>
    <message>
        <source>Writes registers of a device on an I2C bus. A sensor that was set up otherwise misleads the board.</source>
        <translation>Schreibt Register eines Geräts an einem I2C-Bus. Ein Sensor, der anders eingestellt wurde, führt das Board in die Irre.</translation>
    </message>
    <message>
        <source>attitude</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>gyro</source>
        <translation>Gyroskop</translation>
    </message>
    <message>
        <source>helper</source>
        <translation>Hilfsdaten</translation>
    </message>
    <message>
        <source>internal</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>List scripts</source>
        <translation>Skripte auflisten</translation>
    </message>
    <message>
        <source>Run script and follow it</source>
        <translation>Skript starten und verfolgen</translation>
    </message>
    <message>
        <source>Starts a script and tells each command that the board carries out. Cancel stops the script.</source>
        <translation>Startet ein Skript und nennt jeden Befehl, den das Board ausführt. Abbrechen hält das Skript an.</translation>
    </message>
    <message>
        <source>All values are so already.</source>
        <translation>Alle Werte sind schon so.</translation>
    </message>
    <message>
        <source>An axis vibrates strongly: lower its gains (page Tuning), and measure again.</source>
        <translation>Eine Achse vibriert stark: senken Sie ihre Verstärkung (Seite Abstimmen), und messen Sie noch einmal.</translation>
    </message>
    <message>
        <source>An axis was hardly moved: its range stays as it was.</source>
        <translation>Eine Achse wurde kaum bewegt: ihr Bereich bleibt, wie er war.</translation>
    </message>
    <message>
        <source>Balance</source>
        <translation>Balance</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Cells of the battery (0 = find out)</source>
        <translation>Zellen des Akkus (0 = herausfinden)</translation>
    </message>
    <message>
        <source>Error of the accelerometer</source>
        <translation>Fehler des Beschleunigungssensors</translation>
    </message>
    <message>
        <source>Figures are as they were measured; behind an arrow stands what was before. What is left out was neither measured nor set.</source>
        <translation>Die Zahlen sind, wie sie gemessen wurden; hinter einem Pfeil steht, was vorher war. Was ausgelassen ist, wurde weder gemessen noch eingestellt.</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>Gyroscope</source>
        <translation>Gyroskop</translation>
    </message>
    <message>
        <source>Held to</source>
        <translation>Gehalten auf</translation>
    </message>
    <message>
        <source>I hold the camera</source>
        <translation>Ich halte die Kamera</translation>
    </message>
    <message>
        <source>It is balanced.</source>
        <translation>Sie ist ausbalanciert.</translation>
    </message>
    <message>
        <source>It is held about as before.</source>
        <translation>Sie wird etwa so gehalten wie vorher.</translation>
    </message>
    <message>
        <source>It is held better than before.</source>
        <translation>Sie wird besser gehalten als vorher.</translation>
    </message>
    <message>
        <source>It is held worse than before, and the old gains could not be written back: see Backups.</source>
        <translation>Sie wird schlechter gehalten als vorher, und die alten Werte ließen sich nicht zurückschreiben: siehe Sicherungen.</translation>
    </message>
    <message>
        <source>It is not balanced on the axis that swings: move the camera on its plate against it, and measure again. Motors that carry weight get hot and hold badly.</source>
        <translation>Auf der Achse, die ausschwingt, ist sie nicht ausbalanciert: verschieben Sie die Kamera auf ihrer Platte dagegen, und messen Sie noch einmal. Motoren, die Gewicht tragen, werden heiß und halten schlecht.</translation>
    </message>
    <message>
        <source>It was held worse than before: the old gains were written back.</source>
        <translation>Sie wurde schlechter gehalten als vorher: die alten Werte wurden zurückgeschrieben.</translation>
    </message>
    <message>
        <source>Kind of battery</source>
        <translation>Art des Akkus</translation>
    </message>
    <message>
        <source>Margin at each end</source>
        <translation>Abstand an jedem Ende</translation>
    </message>
    <message>
        <source>Measures the voltage, finds how many cells the battery has, and sets the alarm and the voltage below which motors are switched off.</source>
        <translation>Misst die Spannung, findet heraus, wie viele Zellen der Akku hat, und stellt den Alarm ein und die Spannung, unter der die Motoren ausgeschaltet werden.</translation>
    </message>
    <message>
        <source>Measures the zero of the sensor of turn rate, and compares it with before.</source>
        <translation>Misst den Nullpunkt des Drehratensensors, und vergleicht ihn mit vorher.</translation>
    </message>
    <message>
        <source>Measures what the accelerometer takes for level, and compares it with before.</source>
        <translation>Misst, was der Beschleunigungssensor für waagerecht hält, und vergleicht es mit vorher.</translation>
    </message>
    <message>
        <source>Nothing is written yet.</source>
        <translation>Noch ist nichts geschrieben.</translation>
    </message>
    <message>
        <source>Nothing vibrates in a line of its own.</source>
        <translation>Nichts vibriert in einer eigenen Linie.</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Set-up of a gimbal</source>
        <translation>Einrichtung eines Gimbals</translation>
    </message>
    <message>
        <source>Shows which values follow from what the gimbal is for, and writes them if they are wanted.</source>
        <translation>Zeigt, welche Werte aus der Verwendung des Gimbals folgen, und schreibt sie, wenn sie gewünscht sind.</translation>
    </message>
    <message>
        <source>Steering reaches what you have shown, less the margin.</source>
        <translation>Das Steuern reicht so weit, wie Sie gezeigt haben, weniger den Abstand.</translation>
    </message>
    <message>
        <source>Strays from its target</source>
        <translation>Weicht vom Ziel ab</translation>
    </message>
    <message>
        <source>Strongest line</source>
        <translation>Stärkste Linie</translation>
    </message>
    <message>
        <source>Swings when let go</source>
        <translation>Schwingt losgelassen aus</translation>
    </message>
    <message>
        <source>That is good.</source>
        <translation>Das ist gut.</translation>
    </message>
    <message>
        <source>That is poor: do it again in a steadier place.</source>
        <translation>Das ist schlecht: wiederholen Sie es an einem ruhigeren Ort.</translation>
    </message>
    <message>
        <source>That is usable; in a steadier place it gets better.</source>
        <translation>Das ist brauchbar; an einem ruhigeren Ort wird es besser.</translation>
    </message>
    <message>
        <source>The camera lies or hangs absolutely still.</source>
        <translation>Die Kamera liegt oder hängt völlig still.</translation>
    </message>
    <message>
        <source>The camera lies or is held: its motors may let go</source>
        <translation>Die Kamera liegt oder wird gehalten: ihre Motoren können loslassen</translation>
    </message>
    <message>
        <source>The camera stands level and still.</source>
        <translation>Die Kamera steht waagerecht und still.</translation>
    </message>
    <message>
        <source>The frame stands level and still while the camera is moved as far as it may go.</source>
        <translation>Der Rahmen steht waagerecht und still, während die Kamera so weit bewegt wird, wie sie darf.</translation>
    </message>
    <message>
        <source>The gimbal is held in the hand as in use, and the motors run.</source>
        <translation>Der Gimbal wird in der Hand gehalten wie im Einsatz, und die Motoren laufen.</translation>
    </message>
    <message>
        <source>The gimbal is held or stands so that nothing is in the way of the camera.</source>
        <translation>Der Gimbal wird so gehalten oder steht so, dass der Kamera nichts im Weg ist.</translation>
    </message>
    <message>
        <source>The motors are as they were set.</source>
        <translation>Die Motoren sind, wie sie eingestellt waren.</translation>
    </message>
    <message>
        <source>The motors are off until the step “Motors” has found what they are.</source>
        <translation>Die Motoren sind aus, bis der Schritt „Motoren“ herausgefunden hat, was sie sind.</translation>
    </message>
    <message>
        <source>The thresholds fit the battery now.</source>
        <translation>Die Schwellen passen jetzt zum Akku.</translation>
    </message>
    <message>
        <source>The thresholds fitted the battery already.</source>
        <translation>Die Schwellen passten schon zum Akku.</translation>
    </message>
    <message>
        <source>The values are written.</source>
        <translation>Die Werte sind geschrieben.</translation>
    </message>
    <message>
        <source>Time for moving it</source>
        <translation>Zeit zum Bewegen</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Zweck</translation>
    </message>
    <message>
        <source>Vibrates</source>
        <translation>Vibriert</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Vibration</translation>
    </message>
    <message>
        <source>Voltage</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>Voltage of a cell</source>
        <translation>Spannung einer Zelle</translation>
    </message>
    <message>
        <source>What the gimbal is for</source>
        <translation>Wofür der Gimbal ist</translation>
    </message>
    <message>
        <source>Write the values (off: only show what would change)</source>
        <translation>Die Werte schreiben (aus: nur zeigen, was sich ändern würde)</translation>
    </message>
    <message>
        <source>Zero of the gyroscope</source>
        <translation>Nullpunkt des Gyroskops</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>handheld</source>
        <translation>in der Hand</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>liion</source>
        <translation>Li-Ion</translation>
    </message>
    <message>
        <source>lipo</source>
        <translation>LiPo</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>nicht getan</translation>
    </message>
    <message>
        <source>to be done again</source>
        <translation>noch einmal nötig</translation>
    </message>
    <message>
        <source>tripod</source>
        <translation>Stativ</translation>
    </message>
    <message>
        <source>vehicle</source>
        <translation>Fahrzeug</translation>
    </message>
    <message>
        <source>The camera is mounted as it will be used, with its lens and its cables. The frame stands still, best on a stand.</source>
        <translation>Die Kamera ist montiert, wie sie benutzt wird, mit Objektiv und Kabeln. Der Rahmen steht still, am besten auf einem Stativ.</translation>
    </message>
    <message>
        <source>It is a special build, which may lack things or do them in another way.</source>
        <translation>Es ist eine Sonderversion, der manches fehlen kann oder die es anders macht.</translation>
    </message>
    <message>
        <source>It steers all axes in one mode: none can be left as it is.</source>
        <translation>Sie steuert alle Achsen in einem Modus: keine kann bleiben, wie sie ist.</translation>
    </message>
    <message>
        <source>It streams no live data: they are asked for one by one, and come more slowly.</source>
        <translation>Sie sendet Live-Daten nicht von selbst: Sie werden einzeln abgefragt und kommen langsamer.</translation>
    </message>
    <message>
        <source>On a serial line it needs even parity.</source>
        <translation>An einer seriellen Leitung braucht sie gerade Parität.</translation>
    </message>
    <message>
        <source>This firmware is newer than any that this program knows: everything is shown, and nothing is written.</source>
        <translation>Diese Firmware ist neuer als jede, die dieses Programm kennt: Alles wird gezeigt, nichts wird geschrieben.</translation>
    </message>
    <message>
        <source>This firmware is older than any that this program knows: everything is shown, and nothing is written.</source>
        <translation>Diese Firmware ist älter als jede, die dieses Programm kennt: Alles wird gezeigt, nichts wird geschrieben.</translation>
    </message>
    <message>
        <source>This program knows this firmware. No fault of it is documented.</source>
        <translation>Dieses Programm kennt diese Firmware. Ein Fehler von ihr ist nicht dokumentiert.</translation>
    </message>
    <message>
        <source>2 MHz (in a driver: AS5048A)</source>
        <translation>2 MHz (im Treiber: AS5048A)</translation>
    </message>
    <message>
        <source>4 MHz (in a driver: AS5048B)</source>
        <translation>4 MHz (im Treiber: AS5048B)</translation>
    </message>
    <message>
        <source>500 kHz (in a driver: AS5048 PWM)</source>
        <translation>500 kHz (im Treiber: AS5048 PWM)</translation>
    </message>
    <message>
        <source>Find fields of encoders</source>
        <translation>Geberfelder finden</translation>
    </message>
    <message>
        <source>In a driver: AMT203</source>
        <translation>Im Treiber: AMT203</translation>
    </message>
    <message>
        <source>In a driver: AS5600 I2C</source>
        <translation>Im Treiber: AS5600 I2C</translation>
    </message>
    <message>
        <source>In a driver: AS5600 PWM</source>
        <translation>Im Treiber: AS5600 PWM</translation>
    </message>
    <message>
        <source>In a driver: MA3 10 bit</source>
        <translation>Im Treiber: MA3 10 Bit</translation>
    </message>
    <message>
        <source>In a driver: MA3 12 bit</source>
        <translation>Im Treiber: MA3 12 Bit</translation>
    </message>
    <message>
        <source>In a driver: RLS Orbis</source>
        <translation>Im Treiber: RLS Orbis</translation>
    </message>
    <message>
        <source>In a driver: RLS Orbis PWM</source>
        <translation>Im Treiber: RLS Orbis PWM</translation>
    </message>
    <message>
        <source>In a driver: analog</source>
        <translation>Im Treiber: analog</translation>
    </message>
    <message>
        <source>Match flight controller</source>
        <translation>Flugregler angleichen</translation>
    </message>
    <message>
        <source>Read state</source>
        <translation>Zustand lesen</translation>
    </message>
    <message>
        <source>Take position as zero of encoders</source>
        <translation>Lage als Gebernull nehmen</translation>
    </message>
    <message>
        <source>The board turns each motor there and back to find where its magnets stand against the encoder. A wrong value makes the motor weak, or it runs away.</source>
        <translation>Das Board dreht jeden Motor hin und zurück und findet so, wie seine Magnete zum Geber stehen. Mit einem falschen Wert ist der Motor schwach oder läuft davon.</translation>
    </message>
    <message>
        <source>The camera is held in the hand</source>
        <translation>Die Kamera wird in der Hand gehalten</translation>
    </message>
    <message>
        <source>The camera is level and looks straight ahead, as in its normal position</source>
        <translation>Die Kamera steht waagerecht und blickt geradeaus wie in der Normallage</translation>
    </message>
    <message>
        <source>Tilt the frame by hand to all sides until it ends: the board compares its angle with the signal of the flight controller.</source>
        <translation>Neigen Sie den Rahmen von Hand nach allen Seiten, bis es endet: das Board vergleicht seinen Winkel mit dem Signal des Flugreglers.</translation>
    </message>
    <message>
        <source>Turn by</source>
        <translation>Drehen um</translation>
    </message>
    <message>
        <source>Turn the camera in all directions until it ends. Motors are off meanwhile, so hold it, and keep away from iron and cables.</source>
        <translation>Drehen Sie die Kamera in alle Richtungen, bis es endet. Die Motoren sind währenddessen aus: halten Sie die Kamera fest, fern von Eisen und Kabeln.</translation>
    </message>
    <message>
        <source>What the board is calibrating, and which of its modes are on.</source>
        <translation>Was das Board kalibriert und welche seiner Modi an sind.</translation>
    </message>
    <message>
        <source>What the encoders read now becomes the zero of the motors&apos; angles. Nothing is turned.</source>
        <translation>Was die Geber jetzt lesen, wird die Null der Motorwinkel. Nichts wird gedreht.</translation>
    </message>
    <message>
        <source>an encoder on SPI has one of four speeds, and none inside</source>
        <translation>ein Geber an SPI hat eine von vier Geschwindigkeiten und keinen anderen in sich</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Pitch</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Roll</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>Yaw</translation>
    </message>
    <message>
        <source>A notch helps, and is written.</source>
        <translation>Eine Kerbe hilft, und ist geschrieben.</translation>
    </message>
    <message>
        <source>A notch was tried and did not help: the board holds what it held.</source>
        <translation>Eine Kerbe wurde versucht und half nicht: das Board hält, was es hielt.</translation>
    </message>
    <message>
        <source>Measures how the camera vibrates while it is held. Where a line of its own stands out, a notch is tried, and kept only where the axis vibrates less with it.</source>
        <translation>Misst, wie die Kamera vibriert, während sie gehalten wird. Wo eine eigene Linie hervorsticht, wird eine Kerbe versucht, und nur behalten, wo die Achse mit ihr weniger vibriert.</translation>
    </message>
    <message>
        <source>Some lines stand out: the page Spectrum says whether a notch helps, and tries it.</source>
        <translation>Einige Linien stechen hervor: die Seite Spektrum sagt, ob eine Kerbe hilft, und versucht sie.</translation>
    </message>
    <message>
        <source>Try a notch where a line stands out</source>
        <translation>Eine Kerbe versuchen, wo eine Linie hervorsticht</translation>
    </message>
    <message>
        <source>An axis vibrates strongly with these gains: lower them (page Tuning), or try a notch (step Vibration).</source>
        <translation>Eine Achse vibriert mit diesen Reglerwerten stark: senken Sie sie (Seite Abstimmen), oder versuchen Sie eine Kerbe (Schritt Vibration).</translation>
    </message>
    <message>
        <source>An axis was held worse with the gains that were found: it has its old ones again, the others the new ones.</source>
        <translation>Eine Achse wurde mit den gefundenen Werten schlechter gehalten: sie hat wieder ihre alten, die anderen die neuen.</translation>
    </message>
    <message>
        <source>No axis runs away. The motors run.</source>
        <translation>Keine Achse läuft davon. Die Motoren laufen.</translation>
    </message>
    <message>
        <source>Switches the motors off, waits until the camera is held level, and measures how far it swings when it is let go and tipped lightly.</source>
        <translation>Schaltet die Motoren aus, wartet, bis die Kamera waagerecht gehalten wird, und misst, wie weit sie ausschwingt, wenn sie losgelassen und leicht angetippt wird.</translation>
    </message>
    <message>
        <source>The board has found other poles or directions than were set.</source>
        <translation>Das Board hat andere Polzahlen oder Richtungen gefunden, als eingestellt waren.</translation>
    </message>
    <message>
        <source>The board holds other values since: do it again.</source>
        <translation>Das Board hält seither andere Werte: wiederholen Sie den Schritt.</translation>
    </message>
    <message>
        <source>the drone&apos;s Lua does not know binary numbers</source>
        <translation>das Lua der Drohne kennt keine Binärzahlen</translation>
    </message>
    <message>
        <source>Battery below its cut-off</source>
        <translation>Akku unter der Abschaltspannung</translation>
    </message>
    <message>
        <source>Battery below the alarm</source>
        <translation>Akku unter der Alarmschwelle</translation>
    </message>
    <message>
        <source>CAN bus off, inside</source>
        <translation>CAN-Bus innen abgeschaltet</translation>
    </message>
    <message>
        <source>CAN bus off, outside</source>
        <translation>CAN-Bus außen abgeschaltet</translation>
    </message>
    <message>
        <source>CAN driver does not answer</source>
        <translation>CAN-Treiber antwortet nicht</translation>
    </message>
    <message>
        <source>CAN driver: controller too hot</source>
        <translation>CAN-Treiber: Controller zu heiß</translation>
    </message>
    <message>
        <source>CAN driver: emergency pin</source>
        <translation>CAN-Treiber: Not-Aus-Eingang</translation>
    </message>
    <message>
        <source>CAN driver: field-oriented control</source>
        <translation>CAN-Treiber: feldorientierte Regelung</translation>
    </message>
    <message>
        <source>CAN driver: lasting over-current</source>
        <translation>CAN-Treiber: anhaltender Überstrom</translation>
    </message>
    <message>
        <source>CAN driver: motor too hot</source>
        <translation>CAN-Treiber: Motor zu heiß</translation>
    </message>
    <message>
        <source>CAN driver: over-current</source>
        <translation>CAN-Treiber: Überstrom</translation>
    </message>
    <message>
        <source>CAN driver: parameters</source>
        <translation>CAN-Treiber: Parameter</translation>
    </message>
    <message>
        <source>CAN driver: several faults</source>
        <translation>CAN-Treiber: mehrere Fehler</translation>
    </message>
    <message>
        <source>CAN driver: under-voltage</source>
        <translation>CAN-Treiber: Unterspannung</translation>
    </message>
    <message>
        <source>CAN hardware</source>
        <translation>CAN-Hardware</translation>
    </message>
    <message>
        <source>Charge or change the battery; if it is full, correct the alarm.</source>
        <translation>Den Akku laden oder wechseln; ist er voll, die Alarmschwelle berichtigen.</translation>
    </message>
    <message>
        <source>Charge or change the battery; if it is full, correct the voltage at which motors are switched off.</source>
        <translation>Den Akku laden oder wechseln; ist er voll, die Spannung berichtigen, bei der Motoren abgeschaltet werden.</translation>
    </message>
    <message>
        <source>Finds which way the sensor sits on the camera: you hold the camera level, tilt its right side down, then its nose. Where the board takes the sensor to sit otherwise, that is set, and kept only where the board&apos;s angles follow the camera then.</source>
        <translation>Findet, wie der Sensor an der Kamera sitzt: Sie halten die Kamera waagerecht, neigen ihre rechte Seite nach unten, dann ihre Nase. Wo das Board den Sensor anders sitzend annimmt, wird das gesetzt, und nur behalten, wenn die Winkel des Boards der Kamera dann folgen.</translation>
    </message>
    <message>
        <source>I hold the camera: its motors let go</source>
        <translation>Ich halte die Kamera: die Motoren lassen los</translation>
    </message>
    <message>
        <source>IMU at the high address</source>
        <translation>IMU an der hohen Adresse</translation>
    </message>
    <message>
        <source>IMU lost</source>
        <translation>IMU verloren</translation>
    </message>
    <message>
        <source>IMU present</source>
        <translation>IMU vorhanden</translation>
    </message>
    <message>
        <source>Its axis X points to the left.</source>
        <translation>Seine Achse X zeigt nach links.</translation>
    </message>
    <message>
        <source>Its axis X points to the right.</source>
        <translation>Seine Achse X zeigt nach rechts.</translation>
    </message>
    <message>
        <source>Its axis Y points to the left.</source>
        <translation>Seine Achse Y zeigt nach links.</translation>
    </message>
    <message>
        <source>Its axis Y points to the right.</source>
        <translation>Seine Achse Y zeigt nach rechts.</translation>
    </message>
    <message>
        <source>Its axis Z points to the left.</source>
        <translation>Seine Achse Z zeigt nach links.</translation>
    </message>
    <message>
        <source>Its axis Z points to the right.</source>
        <translation>Seine Achse Z zeigt nach rechts.</translation>
    </message>
    <message>
        <source>Its voltage is below the alarm that is set in the board.</source>
        <translation>Seine Spannung liegt unter der Alarmschwelle, die im Board eingestellt ist.</translation>
    </message>
    <message>
        <source>NT bus in use</source>
        <translation>NT-Bus in Gebrauch</translation>
    </message>
    <message>
        <source>STorM32-Link present</source>
        <translation>STorM32-Link vorhanden</translation>
    </message>
    <message>
        <source>Sensor off the camera&apos;s level</source>
        <translation>Sensor gegen die Waagerechte der Kamera</translation>
    </message>
    <message>
        <source>The battery that the gimbal is used with is connected, and full or nearly so. Where the gimbal runs wild, its motors are stopped first.</source>
        <translation>Der Akku, mit dem der Gimbal benutzt wird, ist angeschlossen, und voll oder fast voll. Wo der Gimbal außer sich gerät, werden zuerst seine Motoren gestoppt.</translation>
    </message>
    <message>
        <source>The board takes it so, and its angles follow the camera.</source>
        <translation>Das Board nimmt ihn so an, und seine Winkel folgen der Kamera.</translation>
    </message>
    <message>
        <source>The board took it to sit otherwise; now its angles follow the camera.</source>
        <translation>Das Board nahm ihn anders sitzend an; jetzt folgen seine Winkel der Kamera.</translation>
    </message>
    <message>
        <source>The frame stands level and still. Right and nose are meant as seen from behind the camera.</source>
        <translation>Der Rahmen steht waagerecht und still. Rechts und Nase sind von hinten auf die Kamera gesehen gemeint.</translation>
    </message>
    <message>
        <source>The sensor&apos;s axis X points down.</source>
        <translation>Die Achse X des Sensors zeigt nach unten.</translation>
    </message>
    <message>
        <source>The sensor&apos;s axis X points up.</source>
        <translation>Die Achse X des Sensors zeigt nach oben.</translation>
    </message>
    <message>
        <source>The sensor&apos;s axis Y points down.</source>
        <translation>Die Achse Y des Sensors zeigt nach unten.</translation>
    </message>
    <message>
        <source>The sensor&apos;s axis Y points up.</source>
        <translation>Die Achse Y des Sensors zeigt nach oben.</translation>
    </message>
    <message>
        <source>The sensor&apos;s axis Z points down.</source>
        <translation>Die Achse Z des Sensors zeigt nach unten.</translation>
    </message>
    <message>
        <source>The sensor&apos;s axis Z points up.</source>
        <translation>Die Achse Z des Sensors zeigt nach oben.</translation>
    </message>
    <message>
        <source>accelerometer</source>
        <translation>Beschleunigungssensor</translation>
    </message>
    <message>
        <source>accelerometer by reference</source>
        <translation>Beschleunigungssensor nach Referenz</translation>
    </message>
    <message>
        <source>accelerometer, sphere</source>
        <translation>Beschleunigungssensor, Kugel</translation>
    </message>
    <message>
        <source>accelerometer, temperature</source>
        <translation>Beschleunigungssensor, Temperatur</translation>
    </message>
    <message>
        <source>alignment of the external IMU</source>
        <translation>Ausrichtung der externen IMU</translation>
    </message>
    <message>
        <source>analogue inputs</source>
        <translation>Analogeingänge</translation>
    </message>
    <message>
        <source>angles by hand</source>
        <translation>Winkel von Hand</translation>
    </message>
    <message>
        <source>angles by hand, not stored</source>
        <translation>Winkel von Hand, nicht gespeichert</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>scharf</translation>
    </message>
    <message>
        <source>auto-tune</source>
        <translation>Auto-Abstimmung</translation>
    </message>
    <message>
        <source>axes of the gyroscope</source>
        <translation>Achsen des Gyroskops</translation>
    </message>
    <message>
        <source>bad IMU</source>
        <translation>schlechte IMU</translation>
    </message>
    <message>
        <source>battery below the alarm</source>
        <translation>Akku unter der Alarmschwelle</translation>
    </message>
    <message>
        <source>battery connected</source>
        <translation>Akku angeschlossen</translation>
    </message>
    <message>
        <source>battery setting</source>
        <translation>Akku-Einstellung</translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation>kalibriert</translation>
    </message>
    <message>
        <source>calibration failed</source>
        <translation>Kalibrierung misslungen</translation>
    </message>
    <message>
        <source>calibration of the driver</source>
        <translation>Kalibrierung des Treibers</translation>
    </message>
    <message>
        <source>calibration with motors off</source>
        <translation>Kalibrierung bei ausgeschalteten Motoren</translation>
    </message>
    <message>
        <source>clock crystal</source>
        <translation>Taktquarz</translation>
    </message>
    <message>
        <source>current sensor</source>
        <translation>Stromsensor</translation>
    </message>
    <message>
        <source>data of the encoder too late</source>
        <translation>Encoderdaten zu spät</translation>
    </message>
    <message>
        <source>driver fault</source>
        <translation>Treiberfehler</translation>
    </message>
    <message>
        <source>driver licence</source>
        <translation>Lizenz des Treibers</translation>
    </message>
    <message>
        <source>driver on</source>
        <translation>Treiber ein</translation>
    </message>
    <message>
        <source>driver too hot</source>
        <translation>Treiber zu heiß</translation>
    </message>
    <message>
        <source>encoder and IMU disagree</source>
        <translation>Geber und IMU widersprechen sich</translation>
    </message>
    <message>
        <source>encoder field</source>
        <translation>Encoderfeld</translation>
    </message>
    <message>
        <source>encoder missing</source>
        <translation>Encoder fehlt</translation>
    </message>
    <message>
        <source>encoder offset</source>
        <translation>Encoder-Nullpunkt</translation>
    </message>
    <message>
        <source>encoder scale</source>
        <translation>Gebermaßstab</translation>
    </message>
    <message>
        <source>encoder table</source>
        <translation>Encodertabelle</translation>
    </message>
    <message>
        <source>encoder type</source>
        <translation>Encodertyp</translation>
    </message>
    <message>
        <source>endless restarts</source>
        <translation>endlose Neustarts</translation>
    </message>
    <message>
        <source>external IMU lost</source>
        <translation>externe IMU verloren</translation>
    </message>
    <message>
        <source>flight controller</source>
        <translation>Flugregler</translation>
    </message>
    <message>
        <source>follows pitch</source>
        <translation>folgt in Pitch</translation>
    </message>
    <message>
        <source>follows roll</source>
        <translation>folgt in Roll</translation>
    </message>
    <message>
        <source>follows yaw</source>
        <translation>folgt in Yaw</translation>
    </message>
    <message>
        <source>frame IMU</source>
        <translation>Rahmen-IMU</translation>
    </message>
    <message>
        <source>frame IMU lost</source>
        <translation>Rahmen-IMU verloren</translation>
    </message>
    <message>
        <source>frame inverted</source>
        <translation>Rahmen umgedreht</translation>
    </message>
    <message>
        <source>frequency response</source>
        <translation>Frequenzgang</translation>
    </message>
    <message>
        <source>gyroscope</source>
        <translation>Gyroskop</translation>
    </message>
    <message>
        <source>gyroscope of the external IMU</source>
        <translation>Gyroskop der externen IMU</translation>
    </message>
    <message>
        <source>gyroscope, temperature</source>
        <translation>Gyroskop, Temperatur</translation>
    </message>
    <message>
        <source>home position of motors</source>
        <translation>Grundstellung der Motoren</translation>
    </message>
    <message>
        <source>inside the encoder</source>
        <translation>im Encoder</translation>
    </message>
    <message>
        <source>internal fault</source>
        <translation>innerer Fehler</translation>
    </message>
    <message>
        <source>leveling failed</source>
        <translation>Ausrichten misslungen</translation>
    </message>
    <message>
        <source>limit violated</source>
        <translation>Grenze verletzt</translation>
    </message>
    <message>
        <source>link OK</source>
        <translation>Link in Ordnung</translation>
    </message>
    <message>
        <source>link in use</source>
        <translation>Link in Gebrauch</translation>
    </message>
    <message>
        <source>link on the CAN bus lost</source>
        <translation>Verbindung am CAN-Bus verloren</translation>
    </message>
    <message>
        <source>magnetic link</source>
        <translation>magnetische Kopplung</translation>
    </message>
    <message>
        <source>magnetometer</source>
        <translation>Magnetometer</translation>
    </message>
    <message>
        <source>magnetometer OK</source>
        <translation>Magnetometer in Ordnung</translation>
    </message>
    <message>
        <source>magnetometer lost</source>
        <translation>Magnetometer verloren</translation>
    </message>
    <message>
        <source>magnetometer present</source>
        <translation>Magnetometer vorhanden</translation>
    </message>
    <message>
        <source>main IMU</source>
        <translation>Haupt-IMU</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>momentum</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>momentum, automatic</source>
        <translation>Trägheit, automatisch</translation>
    </message>
    <message>
        <source>motor blocked</source>
        <translation>Motor blockiert</translation>
    </message>
    <message>
        <source>motor poles or inversion</source>
        <translation>Motorpole oder Richtung</translation>
    </message>
    <message>
        <source>motor too hot</source>
        <translation>Motor zu heiß</translation>
    </message>
    <message>
        <source>night mode</source>
        <translation>Nachtmodus</translation>
    </message>
    <message>
        <source>not in its normal position</source>
        <translation>nicht in normaler Lage</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>operating position</source>
        <translation>Betriebsstellung</translation>
    </message>
    <message>
        <source>orientation of the IMU</source>
        <translation>Ausrichtung der IMU</translation>
    </message>
    <message>
        <source>over-current</source>
        <translation>Überstrom</translation>
    </message>
    <message>
        <source>over-speed</source>
        <translation>Überdrehzahl</translation>
    </message>
    <message>
        <source>overload too long</source>
        <translation>zu lange überlastet</translation>
    </message>
    <message>
        <source>parameters of the external IMU</source>
        <translation>Parameter der externen IMU</translation>
    </message>
    <message>
        <source>parameters were changed</source>
        <translation>Parameter wurden geändert</translation>
    </message>
    <message>
        <source>pitch motor runs</source>
        <translation>Pitch-Motor läuft</translation>
    </message>
    <message>
        <source>poles</source>
        <translation>Pole</translation>
    </message>
    <message>
        <source>power manager</source>
        <translation>Stromverwaltung</translation>
    </message>
    <message>
        <source>profile 1</source>
        <translation>Profil 1</translation>
    </message>
    <message>
        <source>profile 2</source>
        <translation>Profil 2</translation>
    </message>
    <message>
        <source>profile 3</source>
        <translation>Profil 3</translation>
    </message>
    <message>
        <source>profile 4</source>
        <translation>Profil 4</translation>
    </message>
    <message>
        <source>profile 5</source>
        <translation>Profil 5</translation>
    </message>
    <message>
        <source>re-centers pitch</source>
        <translation>zentriert Pitch</translation>
    </message>
    <message>
        <source>re-centers roll</source>
        <translation>zentriert Roll</translation>
    </message>
    <message>
        <source>re-centers yaw</source>
        <translation>zentriert Yaw</translation>
    </message>
    <message>
        <source>retracted</source>
        <translation>eingefahren</translation>
    </message>
    <message>
        <source>retracting</source>
        <translation>fährt ein</translation>
    </message>
    <message>
        <source>roll motor runs</source>
        <translation>Roll-Motor läuft</translation>
    </message>
    <message>
        <source>safe stop</source>
        <translation>sicherer Halt</translation>
    </message>
    <message>
        <source>search of limits</source>
        <translation>Suche der Grenzen</translation>
    </message>
    <message>
        <source>second IMU OK</source>
        <translation>zweite IMU in Ordnung</translation>
    </message>
    <message>
        <source>second IMU on the NT bus</source>
        <translation>zweite IMU am NT-Bus</translation>
    </message>
    <message>
        <source>second IMU on the board</source>
        <translation>zweite IMU auf dem Board</translation>
    </message>
    <message>
        <source>second IMU present</source>
        <translation>zweite IMU vorhanden</translation>
    </message>
    <message>
        <source>self-calibration of the encoder</source>
        <translation>Selbstkalibrierung des Encoders</translation>
    </message>
    <message>
        <source>serial number on the CAN bus</source>
        <translation>Seriennummer am CAN-Bus</translation>
    </message>
    <message>
        <source>serial numbers on the CAN bus differ</source>
        <translation>Seriennummern am CAN-Bus verschieden</translation>
    </message>
    <message>
        <source>servo mode</source>
        <translation>Servobetrieb</translation>
    </message>
    <message>
        <source>several positions</source>
        <translation>mehrere Stellungen</translation>
    </message>
    <message>
        <source>shake generator</source>
        <translation>Rüttelgenerator</translation>
    </message>
    <message>
        <source>stage of the driver&apos;s start</source>
        <translation>Startstufe des Treibers</translation>
    </message>
    <message>
        <source>start of the motor driver</source>
        <translation>Start des Motortreibers</translation>
    </message>
    <message>
        <source>start step 1 done</source>
        <translation>Startschritt 1 fertig</translation>
    </message>
    <message>
        <source>start step 2 done</source>
        <translation>Startschritt 2 fertig</translation>
    </message>
    <message>
        <source>started</source>
        <translation>gestartet</translation>
    </message>
    <message>
        <source>stored parameters</source>
        <translation>gespeicherte Parameter</translation>
    </message>
    <message>
        <source>stored variables</source>
        <translation>gespeicherte Variablen</translation>
    </message>
    <message>
        <source>system identification</source>
        <translation>Systemerkennung</translation>
    </message>
    <message>
        <source>time-lapse</source>
        <translation>Zeitraffer</translation>
    </message>
    <message>
        <source>time-out</source>
        <translation>Zeitüberschreitung</translation>
    </message>
    <message>
        <source>too hot</source>
        <translation>zu heiß</translation>
    </message>
    <message>
        <source>tripod mode</source>
        <translation>Stativbetrieb</translation>
    </message>
    <message>
        <source>type of the external IMU</source>
        <translation>Typ der externen IMU</translation>
    </message>
    <message>
        <source>unsafe voltage</source>
        <translation>unsichere Spannung</translation>
    </message>
    <message>
        <source>version on the CAN bus</source>
        <translation>Version am CAN-Bus</translation>
    </message>
    <message>
        <source>vibration test</source>
        <translation>Vibrationstest</translation>
    </message>
    <message>
        <source>watchdog</source>
        <translation>Watchdog</translation>
    </message>
    <message>
        <source>writing parameters</source>
        <translation>Parameter schreiben</translation>
    </message>
    <message>
        <source>wrong start position</source>
        <translation>falsche Startlage</translation>
    </message>
    <message>
        <source>yaw motor runs</source>
        <translation>Yaw-Motor läuft</translation>
    </message>
    <message>
        <source>Battery cells</source>
        <translation>Akkuzellen</translation>
    </message>
    <message>
        <source>Content of this MAVLink channel.</source>
        <translation>Inhalt dieses MAVLink-Kanals.</translation>
    </message>
    <message>
        <source>MAVLink channel %1: rate</source>
        <translation>MAVLink-Kanal %1: Rate</translation>
    </message>
    <message>
        <source>Speed of the port. That it is coded like the other serial speeds is likely, but no document tells it.</source>
        <translation>Geschwindigkeit des Anschlusses. Dass sie wie die anderen seriellen Geschwindigkeiten codiert ist, ist wahrscheinlich, steht aber in keinem Dokument.</translation>
    </message>
    <message>
        <source>A stick does not come back to the middle when it is let go: trim it at the transmitter.</source>
        <translation>Ein Knüppel kommt losgelassen nicht zur Mitte zurück: am Sender trimmen.</translation>
    </message>
    <message>
        <source>A stick for pitch</source>
        <translation>Ein Knüppel für Pitch</translation>
    </message>
    <message>
        <source>A stick for roll</source>
        <translation>Ein Knüppel für Roll</translation>
    </message>
    <message>
        <source>A stick for yaw</source>
        <translation>Ein Knüppel für Yaw</translation>
    </message>
    <message>
        <source>A stick reaches less than 80 % of its way: widen its travel at the transmitter.</source>
        <translation>Ein Knüppel erreicht weniger als 80 % seines Wegs: den Weg am Sender vergrößern.</translation>
    </message>
    <message>
        <source>A switch for commands</source>
        <translation>Ein Schalter für Befehle</translation>
    </message>
    <message>
        <source>Make inputs of pins that nothing uses</source>
        <translation>Pins, die nichts benutzt, zu Eingängen machen</translation>
    </message>
    <message>
        <source>Read inputs</source>
        <translation>Eingänge lesen</translation>
    </message>
    <message>
        <source>Something that was left out has the same input as one of them: map it otherwise, or to none.</source>
        <translation>Etwas Ausgelassenes hat denselben Eingang wie einer davon: anders oder gar nicht zuordnen.</translation>
    </message>
    <message>
        <source>Stick at its lower end</source>
        <translation>Knüppel am unteren Anschlag</translation>
    </message>
    <message>
        <source>Stick at its upper end</source>
        <translation>Knüppel am oberen Anschlag</translation>
    </message>
    <message>
        <source>Stick let go</source>
        <translation>Knüppel losgelassen</translation>
    </message>
    <message>
        <source>Switches the motors off and has you move one stick after the other: finds the input that it moves, its direction and its ends. The map is written, and kept only where the board&apos;s own signal follows the stick.</source>
        <translation>Schaltet die Motoren aus und lässt Sie einen Knüppel nach dem anderen bewegen: findet den Eingang, den er bewegt, seine Richtung und seine Anschläge. Die Zuordnung wird geschrieben und nur behalten, wenn das eigene Signal des Boards dem Knüppel folgt.</translation>
    </message>
    <message>
        <source>The motors are off. In angle mode the camera turns to where the sticks stand when they are switched on.</source>
        <translation>Die Motoren sind aus. In der Betriebsart Winkel dreht sich die Kamera beim Einschalten dorthin, wo die Knüppel stehen.</translation>
    </message>
    <message>
        <source>The sticks are mapped, and the board follows them.</source>
        <translation>Die Knüppel sind zugeordnet, und das Board folgt ihnen.</translation>
    </message>
    <message>
        <source>They were mapped so already, and the board follows them.</source>
        <translation>Sie waren schon so zugeordnet, und das Board folgt ihnen.</translation>
    </message>
    <message>
        <source>Transmitter and receiver are on. What is moved by no stick is left out below; without a remote control, leave out the step.</source>
        <translation>Sender und Empfänger sind an. Was kein Knüppel bewegt, wird unten ausgelassen; ohne Fernsteuerung den Schritt auslassen.</translation>
    </message>
    <message>
        <source>What comes in at all inputs, whether a function is mapped to them or not. Firmware before 2.60 tells of those alone that have one.</source>
        <translation>Was an allen Eingängen ankommt, ob ihnen eine Funktion zugeordnet ist oder nicht. Firmware vor 2.60 meldet nur die, die eine haben.</translation>
    </message>
    <message>
        <source>A motor is hot: let it cool, and see on the page Monitor how warm it gets with the power that it has now.</source>
        <translation>Ein Motor ist heiß: lassen Sie ihn abkühlen, und sehen Sie auf der Seite Monitor, wie warm er mit der Leistung wird, die er jetzt hat.</translation>
    </message>
    <message>
        <source>An axis needs more than half of what its motor can bear: balance the camera, and see whether a cable pulls at it.</source>
        <translation>Eine Achse braucht mehr als die Hälfte dessen, was ihr Motor verträgt: balancieren Sie die Kamera aus, und sehen Sie nach, ob ein Kabel an ihr zieht.</translation>
    </message>
    <message>
        <source>Current of the gimbal</source>
        <translation>Strom des Gimbals</translation>
    </message>
    <message>
        <source>Each motor has twice the power that its axis needs, and holds it with that.</source>
        <translation>Jeder Motor hat das Doppelte der Leistung, die seine Achse braucht, und hält sie damit.</translation>
    </message>
    <message>
        <source>Motors get warm in minutes: see on the page Monitor how warm these are after ten.</source>
        <translation>Motoren werden in Minuten warm: sehen Sie auf der Seite Monitor, wie warm diese nach zehn Minuten sind.</translation>
    </message>
    <message>
        <source>Moves one axis after the other a little, with less and with more power in use for the moment, and finds the lowest that holds it. It gets twice that: warm windings, an emptier battery and a gust take the rest. The old power is back at once where an axis turns wild or the step is left.</source>
        <translation>Bewegt eine Achse nach der anderen ein wenig, im Augenblick mit weniger oder mehr Leistung, und findet die niedrigste, die sie hält. Sie bekommt das Doppelte: warme Wicklungen, ein leererer Akku und eine Böe nehmen den Rest. Die alte Leistung gilt sofort wieder, wo eine Achse außer sich gerät oder der Schritt verlassen wird.</translation>
    </message>
    <message>
        <source>Off its target after a move</source>
        <translation>Neben dem Ziel nach einer Bewegung</translation>
    </message>
    <message>
        <source>Temperature of the motor</source>
        <translation>Temperatur des Motors</translation>
    </message>
    <message>
        <source>The camera is balanced and can turn freely; my hands catch it if it sags</source>
        <translation>Die Kamera ist ausbalanciert und kann sich frei drehen; meine Hände fangen sie auf, wenn sie absackt</translation>
    </message>
    <message>
        <source>The motors had the right power already, and hold the camera with it.</source>
        <translation>Die Motoren hatten schon die richtige Leistung und halten die Kamera damit.</translation>
    </message>
    <message>
        <source>This board does not tell how warm its motors are: touch them after ten minutes. What is too hot to touch has too much power.</source>
        <translation>Dieses Board meldet nicht, wie warm seine Motoren sind: fassen Sie sie nach zehn Minuten an. Was zu heiß zum Anfassen ist, hat zu viel Leistung.</translation>
    </message>
    <message>
        <source>Still held with a power of</source>
        <translation>Noch gehalten mit einer Leistung von</translation>
    </message>
    <message>
        <source>Nothing in the file shows that it is a program for a drone. A drone whose program does not start cannot be reached any more.</source>
        <translation>Nichts an der Datei zeigt, dass sie ein Programm für eine Drohne ist. Eine Drohne, deren Programm nicht startet, ist nicht mehr zu erreichen.</translation>
    </message>
    <message>
        <source>a share of motor %1 is beyond 1: %2</source>
        <translation>ein Anteil von Motor %1 liegt jenseits von 1: %2</translation>
    </message>
    <message>
        <source>motor %1 does not lift</source>
        <translation>Motor %1 hebt nicht</translation>
    </message>
    <message>
        <source>no motor has a share in %1</source>
        <translation>kein Motor hat einen Anteil an %1</translation>
    </message>
    <message>
        <source>the motors&apos; shares in %1 add up to %2, not to 0: more thrust would turn it</source>
        <translation>die Anteile der Motoren an %1 ergeben %2, nicht 0: mehr Schub würde die Drohne drehen</translation>
    </message>
    <message>
        <source>%1 and %2 drive the motors alike</source>
        <translation>%1 und %2 treiben die Motoren gleich an</translation>
    </message>
    <message>
        <source>mixing has %1 rows for %2 motors</source>
        <translation>die Mischung hat %1 Zeilen für %2 Motoren</translation>
    </message>
    <message>
        <source>this loop never ends: the drone would not start</source>
        <translation>diese Schleife endet nie: die Drohne würde nicht starten</translation>
    </message>
    <message>
        <source>this ends the loading: the drone would not start</source>
        <translation>das bricht das Laden ab: die Drohne würde nicht starten</translation>
    </message>
    <message>
        <source>%1 acts on the drone&apos;s computer when this function is called</source>
        <translation>%1 wirkt auf den Rechner der Drohne, wenn diese Funktion aufgerufen wird</translation>
    </message>
    <message>
        <source>%1 acts on the drone&apos;s computer whenever the text is loaded</source>
        <translation>%1 wirkt auf den Rechner der Drohne, sooft der Text geladen wird</translation>
    </message>
    <message>
        <source>A sensor on the frame is set up and does not measure: see its cable, or set up none.</source>
        <translation>Ein Sensor am Rahmen ist eingerichtet und misst nicht: sein Kabel prüfen, oder keinen einrichten.</translation>
    </message>
    <message>
        <source>Acceleration X, Y, Z</source>
        <translation>Beschleunigung X, Y, Z</translation>
    </message>
    <message>
        <source>An axis overshoots far before it rests: more D or less P calms it (page Tuning).</source>
        <translation>Eine Achse schwingt weit über, bevor sie ruht: mehr D oder weniger P beruhigt sie (Seite Abstimmen).</translation>
    </message>
    <message>
        <source>An axis ran away with little power and was stopped; the other way round it holds.</source>
        <translation>Eine Achse lief mit wenig Leistung davon und wurde gestoppt; andersherum hält sie.</translation>
    </message>
    <message>
        <source>Angle of the frame</source>
        <translation>Winkel des Rahmens</translation>
    </message>
    <message>
        <source>Angle of the motor</source>
        <translation>Winkel des Motors</translation>
    </message>
    <message>
        <source>Compare the calibrations</source>
        <translation>Kalibrierungen vergleichen</translation>
    </message>
    <message>
        <source>Compare the whole board</source>
        <translation>Ganzes Board vergleichen</translation>
    </message>
    <message>
        <source>Compares the board&apos;s calibrations with a copy.</source>
        <translation>Vergleicht die Kalibrierungen des Boards mit einer Kopie.</translation>
    </message>
    <message>
        <source>Compares the board&apos;s memory and files with a copy. Parameters are named where their place can be found; no document tells it.</source>
        <translation>Vergleicht Speicher und Dateien des Boards mit einer Kopie. Parameter werden genannt, wo sich ihr Platz finden lässt; kein Dokument sagt ihn.</translation>
    </message>
    <message>
        <source>Copies the board&apos;s memory and its files into a file, byte for byte, and reads all twice. Of each kind files 0 to 15 are asked for: no command lists them.</source>
        <translation>Kopiert Speicher und Dateien des Boards Byte für Byte in eine Datei und liest alles zweimal. Von jeder Art werden die Dateien 0 bis 15 abgefragt: Kein Befehl zählt sie auf.</translation>
    </message>
    <message>
        <source>Copies the calibrations that the board keeps in files, and what it tells of the others.</source>
        <translation>Kopiert die Kalibrierungen, die das Board in Dateien hält, und was es von den anderen sagt.</translation>
    </message>
    <message>
        <source>Copies the whole board into a new file first. Then scripts, calibrations and everything else in the board&apos;s file system are gone.</source>
        <translation>Kopiert zuerst das ganze Board in eine neue Datei. Danach sind Skripte, Kalibrierungen und alles andere im Dateisystem des Boards weg.</translation>
    </message>
    <message>
        <source>Copy the calibrations</source>
        <translation>Kalibrierungen kopieren</translation>
    </message>
    <message>
        <source>Copy the whole board</source>
        <translation>Ganzes Board kopieren</translation>
    </message>
    <message>
        <source>Each motor has an encoder.</source>
        <translation>Jeder Motor hat einen Encoder.</translation>
    </message>
    <message>
        <source>Erase all files of the board</source>
        <translation>Alle Dateien des Boards löschen</translation>
    </message>
    <message>
        <source>Follows a step in</source>
        <translation>Folgt einem Sprung in</translation>
    </message>
    <message>
        <source>Let the board search its gains (off: measure those that it has)</source>
        <translation>Das Board seine Werte suchen lassen (aus: die messen, die es hat)</translation>
    </message>
    <message>
        <source>Listens to the sensors that the board tells of, on the camera, on the frame, and at the motors, and says which of them measure.</source>
        <translation>Hört auf die Sensoren, die das Board meldet, an der Kamera, am Rahmen und an den Motoren, und sagt, welche davon messen.</translation>
    </message>
    <message>
        <source>Measures how well the camera is held and how each axis follows a small step, lets the board search its gains, and measures again. Where it is held worse than before, the old gains are written back.</source>
        <translation>Misst, wie gut die Kamera gehalten wird und wie jede Achse einem kleinen Sprung folgt, lässt das Board seine Werte suchen und misst noch einmal. Wird sie schlechter gehalten als vorher, werden die alten Werte zurückgeschrieben.</translation>
    </message>
    <message>
        <source>Motors are plugged in otherwise than was set: each axis has the output now that turns it. Outputs of other profiles are as they were.</source>
        <translation>Motoren stecken anders, als eingestellt war: jede Achse hat nun den Ausgang, der sie dreht. Die Ausgänge anderer Profile sind, wie sie waren.</translation>
    </message>
    <message>
        <source>Nothing measures the frame, and nothing has to.</source>
        <translation>Nichts misst den Rahmen, und das muss auch nicht sein.</translation>
    </message>
    <message>
        <source>Nothing was searched: that is how the gains hold that it has.</source>
        <translation>Es wurde nichts gesucht: so halten die Werte, die es hat.</translation>
    </message>
    <message>
        <source>One motor at a time, all others off, with a fifth of its power: the board turns it to find its poles and its direction, and what turned tells whether it is plugged in at its place. Then it holds its axis alone. Where that runs away, it is stopped at once, and tried the other way round. In the end they all start.</source>
        <translation>Ein Motor nach dem anderen, alle anderen aus, mit einem Fünftel seiner Leistung: das Board dreht ihn, um Polzahl und Richtung zu finden, und was sich gedreht hat, sagt, ob er an seinem Platz steckt. Dann hält er seine Achse allein. Läuft die davon, wird er sofort gestoppt und andersherum versucht. Am Ende starten alle.</translation>
    </message>
    <message>
        <source>Overshoots a step by</source>
        <translation>Schwingt bei einem Sprung über um</translation>
    </message>
    <message>
        <source>Power that turned it</source>
        <translation>Leistung, die ihn drehte</translation>
    </message>
    <message>
        <source>Restore the calibrations</source>
        <translation>Kalibrierungen wiederherstellen</translation>
    </message>
    <message>
        <source>Restore the whole board</source>
        <translation>Ganzes Board wiederherstellen</translation>
    </message>
    <message>
        <source>Scripts and calibrations are to be erased</source>
        <translation>Skripte und Kalibrierungen sollen gelöscht werden</translation>
    </message>
    <message>
        <source>Sensors found</source>
        <translation>Gefundene Sensoren</translation>
    </message>
    <message>
        <source>Some motors have an encoder set up, others have none.</source>
        <translation>Für manche Motoren ist ein Encoder eingerichtet, für andere keiner.</translation>
    </message>
    <message>
        <source>Stops at, lower end</source>
        <translation>Anschlag unten bei</translation>
    </message>
    <message>
        <source>Stops at, upper end</source>
        <translation>Anschlag oben bei</translation>
    </message>
    <message>
        <source>Switches the motors off, watches how far the camera is moved by hand, and sets the range that steering may reach. Where the board has limits of the axes themselves, they lie half of the margin further.</source>
        <translation>Schaltet die Motoren aus, beobachtet, wie weit die Kamera von Hand bewegt wird, und setzt den Bereich, den das Steuern erreichen darf. Wo das Board Grenzen der Achsen selbst hat, liegen sie um den halben Abstand weiter.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>The axes themselves stop half of the margin further.</source>
        <translation>Die Achsen selbst halten um den halben Abstand weiter an.</translation>
    </message>
    <message>
        <source>The board can have a magnetometer: one that is connected is calibrated on the page Calibration.</source>
        <translation>Das Board kann ein Magnetometer haben: ein angeschlossenes wird auf der Seite Kalibrierung kalibriert.</translation>
    </message>
    <message>
        <source>The board can read encoders; none is set up.</source>
        <translation>Das Board kann Encoder lesen; es ist keiner eingerichtet.</translation>
    </message>
    <message>
        <source>The camera lies or hangs still.</source>
        <translation>Die Kamera liegt oder hängt still.</translation>
    </message>
    <message>
        <source>The frame&apos;s angles are measured, too.</source>
        <translation>Auch die Winkel des Rahmens werden gemessen.</translation>
    </message>
    <message>
        <source>The sensor on the camera does not measure: see its cable. Without it nothing is held.</source>
        <translation>Der Sensor an der Kamera misst nicht: sein Kabel prüfen. Ohne ihn wird nichts gehalten.</translation>
    </message>
    <message>
        <source>The sensor on the camera measures.</source>
        <translation>Der Sensor an der Kamera misst.</translation>
    </message>
    <message>
        <source>The sensors and motors are those from which the copy was made</source>
        <translation>Sensoren und Motoren sind die, von denen die Kopie gemacht wurde</translation>
    </message>
    <message>
        <source>This board reads no encoders: where its motors stand it does not measure.</source>
        <translation>Dieses Board liest keine Encoder: wo seine Motoren stehen, misst es nicht.</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>Drehrate</translation>
    </message>
    <message>
        <source>Turn rate varies by</source>
        <translation>Drehrate schwankt um</translation>
    </message>
    <message>
        <source>What of it</source>
        <translation>Was davon</translation>
    </message>
    <message>
        <source>With the board&apos;s files</source>
        <translation>Mit den Dateien des Boards</translation>
    </message>
    <message>
        <source>Without a magnetometer the heading drifts slowly.</source>
        <translation>Ohne Magnetometer driftet der Kurs langsam.</translation>
    </message>
    <message>
        <source>Writes a copy of memory and files back and compares. Settings alone leave calibrations, licence and all that no document describes as it is. It is in use after a restart.</source>
        <translation>Schreibt eine Kopie von Speicher und Dateien zurück und vergleicht. Nur die Einstellungen lassen Kalibrierungen, Lizenz und alles, was kein Dokument beschreibt, wie es ist. Es gilt nach einem Neustart.</translation>
    </message>
    <message>
        <source>Writes the calibrations that are in a copy back and compares. They are in use after a restart.</source>
        <translation>Schreibt die Kalibrierungen einer Kopie zurück und vergleicht. Sie gelten nach einem Neustart.</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>What the board keeps is replaced by what is in the copy</source>
        <translation>Was das Board behält, wird durch den Inhalt der Kopie ersetzt</translation>
    </message>
    <message>
        <source>set in the drone&apos;s text, and no more in this one: %1. Without what it needs the drone does not start, or is never heard again</source>
        <translation>im Text der Drohne gesetzt und in diesem nicht mehr: %1. Ohne das, was sie braucht, startet die Drohne nicht, oder man hört nie wieder von ihr</translation>
    </message>
    <message>
        <source>ports change from %1 to %2: the drone may not be heard at its present address any more</source>
        <translation>die Ports ändern sich von %1 zu %2: Die Drohne ist an ihrer jetzigen Adresse vielleicht nicht mehr zu hören</translation>
    </message>
    <message>
        <source>A pulse at one output, also of a CAN driver; 0 holds it low, -1 frees it.</source>
        <translation>Ein Impuls an einem Ausgang, auch an dem eines CAN-Treibers; 0 hält ihn auf low, -1 gibt ihn frei.</translation>
    </message>
    <message>
        <source>Acceleration (0 = no limit)</source>
        <translation>Beschleunigung (0 = ohne Grenze)</translation>
    </message>
    <message>
        <source>Accelerometer by reference</source>
        <translation>Beschleunigungssensor nach Vorgabe</translation>
    </message>
    <message>
        <source>Angles and motion of the frame, and how far each axis is off its target.</source>
        <translation>Winkel und Bewegung des Rahmens, und wie weit jede Achse von ihrem Ziel entfernt ist.</translation>
    </message>
    <message>
        <source>As real numbers</source>
        <translation>Als reelle Zahlen</translation>
    </message>
    <message>
        <source>Auto-tune by axis</source>
        <translation>Auto-Abstimmung je Achse</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Follow events</source>
        <translation>Ereignisse verfolgen</translation>
    </message>
    <message>
        <source>Highest frequency</source>
        <translation>Höchste Frequenz</translation>
    </message>
    <message>
        <source>How fast steering may speed up, and whether it ends where no command comes any more. Until the next start.</source>
        <translation>Wie schnell das Lenken beschleunigen darf und ob es endet, wenn kein Befehl mehr kommt. Gilt bis zum nächsten Start.</translation>
    </message>
    <message>
        <source>In finer steps</source>
        <translation>In feineren Schritten</translation>
    </message>
    <message>
        <source>Learn cogging of motors</source>
        <translation>Rastmomente der Motoren lernen</translation>
    </message>
    <message>
        <source>Limit steering</source>
        <translation>Lenken begrenzen</translation>
    </message>
    <message>
        <source>List adjustable variables</source>
        <translation>Live-Variablen auflisten</translation>
    </message>
    <message>
        <source>Lowest frequency</source>
        <translation>Niedrigste Frequenz</translation>
    </message>
    <message>
        <source>Measure frequency response</source>
        <translation>Frequenzgang messen</translation>
    </message>
    <message>
        <source>Notch filters to find</source>
        <translation>Zu findende Kerbfilter</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Pitch: acceleration (0 = no limit)</source>
        <translation>Pitch: Beschleunigung (0 = ohne Grenze)</translation>
    </message>
    <message>
        <source>Read calibration of a sensor</source>
        <translation>Kalibrierung eines Sensors lesen</translation>
    </message>
    <message>
        <source>Read control of the attitude</source>
        <translation>Lenken der Lage lesen</translation>
    </message>
    <message>
        <source>Read further live data</source>
        <translation>Weitere Live-Daten lesen</translation>
    </message>
    <message>
        <source>Read references of the sensors</source>
        <translation>Bezüge der Sensoren lesen</translation>
    </message>
    <message>
        <source>Reset statistics</source>
        <translation>Statistik zurücksetzen</translation>
    </message>
    <message>
        <source>Roll: acceleration (0 = no limit)</source>
        <translation>Roll: Beschleunigung (0 = ohne Grenze)</translation>
    </message>
    <message>
        <source>Set one servo output</source>
        <translation>Einen Servo-Ausgang setzen</translation>
    </message>
    <message>
        <source>Steer to an attitude</source>
        <translation>In eine Lage lenken</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>Anregung</translation>
    </message>
    <message>
        <source>Strength of the stimulus</source>
        <translation>Stärke der Anregung</translation>
    </message>
    <message>
        <source>Tells the board what its accelerometer measures in this position, which another sensor knows.</source>
        <translation>Sagt dem Board, was sein Beschleunigungssensor in dieser Lage misst, weil ein anderer Sensor es weiß.</translation>
    </message>
    <message>
        <source>The board shakes an axis and tells what went in and what came out; the file opens on the page Response.</source>
        <translation>Das Board rüttelt eine Achse und meldet, was hineinging und was herauskam; die Datei lässt sich auf der Seite Antwort öffnen.</translation>
    </message>
    <message>
        <source>The board turns each motor slowly and learns the ripple of its magnets, which it then takes out; or it forgets it.</source>
        <translation>Das Board dreht jeden Motor langsam und lernt die Welligkeit seiner Magnete, die es danach ausgleicht; oder es vergisst sie wieder.</translation>
    </message>
    <message>
        <source>The board&apos;s own names, with range and value in use.</source>
        <translation>Die Namen, die das Board selbst hat, mit Bereich und benutztem Wert.</translation>
    </message>
    <message>
        <source>The newer search of gains: its settings stay in the board. It moves the camera, and reports nothing on its way.</source>
        <translation>Die neuere Suche der Verstärkungen; ihre Einstellungen bleiben im Board. Sie bewegt die Kamera und meldet unterwegs nichts.</translation>
    </message>
    <message>
        <source>Turns the camera to an attitude about one axis in space, the short way, then gives control back.</source>
        <translation>Dreht die Kamera um eine einzige Achse im Raum und auf dem kurzen Weg in eine Lage und gibt die Steuerung dann zurück.</translation>
    </message>
    <message>
        <source>What a sensor measures, in which positions it was calibrated, and at which temperatures.</source>
        <translation>Was ein Sensor misst, in welchen Lagen er kalibriert wurde und bei welchen Temperaturen.</translation>
    </message>
    <message>
        <source>What holds attitude and heading of each sensor, and how far off it is.</source>
        <translation>Was Lage und Richtung jedes Sensors hält und wie weit es abweicht.</translation>
    </message>
    <message>
        <source>What is measured</source>
        <translation>Was gemessen wird</translation>
    </message>
    <message>
        <source>What the board counts begins at zero again.</source>
        <translation>Was das Board zählt, beginnt wieder bei null.</translation>
    </message>
    <message>
        <source>What the board tells of by itself: motors, emergency stops, scripts, buttons, the camera.</source>
        <translation>Was das Board von selbst meldet: Motoren, Notabschaltungen, Skripte, Tasten, die Kamera.</translation>
    </message>
    <message>
        <source>Where the attitude is steered to, how far it is, and at what speed.</source>
        <translation>Wohin die Lage gelenkt wird, wie weit sie ist und wie schnell.</translation>
    </message>
    <message>
        <source>Without a command, steering ends after (0 = never)</source>
        <translation>Ohne Befehl endet das Lenken nach (0 = nie)</translation>
    </message>
    <message>
        <source>Yaw: acceleration (0 = no limit)</source>
        <translation>Yaw: Beschleunigung (0 = ohne Grenze)</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>exponential-sweep</source>
        <translation>exponentieller Durchlauf</translation>
    </message>
    <message>
        <source>forget</source>
        <translation>vergessen</translation>
    </message>
    <message>
        <source>learn</source>
        <translation>lernen</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>open-loop</source>
        <translation>offener Regelkreis</translation>
    </message>
    <message>
        <source>overall</source>
        <translation>Gesamtsystem</translation>
    </message>
    <message>
        <source>plant</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>plant-closed</source>
        <translation>Strecke, geschlossen</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>Durchlauf</translation>
    </message>
    <message>
        <source>whole-loop</source>
        <translation>ganzer Regelkreis</translation>
    </message>
    <message>
        <source>Copies the compiled script in a slot into a file.</source>
        <translation>Kopiert das übersetzte Skript in einem Platz in eine Datei.</translation>
    </message>
    <message>
        <source>Empties a slot. What is in it is copied into a file first.</source>
        <translation>Leert einen Platz. Was darin ist, wird vorher in eine Datei kopiert.</translation>
    </message>
    <message>
        <source>Erase a script</source>
        <translation>Skript löschen</translation>
    </message>
    <message>
        <source>Load a script</source>
        <translation>Skript laden</translation>
    </message>
    <message>
        <source>New file for what is in the slot</source>
        <translation>Neue Datei für das, was im Platz ist</translation>
    </message>
    <message>
        <source>Save a script</source>
        <translation>Skript sichern</translation>
    </message>
    <message>
        <source>Stops the script that runs. The motors go on.</source>
        <translation>Hält das laufende Skript an. Die Motoren laufen weiter.</translation>
    </message>
    <message>
        <source>The slots for scripts and how many bytes each holds.</source>
        <translation>Die Plätze für Skripte und wie viele Bytes jeder enthält.</translation>
    </message>
    <message>
        <source>Writes a compiled script into a slot and compares. What is in the slot is copied into a file first.</source>
        <translation>Schreibt ein übersetztes Skript in einen Platz und vergleicht. Was im Platz ist, wird vorher in eine Datei kopiert.</translation>
    </message>
</context>
<context>
    <name>ThinningText</name>
    <message>
        <source>The line is slow: live data are thinned out to %1 samples/s of the %2 that a faster one would carry.</source>
        <translation>Die Leitung ist langsam: Live-Daten sind auf %1 Messwerte/s ausgedünnt; eine schnellere trüge %2.</translation>
    </message>
    <message>
        <source>The line is slow: %1 comes %2 times a second instead of %3.</source>
        <translation>Die Leitung ist langsam: %1 kommt %2-mal statt %3-mal je Sekunde.</translation>
    </message>
</context>
<context>
    <name>TransmitterCard</name>
    <message>
        <source>Video transmitter</source>
        <translation>Videosender</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>Set band and channel</source>
        <translation>Band und Kanal setzen</translation>
    </message>
    <message>
        <source>Set the power</source>
        <translation>Leistung setzen</translation>
    </message>
    <message>
        <source>Band</source>
        <translation>Band</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>%1: %2 MHz</source>
        <translation>%1: %2 MHz</translation>
    </message>
    <message>
        <source>✓ Set, and read back.</source>
        <translation>✓ Gesetzt und ausgelesen.</translation>
    </message>
    <message>
        <source>✖ Not set. What it sends with is read again.</source>
        <translation>✖ Nicht gesetzt. Womit er sendet, wird neu ausgelesen.</translation>
    </message>
    <message>
        <source>The drone says that it has no video transmitter.</source>
        <translation>Die Drohne sagt, dass sie keinen Videosender hat.</translation>
    </message>
    <message>
        <source>What it sends with could not be read: %1</source>
        <translation>Womit er sendet, ließ sich nicht auslesen: %1</translation>
    </message>
    <message>
        <source>Sends in the band %1 on channel %2, at %3 MHz, with %4 dBm (step %5 of %6).</source>
        <translation>Sendet im Band %1 auf Kanal %2, bei %3 MHz, mit %4 dBm (Stufe %5 von %6).</translation>
    </message>
    <message>
        <source>⚠ In the list of bands this channel has %1 MHz.</source>
        <translation>⚠ In der Liste der Bänder hat dieser Kanal %1 MHz.</translation>
    </message>
    <message>
        <source>%1: %2 dBm</source>
        <translation>%1: %2 dBm</translation>
    </message>
    <message>
        <source>What it sends with is not known yet.</source>
        <translation>Womit er sendet, ist noch nicht bekannt.</translation>
    </message>
</context>
<context>
    <name>TuningPage</name>
    <message>
        <source>Tuning</source>
        <translation>Abstimmen</translation>
    </message>
    <message>
        <source>Set A</source>
        <translation>Satz A</translation>
    </message>
    <message>
        <source>Use the first set of values (F6 switches)</source>
        <translation>Den ersten Satz Werte benutzen (F6 wechselt)</translation>
    </message>
    <message>
        <source>Set B</source>
        <translation>Satz B</translation>
    </message>
    <message>
        <source>Use the second set of values (F6 switches)</source>
        <translation>Den zweiten Satz Werte benutzen (F6 wechselt)</translation>
    </message>
    <message>
        <source>Copy to other</source>
        <translation>Übertragen</translation>
    </message>
    <message>
        <source>Make the other set the same as the values in use</source>
        <translation>Den anderen Satz den Werten in Gebrauch gleich machen</translation>
    </message>
    <message>
        <source>Revert all</source>
        <translation>Alles zurücknehmen</translation>
    </message>
    <message>
        <source>Store the values in use in the active profile; a snapshot is taken first</source>
        <translation>Die Werte in Gebrauch im aktiven Profil speichern; vorher wird eine Sicherung gemacht</translation>
    </message>
    <message>
        <source>Angle error</source>
        <translation>Winkelfehler</translation>
    </message>
    <message>
        <source>Gyroscope</source>
        <translation>Gyroskop</translation>
    </message>
    <message>
        <source>Angle error, last %1 s</source>
        <translation>Winkelfehler, letzte %1 s</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Peak</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Compare what follows with these figures; switching sets does so too</source>
        <translation>Vergleicht, was folgt, mit diesen Zahlen; ein Wechsel des Satzes tut das auch</translation>
    </message>
    <message>
        <source>This board has no values that can be changed live.</source>
        <translation>Dieses Board hat keine Werte, die sich live ändern lassen.</translation>
    </message>
    <message>
        <source>Error, %1</source>
        <translation>Fehler, %1</translation>
    </message>
    <message>
        <source>Connect the board to tune it live</source>
        <translation>Verbinden Sie das Board, um live abzustimmen</translation>
    </message>
    <message>
        <source>In use: as stored</source>
        <translation>In Gebrauch: wie gespeichert</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) in use, not stored</source>
        <translation>
            <numerusform>%n Wert in Gebrauch, nicht gespeichert</numerusform>
            <numerusform>%n Werte in Gebrauch, nicht gespeichert</numerusform>
        </translation>
    </message>
    <message>
        <source>A and B differ in %1</source>
        <translation>A und B: %1 anders</translation>
    </message>
    <message>
        <source>RMS
before</source>
        <translation>RMS
vorher</translation>
    </message>
    <message>
        <source>Peak
before</source>
        <translation>Spitze
vorher</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Put the values that were read from the board into use at once (F9)</source>
        <translation>Die vom Board gelesenen Werte sofort in Gebrauch nehmen (F9)</translation>
    </message>
    <message>
        <source>Reads what is stored: the board uses it for a moment</source>
        <translation>Liest, was gespeichert ist: Das Board verwendet es einen Augenblick lang</translation>
    </message>
    <message>
        <source>Whether what is in use is stored is not known yet</source>
        <translation>Ob gespeichert ist, was in Gebrauch ist, ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>Nothing is changed here; this board does not tell what it has stored</source>
        <translation>Hier ist nichts geändert; dieses Board sagt nicht, was es gespeichert hat</translation>
    </message>
    <message>
        <source>Compare with stored</source>
        <translation>Mit Gespeichertem vergleichen</translation>
    </message>
    <message>
        <source>Locked while a search, measurement or calibration runs</source>
        <translation>Gesperrt, solange eine Suche, Messung oder Kalibrierung läuft</translation>
    </message>
    <message>
        <source>What it uses is not known until it answers.</source>
        <translation>Was es benutzt, ist nicht bekannt, bis es antwortet.</translation>
    </message>
    <message>
        <source>Values in use are not stored</source>
        <translation>Verwendete Werte sind nicht gespeichert</translation>
    </message>
    <message>
        <source>In use: as in the board&apos;s text</source>
        <translation>In Gebrauch: wie im Text des Boards</translation>
    </message>
</context>
<context>
    <name>UnsavedBar</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>Save to &amp;file…</source>
        <translation>In &amp;Datei sichern…</translation>
    </message>
    <message>
        <source>Review and &amp;write…</source>
        <translation>&amp;Prüfen und schreiben…</translation>
    </message>
    <message>
        <source>Undo: %1 (Ctrl+Z)</source>
        <translation>Rückgängig: %1 (Strg+Z)</translation>
    </message>
    <message>
        <source>Redo: %1 (Ctrl+Shift+Z)</source>
        <translation>Wiederholen: %1 (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Ctrl+S</source>
        <translation>Strg+S</translation>
    </message>
    <message>
        <source>Connect the board to write to it</source>
        <translation>Verbinden Sie das Board, um darauf zu schreiben</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) that are no values</source>
        <translation>
            <numerusform>%n Eintrag, der kein Wert ist</numerusform>
            <numerusform>%n Einträge, die keine Werte sind</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n no value</source>
        <translation>
            <numerusform>%n kein Wert</numerusform>
            <numerusform>%n keine Werte</numerusform>
        </translation>
    </message>
    <message>
        <source>all: %1</source>
        <translation>alle: %1</translation>
    </message>
    <message>
        <source>P%1: %2</source>
        <translation>P%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n unwritten change(s)</source>
        <translation>
            <numerusform>%n ungeschriebene Änderung</numerusform>
            <numerusform>%n ungeschriebene Änderungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unwritten</source>
        <translation>
            <numerusform>%n ungeschrieben</numerusform>
            <numerusform>%n ungeschrieben</numerusform>
        </translation>
    </message>
    <message>
        <source>No unwritten changes</source>
        <translation>Keine ungeschriebenen Änderungen</translation>
    </message>
    <message>
        <source>A write is running</source>
        <translation>Es wird gerade geschrieben</translation>
    </message>
</context>
<context>
    <name>UnstoredBar</name>
    <message>
        <source>Store on the board</source>
        <translation>Auf dem Board speichern</translation>
    </message>
    <message>
        <source>Values in use on the board are not stored: a restart loses them.</source>
        <translation>Werte, die das Board verwendet, sind nicht gespeichert: ein Neustart verliert sie.</translation>
    </message>
    <message>
        <source>Revert all</source>
        <translation>Alles zurücknehmen</translation>
    </message>
    <message>
        <source>Store everything that is in use; a snapshot is taken first</source>
        <translation>Alles speichern, was in Gebrauch ist; vorher wird eine Sicherung gemacht</translation>
    </message>
    <message>
        <source>Revert all?</source>
        <translation>Alles zurücknehmen?</translation>
    </message>
    <message>
        <source>All values in use that are not stored are lost. The board starts with the stored ones, and so may its motors: keep hands and cables clear of the gimbal.</source>
        <translation>Alle benutzten, nicht gespeicherten Werte gehen verloren. Das Board beginnt mit den gespeicherten, und auch die Motoren können anlaufen: Hände und Kabel vom Gimbal fernhalten.</translation>
    </message>
    <message>
        <source>Keep what is in use</source>
        <translation>Benutzte Werte behalten</translation>
    </message>
    <message>
        <source>Put the values that were read from the board into use at once</source>
        <translation>Die vom Board gelesenen Werte sofort in Gebrauch nehmen</translation>
    </message>
    <message>
        <source>Values are not stored</source>
        <translation>Werte nicht gespeichert</translation>
    </message>
    <message numerus="yes">
        <source>%n not stored</source>
        <translation>
            <numerusform>%n nicht gespeichert</numerusform>
            <numerusform>%n nicht gespeichert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Whether %n value(s) set last are in use is not known: the board has not answered.</source>
        <translation>
            <numerusform>Ob %n zuletzt gesetzter Wert in Gebrauch ist, ist nicht bekannt: Das Board hat nicht geantwortet.</numerusform>
            <numerusform>Ob %n zuletzt gesetzte Werte in Gebrauch sind, ist nicht bekannt: Das Board hat nicht geantwortet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not known</source>
        <translation>
            <numerusform>%n nicht bekannt</numerusform>
            <numerusform>%n nicht bekannt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) set live, not stored: a restart loses them.</source>
        <translation>
            <numerusform>%n Wert live gesetzt, nicht gespeichert: Ein Neustart verliert ihn.</numerusform>
            <numerusform>%n Werte live gesetzt, nicht gespeichert: Ein Neustart verliert sie.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) set live, not stored; whether others are is not known.</source>
        <translation>
            <numerusform>%n Wert live gesetzt, nicht gespeichert; ob es andere gibt, ist nicht bekannt.</numerusform>
            <numerusform>%n Werte live gesetzt, nicht gespeichert; ob es andere gibt, ist nicht bekannt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>UnwatchedNote</name>
    <message>
        <source>Not watched: %1.</source>
        <translation>Nicht überwacht: %1.</translation>
    </message>
</context>
<context>
    <name>ValueEditor</name>
    <message>
        <source>
On the board: %1</source>
        <translation>
Auf dem Board: %1</translation>
    </message>
    <message>
        <source>Unknown (%1)</source>
        <translation>Unbekannt (%1)</translation>
    </message>
    <message>
        <source>The board has %1. Discard the change.</source>
        <translation>Das Board hat %1. Die Änderung verwerfen.</translation>
    </message>
    <message>
        <source>Discard the change; the board has %1</source>
        <translation>Die Änderung verwerfen; das Board hat %1</translation>
    </message>
    <message>
        <source>Discard the change. What the board has is not known now.</source>
        <translation>Die Änderung verwerfen. Was das Board jetzt hat, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>not told by the text</source>
        <translation>steht nicht im Text</translation>
    </message>
    <message>
        <source>The text that the board keeps has another number for this value.</source>
        <translation>Im Text, den das Board aufbewahrt, steht eine andere Zahl für diesen Wert.</translation>
    </message>
    <message>
        <source>≙ %1 in the text</source>
        <translation>≙ %1 im Text</translation>
    </message>
</context>
<context>
    <name>VariablesPage</name>
    <message>
        <source>Adjustable variables</source>
        <translation>Live-Variablen</translation>
    </message>
    <message>
        <source>Keep reading</source>
        <translation>Weiter lesen</translation>
    </message>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation>Suchen (Strg+F)</translation>
    </message>
    <message>
        <source>Search variables</source>
        <translation>Variablen durchsuchen</translation>
    </message>
    <message>
        <source>Shows changes that the radio, a menu or another program makes</source>
        <translation>Zeigt Änderungen, die Funke, Menü oder ein anderes Programm machen</translation>
    </message>
    <message>
        <source>Store the values in use in the active profile; a snapshot is taken first</source>
        <translation>Die Werte in Gebrauch im aktiven Profil speichern; vorher wird eine Sicherung gemacht</translation>
    </message>
    <message>
        <source>A value set here takes effect at once and is forgotten at the next start unless it is stored. Numbers are the board&apos;s own; their meaning is shown beside them.</source>
        <translation>Ein hier gesetzter Wert wirkt sofort und ist beim nächsten Start vergessen, wenn er nicht gespeichert wird. Die Zahlen sind die des Boards; die Bedeutung steht daneben.</translation>
    </message>
    <message>
        <source>Store variables</source>
        <translation>Variablen speichern</translation>
    </message>
</context>
<context>
    <name>VideoView</name>
    <message>
        <source>Picture of the camera</source>
        <translation>Bild der Kamera</translation>
    </message>
</context>
<context>
    <name>WaterfallView</name>
    <message>
        <source>Waterfall</source>
        <translation>Wasserfall</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 dB</source>
        <translation>%1 dB</translation>
    </message>
</context>
<context>
    <name>WholeBoardPage</name>
    <message>
        <source>Whole board</source>
        <translation>Ganzes Board</translation>
    </message>
    <message>
        <source>Copies of the whole board</source>
        <translation>Kopien des ganzen Boards</translation>
    </message>
    <message>
        <source>A copy holds the board&apos;s memory and its files byte for byte: settings, calibrations, licence, scripts, and what no document describes. All of it is read twice. What is broken off goes on when it is begun again with the same file.</source>
        <translation>Eine Kopie enthält Speicher und Dateien des Boards Byte für Byte: Einstellungen, Kalibrierungen, Lizenz, Skripte und was kein Dokument beschreibt. Alles wird zweimal gelesen. Was abbricht, geht weiter, wenn es mit derselben Datei noch einmal begonnen wird.</translation>
    </message>
    <message>
        <source>Copy the board…</source>
        <translation>Board kopieren…</translation>
    </message>
    <message>
        <source>Into a file; nothing on the board is changed</source>
        <translation>In eine Datei; auf dem Board ändert sich nichts</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Vergleichen…</translation>
    </message>
    <message>
        <source>Tell what differs between a copy and the board</source>
        <translation>Sagen, was sich zwischen einer Kopie und dem Board unterscheidet</translation>
    </message>
    <message>
        <source>Restore settings…</source>
        <translation>Einstellungen wiederherstellen…</translation>
    </message>
    <message>
        <source>Write the settings of a copy; calibrations, licence and what no document describes stay</source>
        <translation>Die Einstellungen einer Kopie schreiben; Kalibrierungen, Lizenz und was kein Dokument beschreibt bleiben</translation>
    </message>
    <message>
        <source>Restore everything…</source>
        <translation>Alles wiederherstellen…</translation>
    </message>
    <message>
        <source>Write memory and files as they are in a copy</source>
        <translation>Speicher und Dateien schreiben, wie sie in einer Kopie sind</translation>
    </message>
    <message>
        <source>Erase all files…</source>
        <translation>Alle Dateien löschen…</translation>
    </message>
    <message>
        <source>Copy the board into a new file, then clear its file system</source>
        <translation>Das Board in eine neue Datei kopieren, dann sein Dateisystem leeren</translation>
    </message>
</context>
<context>
    <name>Workspace</name>
    <message>
        <source>The last write was interrupted: %1 of %2 values are not on the board.</source>
        <translation>Das letzte Schreiben wurde unterbrochen: %1 von %2 Werten sind nicht auf dem Board.</translation>
    </message>
    <message numerus="yes">
        <source>Finish: write %n value(s)</source>
        <translation>
            <numerusform>Abschließen: %n Wert schreiben</numerusform>
            <numerusform>Abschließen: %n Werte schreiben</numerusform>
        </translation>
    </message>
    <message>
        <source>Leave it as it is</source>
        <translation>So lassen</translation>
    </message>
    <message>
        <source>%1 °F</source>
        <translation>%1 °F</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>Restore them</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>None of it fits this board any more.</source>
        <translation>Nichts davon passt noch zu diesem Board.</translation>
    </message>
    <message>
        <source>Throw them away</source>
        <translation>Wegwerfen</translation>
    </message>
    <message>
        <source>Load profile %1 from %2</source>
        <translation>Profil %1 aus %2 laden</translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation>%1 laden</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) of the file do not fit this board and were left out: %1</source>
        <translation>
            <numerusform>%n Wert der Datei passt nicht zu diesem Board und wurde ausgelassen: %1</numerusform>
            <numerusform>%n Werte der Datei passen nicht zu diesem Board und wurden ausgelassen: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Snapshot taken.</source>
        <translation>Sicherung gemacht.</translation>
    </message>
    <message>
        <source>This is a recording: there are no motors to switch.</source>
        <translation>Das ist eine Aufzeichnung: hier gibt es keine Motoren zu schalten.</translation>
    </message>
    <message>
        <source>GimbalDesk configurations (*.json)</source>
        <translation>GimbalDesk-Konfigurationen (*.json)</translation>
    </message>
    <message>
        <source>Configurations and recordings (%1)</source>
        <translation>Konfigurationen und Aufzeichnungen (%1)</translation>
    </message>
    <message>
        <source>Parts of the board could not be read again.</source>
        <translation>Teile des Boards ließen sich nicht noch einmal lesen.</translation>
    </message>
    <message>
        <source>What is shown there was read before.</source>
        <translation>Was dort gezeigt wird, wurde vorher gelesen.</translation>
    </message>
    <message>
        <source>The snapshot is incomplete.</source>
        <translation>Die Sicherung ist unvollständig.</translation>
    </message>
    <message>
        <source>It lacks what could not be read: %1.</source>
        <translation>Es fehlt, was sich nicht lesen ließ: %1.</translation>
    </message>
    <message>
        <source>Read the board again, then take another.</source>
        <translation>Das Board noch einmal lesen, dann neu sichern.</translation>
    </message>
    <message>
        <source>No board was reached: the motors were not switched off.</source>
        <translation>Kein Board wurde erreicht: die Motoren sind nicht ausgeschaltet worden.</translation>
    </message>
    <message>
        <source>There is no link yet. The motors are switched off as soon as there is one.</source>
        <translation>Noch steht keine Verbindung. Die Motoren werden ausgeschaltet, sobald sie steht.</translation>
    </message>
    <message>
        <source>The gimbal is being set up.</source>
        <translation>Der Gimbal wird gerade eingerichtet.</translation>
    </message>
    <message>
        <source>Storing and starting the motors are steps of the setup.</source>
        <translation>Speichern und Starten der Motoren sind Schritte des Einrichtens.</translation>
    </message>
    <message>
        <source>Go on with it, or cancel it first.</source>
        <translation>Führen Sie es fort oder brechen Sie es zuerst ab.</translation>
    </message>
    <message numerus="yes">
        <source>Revert %n value(s)</source>
        <translation>
            <numerusform>%n Wert zurücknehmen</numerusform>
            <numerusform>%n Werte zurücknehmen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unfinished text(s) of an earlier run belong to this board.</source>
        <translation>
            <numerusform>%n unfertiger Text eines früheren Laufs gehört zu diesem Board.</numerusform>
            <numerusform>%n unfertige Texte eines früheren Laufs gehören zu diesem Board.</numerusform>
        </translation>
    </message>
    <message>
        <source>They concern parts of the board that could not be read. They are kept, and offered again once a reading is complete (F5).</source>
        <translation>Sie betreffen Teile des Boards, die nicht gelesen werden konnten. Sie sind aufgehoben und werden wieder angeboten, sobald ein Lesen vollständig ist (F5).</translation>
    </message>
    <message numerus="yes">
        <source>%n edit(s) do not fit this board any more and were left out.</source>
        <translation>
            <numerusform>%n Änderung passt nicht mehr zu diesem Board und wurde ausgelassen.</numerusform>
            <numerusform>%n Änderungen passen nicht mehr zu diesem Board und wurden ausgelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) of the file are unknown and were left out: %1</source>
        <translation>
            <numerusform>%n Eintrag der Datei ist unbekannt und wurde ausgelassen: %1</numerusform>
            <numerusform>%n Einträge der Datei sind unbekannt und wurden ausgelassen: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unwritten step(s) of an earlier run belong to this board.</source>
        <translation>
            <numerusform>%n ungeschriebener Schritt von früher gehört zu diesem Board.</numerusform>
            <numerusform>%n ungeschriebene Schritte von früher gehören zu diesem Board.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unwritten change(s) belong to the board before (%1) and are kept for it; they are offered when it is connected again.</source>
        <translation>
            <numerusform>%n ungeschriebene Änderung gehört zum vorherigen Board (%1) und wird für dieses aufgehoben; sie wird angeboten, wenn es wieder verbunden ist.</numerusform>
            <numerusform>%n ungeschriebene Änderungen gehören zum vorherigen Board (%1) und werden für dieses aufgehoben; sie werden angeboten, wenn es wieder verbunden ist.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The board that answers looks like the one before, but %n of its values differ from what was read then. Is it the same one?</source>
        <translation>
            <numerusform>Das Board, das antwortet, sieht aus wie das vorherige, aber %n seiner Werte ist anders als damals gelesen. Ist es dasselbe?</numerusform>
            <numerusform>Das Board, das antwortet, sieht aus wie das vorherige, aber %n seiner Werte sind anders als damals gelesen. Ist es dasselbe?</numerusform>
        </translation>
    </message>
    <message>
        <source>It is the same one</source>
        <translation>Es ist dasselbe</translation>
    </message>
    <message>
        <source>It is another one</source>
        <translation>Es ist ein anderes</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) on the board differ from what was read before the link ended.</source>
        <translation>
            <numerusform>%n Wert auf dem Board ist anders als zuletzt gelesen, bevor die Verbindung endete.</numerusform>
            <numerusform>%n Werte auf dem Board sind anders als zuletzt gelesen, bevor die Verbindung endete.</numerusform>
        </translation>
    </message>
    <message>
        <source>The unwritten changes of the board before are kept in %1. Say under Backups which board this is.</source>
        <translation>Die ungeschriebenen Änderungen des vorherigen Boards sind in %1 aufgehoben. Geben Sie unter „Sicherungen“ an, welches Board dies ist.</translation>
    </message>
    <message numerus="yes">
        <source>The file holds %n unwritten change(s): it is not what the board holds.</source>
        <translation>
            <numerusform>Die Datei enthält %n ungeschriebene Änderung: Sie ist nicht, was das Board enthält.</numerusform>
            <numerusform>Die Datei enthält %n ungeschriebene Änderungen: Sie ist nicht, was das Board enthält.</numerusform>
        </translation>
    </message>
    <message>
        <source>The command to store was sent, but whether the board has stored could not be proven: %1</source>
        <translation>Der Befehl zum Speichern wurde gesendet, aber ob das Board gespeichert hat, ließ sich nicht nachweisen: %1</translation>
    </message>
    <message>
        <source>Store everything in use?</source>
        <translation>Alles speichern, was in Gebrauch ist?</translation>
    </message>
    <message>
        <source>What is stored cannot be compared now, so values cannot be kept out: %1. The board stores everything that it uses, whoever has set it.</source>
        <translation>Was gespeichert ist, lässt sich jetzt nicht vergleichen, deshalb lassen sich keine Werte ausnehmen: %1. Das Board speichert alles, was es verwendet, wer auch immer es gesetzt hat.</translation>
    </message>
    <message>
        <source>Store everything</source>
        <translation>Alles speichern</translation>
    </message>
    <message>
        <source>Store nothing</source>
        <translation>Nichts speichern</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) are not in the file; what is shown for them are defaults: %1</source>
        <translation>
            <numerusform>%n Wert steht nicht in der Datei; gezeigt wird dafür der Standardwert: %1</numerusform>
            <numerusform>%n Werte stehen nicht in der Datei; gezeigt werden dafür Standardwerte: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) are not in the file and stay as they are: %1</source>
        <translation>
            <numerusform>%n Wert steht nicht in der Datei und bleibt, wie er ist: %1</numerusform>
            <numerusform>%n Werte stehen nicht in der Datei und bleiben, wie sie sind: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) of the file were rounded to what the board can hold: %1</source>
        <translation>
            <numerusform>%n Wert der Datei wurde auf das gerundet, was das Board halten kann: %1</numerusform>
            <numerusform>%n Werte der Datei wurden auf das gerundet, was das Board halten kann: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” was interrupted.</source>
        <translation>„%1“ wurde unterbrochen.</translation>
    </message>
    <message>
        <source>Whether the board has carried it out is not known.</source>
        <translation>Ob das Board es ausgeführt hat, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>It had not begun: nothing was changed.</source>
        <translation>Es hatte noch nicht begonnen: Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Snapshot taken of what is in use: it has not been compared with what is stored, which may differ.</source>
        <translation>Sicherung dessen gemacht, was in Gebrauch ist: Es wurde nicht mit dem Gespeicherten verglichen, das abweichen kann.</translation>
    </message>
    <message>
        <source>A search, measurement or calibration is running.</source>
        <translation>Eine Suche, Messung oder Kalibrierung läuft.</translation>
    </message>
    <message>
        <source>A change made now would only take effect afterwards, and replace what was found.</source>
        <translation>Eine Änderung würde erst danach wirken und ersetzen, was gefunden wurde.</translation>
    </message>
    <message>
        <source>Wait until it is over, or end it first. F12 and the button STOP MOTORS switch the motors off at once.</source>
        <translation>Warten Sie, bis sie fertig ist, oder beenden Sie sie zuerst. F12 und der Knopf MOTOREN STOPPEN schalten die Motoren sofort aus.</translation>
    </message>
    <message>
        <source>The motors run again.</source>
        <translation>Die Motoren laufen wieder.</translation>
    </message>
    <message>
        <source>They were off before the link ended. A board that restarts switches them on by itself.</source>
        <translation>Sie waren aus, bevor die Verbindung endete. Ein Board, das neu startet, schaltet sie von selbst ein.</translation>
    </message>
    <message>
        <source>Keep clear of the gimbal, or stop them (F12).</source>
        <translation>Abstand zum Gimbal halten oder sie stoppen (F12).</translation>
    </message>
    <message>
        <source>The board sends the same live data again and again.</source>
        <translation>Das Board sendet immer wieder dieselben Live-Daten.</translation>
    </message>
    <message>
        <source>Keep clear of the gimbal. Restart the board if it stays so.</source>
        <translation>Abstand zum Gimbal halten. Das Board neu starten, wenn es so bleibt.</translation>
    </message>
    <message>
        <source>Stored on the board. The settings as they were are kept in %1</source>
        <translation>Auf dem Board gespeichert. Die Einstellungen, wie sie waren, sind aufgehoben in %1</translation>
    </message>
    <message>
        <source>Store values that an alarm came with?</source>
        <translation>Werte speichern, mit denen ein Alarm kam?</translation>
    </message>
    <message>
        <source>With these values in use, the program has seen the gimbal run away or oscillate. Stored, they are used again after every start of the board.</source>
        <translation>Mit diesen Werten hat das Programm den Gimbal weglaufen oder schwingen sehen. Gespeichert gelten sie nach jedem Start des Boards wieder.</translation>
    </message>
    <message>
        <source>Store them all the same</source>
        <translation>Trotzdem speichern</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) that were in use without being stored are lost: the board restarted. In use before: %1</source>
        <translation>
            <numerusform>%n Wert, der benutzt und nicht gespeichert war, ist verloren: Das Board ist neu gestartet. Vorher in Gebrauch: %1</numerusform>
            <numerusform>%n Werte, die benutzt und nicht gespeichert waren, sind verloren: Das Board ist neu gestartet. Vorher in Gebrauch: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>The board did not get what was set while it was silent: %1. It uses %2.</source>
        <translation>Was gesetzt wurde, während das Board schwieg, ist dort nicht angekommen: %1. Es benutzt %2.</translation>
    </message>
    <message>
        <source>The motors run: the board has carried out the start that it did not answer to.</source>
        <translation>Die Motoren laufen: Das Board hat den Start ausgeführt, auf den es nicht geantwortet hatte.</translation>
    </message>
    <message>
        <source>The board did not answer to “%1”.</source>
        <translation>Das Board hat auf „%1“ nicht geantwortet.</translation>
    </message>
    <message>
        <source>It may carry it out yet, at any moment.</source>
        <translation>Es kann das noch ausführen, jederzeit.</translation>
    </message>
    <message>
        <source>Keep your hands off the gimbal, or have the motors stopped (F12).</source>
        <translation>Lassen Sie die Hände vom Gimbal, oder stoppen Sie die Motoren (F12).</translation>
    </message>
    <message>
        <source>The board confirms that it has stored; only its next start shows it. The settings as they were are kept in %1</source>
        <translation>Das Board bestätigt, dass es gespeichert hat; zeigen wird es erst sein nächster Start. Die Einstellungen von vorher liegen in %1</translation>
    </message>
    <message>
        <source>%1 is stored otherwise than it is used</source>
        <translation>%1 ist anders gespeichert als verwendet</translation>
    </message>
    <message>
        <source>The link was gone when it was set: %1 is not in use. Set it again when the board is back.</source>
        <translation>Als der Wert gesetzt wurde, war die Verbindung weg: %1 ist nicht in Gebrauch. Setzen Sie ihn noch einmal, wenn das Board wieder da ist.</translation>
    </message>
    <message>
        <source>“%1” is not possible with the text that the board has: %2. Nothing was changed. Mend the text there, write it, then try again.</source>
        <translation>„%1“ ist mit dem Text, den das Board hat, nicht möglich: %2. Nichts wurde geändert. Bessern Sie den Text dort aus, schreiben Sie ihn, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Open the text at line %1</source>
        <translation>Text bei Zeile %1 öffnen</translation>
    </message>
    <message>
        <source>Open the text</source>
        <translation>Text öffnen</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Jetzt nicht</translation>
    </message>
    <message>
        <source>It is armed from here.</source>
        <translation>Sie ist von hier scharf geschaltet.</translation>
    </message>
    <message>
        <source>Nothing is written, stored or begun while its motors may turn.</source>
        <translation>Solange ihre Motoren drehen können, wird nichts geschrieben, gespeichert oder begonnen.</translation>
    </message>
    <message>
        <source>Disarm it first, on the page “Flight”.</source>
        <translation>Zuerst entschärfen, auf der Seite „Flug“.</translation>
    </message>
    <message>
        <source>It tells no attitude before a calibration</source>
        <translation>Vor einer Kalibrierung meldet sie keine Lage</translation>
    </message>
    <message>
        <source>No attitude yet</source>
        <translation>Noch keine Lage</translation>
    </message>
    <message>
        <source>Keep clear of the propellers, or stop them (F12).</source>
        <translation>Von den Propellern fernbleiben oder sie stoppen (F12).</translation>
    </message>
    <message>
        <source>You stopped “%1”.</source>
        <translation>Sie haben „%1“ gestoppt.</translation>
    </message>
    <message>
        <source>It had begun, and the board heard nothing until it was over.</source>
        <translation>Es hatte begonnen, und bis es vorbei war, hörte das Board nichts.</translation>
    </message>
    <message>
        <source>The motors are proven to stand.</source>
        <translation>Die Motoren stehen, das ist bewiesen.</translation>
    </message>
    <message>
        <source>That the motors stand is not proven yet.</source>
        <translation>Dass die Motoren stehen, ist noch nicht bewiesen.</translation>
    </message>
    <message>
        <source>Keep clear of the propellers, or have the motors stopped (F12).</source>
        <translation>Von den Propellern fernbleiben oder die Motoren stoppen (F12).</translation>
    </message>
    <message>
        <source>What they say of its motors is old.</source>
        <translation>Was sie über seine Motoren sagen, ist alt.</translation>
    </message>
    <message>
        <source>Read the board again; if parts keep missing, check its cable or network, and its power.</source>
        <translation>Das Board noch einmal lesen; fehlen weiter Teile, Kabel oder Netz und Versorgung prüfen.</translation>
    </message>
    <message>
        <source>“%1” is not begun: a control session is open in which the propellers are on.</source>
        <translation>„%1“ wird nicht begonnen: Es ist eine Steuersitzung offen, in der die Propeller dran sind.</translation>
    </message>
    <message>
        <source>It turns motors, and may only do so without propellers.</source>
        <translation>Das dreht Motoren und darf es nur ohne Propeller.</translation>
    </message>
    <message>
        <source>Close the session on the page “Flight”, and take the propellers off.</source>
        <translation>Die Sitzung auf der Seite „Flug“ schließen und die Propeller abnehmen.</translation>
    </message>
</context>
</TS>
