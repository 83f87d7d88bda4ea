<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>AlarmBar</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>AlarmText</name>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n value</numerusform>
            <numerusform>%n values</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>BackupsPage</name>
    <message numerus="yes">
        <source>%n value(s) differ.</source>
        <translation>
            <numerusform>%n value differs.</numerusform>
            <numerusform>%n values differ.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>BatteryView</name>
    <message numerus="yes">
        <source>%n cell(s) by the voltage, %1 V each</source>
        <translation>
            <numerusform>%n cell by the voltage, %1 V each</numerusform>
            <numerusform>%n cells by the voltage, %1 V each</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>BoardWriter</name>
    <message numerus="yes">
        <source>%n value(s) written and read back.</source>
        <translation>
            <numerusform>%n value written and read back.</numerusform>
            <numerusform>%n values written and read back.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Finish: write %n value(s)</source>
        <translation>
            <numerusform>Finish: write %n value</numerusform>
            <numerusform>Finish: write %n values</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other value(s) stay in use without being stored: %1</source>
        <translation>
            <numerusform>%n other value stays in use without being stored: %1</numerusform>
            <numerusform>%n other values stay in use without being stored: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other value(s) in use are stored too: %1</source>
        <translation>
            <numerusform>%n other value in use is stored too: %1</numerusform>
            <numerusform>%n other values in use are stored too: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other value(s) are in use as they are stored again: %1</source>
        <translation>
            <numerusform>%n other value is in use as it is stored again: %1</numerusform>
            <numerusform>%n other values are in use as they are stored again: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Revert %n value(s)</source>
        <translation>
            <numerusform>Revert %n value</numerusform>
            <numerusform>Revert %n values</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ChannelModel</name>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n value</numerusform>
            <numerusform>%n values</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ErrorText</name>
    <message numerus="yes">
        <source>%n verified</source>
        <translation>
            <numerusform>%n verified</numerusform>
            <numerusform>%n verified</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n put back</source>
        <translation>
            <numerusform>%n put back</numerusform>
            <numerusform>%n put back</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unknown</source>
        <translation>
            <numerusform>%n unknown</numerusform>
            <numerusform>%n unknown</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not written</source>
        <translation>
            <numerusform>%n not written</numerusform>
            <numerusform>%n not written</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n different</source>
        <translation>
            <numerusform>%n different</numerusform>
            <numerusform>%n different</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>What the board holds of %n value(s) could not be read.</source>
        <translation>
            <numerusform>What the board holds of %n value could not be read.</numerusform>
            <numerusform>What the board holds of %n values could not be read.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The board was read again: %n value(s) are not as they were before.</source>
        <translation>
            <numerusform>The board was read again: %n value is not as it was before.</numerusform>
            <numerusform>The board was read again: %n values are not as they were before.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Leaving</name>
    <message numerus="yes">
        <source>%n change(s) are not on the board.</source>
        <translation>
            <numerusform>%n change is not on the board.</numerusform>
            <numerusform>%n changes are not on the board.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LinkMarks</name>
    <message numerus="yes">
        <source>%n value(s) written</source>
        <translation>
            <numerusform>%n value written</numerusform>
            <numerusform>%n values written</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Notifications</name>
    <message numerus="yes">
        <source>%n part(s) of it cannot be read and are left out, %1 in all.</source>
        <translation>
            <numerusform>%n part of it cannot be read and is left out, %1 in all.</numerusform>
            <numerusform>%n parts of it cannot be read and are left out, %1 in all.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>NumberBox</name>
    <message numerus="yes">
        <source>At most %n decimal(s), %1</source>
        <translation>
            <numerusform>At most %n decimal, %1</numerusform>
            <numerusform>At most %n decimals, %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>OfferBar</name>
    <message numerus="yes">
        <source>%n open question(s)</source>
        <translation>
            <numerusform>%n open question</numerusform>
            <numerusform>%n open questions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ProfileModel</name>
    <message numerus="yes">
        <source>%n unsaved</source>
        <translation>
            <numerusform>%n unsaved</numerusform>
            <numerusform>%n unsaved</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>differs in %n value(s)</source>
        <translation>
            <numerusform>differs in %n value</numerusform>
            <numerusform>differs in %n values</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ReviewDialog</name>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n value</numerusform>
            <numerusform>%n values</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other value(s) in use are not stored:</source>
        <translation>
            <numerusform>%n other value in use is not stored:</numerusform>
            <numerusform>%n other values in use are not stored:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SensorPage</name>
    <message numerus="yes">
        <source>%1 is done. %n face(s) to go: turn the sensor.</source>
        <translation>
            <numerusform>%1 is done. %n face to go: turn the sensor.</numerusform>
            <numerusform>%1 is done. %n faces to go: turn the sensor.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SpectrumPage</name>
    <message numerus="yes">
        <source>%1 samples/s, lines of %2 Hz, %n average(s)</source>
        <translation>
            <numerusform>%1 samples/s, lines of %2 Hz, %n average</numerusform>
            <numerusform>%1 samples/s, lines of %2 Hz, %n averages</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StreamsDialog</name>
    <message numerus="yes">
        <source>Carries %n channel(s), all of them each time</source>
        <translation>
            <numerusform>Carries %n channel</numerusform>
            <numerusform>Carries %n channels, all of them each time</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TuningPage</name>
    <message numerus="yes">
        <source>%n value(s) in use, not stored</source>
        <translation>
            <numerusform>%n value in use, not stored</numerusform>
            <numerusform>%n values in use, not stored</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>UnsavedBar</name>
    <message numerus="yes">
        <source>%n unsaved change(s)</source>
        <translation>
            <numerusform>%n unsaved change</numerusform>
            <numerusform>%n unsaved changes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>UnstoredBar</name>
    <message numerus="yes">
        <source>%n value(s) in use on the board, not stored: a restart loses them.</source>
        <translation>
            <numerusform>%n value in use on the board, not stored: a restart loses it.</numerusform>
            <numerusform>%n values in use on the board, not stored: a restart loses them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Workspace</name>
    <message numerus="yes">
        <source>Finish: write %n value(s)</source>
        <translation>
            <numerusform>Finish: write %n value</numerusform>
            <numerusform>Finish: write %n values</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved step(s) of an earlier run belong to this board.</source>
        <translation>
            <numerusform>%n unsaved step of an earlier run belongs to this board.</numerusform>
            <numerusform>%n unsaved steps of an earlier run belong to this board.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) of the file are unknown and were left out.</source>
        <translation>
            <numerusform>%n entry of the file is unknown and was left out.</numerusform>
            <numerusform>%n entries of the file are unknown and were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) of the file do not fit this board and were left out: %1</source>
        <translation>
            <numerusform>%n value of the file does not fit this board and was left out: %1</numerusform>
            <numerusform>%n values of the file do not fit this board and were left out: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) are not in the file and got their defaults: %1</source>
        <translation>
            <numerusform>%n value is not in the file and got its default: %1</numerusform>
            <numerusform>%n values are not in the file and got their defaults: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Revert %n value(s)</source>
        <translation>
            <numerusform>Revert %n value</numerusform>
            <numerusform>Revert %n values</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unfinished text(s) of an earlier run belong to this board.</source>
        <translation>
            <numerusform>%n unfinished text of an earlier run belongs to this board.</numerusform>
            <numerusform>%n unfinished texts of an earlier run belong to this board.</numerusform>
        </translation>
    </message>
</context>
</TS>
