package tellosimulator.web;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.HttpURLConnection;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import tellosimulator.concurrent.Agent;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.control.AccessToken;
import tellosimulator.goal.Progress;
import tellosimulator.goal.Score;
import tellosimulator.json.Json;
import tellosimulator.scenery.overlay.Overlay;
import tellosimulator.sim.LastCommand;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.time.Ticker;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.RenderCache;

/**
 * Reports a simulator to the teacher's board once a second, and carries out what the teacher asks
 * for. If the board does not answer, keeps trying. Has a thread of its own.
 */
public final class BoardReporter implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(BoardReporter.class);

  /** Time between two reports [ns]. Decided: often enough for tiles. */
  private static final long PERIOD = 1_000_000_000;

  /** Longest time to wait for the board [ms]. Decided: longer than a busy network takes. */
  private static final int PATIENCE_MS = 5_000;

  private static final int WIDTH = 480;
  private static final int HEIGHT = 270;

  /** Largest answer that is read [bytes]. Decided: far more than the orders of a board. */
  private static final int MOST_BYTES = 1 << 16;

  private final ScenarioHost host;
  private final Actions actions;
  private final URI seat;
  private final String name;
  private final String team;
  private final ViewerCamera camera = new ViewerCamera();
  private final RenderCache cache = new RenderCache(ColorSpace.RGB);
  private final Ticker ticker = new Ticker();
  private final Worker worker;

  private WebTexts texts = new WebTexts(Locale.ENGLISH);
  private WebSubject subject;
  private ViewerPictures pictures;
  private Optional<LastCommand.Shown> failed = Optional.empty();
  private Optional<byte[]> unsent = Optional.empty();
  private boolean lost;
  private volatile Optional<HttpURLConnection> open = Optional.empty();

  private BoardReporter(ScenarioHost host, URI board, String name, String team) {
    this.host = host;
    this.name = name;
    this.team = team;
    actions = new Actions(host);
    String id = AccessToken.create().text(); // a secret, so that no other simulator can use it
    seat = board.resolve("seat?" + board.getRawQuery() + "&id=" + id);
    subject = host.current();
    pictures = pictures();
    worker = Worker.start("board", new Reports());
  }

  /**
   * Begins to report.
   *
   * @param board the address that the board has printed for simulators
   * @param name the name of the person or group
   * @param team the name of the team; may be empty
   */
  public static BoardReporter start(ScenarioHost host, URI board, String name, String team) {
    return new BoardReporter(host, board, name, team);
  }

  private final class Reports implements Agent {

    private final ErrorPolicy failed = ErrorPolicy.goOn("A report to the board failed");

    @Override
    public Outcome doWork() {
      if (ticker.awaitTick(PERIOD)) {
        report();
      }
      return Outcome.WORKED;
    }

    @Override
    public ErrorPolicy onError(Throwable failure) {
      return failed;
    }

    @Override
    public void onClose() {
      pictures.close();
    }
  }

  private ViewerPictures pictures() {
    Overlay overlay = new Overlay(subject.simulation().snapshot());
    return new ViewerPictures(subject, overlay, cache, WIDTH, HEIGHT);
  }

  private void report() {
    if (subject.number() != host.current().number()) {
      subject = host.current();
      pictures.close();
      pictures = pictures();
      failed = Optional.empty();
    }
    try {
      Map<?, ?> answer = post(body());
      if (answer.containsKey("orders")) { // otherwise it came too soon
        unsent = Optional.empty();
      }
      carryOut(answer);
      if (lost) {
        LOG.info("The board answers again.");
      }
      lost = false;
    } catch (IOException | IllegalArgumentException e) {
      if (!lost) {
        LOG.warn(
            "The board at {} does not take reports ({}); start it, or check the address.",
            seat.getAuthority(),
            e.getMessage());
      }
      lost = true;
    }
  }

  /** Returns a line with the state, and the picture behind it unless it is the same as before. */
  private byte[] body() throws IOException {
    ByteArrayOutputStream body = new ByteArrayOutputStream();
    body.write(Json.text(state()).getBytes(StandardCharsets.UTF_8));
    body.write('\n');
    unsent = pictures.next(camera, 1).or(() -> unsent);
    if (unsent.isPresent()) {
      body.write(unsent.get());
    }
    return body.toByteArray();
  }

  private Map<String, Object> state() {
    SimSnapshot snapshot = subject.simulation().snapshot();
    Progress progress = subject.goals().progress();
    Optional<LastCommand.Shown> last = subject.lastCommand().newest();
    failed = last.filter(shown -> shown.outcome() == LastCommand.Outcome.FAILED).or(() -> failed);
    return Json.object(
        "name", name,
        "team", team,
        "title", subject.opened().scenario().description().name().in(texts.translation().locale()),
        "course", subject.opened().scenario().config().seed(),
        "status", progress.status().name().toLowerCase(Locale.ROOT),
        "reached", progress.count(),
        "goals", progress.challenge().goals().size(),
        "clock", Json.rounded(progress.elapsed()),
        "points", progress.score().map(Score::points),
        "of", progress.score().map(Score::of),
        "operator", operators(snapshot),
        "command", last.map(LastCommand.Shown::text),
        "failed", progress.failure().map(texts::say).or(() -> failed.map(this::failure)));
  }

  private static String operators(SimSnapshot snapshot) {
    return snapshot.drones().stream()
        .flatMap(drone -> drone.link().operator().stream())
        .map(peer -> peer.host())
        .distinct()
        .collect(Collectors.joining(", "));
  }

  private String failure(LastCommand.Shown shown) {
    return shown.text() + " → " + shown.reason().map(texts::say).orElse(shown.reply());
  }

  private Map<?, ?> post(byte[] body) throws IOException {
    HttpURLConnection connection = (HttpURLConnection) seat.toURL().openConnection();
    open = Optional.of(connection);
    try {
      connection.setConnectTimeout(PATIENCE_MS);
      connection.setReadTimeout(PATIENCE_MS);
      connection.setInstanceFollowRedirects(false);
      connection.setDoOutput(true);
      connection.setFixedLengthStreamingMode(body.length);
      try (OutputStream out = connection.getOutputStream()) {
        out.write(body);
      }
      if (connection.getResponseCode() != WebRequest.OK) {
        throw new IOException("it answers with " + connection.getResponseCode());
      }
      byte[] answer = connection.getInputStream().readNBytes(MOST_BYTES);
      return Json.value(new String(answer, StandardCharsets.UTF_8)) instanceof Map<?, ?> map
          ? map
          : Map.of();
    } finally {
      connection.disconnect();
    }
  }

  /** Carries out orders; those that are not possible are only logged. */
  private void carryOut(Map<?, ?> answer) {
    if (answer.get("language") instanceof String language) {
      texts = new WebTexts(WebRequest.offered(language));
    }
    if (answer.get("orders") instanceof List<?> orders) {
      orders.forEach(this::carryOutOne);
    }
  }

  private void carryOutOne(Object order) {
    try {
      Map<String, Object> action = BoardSite.order(order);
      LOG.info("The board requests {}.", action.get("do"));
      actions.carryOut(action, texts);
    } catch (IllegalArgumentException | IllegalStateException | AssertionError e) {
      LOG.warn("The request of the board cannot be carried out: {}", e.getMessage());
    }
  }

  @Override
  public void close() {
    worker.end();
    open.ifPresent(HttpURLConnection::disconnect);
    ticker.wake();
    worker.close();
  }
}
