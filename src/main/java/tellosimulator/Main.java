package tellosimulator;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import picocli.CommandLine;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;
import tellosimulator.cli.DiffOptions;
import tellosimulator.cli.ExportOptions;
import tellosimulator.cli.Launch;
import tellosimulator.cli.Options;
import tellosimulator.cli.ReportOptions;
import tellosimulator.cli.ScenarioOptions;
import tellosimulator.cli.Subcommand;
import tellosimulator.comparison.ComparisonTable;
import tellosimulator.comparison.FlightComparison;
import tellosimulator.comparison.FlightComparison.Flight;
import tellosimulator.comparison.Tolerance;
import tellosimulator.concurrent.FatalExit;
import tellosimulator.files.IoReason;
import tellosimulator.goal.Progress.Status;
import tellosimulator.headless.HeadlessSimulator;
import tellosimulator.log.LogSetup;
import tellosimulator.log.StandardErrorLog;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.report.ComparisonReport;
import tellosimulator.report.ComparisonReport.NamedFlight;
import tellosimulator.report.FlightReport;
import tellosimulator.report.FlightReports;
import tellosimulator.report.ReportTexts;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.view.app.SimulatorApp;
import tellosimulator.view.app.Toolkit;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.settings.DataFolder;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.text.Language;
import tellosimulator.words.Spelling;

/** The command line: reads the options, then runs the simulator or a {@link Subcommand}. */
public final class Main {

  private static final int FAILED = 1;
  private static final int WRONG_OPTIONS = 2;
  private static final int GOALS_MISSED = 3;
  private static final int FLIGHTS_DIFFER = 4;

  /** Flights of the window that are kept. Decided: those of a lesson. */
  private static final int RECORDINGS_KEPT = 20;

  private final Options options = new Options();
  private final PrintStream out;
  private final PrintStream err;

  private Main(PrintStream out, PrintStream err) {
    this.out = out;
    this.err = err;
  }

  /**
   * Ends the process with 0, or 1 if something could not be had, or 2 if options or a scenario are
   * wrong, or 3 if goals were missed, or 4 after an error from which nothing goes on, or if two
   * flights that are compared differ.
   */
  public static void main(String[] args) {
    System.setProperty("java.awt.headless", "true"); // posters are read, nothing is drawn
    FatalExit fatal = FatalExit.install(LogSetup::flush);
    int status = FatalExit.CODE;
    try {
      status = run(args, System.out, System.err);
      LogSetup.flush();
    } catch (Throwable failure) {
      fatal.end(Thread.currentThread(), failure);
    }
    System.exit(status);
  }

  /** Runs the program and returns its exit code. */
  static int run(String[] args, PrintStream out, PrintStream err) {
    return new Main(out, err).run(args);
  }

  private int run(String... args) {
    Optional<Subcommand> subcommand = Subcommand.of(args);
    if (subcommand.isEmpty()) {
      return run(options.commandLine(new Version()), args, () -> start(List.of(args)));
    }
    String[] rest = Arrays.copyOfRange(args, 1, args.length);
    return switch (subcommand.get()) {
      case REPORT -> {
        ReportOptions said = new ReportOptions();
        yield run(said.commandLine(new Version()), rest, () -> report(said));
      }
      case DIFF -> {
        DiffOptions said = new DiffOptions();
        yield run(said.commandLine(new Version()), rest, () -> diff(said));
      }
      case EXPORT -> {
        ExportOptions said = new ExportOptions();
        yield run(said.commandLine(new Version()), rest, () -> export(said));
      }
    };
  }

  /** What is done once the command line is read. */
  private interface Action {
    int run() throws PortTakenException, InterruptedException;
  }

  private int run(CommandLine commandLine, String[] args, Action action) {
    try {
      ParseResult parsed = commandLine.parseArgs(args);
      if (parsed.isUsageHelpRequested()) {
        commandLine.usage(out);
        return 0;
      }
      if (parsed.isVersionHelpRequested()) {
        commandLine.printVersionHelp(out);
        return 0;
      }
      return action.run();
    } catch (UnmatchedArgumentException e) {
      err.println(
          "There is no option "
              + e.getUnmatched().get(0)
              + Spelling.meant(
                      e.getUnmatched().get(0).replaceFirst("=.*", ""),
                      commandLine.getCommandSpec().optionsMap().keySet())
                  .map(meant -> ", did you mean " + meant + "?")
                  .orElse(".")
              + " Try --help.");
      return WRONG_OPTIONS;
    } catch (ParameterException | IllegalArgumentException e) {
      err.println(
          e.getCause() instanceof ScenarioException wrong
              ? wrong.getMessage()
              : sentence(e.getMessage()) + " Try --help.");
      return WRONG_OPTIONS;
    } catch (PortTakenException e) {
      err.println(e.getMessage());
      return FAILED;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return FAILED;
    }
  }

  private int report(ReportOptions reportOptions) {
    Path file = reportOptions.output();
    try {
      RecordedFlight flight = RecordedFlight.read(reportOptions.folder());
      new FlightReport(flight, new ReportTexts(language().translation())).write(file);
      out.println("report: " + file);
      return 0;
    } catch (UnreadableRecordingException e) {
      err.println(e.getMessage());
    } catch (IOException e) {
      err.println(FlightReports.notWritten(file, e));
    }
    return FAILED;
  }

  private int export(ExportOptions exportOptions) {
    Path file = exportOptions.output();
    try {
      RecordedFlight flight = RecordedFlight.read(exportOptions.folder());
      exportOptions.format().export(exportOptions.folder(), flight, file);
      out.println("exported: " + file);
      return 0;
    } catch (UnreadableRecordingException e) {
      err.println(e.getMessage());
    } catch (IOException e) {
      err.println("The recording was not exported to " + file + ": " + IoReason.of(e) + ".");
    }
    return FAILED;
  }

