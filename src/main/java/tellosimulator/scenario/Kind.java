package tellosimulator.scenario;

import java.util.List;
import java.util.Set;
import tellosimulator.words.Phrase;

/** What a mapping in a scenario file describes, and the keys that it can have. */
enum Kind {
  SCENARIO(
      Phrase.of("a scenario"),
      "name",
      "teaches",
      "room",
      "grid",
      "walls",
      "posters",
      "obstacles",
      "pads",
      "drones",
      "wind",
      "crash-speed",
      "time-factor",
      "seed",
      "goals",
      "in-order",
      "time-limit",
      "touch"),
  ROOM(Phrase.of("a room"), "width", "depth", "height"),
  POSTER(Phrase.of("a poster"), "wall", "along", "height", "width", "picture"),
  OBSTACLE(Phrase.of("an obstacle"), "box", "cylinder", "wall", "gate"),
  BOX(Phrase.of("a box"), "name", "at", "base", "size", "heading", "colour", "pattern", "pictures"),
  CYLINDER(
      Phrase.of("a cylinder"),
      "name",
      "at",
      "base",
      "radius",
      "height",
      "heading",
      "colour",
      "pattern",
      "pictures"),
  WALL(
      Phrase.of("a wall"),
      "name",
      "from",
      "to",
      "base",
      "height",
      "thickness",
      "colour",
      "pattern",
      "pictures"),
  GATE(
      Phrase.of("a gate"),
      "name",
      "at",
      "base",
      "shape",
      "diameter",
      "width",
      "height",
      "centre",
      "thickness",
      "heading",
      "colour",
      "pattern",
      "pictures"),
  PICTURES(Phrase.of("pictures"), "front", "back", "left", "right", "top", "bottom"),
  PAD(Phrase.of("a mission pad"), "id", "at", "heading", "wall", "along", "height", "rotation"),
  DRONE(
      Phrase.of("a drone"),
      "start",
      "heading",
      "profile",
      "behaviour",
      "colour",
      "battery",
      "address",
      "command-port",
      "state-port",
      "video-port"),
  WIND(Phrase.of("wind"), "towards", "speed", "gusts"),
  GOAL(Phrase.of("a goal"), "reach", "hover", "pass", "land", "land-on"),
  REACH(Phrase.of("a place to reach"), "at", "radius", "drone"),
  HOVER(Phrase.of("a place to hover"), "at", "radius", "seconds", "drone"),
  PASS(Phrase.of("a gate to pass"), "gate", "direction", "drone"),
  LAND(Phrase.of("a place to land"), "at", "radius", "drone"),
  LAND_ON(Phrase.of("a pad to land on"), "pad", "drone");

  private final Phrase phrase;
  private final List<String> keys;
  private final Set<String> known;

  Kind(Phrase phrase, String... keys) {
    this.phrase = phrase;
    this.keys = List.of(keys);
    this.known = Set.of(keys);
  }

  /** For people: {@code a room}. */
  Phrase phrase() {
    return phrase;
  }

  /** In the order in which they are written. */
  List<String> keys() {
    return keys;
  }

  /** Whether a mapping can have a key. */
  boolean has(String key) {
    return known.contains(key);
  }
}
