<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>ActionsPage</name>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ Can move the camera or change how it is held, until the next start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ Changes permanent memory; a snapshot is taken first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ Overwrites settings; a snapshot is taken first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions of this board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The reply of the board comes here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: overwrite settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board as it was is kept in %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AdjustableModel</name>
    <message>
        <source>Takes effect at once, in volatile memory, from %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 to %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ArgumentForm</name>
    <message>
        <source>leave alone (%1 to %2 %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AttitudeView</name>
    <message>
        <source>Attitude of the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll %1°, pitch %2°, yaw %3°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No attitude yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AutoTunePage</name>
    <message>
        <source>Auto-tune</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start: the camera will shake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop and put the old gains back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept and save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the old gains back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gains by iteration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tracking error by iteration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gains before and now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search again: the camera will shake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the gimbal in your hand or on a stand, balanced, with all motors running. The board moves the camera a little to find gains; the lower “gain against stability”, the calmer the result. Nothing is saved before you accept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board is searching. Keep the gimbal as it is. F12 or the red button stops everything.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The new gains are in use, but not saved. Try them: turn the gimbal by hand and look at Tuning. Then accept them or put the old ones back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iteration %1. Keep the gimbal as it is. F12 or the red button stops everything.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was saved. The board may still use what it has found so far, until its next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When it is connected again, look at Tuning: “Revert all” puts the stored gains back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gains of before are in use again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AxisDial</name>
    <message>
        <source>Angle %1°, target %2°, motor power %3 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor power %1 %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BackupsPage</name>
    <message>
        <source>by the operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before the first write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unsaved edits of an earlier run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before the action %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a snapshot now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore as edits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the snapshot&apos;s values into the forms; nothing is on the board before you review and write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the snapshot to a file of your choice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapshots of this board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Differences between the snapshot and now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What differs from now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GimbalDesk configurations (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No snapshot yet. One is taken before the first write to a board, and before each action that writes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All values are the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) differ.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Profile names differ.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CalibrationPage</name>
    <message>
        <source>Z up (level)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Z down (upside down)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Y up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Y down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tilted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>usable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>poor, repeat it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated gimbal: your hands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the simulated sensor is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the gimbal, in your hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lies still: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gyroscope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finds the zero of the turn-rate sensor. Do it when the camera drifts, after great changes of temperature, and before anything else. Takes about ten seconds, with the camera lying still.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate the gyroscope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accelerometer, level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finds what is level. Do it when the horizon is crooked. Takes about ten seconds, with the sensor lying level.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accelerometer, six positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finds zero and scale of all three directions, for a horizon that stays straight at every angle. Do it once for each sensor; each of its six faces has to lie up once. Takes about two minutes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate six positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stillness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finish</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lay the camera down so that nothing moves it. Take your hands off the table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the sensor level, Z up, and let it lie still.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lay the sensor on one of its six faces. Begin with Z up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of 6 done. Lay the sensor on another face.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring. Leave it absolutely still for about %1 seconds; the motors are off meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If it is moved, the board begins again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for live data of the sensor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It moves (%1 °/s). Waiting until it is still.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Still, but not level: %1. Waiting for Z up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Still, but tilted. Waiting until one face lies up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is done already. Waiting for another face.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ Still, %1. Ready.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The calibration was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board may still finish this measurement by itself within a few seconds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate again when the sensor lies still.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gyroscope: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accelerometer: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drift before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 °/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drift now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise of the sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good is a drift below %1 °/s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error against gravity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 g</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That is a tilt of about</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good is an error below %1 g; the noise of the sensor is part of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The result is stored in the sensor&apos;s memory; the settings as they were are among the backups.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ChangeModel</name>
    <message>
        <source>Profile name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ChannelModel</name>
    <message>
        <source>Channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CommandPalette</name>
    <message>
        <source>Go to or do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page, parameter, channel or action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Matches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Review and write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ConsolePage</name>
    <message>
        <source>Console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live data too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow commands that change something</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter (Ctrl+F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the frames of streamed live data as well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save all frames listed as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a frame to see all of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command to send</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command: a name with payload bytes (READ_PARAMS_3 00), or a whole frame in hex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands that write take a snapshot first; motors may move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text files (*.txt)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not sent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It can move the camera or change settings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick “Allow commands that change something” to send it all the same.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ControlPad</name>
    <message>
        <source>Steering pad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag, or hold the arrow keys; Shift for slow</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ControlPage</name>
    <message>
        <source>Control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While armed the camera moves as you steer. Let go, leave this page or press Esc to end it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode of control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angles to go to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 °/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>■ Disarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armed: the camera follows you. It stops when you let go, leave this page, or do nothing for %1 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not armed: nothing is sent. Choose a mode, then arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control was disarmed: nothing was moved for %1 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>target</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DashboardPage</name>
    <message>
        <source>Dashboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes: angle and target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of the board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensor temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensor bus errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames received</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 per second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Damaged frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answer time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No live data yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● Motors are running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>○ Motors are off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ The board reports no errors.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DebugModel</name>
    <message>
        <source>unknown type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DebugPage</name>
    <message>
        <source>Debug variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget bounds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start lowest, highest and the curve anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Course</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What these variables mean is known to the firmware&apos;s makers only; they help a supporter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>EditStack</name>
    <message>
        <source>Profile name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard all changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy profile %1 onto profile %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ErrorText</name>
    <message>
        <source>Cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board did not answer in time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It may be busy, restarting, or the cable may be disturbed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again; if it stays so, check cable and power.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link to the board broke.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board keeps doing what it did.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check cable and power; the program connects again by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no such port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The adapter is not plugged in, or it has another name now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug it in and choose it from the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You may not open this port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On Linux, serial ports belong to the group dialout.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run “sudo usermod -aG dialout $USER”, then log in anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program holds this port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only one program can talk to a board at a time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the other program (ModemManager is a usual suspect), then connect again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing answers at this network address.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check address and port, and that the bridge or simulator is running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The port is open, but no board answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All rates and parities were tried.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the board has power, that RX and TX are crossed, and that this is the right port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes arrive, but they make no sense.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rate is unknown, the cable is disturbed, or it is another kind of device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check cable and ground, and that this is the gimbal&apos;s port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This device speaks another protocol.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is not a board of the chosen family.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the right family, or another port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board is open for reading only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its firmware, or this value, must not be written by this version of the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update the program, or change the value with the board maker&apos;s tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board refused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was changed by this command.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board&apos;s answer is not what its document promises.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again; if it stays so, the firmware is not supported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That does not make sense.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value is outside its range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board cannot do that.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Somebody else changed the board since it was read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the board again, look at the differences, then write.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board does not hold what was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The old values were put back as far as the board let us.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the report; try again, or restore the snapshot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file cannot be used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No board is connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect one, or try the simulated gimbal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No safety copy could be made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Therefore nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the disk has space and that the folder may be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another job is still running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for it or cancel it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for a board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for a board at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading back %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Putting back %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrating: keep the camera absolutely still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto-tune, iteration %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steering</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FrameLogModel</name>
    <message>
        <source>Payload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Complete frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>← board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>→ board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HelpCard</name>
    <message>
        <source>What a value does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a field: its effect, range, default and what the board holds stand here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the whole board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ Risk: a wrong value can make a motor run away or overheat.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HelpPage</name>
    <message>
        <source>en</source>
        <comment>folder of the help texts</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search all texts (Ctrl+F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Topics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help text</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LinkBar</name>
    <message>
        <source>Connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Port or address of the board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial port, tcp://host:port, or the simulated gimbal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Port or tcp://host:port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Active profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Active profile of the board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F12 switches the motors off from anywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link lost, connecting again…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · firmware %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>■ MOTORS OFF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▶ Motors on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch motors off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch motors on</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Hold Esc to switch the motors off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a configuration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GimbalDesk configurations (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the configuration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n change(s) are not on the board.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Quit and keep them for next time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard and quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stay</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MessageBar</name>
    <message>
        <source>Details</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy everything a supporter needs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close message</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MonitorPage</name>
    <message>
        <source>Monitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick channels on the left to see them here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the picture still while data goes on (Space in the plot). The wheel zooms, dragging moves, arrow keys move the cursor, End goes on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save what is seen as a CSV file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Telemetry channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lines saved to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 samples/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>polled, up to %1 samples/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Navigation</name>
    <message>
        <source>Pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, with unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Dashboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Watch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Debug variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tune</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto-tune</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adjustable variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ParameterModel</name>
    <message>
        <source>Parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ParametersPage</name>
    <message>
        <source>Parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ Risk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing matches. Change the search, the filters or the level.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Basic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much to show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks in names, keys and help of all parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All parameters</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlotView</name>
    <message>
        <source>Live plot</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ProfileModel</name>
    <message>
        <source>● active</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>differs in %n value(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>same values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Against the active profile</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ProfilesPage</name>
    <message>
        <source>GimbalDesk configurations (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make active</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy onto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load from file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save to file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load all profiles…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile to copy onto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board uses this profile from now on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the name (F2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take all values of the chosen profile over into another one, as an edit that can be undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take one profile of a file over into the chosen profile, as an edit that can be undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save all profiles with their unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take everything in a file over, as one edit that can be undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copying, renaming and loading are edits: nothing is on the board before you review and write. Board-wide values (sensors, motors&apos; outputs, ports) belong to no profile and stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name of profile %1 is too long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has %1 bytes, the board holds %2; an accented letter counts as two.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a shorter one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load a profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load all profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load into profile %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profiles of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which profile of %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ReviewDialog</name>
    <message>
        <source>Review and write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These values go to the board. They are read back and compared, and a copy of the whole board is kept before the first write.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes to write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ Values of the risk class are among them: hold the camera, or take it off, while motors start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Write %1 to %2 profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SensorCube</name>
    <message>
        <source>Position of the sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tilted</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SettingsPage</name>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the motors off when the program is closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language changes at the next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degrees Celsius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degrees Fahrenheit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not by Esc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> °/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look and language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperatures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep in memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold Esc to switch motors off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest speed on Control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disarm control after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Always so, and not to be switched off: a snapshot before the first write, reading back of every byte, F12 for motors off, and control that ends when the program does not refresh it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GimbalDesk %1, GPL 3.0 or later. Settings: %2. Snapshots: %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most %1 MB with 24 channels at full rate.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Sparkline</name>
    <message>
        <source>Course of the chosen variable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a variable to see its course</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StartPage</name>
    <message>
        <source>No gimbal yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug the controller in with USB or a serial adapter, choose its port at the top left and connect. Rate and parity are found by the program. Nothing is sent to a port you did not choose, and nothing is written without your review.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Choose a port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Try the simulated gimbal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at a snapshot or a saved configuration and edit it without a board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulated gimbal shakes, drifts and answers like a real one: a safe place to learn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes of an earlier run:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Board %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StatusStrip</name>
    <message>
        <source>Frames received per second, samples lost, answer time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offline: editing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1/s · %2 lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no errors</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Tables</name>
    <message>
        <source>Roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 MHz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2 MHz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>4 MHz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>500 kHz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A motor could not hold the camera.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ADC1 (analog)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ADC2 (analog)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ADC3 (analog)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ADC4 (analog)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 10</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 11</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 12</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 13</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 14</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 15</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 16</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 17</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 18</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 19</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 20</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 21</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 22</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 23</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 24</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 25</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 26</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 27</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 28</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 29</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 30</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 31</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API channel 9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration limit, all axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration limit, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration limit, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration limit, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration of moves the board makes by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration, X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration, Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration, Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accelerometer low-pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accelerometer not calibrated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action at start; 128 is added where the menu button must be held.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action for so many presses of the menu button.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action when the command channel is high.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action when the command channel is in the middle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action when the command channel is low.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action when the menu button is held.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Active profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adaptive PID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adaptive PID: rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adaptive PID: recovery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adaptive PID: threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adaptive gyro trust</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added to the signal, in 1/128 of half the range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarm below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Always calibrate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle at start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle between encoder zero and the motor&apos;s field; found by calibration. Wrong, the motor runs away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle between frame and camera that the axis does not go above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle between frame and camera that the axis does not go below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle between magnetic and true north at this place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle over which following of roll comes in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle relative to frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle, shortest way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle: the stick position is the camera angle. Speed: the stick position is the speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As RC signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As RC signal, fine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attitude vectors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto PID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto PID gain against stability</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto PID momentum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto PID options</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto PID target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto PID, gain only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto-tune PID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic move: acceleration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic move: speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes among which the board chooses by position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes and options that the automatic tuning on the board starts with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes that MAVLink commands steer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes whose gains are lowered while they vibrate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis of the camera that this motor stabilizes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bad frames received</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balance error, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balance error, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balance error, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balance the camera, or raise the power of that motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery is low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery voltage at which the alarm sounds; negative = off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery voltage at which the motors are switched off; negative = never.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beeper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beeper volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Below yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Below yaw, PID source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bind RC receiver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bit 3 of the snap byte, without documented meaning. Kept as read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bit 4, without documented meaning. Kept as read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bits 4-7 of the mode byte, without documented meaning. Kept as read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bits 5 and 6 of the type byte, without documented meaning. Kept as read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bits 7-15, without documented meaning. Kept as read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blink the battery state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blink the profile number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Board options</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Board state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boost power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Buzzer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate accelerometer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate accelerometer (automatic)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate accelerometer (temperature)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate external gyroscope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate follow offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate gyroscope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate gyroscope (temperature)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate magnetometer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate momentum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate momentum automatically</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate voltage sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration stimulus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera angle taken at power-up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera angle, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera angle, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera angle, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera may work upside-down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera, target and motor angles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera: photo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera: record or photo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Center of the band that is taken out; set it on the resonance of the structure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Center yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Center yaw at start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Center yaw, shortest way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the battery soon.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the battery.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes a value in volatile memory; lost at the next start unless saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the cable and its ground.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the sensor cable and its connectors, then restart the board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the values before writing any.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clock of an SPI encoder; for an I2C driver the type of its own encoder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compensate from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Component ID of the gimbal; 154 is the standard one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confirmation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control in camera axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cooling factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corrects the neutral point of following, where the magnets do not meet the frame exactly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current at which power is lowered; 0 = no limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cycle time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D low-pass frequency, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D low-pass frequency, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D low-pass frequency, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D-term low-pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DSM2 11 ms 10 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DSM2 11 ms 11 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DSM2 22 ms 10 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DSM2 22 ms 11 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DSMX 11 ms 10 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DSMX 11 ms 11 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DSMX 22 ms 10 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DSMX 22 ms 11 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Damps the response. Too little overshoots, too much makes the structure ring at a high tone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dead band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth of the notch; negative makes it a peak.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detect ADC1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detect ADC2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detect ADC3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detect briefcase mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detect upside-down frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not check encoder limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not test the encoder at start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not use the accelerometer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Doubles the rate of the sensor bus; needs short, good cables.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Electrical field offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ellipticity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 19)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 20)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 21)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 22)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 23)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 24)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 25)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 26)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 27)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 28)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 29)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 30)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 31)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 32)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 33)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 34)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 35)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 36)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 37)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 38)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 39)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 40)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 41)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 42)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 43)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 44)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 45)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 46)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 47)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 48)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 49)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 50)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 51)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 52)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 53)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 54)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 55)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 56)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 57)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 58)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 59)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 60)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 61)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 62)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop (cause 63)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop cause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: CAN hardware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: I2C errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: IMU lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: bad IMU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: calibration failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: driver fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: driver too hot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: encoder and IMU disagree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: encoder scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: endless restarts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: internal fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: motor blocked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: motor poles or inversion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: motor too hot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: overload too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: too hot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop: wrong start position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encoder bus speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encoder gear ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encoder offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encoder reading in the normal position; found by calibration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encoder type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encoder type, further bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encoders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends of travel that count as parking position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Entering parking position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environment temperature unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimates acceleration of the frame from a motion model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimates the frame&apos;s tilt from the motors&apos; positions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Euler order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Even parity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Events that are signalled on the interrupt pin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Events that make a sound, and whether the motors make it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exponential curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extended low-pass range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>External LED pin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factory defaults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fast I2C (800 kHz)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filters and limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filters in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fine adjustment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firmware and tool differ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight controller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight controller below middle motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight controller below outer motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight controller gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight controller input, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight controller input, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow dead band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow exponential curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow flight controller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow inner dead band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow lock offset correction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow low-pass, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow low-pass, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow low-pass, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow off/on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow pitch and roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow range, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow range, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow range, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow roll mix, range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow roll mix, start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow speed, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow speed, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow speed, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow uses the frame IMU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forced follow on/off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Form of the command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Format of the Spektrum satellite receiver.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame IMU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame IMU feed-forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame IMU low-pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame IMU temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame IMU: axis right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame IMU: axis up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame IMU: place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame angle at which following reaches full speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame angle, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame angle, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame angle, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame angles from motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame heading angle (0.1°)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame is upside-down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame motion around the neutral point that is not followed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame upside-down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frequency above which the controller no longer reacts. Lower is quieter and slower.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Further board options</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gain against stability</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gain of the outer loop, from angle error to wanted speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Geared encoder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gearing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gravity error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gravity vector, x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gravity vector, y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gravity vector, z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gyro calibration at start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gyro dead band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gyro heading correction (0.001)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gyro sensitivity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gyro trust</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gyro, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gyro, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gyro, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heading correction factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heading error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heading vector, x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heading vector, y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heading vector, z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heating factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>High</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Home position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Home position of motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Home position, shortest way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast gains are lowered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast the camera follows the frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast this motor is taken to cool down.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast this motor is taken to warm up; 0 = no heat model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How long a time-lapse move takes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How long the camera must be held before its new position is taken over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much is still followed inside the dead band.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much the gyroscope counts against the accelerometer. More suits vehicles, less suits tripods.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much the inertia depends on the camera&apos;s position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How slowly gains come back; more is slower.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How strongly the heading follows the magnetometer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I2C driver 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I2C driver 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I2C driver 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I2C driver 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I2C errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IMU angle correction, pitch (0.01°)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IMU angle correction, roll (0.01°)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IMU temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ignore limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inertia of the axis as measured by calibration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inertial sensors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input that carries the flight controller&apos;s angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input that controls this axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input that is corrected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input whose pulses step the signal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input whose three positions run the commands low, middle and high.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Integral part of the outer loop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Internal I2C pull-ups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interrupt events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interrupt pin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interrupt, further bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Invert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Invert RC pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Invert RC roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Invert RC when upside-down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Invert RC yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jerk limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of a note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the motors cool, then lower the power.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level of the input that makes a step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level roll and pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits how fast commanded motion speeds up; 0 = no limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits how fast commanded motion speeds up; 0 = no limit. Replaced by the limit per axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List debug variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live values in the board&apos;s memory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load backup set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load profile set 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load profile set 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load profile set 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load profile set 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load profile set 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loudness of the sounds made by the motors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low (audible)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low-pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low-pass filter of following; more is smoother and later.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low-pass filter of the stick signal; more is smoother and later.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low-pass filter of the stick signal; more is smoother and later. Above 15 only with the extended range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low-pass frequency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low-pass frequency, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low-pass frequency, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low-pass frequency, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower end of the range that remote control can reach.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MA3 10 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MA3 12 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink channel %1: component ID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink channel %1: options</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink channel %1: port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink channel %1: system ID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MAVLink control mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnetic declination</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnetic link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnetic link (old)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnetometer on the frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnetometer trust</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnetometer, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnetometer, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnetometer, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnetometer: axis right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnetometer: axis up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Main IMU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Main IMU: axis right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Main IMU: axis up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a sound</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes a profile the active one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes following soft near the neutral point and fast far from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the middle of the stick finer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Matches the flight controller&apos;s angle signal to the frame; found by calibration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures the zero of the accelerometer in this position. The sensor must be level and still.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures the zero of the gyroscope. The camera must stand absolutely still.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Menu button disables follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Menu button press</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Menu button, %1 presses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Menu button, long press</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Menu command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimum angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mix into</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mix rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode, further bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model of the encoder on this axis. Wrong, the motor runs away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Momentum assumed by automatic tuning; 0 = found by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Momentum feed-forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More gives higher gains and less reserve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor angle that the axis does not go above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor angle that the axis does not go below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor angle, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor angle, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor angle, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor connector that drives this axis. Wrong, an axis turns the wrong motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor lost steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor power is not set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor power, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor power, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor power, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors off at start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors off below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors on/off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors: safe stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors: safe stop/on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mounting angle of the middle motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mounting angle of the outer motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the camera for a time, then gives control back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the middle of the stick signal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies P, I and D together; turn this one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names and types of the board&apos;s inner variables.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No IMU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No power manager</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal PWM</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not used by current firmware.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notch %1 frequency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notch %1 gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notch %1 width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notch 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notch 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notch 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes of a melody (Hz, comma between)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of magnet poles of the motor. Wrong, gains are off by the same factor and steps are lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of steps over the whole range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers (comma between)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On-board IMU may be main</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Options</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Options of this profile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Options that hold for all profiles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order of Euler angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order of motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order of rotations in which angles and targets are expressed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order of the motors, counted from the camera outwards.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outer I</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outer P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outer P, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outer P, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outer P, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outer motor turns freely</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overheating stops motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overload time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overwrites a profile, or everything, with defaults.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PID gain, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PID gain, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PID gain, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PWM frequency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parking position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pin that repeats the status LED.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pin that signals events to another device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pitch (motor), roll, yaw (motor)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pitch +</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pitch angle from which the roll axis begins to follow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pitch port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pitch −</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pitch, roll, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poles are not calibrated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Port on which this MAVLink channel works.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power added to bring a motor back that lost its step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile (0 = active)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile of this block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile options</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protection is active</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulse rate of the servo outputs. Analog servos want 50 Hz.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC calibration %1: offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC calibration %1: scale above zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC calibration %1: scale below zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC calibration %1: source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 10</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 11</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 12</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 13</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 14</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 15</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 16</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 17</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 18</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 19</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 20</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 21</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 22</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 23</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 24</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 25</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 26</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 27</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 28</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 29</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 30</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 31</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channel 9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC command high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC command low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC command middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC dead band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC dead band, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC dead band, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC exponential curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC exponential curve, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC exponential curve, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC input, command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC input, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC input, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC input, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC keeps mix rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC keeps position at start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC limit, pitch, lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC limit, pitch, upper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC limit, roll, lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC limit, roll, upper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC limit, yaw, lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC limit, yaw, upper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC low-pass, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC low-pass, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC low-pass, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC mode, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC mode, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC mode, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC serial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC serial speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC signal, FC pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC signal, FC roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC signal, command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC signal, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC signal, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC signal, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC speed, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC speed, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC speed, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC trim, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC trim, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RC trim, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RLS Orbis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RLS Orbis PWM</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raster of positions the axis snaps to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate and content of this MAVLink channel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate bit 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate bit 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate bit 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate inside the dead band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate of the RC serial port after the next restart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate of the first UART after the next restart. The USB port does not care.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate of the second UART after the next restart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read adjustable variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read debug variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release control at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remember last profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remote control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remote control axis that the flight controller signal is added to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remote control turns about the camera&apos;s own axes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the cause, then restart the board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes what remains of an error over time. Too much sways slowly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat time-lapse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaced by the fine magnetic link.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset IMU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resistance of the motor&apos;s windings, for the current estimate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart after emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart the board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restarts the controller; motors go off meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Retracted position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll +</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll and pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll and pitch: how much the flight controller&apos;s angle is followed. Yaw: not 0 = follow the frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll mix range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll mix start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll −</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll, pitch (motor), yaw (motor)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll, pitch, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll, yaw, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate when upside-down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate yaw 180 deg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate yaw 180 deg, relative to frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation below this is taken for noise, in gyro units.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run script 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run script 10</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run script 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run script 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run script 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run script 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run script 6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run script 7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run script 8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run script 9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the accelerometer calibration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs a command of the board&apos;s menu.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S-bus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save backup automatically</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save statistics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search limits of pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search limits of roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search limits of yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second signal that the start-up action depends on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selected IMU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send debug data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send heartbeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensor mounting correction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial API</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Service</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Servo mode off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Servo mode on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Servo mode on/off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Servo output %1: source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Servo rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set RC trim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set adjustable variable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set poles and direction of each motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the power of each motor on the Parameters page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set tilt angles by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set tilt angles by hand, do not save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set-by-hand time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake amplitude, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake amplitude, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake amplitude, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake frequency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake frequency range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake frequency shift, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake frequency shift, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake frequency shift, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake generator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake generator off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake generator on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake master gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake pause (ms)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake pause balance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake pause randomness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake resonance gain, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake resonance gain, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shake resonance gain, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the flight controller signal added to a remote control axis; 63 = all of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the move spent speeding up and slowing down.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the supply voltage a motor may get. Too little loses steps, too much overheats the motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signal level of the condition, in tenths of the RC range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signal level of the second condition.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signal on RC_ROLL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signal that the start-up action depends on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skip detection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skip when moving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Small correction for a sensor that is not mounted quite straight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooth gimbal-lock transition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooths the D term alone; 0 = off. Lower lets D be higher before noise is heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooths the accelerometer against vibration and accelerated motion; 0 = off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooths the frame sensor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap options</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to fixed position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap, further bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Softens the start and end of commanded motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Software limit width, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Software limit width, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Software limit width, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Software limit, pitch, lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Software limit, pitch, upper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Software limit, roll, lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Software limit, roll, upper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Software limit, yaw, lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Software limit, yaw, upper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sound</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sound by the motors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source of commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source of the flight controller signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed and angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of motion at full stick, and the default speed of commanded moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of moves the board makes by itself, such as going home.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spektrum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spektrum mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spektrum power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stabilization</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stabilization works about the camera&apos;s own axes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stabilize in camera axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stabilized axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stabilized axis, automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard sound or melody; helps to find the right board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start from current gains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start in neutral position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start time-lapse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start-up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start-up action %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start-up condition A%1: source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start-up condition A%1: threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start-up condition B%1: source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start-up condition B%1: threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts stabilization.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step signal %1: further bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step signal %1: needs button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step signal %1: source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step signal %1: start at zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step signal %1: steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step signal %1: trigger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step signal 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step signal 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step signal 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step signal 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step signal 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step signal 6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps only while the menu button is held.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stick movement around the middle that is ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness of the motor&apos;s magnetic field as measured by calibration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop script</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stores the live values in the active profile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength of the motion used to measure the momentum.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength of the response to an angle error. Too little is soft, too much vibrates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stretches the lower half of the signal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stretches the upper half of the signal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap RC pitch and roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap RC serial and UART2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap RC yaw and roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap frame and main IMU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch roll 90 deg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch yaw 180 deg, relative to frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switches all motors off at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switches the controller&apos;s own I2C pull-up resistors on; helps on long sensor cables.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switching frequency of the motor drivers. Low is efficient and audible.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>System ID of the gimbal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>System error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>System error bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take position as home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the present position as the neutral point of following.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target angle, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target angle, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target angle, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target speed, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target speed, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target speed, yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tells the board the true battery voltage.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The alarm threshold is reached.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board does not see its motion sensor, so it cannot stabilize.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board expects another version of its configuration tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board received damaged commands.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board searches gains by moving the camera.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board switched the motors off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The encoder turns faster or slower than the axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The firmware found a fault in itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The horizon will be tilted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motor drivers switched off to save themselves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motors have no power and the camera hangs free.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motors may turn the wrong way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The profile in use when the block was read, counted from 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The profile this block of values belongs to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sensor that calibration works on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The signal is zero after power-up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tilt of the middle motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tilt of the outer motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time at full power after which motors are switched off; 0 = never.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time until the board restarts by itself; 0 = stays off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time-lapse acceleration part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time-lapse duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time-lapse keeps frame heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time-lapse step 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time-lapse time (s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tripod mode off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tripod mode on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tune the low-pass filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns of the encoder per turn of the motor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns of the motor per turn of the axis; 1 = direct drive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns the direction of this remote control axis round.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns the motor the other way. Wrong, the camera runs away from its target as soon as motors start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UART2 speaks the serial API</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UART2 speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UART3 speaks the serial API</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ultra high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Untwist cables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper end of the range that remote control can reach.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use motion model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use profile 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use profile 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use profile 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use profile 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use profile 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values of the board&apos;s inner variables.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vibration level at which gains are lowered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Virtual channel whose signal is put out on this servo pin; 0 = off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voltage of the full battery: power is raised as it falls; negative = off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What kind of signal the RC_ROLL pin carries.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the camera follows in pitch and roll.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When and how the axis snaps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the second sensor is mounted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the gyroscope is calibrated each time the board starts; it must then stand still.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which axis of the frame sensor points right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which axis of the frame sensor points up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which axis of the magnetometer points right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which axis of the magnetometer points up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which axis printed on the sensor board points right, seen from behind the camera.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which axis printed on the sensor board points up. Wrong, the camera turns over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which of the filters of this axis work.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the band at -3 dB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Winding resistance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yaw +</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yaw port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yaw −</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yaw, pitch, roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yaw, roll, pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle-frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>calibrate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>complete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>confirm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>copy-to-sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>erase-eeprom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>extended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>intro</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>main</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>melody</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>profile1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>profile2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>profile3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>profile4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>profile5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reset-all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>restore-factory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed-angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>temperature-off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>temperature-on</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TuningPage</name>
    <message>
        <source>Tuning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the first set of values (F6 switches)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the second set of values (F6 switches)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy to other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the other set the same as the values in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revert all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the stored values into use at once (F9)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store the values in use in the active profile; a snapshot is taken first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gyroscope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle error, last %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peak before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare what follows with these figures; switching sets does so too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> The values in use were asked for again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This board has no values that can be changed live.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect the board to tune it live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In use: as stored</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) in use, not stored</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>A and B differ in %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>UnsavedBar</name>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save to &amp;file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Review and &amp;write…</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved change(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>in %1 profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo: %1 (Ctrl+Z)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo: %1 (Ctrl+Shift+Z)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+S</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect the board to write to it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ValueEditor</name>
    <message>
        <source>↺ %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board has %1. Go back to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go back to the board&apos;s value %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
On the board: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n set</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>VariablesPage</name>
    <message>
        <source>Adjustable variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A value set here takes effect at once and is forgotten at the next start unless it is saved. Numbers are the board&apos;s own; the meaning stands beside them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows changes that the radio, a menu or another program makes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save variables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store the values in use in the active profile; a snapshot is taken first</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Workspace</name>
    <message>
        <source>The last write was interrupted: %1 of %2 values are not on the board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Finish: write %n value(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Undo: put %n value(s) back</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Leave it so</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 °F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved edits would not survive a crash of the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Unsaved changes are kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live data could not be started. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors are off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board did not confirm that the motors are off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They may still be running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the camera and disconnect the power.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control was released because the program did not refresh it in time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connected again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes of the interrupted write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile names written and read back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) written and read back.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>The board as it was is kept in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n verified</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n put back</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unknown</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n not written</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n different</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>The write is not complete: %1. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When the board is back it is read again; then the write can be finished or undone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The interrupted write was complete: all %1 values are on the board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board holds the old values.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved step(s) of an earlier run belong to this board.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Restore them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing of it fits this board any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Throw them away</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) of the file are unknown and were left out.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>The file is of another family of boards.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load profile %1 from %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) of the file do not fit this board and were left out: %1</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Snapshot taken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stored in the active profile. The board as it was is kept in %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
