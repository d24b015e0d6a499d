package tellosimulator.web;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import tellosimulator.json.Json;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.report.FlightReport;
import tellosimulator.report.ReportTexts;
import tellosimulator.scenario.Description;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.time.TimeFactor;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.RenderCache;

/** The page of a simulator, with its viewers. Thread-safe. */
final class SimulatorSite implements Site {

  /** Maximum number of viewers. Decided: a group of a class; each takes a part of a processor. */
  static final int MOST_VIEWERS = 8;

  private final ScenarioHost host;
  private final RenderCache cache = new RenderCache(ColorSpace.RGB);
  private final Map<String, Viewer> viewers = new HashMap<>();
  private final WebPilot pilot = new WebPilot();
  private boolean closed;

  SimulatorSite(ScenarioHost host) {
    this.host = host;
  }

  @Override
  public String page() {
    return "page.html";
  }

  /**
   * Returns the viewer of a page, which is created if it is new. Pages without open streams make
   * place for a new one.
   *
   * @throws IllegalStateException if there are too many; the message is one sentence
   */
  private synchronized Viewer viewer(WebRequest request) {
    String name = request.parameter("viewer").orElse("");
    Viewer known = viewers.get(name);
    if (known != null) {
      return known;
    }
    if (viewers.size() >= MOST_VIEWERS) {
      viewers.values().removeIf(Viewer::idle);
    }
    if (closed || viewers.size() >= MOST_VIEWERS) {
      throw new IllegalStateException(
          "There are " + MOST_VIEWERS + " viewers already; close another page.");
    }
    Viewer viewer = new Viewer(host::current, cache);
    viewers.put(name, viewer);
    return viewer;
  }

  @Override
  public void get(WebRequest request) throws IOException {
    try {
      switch (request.path()) {
        case "room" -> viewer(request).sendRoom(request);
        case "film" -> viewer(request).sendFilm(request);
        case "state" -> viewer(request).sendState(request, this::flights);
        case "gallery" -> request.answer(gallery(request.locale()));
        case "report" -> report(request);
        case "recording.zip" -> recording(request);
        default -> request.answer(WebRequest.NOT_FOUND, "There is no such page.");
      }
    } catch (IllegalStateException e) {
      request.answer(WebRequest.TOO_MANY, e.getMessage());
    }
  }

  /** Returns the members of the state that are about flights, and not about the scenario. */
  private Map<String, Object> flights() {
    return Json.object("report", lastFlight().isPresent(), "demo", pilot.fliesDemo());
  }

  private static List<Map<String, Object>> gallery(Locale locale) {
    return Gallery.NAMES.stream()
        .map(
            name -> {
              Description about = Gallery.find(name).orElseThrow().description();
              return Json.object(
                  "name", name,
                  "title", about.name().in(locale),
                  "teaches", about.teaches().in(locale));
            })
        .toList();
  }

  private Optional<Path> lastFlight() {
    return host.recordings().flatMap(RecordingFolder::latest).filter(Files::isDirectory);
  }

  private Path flight(WebRequest request) {
    return lastFlight()
        .orElseThrow(
            () -> new IllegalStateException(new WebTexts(request.locale()).text("web.no-flight")));
  }