  private int diff(DiffOptions diffOptions) {
    try {
      Flight first = Flight.read(diffOptions.first());
      Flight second = Flight.read(diffOptions.second());
      FlightComparison comparison = FlightComparison.of(first, second, Tolerance.DEFAULT);
      new ComparisonTable(comparison, Tolerance.DEFAULT).print(out);
      if (diffOptions.output().isPresent()) {
        Path file = diffOptions.output().get();
        new ComparisonReport(
                NamedFlight.of(diffOptions.first(), first),
                NamedFlight.of(diffOptions.second(), second),
                Tolerance.DEFAULT,
                new ReportTexts(language().translation()))
            .write(file);
        out.println("report: " + file);
      }
      return comparison.alike() ? 0 : FLIGHTS_DIFFER;
    } catch (UnreadableRecordingException e) {
      err.println(e.getMessage());
    } catch (IOException e) {
      err.println("The flights were not compared: " + IoReason.of(e) + ".");
    }
    return FAILED;
  }

  /** That of the window. */
  private static Language language() {
    Language language = new Language(Locale.getDefault());
    Settings.load(Settings.file()).bind("language", language.localeProperty(), Language.codec());
    return language;
  }

  private int start(List<String> words) throws PortTakenException, InterruptedException {
    if (options.listScenarios()) {
      ScenarioOptions.list(out);
      return 0;
    }
    LogSetup.setLevel(options.logLevel());
    return simulate(words);
  }

  private int simulate(List<String> words) throws PortTakenException, InterruptedException {
    Launch launch = options.launch();
    if (!options.headless()) {
      StandardErrorLog.install();
      Settings settings = Settings.load(Settings.file());
      WindowState state = WindowState.remembered(settings);
      state.applyUiScale();
      Optional<String> obstacle = Toolkit.start();
      if (obstacle.isEmpty()) {
        return simulateInWindow(launch, settings, state, words);
      }
      err.println(obstacle.get());
    }
    return simulateHeadless(launch, words);
  }

  private int simulateInWindow(
      Launch launch, Settings settings, WindowState state, List<String> words)
      throws InterruptedException, PortTakenException {
    SimulatorApp.Rules rules =
        new SimulatorApp.Rules(
            options::applied, options::addressPlan, options.replyPort(), recordings(words));
    try (SimulatorApp app = new SimulatorApp(launch.scenario(), rules, options.optics())) {
      Runtime.getRuntime().addShutdownHook(new Thread(app::close, "shutdown"));
      if (options.on()) {
        app.switchAllOn();
        out.println(app.ready());
      }
      return app.run(settings, state) ? 0 : FAILED;
    }
  }

  /** In the window each flight is recorded, so that one can look at it afterwards. */
  private SimulatorApp.Recordings recordings(List<String> words) {
    RecordingFolder folder =
        options
            .record()
            .map(RecordingFolder::at)
            .orElseGet(() -> RecordingFolder.keeping(DataFolder.recordings(), RECORDINGS_KEPT));
    return new SimulatorApp.Recordings(folder, options.record().isPresent(), words);
  }

  private int simulateHeadless(Launch launch, List<String> words)
      throws PortTakenException, InterruptedException {
    try (HeadlessSimulator simulator =
        new HeadlessSimulator(
            launch.scenario().scenario(),
            launch.addresses(),
            options.replyPort(),
            new SoftwareCameras(options.optics()))) {
      Optional<RecordingFolder> kept = options.record().map(RecordingFolder::at);
      Optional<FlightReports> reports =
          options.report().isPresent()
              ? Optional.of(FlightReports.to(options.report().get(), kept))
              : Optional.empty();
      Runtime.getRuntime().addShutdownHook(new Thread(() -> end(simulator, reports), "shutdown"));
      if (options.control().isPresent()) {
        simulator.openControl(options.control().get(), out);
      }
      reports
          .map(FlightReports::recordings)
          .or(() -> kept)
          .ifPresent(folder -> simulator.record(folder, launch.scenario().title(), words));
      simulator.sayReady(out);
      int status = run(simulator);
      return end(simulator, reports) || status != 0 ? status : FAILED;
    } catch (PortTakenException e) {
      throw e;
    } catch (IOException e) {
      err.println("There is no place for recordings: " + IoReason.of(e) + ".");
      return FAILED;
    }
  }

  /** Ends all, also when the program is told to end; whether all reports were written. */
  private boolean end(HeadlessSimulator simulator, Optional<FlightReports> reports) {
    simulator.close();
    return reports
        .map(
            each ->
                each.write(
                    () -> new ReportTexts(language().translation()),
                    file -> out.println("report: " + file),
                    err::println))
        .orElse(true);
  }

  /** Until it is over; the exit code of the program. */
  private int run(HeadlessSimulator simulator) throws InterruptedException {
    Charset charset = Charset.defaultCharset();
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in, charset));
    if (options.exitWhenDone()) {
      return simulator.runUntilDone(options.timeout(), in, out) == Status.REACHED
          ? 0
          : GOALS_MISSED;
    }
    simulator.run(in, out);
    return 0;
  }

  private static String sentence(String message) {
    String line = message.lines().findFirst().orElse("The options are wrong");
    String capital = Character.toUpperCase(line.charAt(0)) + line.substring(1);
    return capital.matches(".*[.?]") ? capital : capital + ".";
  }

  private static final class Version implements IVersionProvider {
    @Override
    public String[] getVersion() {
      String version =
          Optional.ofNullable(Main.class.getPackage().getImplementationVersion())
              .orElse("development");
      return new String[] {"Tello Simulator " + version};
    }
  }
}
