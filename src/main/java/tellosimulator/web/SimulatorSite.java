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
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import tellosimulator.json.Json;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.report.FlightReport;
import tellosimulator.report.ReportTexts;
import tellosimulator.scenario.Description;
import tellosimulator.scenario.Gallery;
import tellosimulator.video.camera.ColorSpace;
import tellosimulator.video.camera.RenderCache;

/** The page of a simulator, with its viewers. Thread-safe. */
final class SimulatorSite implements Site {

  /** Maximum number of viewers. Decided: a group of a class; each takes a part of a processor. */
  static final int MOST_VIEWERS = 8;

  private final ScenarioHost host;
  private final RenderCache cache = new RenderCache(ColorSpace.RGB);
  private final Map<String, Viewer> viewers = new HashMap<>();
  private final Actions actions;
  private final WebPilot pilot = new WebPilot();
  private boolean closed;

  SimulatorSite(ScenarioHost host) {
    this.host = host;
    actions = new Actions(host);
  }

  @Override
  public String page() {
    return "page.html";
  }

  /**
   * Returns the viewer of a page, which is created if it is new. Pages that are no longer open make
   * place for a new one.
   *
   * @throws IllegalStateException if there are too many; the message is one sentence
   */
  private synchronized Viewer viewer(WebRequest request) {
    String name = request.parameter("viewer").orElse("");
    Viewer known = viewers.get(name);
    if (known != null) {
      known.use();
      return known;
    }
    if (viewers.size() >= MOST_VIEWERS) {
      viewers.values().removeIf(Viewer::abandoned);
    }
    if (closed || viewers.size() >= MOST_VIEWERS) {
      throw new IllegalStateException(
          "There are " + MOST_VIEWERS + " viewers already; close another page.");
    }
    Viewer viewer = new Viewer(host::current, cache, this::readers);
    viewers.put(name, viewer);
    return viewer;
  }

  /** Returns the number of viewers that read a stream. */
  private synchronized int readers() {
    return (int) viewers.values().stream().filter(Viewer::reads).count();
  }

  @Override
  public void get(WebRequest request) throws IOException {
    try {
      switch (request.path()) {
        case "room" -> viewer(request).sendRoom(request);
        case "state" -> viewer(request).sendState(request, this::flights);
        case "gallery" -> request.answer(gallery(request.locale()));
        case "report" -> lastFlight(request, this::report);
        case "recording.zip" -> lastFlight(request, this::recording);
        default -> request.answer(WebRequest.NOT_FOUND, "There is no such page.");
      }
    } catch (IllegalStateException e) {
      request.answer(WebRequest.TOO_MANY, e.getMessage());
    }
  }

  /** Returns the members of the state that are about flights, and not about the scenario. */
  private Map<String, Object> flights() {
    return Json.object("report", lastFlight().isPresent(), "demo", pilot.fliesDemo(host.current()));
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

  /** What answers with the last flight. */
  private interface FlightAnswer {
    void send(WebRequest request, Path folder) throws IOException;
  }

  private void lastFlight(WebRequest request, FlightAnswer answer) throws IOException {
    Optional<Path> folder = lastFlight();
    if (folder.isPresent()) {
      answer.send(request, folder.get());
    } else {
      request.answer(WebRequest.NOT_FOUND, new WebTexts(request.locale()).text("web.no-flight"));
    }
  }

  private void report(WebRequest request, Path folder) throws IOException {
    try {
      ReportTexts texts = new ReportTexts(new WebTexts(request.locale()).translation());
      String page = new FlightReport(RecordedFlight.read(folder), texts).html();
      request.header("Content-Security-Policy"); // the report has its own
      request.answer(WebRequest.OK, "text/html", page.getBytes(StandardCharsets.UTF_8));
    } catch (UnreadableRecordingException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  private void recording(WebRequest request, Path folder) throws IOException {
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
      String name = request.parameter("name").orElse("scenario.yaml");
      actions.open(name, request.body(), new WebTexts(request.locale()));
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
      case "turn" ->
          viewer.camera().turn(Actions.number(action, "right"), Actions.number(action, "down"));
      case "zoom" -> viewer.camera().zoom(Actions.number(action, "factor"));
      case "look" -> viewer.look(Actions.text(action, "view"));
      case "follow" -> viewer.camera().follow();
      case "fly" ->
          pilot.send(subject, Viewer.drone(request, subject), Actions.text(action, "command"));
      case "demo" -> pilot.demo(subject, Viewer.drone(request, subject));
      default -> {
        return actions.carryOut(action, new WebTexts(request.locale()));
      }
    }
    return Map.of();
  }

  @Override
  public synchronized void close() {
    closed = true;
    viewers.values().forEach(Viewer::close);
    pilot.close();
  }
}
