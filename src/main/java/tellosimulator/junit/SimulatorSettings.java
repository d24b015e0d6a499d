package tellosimulator.junit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Function;
import java.util.stream.Collectors;
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
 * What is simulated: all that can be said of a {@link TelloSimulator} before it starts. Each method
 * returns this object. Whether what was said makes sense is checked at the start. For one thread.
 *
 * @param <T> the kind of this object
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

  /** A file, or one of the scenarios that come with the program; without this, an empty room. */
  public T scenario(String fileOrName) {
    scenario = fileOrName;
    return self();
  }

  /** How many drones, beside each other; only without a scenario, which says it. */
  public T drones(int count) {
    if (count < 1) {
      throw new IllegalArgumentException("drones is " + count + ", but must be at least 1");
    }
    drones = count;
    return self();
  }

  /** Which product: {@code edu}, {@code tello} or {@code tt}. */
  public T profile(String name) {
    profile = name;
    return self();
  }

  /** After which account of the drone: {@code report}, or {@code measured} with its noise. */
  public T behavior(String name) {
    behavior = name;
    return self();
  }

  /**
   * How many simulated seconds pass in a second of the wall clock; without this {@code max}: as
   * fast as the machine can while somebody waits for an answer, and not at all otherwise.
   */
  public T timeFactor(String factor) {
    timeFactor = factor;
    return self();
  }

  /** Of everything random; without this, the scenario's. */
  public T seed(long number) {
    seed = OptionalLong.of(number);
    return self();
  }

  /**
   * How good the link is: {@code ideal}, {@code lab}, {@code classroom} or {@code crowded}; without
   * this, as the scenario says, or what the behaviour usually has.
   */
  public T link(String preset) {
    link = preset;
    return self();
  }

  /**
   * Something more that goes wrong.
   *
   * @param text such as {@code loss state 20% at 5s for 10s}; see the page on faults
   */
  public T fault(String text) {
    faults.add(text);
    return self();
  }

  /** Whether drones film after {@code streamon}; without this they do. */
  public T video(boolean filmed) {
    video = filmed;
    return self();
  }

  /** Which ports are used; without this, free ones. */
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
   * What is to be simulated.
   *
   * @throws IllegalArgumentException with a sentence that names what is wrong
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
      Scenario opened = OpenedScenario.named(scenario).scenario();
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
      String guess =
          Spelling.meant(word, names).map(meant -> ", did you mean " + meant + "?").orElse("");
      throw new IllegalArgumentException(
          names.stream()
                  .collect(
                      Collectors.joining(", ", what + " is " + word + ", but must be one of ", ""))
              + guess);
    }
    return Optional.of(values[names.indexOf(word)]);
  }

  /** The setups of the drones with places for their state and video. */
  static SimConfig withStreamPorts(SimConfig config, List<StreamPorts> streamPorts) {
    List<DroneSetup> changed = new ArrayList<>();
    for (int i = 0; i < config.drones().size(); i++) {
      changed.add(config.drones().get(i).withStreamPorts(streamPorts.get(i)));
    }
    return config.withDrones(changed);
  }
}