  private void report(WebRequest request) throws IOException {
    try {
      ReportTexts texts = new ReportTexts(new WebTexts(request.locale()).translation());
      String page = new FlightReport(RecordedFlight.read(flight(request)), texts).html();
      request.header("Content-Security-Policy"); // the report has its own
      request.answer(WebRequest.OK, "text/html", page.getBytes(StandardCharsets.UTF_8));
    } catch (UnreadableRecordingException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  private void recording(WebRequest request) throws IOException {
    Path folder = flight(request);
    request.header(
        "Content-Disposition", "attachment; filename=\"" + folder.getFileName() + ".zip\"");
    try (OutputStream out = request.begin("application/zip");
        ZipOutputStream zip = new ZipOutputStream(out, StandardCharsets.UTF_8);
        var files = Files.list(folder)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        zip.putNextEntry(new ZipEntry(folder.getFileName() + "/" + file.getFileName()));
        Files.copy(file, zip);
      }
    }
  }

  @Override
  public void post(WebRequest request) throws IOException {
    if (request.path().equals("scenario")) {
      open(uploaded(request), OptionalLong.empty(), request);
      request.answer(Map.of());
    } else if (request.path().equals("do")) {
      request.answer(carryOut(request));
    } else {
      request.answer(WebRequest.NOT_FOUND, "There is no such action.");
    }
  }

  private Object carryOut(WebRequest request) throws IOException {
    Map<String, Object> action = request.action();
    Viewer viewer = viewer(request);
    WebSubject subject = host.current();
    switch (String.valueOf(action.get("do"))) {
      case "turn" -> viewer.camera().turn(number(action, "right"), number(action, "down"));
      case "zoom" -> viewer.camera().zoom(number(action, "factor"));
      case "look" -> viewer.look(text(action, "view"));
      case "follow" -> viewer.camera().follow();
      case "select" -> viewer.select(number(action, "drone"));
      case "fly" -> pilot.send(subject.simulation(), viewer.drone(), text(action, "command"));
      case "demo" ->
          pilot.demo(subject.simulation(), subject.goals().progress().challenge(), viewer.drone());
      case "open" -> open(known(text(action, "scenario")), OptionalLong.empty(), request);
      case "course" -> {
        OpenedScenario opened = subject.opened();
        long next = opened.scenario().config().seed() + 1;
        open(opened, OptionalLong.of(next), request);
      }
      case "pause" -> control(new Control.Pause(Boolean.TRUE.equals(action.get("on"))));
      case "time-factor" -> control(new Control.SetTimeFactor(factor(text(action, "factor"))));
      default -> {
        return subject.requests().result(action);
      }
    }
    return Map.of();
  }

  private void control(Control control) {
    try {
      host.current().simulation().carryOut(control);
    } catch (PortTakenException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  private static TimeFactor factor(String word) {
    return word.equals(TimeFactor.MAX.toString())
        ? TimeFactor.MAX
        : new TimeFactor(Double.parseDouble(word));
  }

  private static OpenedScenario known(String name) {
    return name.isEmpty()
        ? OpenedScenario.once(Scenario.of(SimConfig.DEFAULT))
        : Gallery.open(name)
            .map(document -> OpenedScenario.known(document, name))
            .orElseThrow(() -> new IllegalArgumentException("there is no such scenario"));
  }

  private static OpenedScenario uploaded(WebRequest request) throws IOException {
    String name = request.parameter("name").orElse("scenario.yaml");
    try {
      return OpenedScenario.received(name, request.body());
    } catch (ScenarioException e) {
      throw complaint(e, request);
    }
  }

  private void open(OpenedScenario chosen, OptionalLong seed, WebRequest request) {
    try {
      host.open(chosen, seed);
    } catch (ScenarioException e) {
      throw complaint(e, request);
    } catch (PortTakenException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  private static IllegalArgumentException complaint(ScenarioException e, WebRequest request) {
    WebTexts texts = new WebTexts(request.locale());
    return new IllegalArgumentException(e.diagnostics().get(0).in(texts.translation()), e);
  }

  private static String text(Map<String, Object> action, String name) {
    return String.valueOf(action.getOrDefault(name, ""));
  }

  private static double number(Map<String, Object> action, String name) {
    return Optional.ofNullable(action.get(name))
        .filter(Number.class::isInstance)
        .map(value -> ((Number) value).doubleValue())
        .filter(Double::isFinite)
        .orElseThrow(() -> new IllegalArgumentException(name + " must be a number"));
  }

  @Override
  public synchronized void close() {
    closed = true;
    viewers.values().forEach(Viewer::close);
    pilot.close();
  }
}
