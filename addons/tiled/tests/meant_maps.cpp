#include "meant_maps.h"

namespace lgs::tiled::meant {

std::vector<MeantMap> meantMaps() {
  const std::string G = "......../..aa..../aaaa..aa/aaaaaaaa";   // ground, seen from the side
  const std::string P = "......../.aaa..../....aaa./........";   // platforms
  const std::string GP = "......../.aaa..../aaaaaaaa/aaaaaaaa";  // both
  const std::string U = "......../......../aaaaaaaa/aaaaaaaa";   // a plain ground
  const std::string W = "aaaaaaaa/a......a/a......a/aaaaaaaa";   // walls, seen from above
  const std::string B = "bbbbbbbb/bbbbbbbb/bbbbbbbb/bbbbbbbb";   // a background, or a floor
  const std::string F = "......../.bbbbbb./.bbbbbb./........";   // the floor of a room
  const std::string S = "bbbbbbbb/bbbbbbbb/......../........";   // a sky
  const std::string D = ".c....../......c./......../........";   // decoration
  const std::string K = "......../......../......../...d.d..";   // spikes and the like
  const std::string none;
  const std::string ground = box(0, 2, 8, 2),
                    wall = box(0, 0, 8, 1) + box(0, 3, 8, 1) + box(0, 1, 1, 2) + box(7, 1, 1, 2);
  const std::string shape = tile('a', kShape), yes = property("collides", "true"), no = property("collides", "false");
  const auto has = [](char letter, const std::string& name, const std::string& value = "true") {
    return tile(letter, property(name, value));
  };
  const std::string spawns = objects("Spawns", figure(1, 1) + figure(5, 1)),
                    marks = objects("Marks", spot(1, 1) + spot(2, 2));
  const std::string boxes = box(0, 0, 1, 1) + box(1, 0, 1, 1);
  const auto solidBox = [&](const std::string& name, const std::string& value) {
    return "<object id='7' " + at(0, 2) + " width='128' height='32'>" + property(name, value) + "</object>";
  };
  return {
      // 1. Shapes in tiles.
      {"shapes in tiles", mapOf(shape, tiles("Sky", B) + tiles("World", G)), G},
      {"shapes in tiles, decoration above", mapOf(shape, tiles("World", G) + tiles("Deco", D)), G},
      {"shapes in tiles, and things", mapOf(shape, tiles("World", G) + objects("Things", box(1, 1, 1, 1))), G},
      {"shapes in tiles, and properties", mapOf(shape + tile('b', yes), tiles("World", G) + tiles("Sky", S)), G},
      {"shapes in tiles of the walls", mapOf(shape, tiles("Floor", B) + tiles("Walls", W)), W},
      {"shapes in tiles, and drawn walls", mapOf(shape, tiles("World", U) + objects("Walls", box(0, 0, 1, 2))),
       "a......./a......./aaaaaaaa/aaaaaaaa"},
      {"shapes in most tiles of the ground", mapOf(shape, tiles("Ground", "......../......d./aaaaaaaa/aaaaaaaa")), U},
      {"spikes have shapes, platforms have none", mapOf(tile('d', kShape), tiles("Spikes", K) + tiles("Platforms", P)),
       P},
      {"spikes have the property of the ground",
       mapOf(has('a', "collides") + has('d', "collides"),
             tiles("World", G) + tiles("Spikes", "......../......../....dd../........")),
       G},
      {"few of the platforms have shapes", mapOf(shape, tiles("Platforms", "......../.abb..../....bbb./........")), P},

      {"shapes in tiles, and the same tiles behind",
       mapOf(shape, tiles("Background", "aaaaaaaa/aaaaaaaa/aaaaaaaa/aaaaaaaa") + tiles("Platforms", G)), G},
      {"shapes in tiles, and a property that tiles without shapes have as well",
       mapOf(
           tile('a', property("collidable", "true") + kShape) + has('b', "collidable"),
           tiles("World", "......../......../aabaaaaa/aaaaaaab") + tiles("Sky", "cccccccc/......../......../........")),
       U},

      {"shapes of a floor that fills the map",
       mapOf(shape, tiles("ground", "aaaaaaaa/aaaaaaaa/aaaaaaaa/aaaaaaaa") + objects("border", ground) +
                        tiles("obstacles", "...a..../......../......../........")),
       "...a..../......../aaaaaaaa/aaaaaaaa"},

      // Of what nothing speaks for all together is offered first, and after that for which something does.
      {"two layers that nothing tells apart", mapOf(none, tiles("Red", P) + tiles("Blue", U)), GP},
      {"a property of some tiles of the walls, and a layer that says nothing",
       mapOf(has('a', "tile", "block"), tiles("static", "......../.abb..../aaaaaaaa/bbbbbbbb") + tiles("Things", D)),
       "......../.a....../aaaaaaaa/........"},

      // All that says collision counts together.
      {"a layer that is solid by a property, with few shapes", mapOf(shape, tiles("Main", GP, "solid")), GP},
      {"a solid layer, and shapes in another",
       mapOf(tile('d', kShape), tiles("Main", U, "solid") + tiles("Trees", "......../......../.d....d./........")), U},
      {"a solid layer, and shapes above it",
       mapOf(tile('d', kShape), tiles("Collision", U) + tiles("Rocks", "......../.d....d./......../........")),
       "......../.a....a./aaaaaaaa/aaaaaaaa"},
      {"a layer that is solid by a property, and has one that is called layer",
       mapOf(none,
             "<layer name='tiles' width='8' height='4'><properties><property name='layer' value='3'/><property "
             "name='solid' value='1'/></properties><data encoding='csv'>0,0,0,0,0,0,0,0,0,1,1,1,0,0,0,0,0,0,0,0,1,"
             "1,1,0,0,0,0,0,0,0,0,0</data></layer>"),
       P},
      {"a property of tiles and of a layer", mapOf(has('a', "collides"), tiles("L1", U) + tiles("L2", P, "collides")),
       "......../.aaa..../aaaaaaaa/aaaaaaaa"},
      {"shapes and walls that were drawn", mapOf(shape, tiles("World", U) + objects("Geometry", box(0, 0, 1, 2))),
       "a......./a......./aaaaaaaa/aaaaaaaa"},

      // What is deadly or passable is left out.
      {"deadly shapes",
       mapOf(shape + tile('d', "<objectgroup><object id='1' name='Deadly' width='16' height='16'/></objectgroup>"),
             tiles("World", "......../...d..../aaaaaaaa/aaaaaaaa")),
       U},
      {"ladders with shapes",
       mapOf(shape + tile('d', kShape, "ladder"), tiles("World", "...d..../...d..../aaaaaaaa/aaaaaaaa")), U},
      {"spikes in the ground layer",
       mapOf(tile('d', none, "spikes"), tiles("ground", "......../...d..../aaaaaaaa/aaaaaaaa")), U},
      {"tiles that say that they are not solid",
       mapOf(tile('d', property("solid", "false")), tiles("ground", "......../...d..../aaaaaaaa/aaaaaaaa")), U},
      {"tiles that say NoCollide",
       mapOf(has('d', "NoCollide", "1") + has('e', "not_solid"), tiles("Map", "......../.aaa.d../..e.aaa./........")),
       P},
      {"a layer of hazards whose tiles have shapes",
       mapOf(shape + tile('d', kShape), tiles("World", U) + tiles("Hazards", "......../...d..../......../........")),
       U},
      {"triggers among walls that were drawn",
       mapOf(none, tiles("Main", B) + objects("Walls", ground + box(1, 0, 1, 1, "name='trigger_door'"))), U},
      {"a killzone drawn beside collisions",
       mapOf(none, objects("collisions", ground) + objects("killzones", box(0, 0, 8, 1))), U},

      // Words with a letter wrong, and words of more languages and games.
      {"Obsticles", mapOf(none, tiles("Grass", B) + tiles("Obsticles", W)), W},
      {"colision", mapOf(none, tiles("Grass", B) + tiles("colision", W)), W},
      {"Plattformen", mapOf(none, tiles("Hintergrund", B) + tiles("Plattformen", P)), P},
      {"geom as objects beside scenery",
       mapOf(none, tiles("art", B) + objects("scenery", figure(1, 1)) + objects("geom", ground)), U},
      {"slopes and ground", mapOf(none, tiles("ground", U) + tiles("slopes", "......../a......a/......../........")),
       "......../a......a/aaaaaaaa/aaaaaaaa"},
      {"pendientes", mapOf(none, tiles("fondo", B) + tiles("pendientes", G)), G},
      {"terrain, and terrain that cannot be destroyed",
       mapOf(none, tiles("terrain", P) + tiles("terrain_no_destructible", U)), "......../.aaa..../aaaaaaaa/aaaaaaaa"},
      {"no_collision beside a plain layer", mapOf(none, tiles("no_collision", D) + tiles("main", G)), G},

      // 2. Layers and classes that say collision.
      {"a layer called Collision", mapOf(none, tiles("Background", B) + tiles("Collision", G)), G},
      {"collision and ground: a floor", mapOf(none, tiles("Ground", B) + tiles("Collision", W)), W},
      {"collision and ground: a room", mapOf(none, tiles("Ground", F) + tiles("Collision", W)), W},
      {"collision and walls: pictures", mapOf(none, tiles("Walls", W) + tiles("collision", GP)), GP},
      {"collisions, and a layer of spawns", mapOf(none, spawns + tiles("collisions", G)), G},
      {"a hidden layer called collision",
       mapOf(none, tiles("Layer", B) + tiles("col_lision", D) + tiles("Collisions", G)), G},
      {"Collidable", mapOf(none, tiles("Art", B) + tiles("Collidable", G)), G},
      {"Collidables as objects, and events",
       mapOf(none, tiles("Dirt", G) + objects("Collidables", ground) + objects("Events", box(0, 0, 2, 2))), U},
      {"Colliders as objects", mapOf(none, tiles("Map", B) + objects("Colliders", wall)), W},
      {"blockedLayer",
       mapOf(none, tiles("backgroundLayer", B) + tiles("blockedLayer", G) + objects("objectsLayer", figure(1, 1))), G},
      {"blockedLayer, and an unblocked one", mapOf(none, tiles("unblockedLayer", D) + tiles("blockedLayer", G)), G},
      {"Blocked", mapOf(none, tiles("Background", B) + tiles("Blocked", W) + marks), W},
      {"Solid", mapOf(none, tiles("Art", D) + tiles("Solid", G)), G},
      {"solids, one word", mapOf(none, tiles("art", D) + tiles("levelsolids", G)), G},
      {"noncollidable is not collidable", mapOf(none, tiles("noncollidable", D) + tiles("ground", G)), G},
      {"Obstacles", mapOf(none, tiles("Grass", B) + tiles("Obstacles", W)), W},
      {"obstacles as objects",
       mapOf(none, tiles("fond", B) + objects("obstacles", ground) + objects("piece", box(1, 1, 1, 1))), U},
      {"things that are called Obstacle",
       mapOf(none, tiles("floor", B) +
                       objects("Objects", box(0, 2, 8, 2, "name='Obstacle'") + box(1, 0, 1, 1, "name='Mob'"))),
       U},
      {"things of the class solid",
       mapOf(none, objects("Objects", box(0, 2, 8, 2, "type='solid'") + box(1, 0, 1, 1, "type='coin'"))), U},
      {"tiles of the class collision", mapOf(tile('a', none, "collision"), tiles("L1", S) + tiles("L2", U)), U},
      {"a layer of the class Solid", mapOf(none, tiles("Main", G, "", "Solid") + tiles("Main 2", D)), G},
      {"a layer with the property collides", mapOf(none, tiles("Layer 1", G, "collides") + tiles("Layer 2", D)), G},
      {"objects with the property collidable",
       mapOf(none, tiles("Layer", B) + objects("Object Layer 1", ground, "collidable")), U},
      {"kill-collision is no ground", mapOf(none, tiles("kill-collision", K) + tiles("Ground", U)), U},
      {"collisions of light are others",
       mapOf(none, objects("Light-Collisions", box(0, 0, 8, 1)) + objects("Collisions", ground)), U},
      {"a collision layer where tiles mean free as well",
       mapOf(has('a', "solid"), tiles("collision", "bbbbbbbb/bbbbbbbb/aaaaaaaa/aaaaaaaa")), U},

      {"hitboxes", mapOf(none, tiles("walls", W) + tiles("hitboxes", G)), G},
      {"Colisiones", mapOf(none, tiles("Fondo", B) + objects("Colisiones", ground) + objects("Luces", boxes)), U},
      {"walls and zombies in a layer called Obstacles",
       mapOf(none, tiles("ground", B) + tiles("walls", W) +
                       objects("Obstacles", box(0, 2, 8, 2, "name='wall'") + box(1, 0, 1, 1, "name='zombie'"))),
       U},
      {"Collisions and Blocks, both drawn",
       mapOf(none, objects("Collisions", ground) + objects("Blocks", box(3, 0, 1, 1))),
       "...a..../......../aaaaaaaa/aaaaaaaa"},

      {"obstacles, and walls that were drawn",
       mapOf(none, tiles("Land", B) + objects("Walls", box(0, 2, 8, 2)) + objects("Obstacles", box(3, 0, 1, 1))),
       "...a..../......../aaaaaaaa/aaaaaaaa"},
      {"a surface and obstacles",
       mapOf(none, tiles("T1", U) + objects("surface", ground) + objects("obstacles", box(3, 0, 1, 1)) +
                       objects("text", spot(1, 1))),
       "...a..../......../aaaaaaaa/aaaaaaaa"},
      {"colider", mapOf(none, tiles("floor", B) + objects("black", boxes) + objects("colider", ground)), U},
      {"Kollision", mapOf(none, tiles("Boden", B) + tiles("Kollision", W)), W},
      {"col", mapOf(none, tiles("FG", F) + tiles("col", G) + tiles("det", D)), G},
      {"things with pictures in a layer called obstacles",
       mapOf(none, tiles("Platforms", P) + objects("obstacles", figure(1, 1) + figure(5, 1))), P},

      // 3. Properties of tiles and objects.
      {"a property collides", mapOf(tile('a', yes) + tile('b', no), tiles("World", G) + tiles("Sky", S)), G},
      {"a property solid, in one layer with the rest",
       mapOf(has('a', "solid"), tiles("Tile Layer 1", "bbbbbbbb/bbbbbbbb/aaaaaaaa/aaaaaaaa")), U},
      {"the ground is full, a property says more",
       mapOf(has('a', "collide"), tiles("ground", "bbbbbbbb/bbbbbbbb/aaaaaaaa/aaaaaaaa")), U},
      {"estSolide",
       mapOf(has('a', "estSolide") + has('d', "estPointu"), tiles("calque_plateformes", U) + tiles("calque_pics", K)),
       U},
      {"isSolid before collidesWith",
       mapOf(has('a', "isSolid") + has('b', "collidesWith", "player"), tiles("Main", GP) + tiles("Sky", S)), GP},
      {"a property blocked, and things",
       mapOf(has('a', "blocked", "1"), tiles("base", U) + objects("items", box(1, 0, 1, 1))), U},
      {"a property and a name: the property is stronger",
       mapOf(has('a', "collides"), tiles("Ground", G) + tiles("Walls", D)), G},
      {"kind is solid", mapOf(has('a', "kind", "solid") + has('b', "kind", "sky"), tiles("Main", U) + tiles("Back", S)),
       U},
      {"not walkable",
       mapOf(has('a', "walkable", "false") + has('b', "walkable"), tiles("map", "aaaaaaaa/abbbbbba/abbbbbba/aaaaaaaa")),
       W},
      {"tiles of the class non_traversable",
       mapOf(tile('a', none, "non_traversable") + tile('b', none, "traversable"),
             tiles("floor", "aaaaaaaa/abbbbbba/abbbbbba/aaaaaaaa")),
       W},
      {"unwalkable", mapOf(none, tiles("walkable", F) + tiles("Unwalkable", W)), W},
      {"a property without a value", mapOf(has('a', "blocked", ""), tiles("Ground", G) + tiles("Walls", D)), G},
      {"what one walks on is no wall",
       mapOf(tile('a', none, "wall") + tile('b', none, "floor"), tiles("base", "aaaaaaaa/abbbbbba/abbbbbba/aaaaaaaa")),
       W},
      {"a property of tiles that lie below the player as well",
       mapOf(has('a', "collides"), tiles("belowplayer", "aaaaaaaa/......../......../........") + tiles("game", U)), U},
      {"a mask is no answer", mapOf(has('b', "collision_mask", "3"), tiles("Sky", S) + tiles("Ground", U)), U},

      {"a property of tiles that lie behind as well",
       mapOf(has('a', "collides"), tiles("Background", "aaaaaaaa/......../......../........") + tiles("World", U)), U},
      {"objects with the property collision",
       mapOf(none, tiles("Tile Layer 1", B) + objects("Object Layer 1", boxes + solidBox("collision", "true"))), U},
      {"objects whose name, as a property, is Solid",
       mapOf(none, tiles("Tile Layer 1", B) + objects("Object Layer 1", boxes + solidBox("name", "Solid"))), U},

      // 4. Layers that say ground or wall.
      {"ground", mapOf(none, tiles("background", B) + tiles("ground", G) + spawns), G},
      {"Ground and Platforms",
       mapOf(none, tiles("Ground", U) + tiles("Platforms", "......../.aaa..../......../........")), GP},
      {"Platforms",
       mapOf(none,
             tiles("Platforms", P) + tiles("Ladders", ".e....../.e....../.e....../.e......") + tiles("Enemies", D)),
       P},
      {"plateformes", mapOf(none, tiles("fond", B) + tiles("calque_plateformes", P)), P},
      {"walls and a floor that fills the map", mapOf(none, tiles("Floor", B) + tiles("Walls", W)), W},
      {"walls and the floor of a room",
       mapOf(none, tiles("Floor", "bbbbbbbb/bbbbbb../bbbbbb../bb......") +
                       tiles("Walls", "......../......a./......a./..aaaaa.")),
       "......../......a./......a./..aaaaa."},
      {"walls drawn as objects above a floor",
       mapOf(none, tiles("Ground", B) + objects("Wall", wall) + objects("Enemy", spot(2, 2))), W},
      {"ground drawn as objects",
       mapOf(none, tiles("Graphic Layer", B) + objects("Ground", ground) + objects("Coins", box(1, 1, 1, 1))), U},
      {"InnerWalls and outerwalls",
       mapOf(none, tiles("InnerWalls", ".......a/......../......../........") + tiles("outerwalls", U)),
       ".......a/......../aaaaaaaa/aaaaaaaa"},
      {"terrain", mapOf(none, tiles("Terrain", G) + tiles("Trees", D)), G},
      {"blocks", mapOf(none, tiles("blocks", P) + tiles("clouds", S)), P},
      {"a firewall is no wall", mapOf(none, tiles("firewall", K) + tiles("floor", U)), U},
      {"GroundEffects are no ground", mapOf(none, tiles("GroundEffects", S) + tiles("Ground", U)), U},
      {"wall decoration is no wall", mapOf(none, tiles("wall decoration", D) + tiles("wall", W)), W},
      {"walls in the background are no walls", mapOf(none, tiles("BG Wall", S) + tiles("terrain", U)), U},
      {"ground in a group", mapOf(none, "<group name='Level'>" + tiles("Ground", U) + "</group>" + tiles("Sky", S)), U},

      {"layers without a word in a group that has one",
       mapOf(none, tiles("Art", B) + "<group name='collisions'>" + tiles("Layer 1", U) + tiles("Layer 2", P) +
                       tiles("Decoration", D) + "</group>"),
       "......../.aaa..../aaaaaaaa/aaaaaaaa"},
      {"where a hitbox begins",
       mapOf(tile('a', property("type", "solid")) + tile('d', property("hitbox_x", "1")),
             tiles("Layer 1", "......../......../...d.d../aaaaaaaa")),
       "......../......../......../aaaaaaaa"},
      {"World and a few blocks",
       mapOf(none, tiles("WorldLayer", U) + tiles("CoinLayer", D) +
                       tiles("BlocksLayer", ".a....../......../......../........")),
       ".a....../......../aaaaaaaa/aaaaaaaa"},
      {"a fence", mapOf(none, tiles("Grass", B) + tiles("Fence", W)), W},
      {"suelo y pared", mapOf(none, tiles("fondo", B) + tiles("Suelo", U)), U},
      {"objects that are called STATIC",
       mapOf(none, tiles("T1", B) + objects("Object Layer 1", box(0, 2, 8, 2, "name='STATIC'"))), U},

      {"pipes and bricks drawn as objects",
       mapOf(none, tiles("Graphic Layer", B) + objects("Ground", ground) + objects("Pipes", box(3, 1, 1, 1)) +
                       objects("Bricks", box(1, 0, 1, 1)) + objects("Goombas", box(5, 1, 1, 1))),
       ".a....../...a..../aaaaaaaa/aaaaaaaa"},

      {"ground in the foreground",
       mapOf(none, tiles("Hills (background)", S) + tiles("Ground (foreground)", U) + tiles("Pines (foreground)", D)),
       U},
      {"walls in the foreground are pictures", mapOf(none, tiles("Walls", W) + tiles("Foreground Walls", D)), W},
      {"a ladder of another language",
       mapOf(none, tiles("escada", ".e....../.e....../.e....../.e......") + tiles("caminho", P)), P},
      {"terrain in two layers, and walls", mapOf(none, tiles("terrain", B) + tiles("terrain2", D) + tiles("walls", W)),
       W},
      {"a wall and more ground, from the side",
       mapOf(none, tiles("wall", "a......./a......./......../........") +
                       tiles("ground", "......../......../......../aaaaaaa.")),
       "a......./a......./......../aaaaaaa."},
      {"switches in the floor beside walls",
       mapOf(none,
             tiles("background", B) + tiles("walls", W) + objects("logic", box(3, 1, 1, 1, "name='floor_switch'"))),
       W},
      {"what stands on the terrain is no terrain", mapOf(none, tiles("terrainEntities", D) + tiles("walls", W)), W},
      {"things that collide with the player, and where one wins",
       mapOf(none, tiles("T1", B) + objects("Objects", box(0, 2, 8, 2, "name='player_collide'") +
                                                           box(1, 0, 1, 1, "name='win_collide'"))),
       U},

      // 5. The only layer, if it is half empty.
      {"one layer alone", mapOf(none, tiles("T1", P)), P},
      {"one layer before a background", mapOf(none, tiles("Background", B) + tiles("Tile Layer 1", G)), G},
      {"one layer called Level", mapOf(none, tiles("Detail 1", D) + tiles("Level", G) + tiles("Bush", D)), G},
      {"a layer called Level with less in it than the background",
       mapOf(none, tiles("Background", U) + tiles("Level", P)), P},
      {"one layer, and where the level ends",
       mapOf(none, tiles("wg", P) + objects("FinishLine", box(7, 0, 1, 4)) + objects("Checkpoint", box(1, 0, 1, 4))),
       P},
      {"one layer, water and spawns", mapOf(none, spawns + tiles("Water", S) + tiles("Tiles", P)), P},

      {"a foreground beside a background", mapOf(none, tiles("background", B) + tiles("foreground", G)), G},
      {"a foreground with less in it than the background", mapOf(none, tiles("Background", S) + tiles("Foreground", P)),
       P},
      {"spikes are no rival", mapOf(none, tiles("map", P) + tiles("spikes", "......../......../......../dddddddd")), P},

      // 6. Object layers with an area, and 7. tile layers, that nothing is said of: what is first offered.
      {"boxes in Object Layer 1", mapOf(none, tiles("Tile Layer 1", B) + objects("Object Layer 1", ground)), U},
      {"boxes, and a layer of points",
       mapOf(none, tiles("Tile Layer 1", B) + objects("Points", spot(1, 1)) + objects("Boxes", wall)), W},
      {"one layer and things",
       mapOf(none, tiles("Tile Layer 1", U) + objects("objects", box(1, 0, 1, 1, "name='hero'"))), U},
      {"a layer called tile, and a larger one", mapOf(none, tiles("png", G) + tiles("tile", P)), P},
      {"buildings in a town", mapOf(none, tiles("Grass", B) + tiles("Decorations/Buildings", W)), W},
      {"trees and lamps of a layer called Obstacles",
       mapOf(none, tiles("Street", B) + objects("Obstacles", "<object id='3' name='Lamp' gid='5' " + at(1, 1) +
                                                                 " width='16' height='16'/>")),
       ".a....../......../......../........"},
      {"a layer above a background that fills the map", mapOf(none, tiles("Layer 1", B) + tiles("Layer 2", U)), U},
      {"spawns are no offer", mapOf(none, spawns + tiles("main", U)), U},
      {"water is not the likeliest", mapOf(none, tiles("Water", S) + tiles("Tiles", P)), P},
      {"foreground beside a background", mapOf(none, tiles("background", B) + tiles("decor", D) + tiles("stuff", U)),
       U},
  };
}

}  // namespace lgs::tiled::meant
