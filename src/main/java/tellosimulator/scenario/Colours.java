package tellosimulator.scenario;

import java.util.Map;

/** Colours that have a name in scenario files. Decided: as loud as painted wood. */
final class Colours {

  static final Map<String, Integer> BY_NAME =
      Map.ofEntries(
          Map.entry("red", 0xc0392b),
          Map.entry("orange", 0xd9772b),
          Map.entry("yellow", 0xe1b12c),
          Map.entry("green", 0x3d9a50),
          Map.entry("blue", 0x2e6db4),
          Map.entry("purple", 0x7d4fa0),
          Map.entry("brown", 0x8a5a36),
          Map.entry("white", 0xf2f2f2),
          Map.entry("grey", 0x8c8c8c),
          Map.entry("black", 0x262626));

  private Colours() {}
}
