<?xml version="1.0" encoding="UTF-8"?>
<tileset version="1.10" tiledversion="1.10.2" name="landscape" tilewidth="32" tileheight="32" tilecount="64" columns="16">
 <image source="landscape.png" width="512" height="128"/>
 <tile id="0" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0" width="32" height="32"/>
  </objectgroup>
 </tile>
 <tile id="1" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="16" width="32" height="16"/>
  </objectgroup>
 </tile>
 <tile id="2" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 32,0 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="3" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 32,16 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="4" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,16 32,0 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="5" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 32,24 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="6" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,24 32,16 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="7" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,16 32,8 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="8" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,8 32,0 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="9" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0.2,-0.31 31.75,0.12 32.3,31.9 -0.14,32.22"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="10" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0.31,31.6 32.4,-0.22 31.72,32.35"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="11" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,26 7,20 13,25 20,14 26,22 32,26 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="12" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="16" width="16" height="16"/>
   <object id="2" x="16" y="0" width="16" height="32"/>
  </objectgroup>
 </tile>
 <tile id="13" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,0 32,0 25.76,0.61 19.75,2.44 14.22,5.39 9.37,9.37 5.39,14.22 2.44,19.75 0.61,25.76 0,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="16" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0" width="32" height="32"/>
  </objectgroup>
 </tile>
 <tile id="17" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="16" width="32" height="16"/>
  </objectgroup>
 </tile>
 <tile id="18" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 32,0 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="19" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 32,16 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="20" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,16 32,0 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="21" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 32,24 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="22" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,24 32,16 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="23" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,16 32,8 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="24" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,8 32,0 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="25" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0.2,-0.31 31.75,0.12 32.3,31.9 -0.14,32.22"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="26" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0.31,31.6 32.4,-0.22 31.72,32.35"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="27" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,26 7,20 13,25 20,14 26,22 32,26 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="28" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="16" width="16" height="16"/>
   <object id="2" x="16" y="0" width="16" height="32"/>
  </objectgroup>
 </tile>
 <tile id="29" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,0 32,0 25.76,0.61 19.75,2.44 14.22,5.39 9.37,9.37 5.39,14.22 2.44,19.75 0.61,25.76 0,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="32" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0" width="32" height="32"/>
  </objectgroup>
 </tile>
 <tile id="33" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="16" width="32" height="16"/>
  </objectgroup>
 </tile>
 <tile id="34" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 32,0 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="35" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 32,16 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="36" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,16 32,0 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="37" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 32,24 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="38" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,24 32,16 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="39" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,16 32,8 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="40" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,8 32,0 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="41" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0.2,-0.31 31.75,0.12 32.3,31.9 -0.14,32.22"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="42" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0.31,31.6 32.4,-0.22 31.72,32.35"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="43" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,32 0,26 7,20 13,25 20,14 26,22 32,26 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="44" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="16" width="16" height="16"/>
   <object id="2" x="16" y="0" width="16" height="32"/>
  </objectgroup>
 </tile>
 <tile id="45" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,0 32,0 25.76,0.61 19.75,2.44 14.22,5.39 9.37,9.37 5.39,14.22 2.44,19.75 0.61,25.76 0,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="48" type="wood">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0" width="32" height="8"/>
   <object id="2" x="4" y="8" width="6" height="24"/>
   <object id="3" x="22" y="8" width="6" height="24"/>
  </objectgroup>
 </tile>
 <tile id="49" type="oneway">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0" width="32" height="6"/>
  </objectgroup>
 </tile>
 <tile id="50" type="ice">
  <objectgroup draworder="index" id="2">
   <object id="1" x="16" y="3.7" width="20" height="20" rotation="45"/>
  </objectgroup>
 </tile>
 <tile id="51" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="4" width="32" height="28">
    <ellipse/>
   </object>
  </objectgroup>
 </tile>
 <tile id="52" type="stone">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="4,0 28,0 15,44"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="53" type="ground">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,0 32,32 0,32"/>
   </object>
   <object id="2" type="stone" x="0" y="0">
    <polygon points="0,0 32,0 32,32"/>
   </object>
  </objectgroup>
 </tile>
 <tile id="54" type="wood">
  <objectgroup draworder="index" id="2">
   <object id="1" x="0" y="0">
    <polygon points="0,0 32,20 32,26 0,8"/>
   </object>
   <object id="2" x="26" y="26" width="4" height="6"/>
  </objectgroup>
 </tile>
</tileset>
