package tellosimulator.fault;

import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import tellosimulator.profile.Behavior;

/** The basic quality of the link, as a set of permanently active faults. */
public enum LinkPreset {
  /** No loss, and no delay. */
  IDEAL(),

  /**
   * One drone and its operator in a quiet room. Measured: TelloPy 0.7.0, docs/sensor_time.md,
   * September 2026: a query takes 5 to 228 ms, with a median of 44 ms and a 95th percentile of 124
   * ms. 2 % of the queries are never answered. 6 to 15 % of the state lines are missing; the others
   * have 25 to 35 ms of jitter and gaps of up to 0.6 s. Assumed: commands and replies are lost
   * equally often.
   */
  LAB(
      "loss commands replies 1%",
      "delay replies 44ms spread 38.6ms least 5ms most 228ms",
      "loss state 10% burst 1.5",
      "delay state 25ms spread 20ms"),

  /**
   * A handful of drones in one room. Assumed: the link is about twice as bad as in the lab, with
   * longer bursts of loss. DJITelloPy, pull request 17, reports the loss of commands to one of four
   * drones.
   */
  CLASSROOM(
      "loss commands replies 3% burst 2",
      "delay replies 70ms spread 80ms least 5ms most 600ms",
      "loss state 20% burst 2",
      "delay state 40ms spread 40ms most 400ms"),

  /**
   * A hall full of drones on the same channels. Assumed: a flight is still possible with retries.
   */
  CROWDED(
      "loss commands replies 10% burst 3",
      "delay replies 150ms spread 200ms least 5ms most 1.5s",
      "loss state 40% burst 3",
      "delay state 80ms spread 100ms most 800ms");

  private final List<String> texts;

  LinkPreset(String... texts) {
    this.texts = List.of(texts);
  }

  /** Returns the default preset of a behaviour. */
  public static LinkPreset usual(Behavior behavior) {
    return behavior == Behavior.MEASURED ? LAB : IDEAL;
  }

  /** Returns the word that selects this preset. */
  public String option() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * Returns the preset for a word.
   *
   * @throws FaultTextException if there is no such preset; the message suggests the nearest word
   */
  public static LinkPreset of(String word) {
    return Stream.of(values())
        .filter(preset -> preset.option().equals(word))
        .findFirst()
        .orElseThrow(() -> FaultText.unknown(word, options()));
  }

  /** Returns the words of all presets, from good to bad. */
  public static List<String> options() {
    return Stream.of(values()).map(LinkPreset::option).toList();
  }

  /** Returns the permanently active faults of this preset. */
  List<Fault> faults() {
    return this == IDEAL ? List.of() : Parsed.FAULTS.get(this);
  }

  /**
   * Holds the faults of all presets, which are parsed on first use. An ideal link needs none of
   * them.
   */
  private static final class Parsed {

    private static final Map<LinkPreset, List<Fault>> FAULTS = new EnumMap<>(LinkPreset.class);

    static {
      for (LinkPreset preset : values()) {
        FAULTS.put(preset, preset.texts.stream().map(Fault::of).toList());
      }
    }
  }
}
