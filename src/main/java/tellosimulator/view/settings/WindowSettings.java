package tellosimulator.view.settings;

import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.IntegerProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.beans.property.SimpleIntegerProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.property.SimpleStringProperty;
import javafx.beans.property.StringProperty;
import tellosimulator.math.Frames;
import tellosimulator.view.FxSimulation;
import tellosimulator.view.text.Language;
import tellosimulator.world.Room;

/**
 * What the window remembers, with defaults and limits; each property is kept in the {@link
 * Settings} from its making on. For the JavaFX thread.
 */
public final class WindowSettings {

  /** The language is that of the system. */
  public static final String SYSTEM_LANGUAGE = "system";

  /** Limits of the UI scale. Decided: from netbooks to 4K screens. */
  public static final double SMALLEST_SCALE = 0.75;

  public static final double LARGEST_SCALE = 3;

  /** Limits of the grid [cm]. Decided. */
  public static final double SMALLEST_GRID_CM = 10;

  public static final double LARGEST_GRID_CM = 500;

  private static final int HIGHEST_PORT = 65535;

  /** Documented: README, an operator program on the same machine has 8889 bound. */
  private static final int COMMAND_PORT = 8879;

  /** Documented: SDK 1.3 User Guide. */
  private static final int STATE_PORT = 8890;

  private static final int VIDEO_PORT = 11111;

  private final Settings settings;
  private final ObjectProperty<Theme> theme = new SimpleObjectProperty<>(Theme.SYSTEM);
  private final StringProperty language = new SimpleStringProperty(SYSTEM_LANGUAGE);
  private final DoubleProperty uiScale = new SimpleDoubleProperty(1);
  private final BooleanProperty simulatorControls = new SimpleBooleanProperty(true);
  private final BooleanProperty networkControls = new SimpleBooleanProperty(true);
  private final BooleanProperty log = new SimpleBooleanProperty(true);
  private final BooleanProperty inset = new SimpleBooleanProperty(true);
  private final BooleanProperty trail = new SimpleBooleanProperty(true);
  private final BooleanProperty timeStamps = new SimpleBooleanProperty(true);
  private final StringProperty logLevel = new SimpleStringProperty("info");
  private final DoubleProperty gridCm = new SimpleDoubleProperty(FxSimulation.DEFAULT_GRID_CM);
  private final ObjectProperty<Room> room = new SimpleObjectProperty<>(Room.DEFAULT);
  private final IntegerProperty commandPort = new SimpleIntegerProperty(COMMAND_PORT);
  private final IntegerProperty statePort = new SimpleIntegerProperty(STATE_PORT);
  private final IntegerProperty videoPort = new SimpleIntegerProperty(VIDEO_PORT);

  public WindowSettings(Settings settings) {
    this.settings = settings;
    bindLooks();
    bindParts();
    bindSimulation();
  }

  private void bindLooks() {
    String[] choices =
        Stream.concat(
                Stream.of(SYSTEM_LANGUAGE), Language.OFFERED.stream().map(Locale::getLanguage))
            .toArray(String[]::new);
    settings.bind("theme", theme, Codec.constant(Theme.class));
    settings.bind("language", language, Codec.word(choices));
    settings.bind("ui-scale", uiScale, Codec.decimal(SMALLEST_SCALE, LARGEST_SCALE));
  }

  private void bindParts() {
    settings.bind("show.simulator-controls", simulatorControls, Codec.flag());
    settings.bind("show.network-controls", networkControls, Codec.flag());
    settings.bind("show.log", log, Codec.flag());
    settings.bind("show.inset", inset, Codec.flag());
    settings.bind("show.trail", trail, Codec.flag());
    settings.bind("log.time-stamps", timeStamps, Codec.flag());
    settings.bind("log.level", logLevel, Codec.word("error", "warn", "info", "debug"));
  }

  private void bindSimulation() {
    settings.bind("grid-cm", gridCm, Codec.decimal(SMALLEST_GRID_CM, LARGEST_GRID_CM));
    settings.bind("room", room, roomCodec());
    settings.bind("port.command", commandPort, Codec.whole(1, HIGHEST_PORT));
    settings.bind("port.state", statePort, Codec.whole(1, HIGHEST_PORT));
    settings.bind("port.video", videoPort, Codec.whole(1, HIGHEST_PORT));
  }

  /** Width, depth and height as {@code 500x500x300}, in centimetres. */
  static Codec<Room> roomCodec() {
    return new Codec<>(
        "a width, depth and height of 100 to 20000 cm such as 500x500x300",
        WindowSettings::readRoom,
        value -> cm(value.width()) + "x" + cm(value.depth()) + "x" + cm(value.height()));
  }

  private static Optional<Room> readRoom(String text) {
    if (!text.matches("\\d{1,5}x\\d{1,5}x\\d{1,5}")) {
      return Optional.empty();
    }
    String[] edges = text.split("x", -1);
    try {
      return Optional.of(new Room(metres(edges[0]), metres(edges[1]), metres(edges[2])));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  private static double metres(String cm) {
    return Frames.metres(Integer.parseInt(cm));
  }

  private static long cm(double metres) {
    return Math.round(Frames.centimetres(metres));
  }

  /** Where further properties can be kept. */
  public Settings settings() {
    return settings;
  }

  public ObjectProperty<Theme> themeProperty() {
    return theme;
  }

  /** A language code that is offered, or {@link #SYSTEM_LANGUAGE}. */
  public StringProperty languageProperty() {
    return language;
  }

  /** How large everything is, 1 for the usual size. */
  public DoubleProperty uiScaleProperty() {
    return uiScale;
  }

  public BooleanProperty simulatorControlsProperty() {
    return simulatorControls;
  }

  public BooleanProperty networkControlsProperty() {
    return networkControls;
  }

  public BooleanProperty logProperty() {
    return log;
  }

  public BooleanProperty insetProperty() {
    return inset;
  }

  public BooleanProperty trailProperty() {
    return trail;
  }

  public BooleanProperty timeStampsProperty() {
    return timeStamps;
  }

  /** {@code error}, {@code warn}, {@code info} or {@code debug}. */
  public StringProperty logLevelProperty() {
    return logLevel;
  }

  public DoubleProperty gridCmProperty() {
    return gridCm;
  }

  public ObjectProperty<Room> roomProperty() {
    return room;
  }

  public IntegerProperty commandPortProperty() {
    return commandPort;
  }

  public IntegerProperty statePortProperty() {
    return statePort;
  }

  public IntegerProperty videoPortProperty() {
    return videoPort;
  }
}
