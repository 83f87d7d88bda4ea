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
    <message numerus="yes">
        <source>By its voltage it has %n cell(s) of %1 V, which are not low: the alarm is meant for a battery with more cells. If it has more, it is nearly empty.</source>
        <translation>
            <numerusform>By its voltage it has %n cell of %1 V, which is not low: the alarm is meant for a battery with more cells. If it has more, it is nearly empty.</numerusform>
            <numerusform>By its voltage it has %n cells of %1 V, which are not low: the alarm is meant for a battery with more cells. If it has more, it is nearly empty.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Count its cells: if it has %n, correct the battery&apos;s alarm in the board; if it has more, change it.</source>
        <translation>
            <numerusform>Count its cells: if it has %n, correct the battery&apos;s alarm in the board; if it has more, change it.</numerusform>
            <numerusform>Count its cells: if it has %n, correct the battery&apos;s alarm in the board; if it has more, change it.</numerusform>
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
    <message numerus="yes">
        <source>Compared with what the board holds; %n unwritten change(s) are left aside.</source>
        <translation>
            <numerusform>Compared with what the board holds; %n unwritten change is left aside.</numerusform>
            <numerusform>Compared with what the board holds; %n unwritten changes are left aside.</numerusform>
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
    <message numerus="yes">
        <source>%n cell(s) as the board counts, %1 V each</source>
        <translation>
            <numerusform>%n cell as the board counts, %1 V each</numerusform>
            <numerusform>%n cells as the board counts, %1 V each</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>BenchPage</name>
    <message numerus="yes">
        <source>The drone has %n motor(s).</source>
        <translation>
            <numerusform>The drone has %n motor.</numerusform>
            <numerusform>The drone has %n motors.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The drone hears nothing for %n more second(s), also no stop. Stop motors (F12) is then the first thing that it hears. To stop it at once: its battery.</source>
        <translation>
            <numerusform>The drone hears nothing for %n more second, also no stop. Stop motors (F12) is then the first thing that it hears. To stop it at once: its battery.</numerusform>
            <numerusform>The drone hears nothing for %n more seconds, also no stop. Stop motors (F12) is then the first thing that it hears. To stop it at once: its battery.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>BlackBoxPage</name>
    <message numerus="yes">
        <source>%n line(s)</source>
        <translation>
            <numerusform>%n line</numerusform>
            <numerusform>%n lines</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n name(s)</source>
        <translation>
            <numerusform>%n name</numerusform>
            <numerusform>%n names</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) of the file could not be read.</source>
        <translation>
            <numerusform>%n place of the file could not be read.</numerusform>
            <numerusform>%n places of the file could not be read.</numerusform>
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
    <message numerus="yes">
        <source>%n of them the board had used already: its next start shows whether they are stored.</source>
        <translation>
            <numerusform>%n of them the board had used already: its next start shows whether it is stored.</numerusform>
            <numerusform>%n of them the board had used already: its next start shows whether they are stored.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CameraPage</name>
    <message numerus="yes">
        <source>%n frame(s) lost</source>
        <translation>
            <numerusform>%n frame lost</numerusform>
            <numerusform>%n frames lost</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged picture(s)</source>
        <translation>
            <numerusform>%n damaged picture</numerusform>
            <numerusform>%n damaged pictures</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) that could not be decoded</source>
        <translation>
            <numerusform>%n frame that could not be decoded</numerusform>
            <numerusform>%n frames that could not be decoded</numerusform>
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
    <message numerus="yes">
        <source>%n value(s) came that are no numbers, or not initialised; they are gaps.</source>
        <translation>
            <numerusform>%n value came that is no number, or not initialised; it is a gap.</numerusform>
            <numerusform>%n values came that are no numbers, or not initialised; they are gaps.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CopyCard</name>
    <message numerus="yes">
        <source>%n byte(s)</source>
        <translation>
            <numerusform>%n byte</numerusform>
            <numerusform>%n bytes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) of memory differ.</source>
        <translation>
            <numerusform>%n byte of memory differs.</numerusform>
            <numerusform>%n bytes of memory differ.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) differ.</source>
        <translation>
            <numerusform>%n file differs.</numerusform>
            <numerusform>%n files differ.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) of memory are copied.</source>
        <translation>
            <numerusform>%n byte of memory is copied.</numerusform>
            <numerusform>%n bytes of memory are copied.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) are copied.</source>
        <translation>
            <numerusform>%n file is copied.</numerusform>
            <numerusform>%n files are copied.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n byte(s) of memory were written.</source>
        <translation>
            <numerusform>%n byte of memory was written.</numerusform>
            <numerusform>%n bytes of memory were written.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were written or erased.</source>
        <translation>
            <numerusform>%n file was written or erased.</numerusform>
            <numerusform>%n files were written or erased.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>What lies in %n range(s) is documented nowhere.</source>
        <translation>
            <numerusform>What lies in %n range is documented nowhere.</numerusform>
            <numerusform>What lies in %n ranges is documented nowhere.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>DiffView</name>
    <message numerus="yes">
        <source>⋯ %n line(s) without a difference</source>
        <translation>
            <numerusform>⋯ %n line without a difference</numerusform>
            <numerusform>⋯ %n lines without a difference</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>DocumentsPage</name>
    <message numerus="yes">
        <source>%n line(s) added</source>
        <translation>
            <numerusform>%n line added</numerusform>
            <numerusform>%n lines added</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) removed</source>
        <translation>
            <numerusform>%n line removed</numerusform>
            <numerusform>%n lines removed</numerusform>
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
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) in use are not as they were before.</source>
        <translation>
            <numerusform>%n value in use is not as it was before.</numerusform>
            <numerusform>%n values in use are not as they were before.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The board was read again: it has stored %n other value(s) than before.</source>
        <translation>
            <numerusform>The board was read again: it has stored %n other value than before.</numerusform>
            <numerusform>The board was read again: it has stored %n other values than before.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FirmwareText</name>
    <message numerus="yes">
        <source>%n parameter(s)</source>
        <translation>
            <numerusform>%n parameter</numerusform>
            <numerusform>%n parameters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n action(s)</source>
        <translation>
            <numerusform>%n action</numerusform>
            <numerusform>%n actions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n live variable(s)</source>
        <translation>
            <numerusform>%n live variable</numerusform>
            <numerusform>%n live variables</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n way(s) of steering</source>
        <translation>
            <numerusform>%n way of steering</numerusform>
            <numerusform>%n ways of steering</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stream(s)</source>
        <translation>
            <numerusform>%n stream</numerusform>
            <numerusform>%n streams</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n channel(s) of live data</source>
        <translation>
            <numerusform>%n channel of live data</numerusform>
            <numerusform>%n channels of live data</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n parameter(s) no longer</source>
        <translation>
            <numerusform>%n parameter no longer</numerusform>
            <numerusform>%n parameters no longer</numerusform>
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
        <source>differs in %n value(s)</source>
        <translation>
            <numerusform>differs in %n value</numerusform>
            <numerusform>differs in %n values</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unwritten</source>
        <translation>
            <numerusform>%n unwritten</numerusform>
            <numerusform>%n unwritten</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Questions</name>
    <message numerus="yes">
        <source>%n value(s) in use are not stored and will be lost: %1</source>
        <translation>
            <numerusform>%n value in use is not stored and will be lost: %1</numerusform>
            <numerusform>%n values in use are not stored and will be lost: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RecordingsPage</name>
    <message numerus="yes">
        <source>%n recording(s), %1</source>
        <translation>
            <numerusform>%n recording, %1</numerusform>
            <numerusform>%n recordings, %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) of its list could not be read.</source>
        <translation>
            <numerusform>%n entry of its list could not be read.</numerusform>
            <numerusform>%n entries of its list could not be read.</numerusform>
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
    <message numerus="yes">
        <source>%n other value(s) in use are not stored; the board goes back to the stored ones:</source>
        <translation>
            <numerusform>%n other value in use is not stored; the board goes back to the stored one:</numerusform>
            <numerusform>%n other values in use are not stored; the board goes back to the stored ones:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ScriptSlotsPage</name>
    <message numerus="yes">
        <source>%n byte(s)</source>
        <translation>
            <numerusform>%n byte</numerusform>
            <numerusform>%n bytes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No other command for %n second(s): it waits, or has ended.</source>
        <translation>
            <numerusform>No other command for %n second: it waits, or has ended.</numerusform>
            <numerusform>No other command for %n seconds: it waits, or has ended.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ScriptsPage</name>
    <message numerus="yes">
        <source>The texts of %n other script(s) that were not taken over are lost as well.</source>
        <translation>
            <numerusform>The text of %n other script that was not taken over is lost as well.</numerusform>
            <numerusform>The texts of %n other scripts that were not taken over are lost as well.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SearchBar</name>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n place</numerusform>
            <numerusform>%n places</numerusform>
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
    <name>ShareDialog</name>
    <message numerus="yes">
        <source>with %n unwritten change(s)</source>
        <translation>
            <numerusform>with %n unwritten change</numerusform>
            <numerusform>with %n unwritten changes</numerusform>
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
        <source>%n entry(s) that are no values</source>
        <translation>
            <numerusform>%n entry that is no value</numerusform>
            <numerusform>%n entries that are no values</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n no value</source>
        <translation>
            <numerusform>%n no value</numerusform>
            <numerusform>%n no values</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unwritten change(s)</source>
        <translation>
            <numerusform>%n unwritten change</numerusform>
            <numerusform>%n unwritten changes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unwritten</source>
        <translation>
            <numerusform>%n unwritten</numerusform>
            <numerusform>%n unwritten</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>UnstoredBar</name>
    <message numerus="yes">
        <source>%n not stored</source>
        <translation>
            <numerusform>%n not stored</numerusform>
            <numerusform>%n not stored</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Whether %n value(s) set last are in use is not known: the board has not answered.</source>
        <translation>
            <numerusform>Whether %n value set last is in use is not known: the board has not answered.</numerusform>
            <numerusform>Whether %n values set last are in use is not known: the board has not answered.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not known</source>
        <translation>
            <numerusform>%n not known</numerusform>
            <numerusform>%n not known</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) set live, not stored: a restart loses them.</source>
        <translation>
            <numerusform>%n value set live, not stored: a restart loses it.</numerusform>
            <numerusform>%n values set live, not stored: a restart loses them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) set live, not stored; whether others are is not known.</source>
        <translation>
            <numerusform>%n value set live, not stored; whether others are is not known.</numerusform>
            <numerusform>%n values set live, not stored; whether others are is not known.</numerusform>
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
        <source>%n value(s) of the file do not fit this board and were left out: %1</source>
        <translation>
            <numerusform>%n value of the file does not fit this board and was left out: %1</numerusform>
            <numerusform>%n values of the file do not fit this board and were left out: %1</numerusform>
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
    <message numerus="yes">
        <source>%n edit(s) do not fit this board any more and were left out.</source>
        <translation>
            <numerusform>%n edit does not fit this board any more and was left out.</numerusform>
            <numerusform>%n edits do not fit this board any more and were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) of the file are unknown and were left out: %1</source>
        <translation>
            <numerusform>%n entry of the file is unknown and was left out: %1</numerusform>
            <numerusform>%n entries of the file are unknown and were left out: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unwritten step(s) of an earlier run belong to this board.</source>
        <translation>
            <numerusform>%n unwritten step of an earlier run belongs to this board.</numerusform>
            <numerusform>%n unwritten steps of an earlier run belong to this board.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unwritten change(s) belong to the board before (%1) and are kept for it; they are offered when it is connected again.</source>
        <translation>
            <numerusform>%n unwritten change belongs to the board before (%1) and is kept for it; it is offered when that board is connected again.</numerusform>
            <numerusform>%n unwritten changes belong to the board before (%1) and are kept for it; they are offered when that board is connected again.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The board that answers looks like the one before, but %n of its values differ from what was read then. Is it the same one?</source>
        <translation>
            <numerusform>The board that answers looks like the one before, but %n of its values differs from what was read then. Is it the same one?</numerusform>
            <numerusform>The board that answers looks like the one before, but %n of its values differ from what was read then. Is it the same one?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) on the board differ from what was read before the link ended.</source>
        <translation>
            <numerusform>%n value on the board differs from what was read before the link ended.</numerusform>
            <numerusform>%n values on the board differ from what was read before the link ended.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The file holds %n unwritten change(s): it is not what the board holds.</source>
        <translation>
            <numerusform>The file holds %n unwritten change: it is not what the board holds.</numerusform>
            <numerusform>The file holds %n unwritten changes: it is not what the board holds.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) are not in the file; what is shown for them are defaults: %1</source>
        <translation>
            <numerusform>%n value is not in the file; what is shown for it is the default: %1</numerusform>
            <numerusform>%n values are not in the file; what is shown for them are defaults: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) are not in the file and stay as they are: %1</source>
        <translation>
            <numerusform>%n value is not in the file and stays as it is: %1</numerusform>
            <numerusform>%n values are not in the file and stay as they are: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) of the file were rounded to what the board can hold: %1</source>
        <translation>
            <numerusform>%n value of the file was rounded to what the board can hold: %1</numerusform>
            <numerusform>%n values of the file were rounded to what the board can hold: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) that were in use without being stored are lost: the board restarted. In use before: %1</source>
        <translation>
            <numerusform>%n value that was in use without being stored is lost: the board restarted. In use before: %1</numerusform>
            <numerusform>%n values that were in use without being stored are lost: the board restarted. In use before: %1</numerusform>
        </translation>
    </message>
</context>
</TS>
