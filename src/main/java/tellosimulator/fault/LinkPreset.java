package tellosimulator.fault;

import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import tellosimulator.profile.Behavior;

/** How good the link is when nobody says more: faults that act all the time. */
public enum LinkPreset {
  /** Nothing is lost, and nothing takes time. */
  IDEAL(),

  /**
   * One drone and its operator in a quiet room. Measured: TelloPy 0.7.0, docs/sensor_time.md,
   * September 2026: a query takes 5 to 228 ms, median 44, 95th percentile 124; 2 % are never
   * answered; of the state lines 6 to 15 % are missing, with 25 to 35 ms of scatter and gaps of up
   * to 0.6 s. Assumed: commands and replies are lost equally often.
   */
  LAB(
      "loss commands replies 1%",
      "delay replies 44ms spread 38.6ms least 5ms most 228ms",
      "loss state 10% burst 1.5",
      "delay state 25ms spread 20ms"),

  /**
   * A handful of drones in one room. Assumed: about twice as bad as the lab, with longer bursts;
   * that commands to one of four drones get lost is told in DJITelloPy, pull request 17.
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

  /** What a drone of a behaviour has unless somebody says otherwise. */
  public static LinkPreset usual(Behavior behavior) {
    return behavior == Behavior.MEASURED ? LAB : IDEAL;
  }

  /** The word that chooses it. */
  public String option() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * The preset of a word.
   *
   * @throws FaultTextException if there is none, with the nearest one
   */
  public static LinkPreset of(String word) {
    return Stream.of(values())
        .filter(preset -> preset.option().equals(word))
        .findFirst()
        .orElseThrow(() -> FaultText.unknown(word, options()));
  }

  /** All words, from good to bad. */
  public static List<String> options() {
    return Stream.of(values()).map(LinkPreset::option).toList();
  }

  /** What acts all the time. */
  List<Fault> faults() {
    return this == IDEAL ? List.of() : Parsed.FAULTS.get(this);
  }

  /** Read when they are needed for the first time, which is never on an ideal link. */
  private static final class Parsed {

    private static final Map<LinkPreset, List<Fault>> FAULTS = new EnumMap<>(LinkPreset.class);

    static {
      for (LinkPreset preset : values()) {
        FAULTS.put(preset, preset.texts.stream().map(Fault::of).toList());
      }
    }
  }
}
