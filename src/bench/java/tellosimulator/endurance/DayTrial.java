package tellosimulator.endurance;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import tellosimulator.benchmark.Measurement;
import tellosimulator.benchmark.Operator;

/**
 * A drone that flies circles by {@code rc} and films, in real time: for {@code endurance.hours}, or
 * else for as long as goes with the minutes. ffmpeg decodes all that it films. How fast it is
 * counts only where hours are given, because otherwise other trials run beside it.
 */
final class DayTrial {

  private static final String HOURS = System.getProperty("endurance.hours", "");

  private static final double SHORTEST_SECONDS = 20;
  private static final double SECONDS_A_MINUTE = 12;

  /**
   * Until what runs is compiled, and buffers have their size; not counted. Half of the flight, but
   * within these bounds [s].
   */
  private static final double SHORTEST_WARM_UP_SECONDS = 15;

  private static final double LONGEST_WARM_UP_SECONDS = 300;

  private static final double RC_SECONDS = 0.05;

  /** A battery lasts for thirteen minutes. */
  private static final double BATTERY_SECONDS = 60;

  /** How often a long flight tells how far it is. */
  private static final double TELLING_SECONDS = 600;

  private static final double LARGEST_HEAP_GROWTH_MB = 5;

  /** The collector's young space grows and shrinks by as much. */
  private static final double LARGEST_GROWTH_MB = 60;

  /** Of the thirty that are filmed, as a day's mean. */
  private static final double LEAST_PICTURES_A_SECOND = 28;

  /** How long the last picture may be on its way [s]. */
  private static final double LAST_SECONDS = 1;

  private final SimulatorProcess simulator;
  private final Operator operator;
  private final LiveDecoder decoder;

  private DayTrial(SimulatorProcess simulator, Operator operator, LiveDecoder decoder) {
    this.simulator = simulator;
    this.operator = operator;
    this.decoder = decoder;
  }

  static List<Measurement> run(double minutes) throws IOException {
    double seconds =
        HOURS.isEmpty()
            ? Math.max(SHORTEST_SECONDS, minutes * SECONDS_A_MINUTE)
            : Double.parseDouble(HOURS) * 3600;
    try (LiveDecoder decoder = new LiveDecoder();
        DatagramSocket stateSocket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        SimulatorProcess simulator =
            SimulatorProcess.here(
                "--command-port",
                "0",
                "--state-port",
                "" + stateSocket.getLocalPort(),
                "--video-port",
                "" + decoder.port(),
                "--room",
                "2000x2000x500");
        Operator operator = new Operator(simulator.drone(1).getPort())) {
      return new DayTrial(simulator, operator, decoder).fly(seconds, Arrivals.at(stateSocket));
    }
  }

  private List<Measurement> fly(double seconds, Arrivals states) throws IOException {
    operator.expect("command", "ok");
    operator.expect("takeoff", "ok");
    operator.expect("streamon", "ok");
    circle(Math.max(SHORTEST_WARM_UP_SECONDS, Math.min(seconds / 2, LONGEST_WARM_UP_SECONDS)));
    double resident =
        simulator.figures().residentMegabytes(); // before the collector is told to run
    double heap = simulator.figures().heapMegabytes();
    long pictures = decoder.pictures();
    OtherLoad others = new OtherLoad();
    long begun = System.nanoTime();
    circle(seconds);
    long end = System.nanoTime();
    double share = others.share();
    double flown = (end - begun) * 1e-9;
    double rate = (decoder.pictures() - pictures) / flown;
    double residentAtEnd = simulator.figures().residentMegabytes();
    double heapAtEnd = simulator.figures().heapMegabytes();
    String state = simulator.state(1);
    List<Measurement> rows = new ArrayList<>();
    rows.add(
        Measurement.beside(
            "Hours of flight in real time, with film and `rc`",
            String.format(Locale.ROOT, "%.2f h", flown / 3600)));
    rows.add(
        new Measurement(
            "… the drone at the end", "flies", state, state.startsWith("drone 1: flying")));
    rows.add(
        Measurement.beside(
            "… resident memory at first, and at the end",
            String.format(Locale.ROOT, "%.0f MB, %.0f MB", resident, residentAtEnd)));
    rows.add(
        Measurement.atMost("… it grows by", LARGEST_GROWTH_MB, residentAtEnd - resident, "MB"));
    rows.add(Measurement.atMost("… heap grows by", LARGEST_HEAP_GROWTH_MB, heapAtEnd - heap, "MB"));
    rows.add(pace(StopTrial.statePeriod(states.between(begun, end)), share));
    rows.add(
        pace(
            new Measurement(
                "… pictures a second",
                "at least " + Math.round(LEAST_PICTURES_A_SECOND),
                String.format(Locale.ROOT, "%.1f", rate),
                rate >= LEAST_PICTURES_A_SECOND),
            share));
    rows.add(film());
    rows.add(LeakedInternals.row("… log", simulator));
    return rows;
  }

  private static Measurement pace(Measurement row, double share) {
    return HOURS.isEmpty()
        ? Measurement.beside(row.what(), row.measured())
        : OtherLoad.judged(row, share);
  }

  /** Steers as a person does, and changes the battery in flight. */
  private void circle(double seconds) throws IOException {
    long begun = System.nanoTime();
    long turns = Math.round(seconds / RC_SECONDS);
    long turnsOfBattery = Math.round(BATTERY_SECONDS / RC_SECONDS);
    for (long turn = 0; turn < turns; turn++) {
      if (turn % turnsOfBattery == 0) {
        simulator.program().type("battery 100");
      }
      if ((turn + 1) % Math.round(TELLING_SECONDS / RC_SECONDS) == 0) {
        tell((System.nanoTime() - begun) * 1e-9);
      }
      operator.send("rc 0 30 0 60");
      Waiting.pass((turn + 1) * RC_SECONDS - (System.nanoTime() - begun) * 1e-9);
    }
  }

  /** So that a run that is cut off has told how far it was. */
  private void tell(double seconds) throws IOException {
    System.out.printf(
        Locale.ROOT,
        "day: %.2f h, resident %.0f MB, %d pictures, %d datagrams not taken%n",
        seconds / 3600,
        simulator.figures().residentMegabytes(),
        decoder.pictures(),
        decoder.lost());
  }

  private Measurement film() throws IOException {
    operator.expect("streamoff", "ok");
    Waiting.pass(LAST_SECONDS);
    long lost = decoder.lost();
    long pictures = decoder.pictures();
    long decoded = decoder.decoded();
    String complaints = decoder.complaints();
    String measured = decoded + " of " + pictures;
    if (lost > 0) {
      measured += " (not judged: " + lost + " datagrams found no room in the receiver)";
    } else if (!complaints.isEmpty()) {
      System.out.println(complaints);
      measured += ", with complaints, see above";
    }
    return new Measurement(
        "… pictures that ffmpeg decodes without a complaint",
        "all",
        measured,
        lost > 0 || (decoded == pictures && complaints.isEmpty()));
  }
}
