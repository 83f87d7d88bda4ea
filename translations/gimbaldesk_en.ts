<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context><name>ReviewDialog</name>
<message numerus="yes"><source>%n value(s)</source><translation><numerusform>%n value</numerusform><numerusform>%n values</numerusform></translation></message>
</context>
<context><name>UnsavedBar</name>
<message numerus="yes"><source>%n unsaved change(s)</source><translation><numerusform>%n unsaved change</numerusform><numerusform>%n unsaved changes</numerusform></translation></message>
</context>
<context><name>MainWindow</name>
<message numerus="yes"><source>%n change(s) are not on the board. They are lost when the program ends.</source><translation><numerusform>%n change is not on the board. It is lost when the program ends.</numerusform><numerusform>%n changes are not on the board. They are lost when the program ends.</numerusform></translation></message>
</context>
<context><name>Workspace</name>
<message numerus="yes"><source>%n value(s) written and read back.</source><translation><numerusform>%n value written and read back.</numerusform><numerusform>%n values written and read back.</numerusform></translation></message>
</context>
</TS>
