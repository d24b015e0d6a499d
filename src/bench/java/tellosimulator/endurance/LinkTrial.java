package tellosimulator.endurance;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import tellosimulator.benchmark.Measurement;

/**
 * A bad link between two machines, made by a third one on the way, which knows nothing of the
 * simulator. A client that repeats commands flies its course.
 */
final class LinkTrial {

  private static final int TIME_FACTOR = 4;

  /** More than any command of the course takes, and the way there and back. */
  private static final int RETRY_MS = 2500;

  private static final long SEED = 20;
  private static final double MINUTES_A_TOUR = 5;
  private static final double PATIENCE_SECONDS = 150;
  private static final double ANSWER_SECONDS = 10;

  /** How long state lines and pictures are counted. */
  private static final double WATCHED_SECONDS = 3;

  /** So much later a first picture still counts as one. Decided: as clients wait for an answer. */
  private static final double PICTURE_SECONDS = 30;

  private LinkTrial() {}

  static List<Measurement> run(double minutes) throws IOException {
    int courses = (int) Math.max(1, minutes / MINUTES_A_TOUR);
    List<Measurement> rows = new ArrayList<>();
    try (PrivateNetwork network = new PrivateNetwork(3)) {
      for (Map.Entry<String, String> link : links().entrySet()) {
        rows.addAll(fly(network, link.getKey(), link.getValue(), courses));
      }
    }
    return rows;
  }

  /** What is told of a link, and its disturbances with commas between them. */
  private static Map<String, String> links() {
    Map<String, String> links = new LinkedHashMap<>();
    links.put("Link that loses 20 % each way", Forwarder.Disturbance.LOSS.name());
    links.put("Link that delays by 200 ms each way", Forwarder.Disturbance.DELAY.name());
    links.put("Link that doubles 20 %", Forwarder.Disturbance.DUPLICATE.name());
    links.put("Link on which 20 % are overtaken", Forwarder.Disturbance.REORDER.name());
    links.put(
        "Link that does all of this",
        Arrays.stream(Forwarder.Disturbance.values())
            .map(Enum::name)
            .collect(Collectors.joining(",")));
    return links;
  }

  private static List<Measurement> fly(
      PrivateNetwork network, String what, String disturbances, int courses) throws IOException {
    Host machine = network.host(1);
    Host between = network.host(2);
    Host operator = network.host(3);
    List<String> options =
        new ArrayList<>(List.of(TourProcess.Ports.usual(machine.address()).options()));
    options.addAll(List.of("--time-factor", "" + TIME_FACTOR, "--room", "2000x2000x500"));
    try (SimulatorProcess simulator =
            SimulatorProcess.start(
                machine, List.of(), LanOptions.with(options.toArray(String[]::new)));
        Program forwarder =
            between.start(
                Forwarder.class, machine.address(), operator.address(), SEED, disturbances)) {
      forwarder.await("passing", ANSWER_SECONDS);
      try (TourProcess tours =
          new TourProcess(operator, TourProcess.Ports.usual(between.address()), RETRY_MS)) {
        tours.awaitFlying(PATIENCE_SECONDS);
        TourProcess.Window window = watched(tours);
        String flown = flown(tours, courses);
        forwarder.type("");
        String[] counts = forwarder.await("taken", ANSWER_SECONDS).split(" ", -1);
        return List.of(
            new Measurement(
                what + ": a client that repeats commands",
                "flies its course",
                String.format(
                    Locale.ROOT, "%s; %s of %s datagrams disturbed", flown, counts[3], counts[1]),
                flown.startsWith("flies")),
            new Measurement(
                "… state lines and video",
                "come",
                window.state().count() + " and " + window.video().count() + " datagrams in 3 s",
                window.state().count() > 0 && window.video().count() > 0),
            LeakedInternals.row("… log", simulator));
      }
    }
  }

  /** What comes in three seconds; later ones, if a slow machine has no picture yet. */
  private static TourProcess.Window watched(TourProcess tours) throws IOException {
    long end = System.nanoTime() + (long) (PICTURE_SECONDS * 1e9);
    TourProcess.Window window;
    do {
      window = tours.window(System.nanoTime(), WATCHED_SECONDS);
    } while (window.video().count() == 0 && System.nanoTime() < end);
    return window;
  }

  private static String flown(TourProcess tours, int courses) {
    int again = 0;
    try {
      for (int i = 0; i < courses; i++) {
        again = tours.awaitFlown(PATIENCE_SECONDS);
      }
      return "flies, " + again + " commands sent again";
    } catch (IOException e) {
      return String.valueOf(e.getMessage());
    }
  }
}
