package tellosimulator.junit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Function;
import tellosimulator.fault.Fault;
import tellosimulator.fault.FaultText;
import tellosimulator.fault.LinkPreset;
import tellosimulator.profile.Behavior;
import tellosimulator.profile.Profile;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.sim.DroneSetup;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimConfig.Product;
import tellosimulator.sim.SimConfig.StreamPorts;
import tellosimulator.time.TimeFactor;
import tellosimulator.words.Spelling;

/**
 * The settings of a {@link TelloSimulator}, made before the simulator starts. Each setter returns
 * this object. Whether the settings are consistent is checked when the simulator starts. Not
 * thread-safe.
 *
 * @param <T> the concrete type of this object
 */
public abstract sealed class SimulatorSettings<T extends SimulatorSettings<T>>
    permits TelloSimulator.Builder, TelloSimulatorExtension.Builder {

  private String scenario = "";
  private int drones;
  private String profile = "";
  private String behavior = "";
  private String timeFactor = "max";
  private OptionalLong seed = OptionalLong.empty();
  private String link = "";
  private final List<String> faults = new ArrayList<>();
  private boolean video = true;
  private PortChoice ports = PortChoice.FREE;

  SimulatorSettings() {}

  abstract T self();

  /**
   * Sets the scenario: a file, or one of the scenarios that come with the program. The default is
   * an empty room.
   */
  public T scenario(String fileOrName) {
    scenario = fileOrName;
    return self();
  }

  /**
   * Sets the number of drones. They stand side by side. Not allowed together with a scenario,
   * because a scenario defines its own drones.
   */
  public T drones(int count) {
    if (count < 1) {
      throw new IllegalArgumentException("drones is " + count + ", but must be at least 1");
    }
    drones = count;
    return self();
  }

  /** Sets the product: {@code edu}, {@code tello} or {@code tt}. */
  public T profile(String name) {
    profile = name;
    return self();
  }

  /**
   * Sets the reference model of the drone: {@code report}, or {@code measured}, which includes
   * noise.
   */
  public T behavior(String name) {
    behavior = name;
    return self();
  }

  /**
   * Sets the number of simulated seconds per second of wall clock time. The default is {@code max}:
   * time passes as fast as the machine allows while a client waits for a reply, and stands still
   * otherwise.
   */
  public T timeFactor(String factor) {
    timeFactor = factor;
    return self();
  }

  /** Sets the seed of all randomness. The default is the seed of the scenario. */
  public T seed(long number) {
    seed = OptionalLong.of(number);
    return self();
  }

  /**
   * Sets the quality of the radio link: {@code ideal}, {@code lab}, {@code classroom} or {@code
   * crowded}. The default is the scenario's link quality, or the behaviour's if the scenario has
   * none.
   */
  public T link(String preset) {
    link = preset;
    return self();
  }

  /**
   * Adds a fault.
   *
   * @param text the fault in words, such as {@code loss state 20% at 5s for 10s}; docs/faults.md
   *     lists all faults
   */
  public T fault(String text) {
    faults.add(text);
    return self();
  }

  /** Sets whether the drones send video after {@code streamon}. The default is true. */
  public T video(boolean filmed) {
    video = filmed;
    return self();
  }

  /** Sets the ports to use. The default is free ports. */
  public T ports(PortChoice which) {
    ports = which;
    return self();
  }

  PortChoice ports() {
    return ports;
  }

  boolean video() {
    return video;
  }

  /**
   * Returns the scenario to simulate.
   *
   * @throws IllegalArgumentException if a setting is invalid; the message names the setting or
   *     lists the errors in the scenario file
   */
  Scenario scenario() {
    if (scenario.isEmpty()) {
      int count = Math.max(drones, 1);
      SimConfig empty = SimConfig.DEFAULT;
      return changed(
          Scenario.of(
              empty.withRoom(
                  empty.arena().room(),
                  Formation.row(count, empty.starts().get(0).position(), empty.arena().room()))));
    }
    try {
      OpenedScenario named = OpenedScenario.named(scenario);
      Scenario opened = (seed.isPresent() ? named.drawnFrom(seed.getAsLong()) : named).scenario();
      if (drones != 0) {
        throw new IllegalArgumentException(
            "drones does not go with scenario "
                + scenario
                + ", which has "
                + opened.config().drones().size());
      }
      return changed(opened);
    } catch (ScenarioException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  private Scenario changed(Scenario base) {
    SimConfig config = base.config().withTimeFactor(factor());
    config = seed.isPresent() ? config.withSeed(seed.getAsLong()) : config;
    config = link.isEmpty() ? config : config.withLink(LinkPreset.of(link));
    List<Fault> all = new ArrayList<>(config.rules().faults().faults());
    for (String text : faults) {
      all.add(fault(text, config.drones().size()));
    }
    config = config.withFaults(all);
    List<DroneSetup> changed = new ArrayList<>();
    for (DroneSetup drone : config.drones()) {
      Product product = drone.product();
      changed.add(
          drone.withProduct(
              new Product(
                  byName("profile", profile, Profile.values(), Profile::option)
                      .orElse(product.profile()),
                  byName("behavior", behavior, Behavior.values(), Behavior::option)
                      .orElse(product.behavior()))));
    }
    return base.withConfig(config.withDrones(changed));
  }

  private static Fault fault(String text, int drones) {
    Fault fault = FaultText.read(text);
    int drone = fault.target().drone().orElse(1);
    if (drone > drones) {
      throw new IllegalArgumentException(
          "fault is " + text + ", but there is no drone " + drone + ": the last one is " + drones);
    }
    return fault;
  }

  private TimeFactor factor() {
    if (timeFactor.equals("max")) {
      return TimeFactor.MAX;
    }
    try {
      return new TimeFactor(Double.parseDouble(timeFactor));
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(
          "timeFactor is " + timeFactor + ", but must be a number such as 5, or max", e);
    }
  }

  private static <E> Optional<E> byName(
      String what, String word, E[] values, Function<E, String> name) {
    if (word.isEmpty()) {
      return Optional.empty();
    }
    List<String> names = Arrays.stream(values).map(name).toList();
    if (!names.contains(word)) {
      throw new IllegalArgumentException(
          what
              + " is "
              + word
              + ", but must be one of "
              + String.join(", ", names)
              + Spelling.hint(word, names, ""));
    }
    return Optional.of(values[names.indexOf(word)]);
  }

  /** Returns a copy in which the drones send state and video to the given ports. */
  static SimConfig withStreamPorts(SimConfig config, List<StreamPorts> streamPorts) {
    List<DroneSetup> changed = new ArrayList<>();
    for (int i = 0; i < config.drones().size(); i++) {
      changed.add(config.drones().get(i).withStreamPorts(streamPorts.get(i)));
    }
    return config.withDrones(changed);
  }
}
