package tellosimulator.view.world;

import java.util.List;
import java.util.Locale;
import javafx.beans.binding.Bindings;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.value.ObservableValue;
import javafx.css.PseudoClass;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.StackPane;
import javafx.scene.shape.Circle;
import javafx.util.Duration;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.video.VideoFigures;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SceneContext;
import tellosimulator.view.text.Messages;
import tellosimulator.view.video.VideoCapture;
import tellosimulator.view.video.VideoView;
import tellosimulator.view.video.WindowVideo;

/**
 * The selected drone's video in a corner of the scene. The encoder receives the same pictures. The
 * tooltip shows the stream's frame rate, bit rate and processing times. A hidden inset is only a
 * small button, and takes no processor time. Confined to the JavaFX thread.
 */
final class DroneCameraInset extends StackPane {

  private static final PseudoClass RECORDING = PseudoClass.getPseudoClass("recording");
  private static final PseudoClass SHOWN = PseudoClass.getPseudoClass("shown");

  /**
   * Normal width [px]; when enlarged, {@link #LARGE}. Decided: both are less than 480, half the
   * width of a picture, so that pictures can be converted at half their resolution on an unscaled
   * screen.
   */
  private static final double SMALL = 240;

  private static final double LARGE = 400;

  /** Height of a picture divided by its width. Measured: pictures are 960 by 720 pixels. */
  private static final double FORM = 0.75;

  /**
   * Time between two updates of the figures [ns]. Decided: four updates a second, so that the
   * figures can be read.
   */
  private static final long PERIOD_NANOS = 250_000_000;

  private static final Duration TOOLTIP_DELAY = Duration.millis(400);

  private static final double MEGABIT = 1e6;

  private final Messages messages;
  private final FxSimulation simulation;
  private final WindowVideo video;
  private final BooleanProperty shown = new SimpleBooleanProperty(this, "shown");
  private final BooleanProperty enlarged = new SimpleBooleanProperty(this, "enlarged");
  private final VideoView picture = new VideoView();
  private final StackPane frame = new StackPane(picture);
  private final Tooltip figures = new Tooltip();
  private final Label live = new Label();
  private final Button toggle = button("inset-toggle");
  private final Button enlarge = button("inset-enlarge");
  private final Button still = button("inset-still");
  private final Button record = button("inset-record");
  private final HBox buttons = new HBox(still, record, enlarge, toggle);
  private long describedNanos = Long.MIN_VALUE;

  DroneCameraInset(SceneContext context) {
    messages = context.language().messages(DroneCameraInset.class);
    simulation = context.simulation();
    video = context.video();
    initializeSelf();
    initializeParts();
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  BooleanProperty shownProperty() {
    return shown;
  }

  BooleanProperty enlargedProperty() {
    return enlarged;
  }

  /**
   * Shows the newest picture.
   *
   * @param nanos the time of the frame [ns]
   */
  void advance(long nanos) {
    if (!watched()) {
      return;
    }
    picture.advance();
    if (describedNanos == Long.MIN_VALUE || nanos - describedNanos >= PERIOD_NANOS) {
      describedNanos = nanos;
      figures.setText(described(picture.figuresProperty().get()));
    }
  }

  /** Stops showing pictures. */
  void rest() {
    picture.rest();
  }

  private void initializeSelf() {
    setId("inset");
    getStyleClass().add("drone-camera-inset");
    setPickOnBounds(false);
    setMaxSize(USE_PREF_SIZE, USE_PREF_SIZE);
  }

  private void initializeParts() {
    picture.setId("inset-picture");
    frame.setId("inset-frame");
    figures.setShowDelay(TOOLTIP_DELAY);
    figures.setShowDuration(Duration.INDEFINITE);
    Tooltip.install(frame, figures);
    live.setId("inset-live");
    live.getStyleClass().add("live");
    Circle dot = new Circle(3.5);
    dot.getStyleClass().add("dot");
    live.setGraphic(dot);
    live.setMouseTransparent(true);
    buttons.getStyleClass().add("buttons");
    buttons.setMaxSize(USE_PREF_SIZE, USE_PREF_SIZE);
    buttons.setPickOnBounds(false);
  }

  private void layoutParts() {
    StackPane.setAlignment(buttons, Pos.TOP_RIGHT);
    StackPane.setAlignment(live, Pos.TOP_LEFT);
    getChildren().addAll(frame, live, buttons);
  }

  private void setupEventHandlers() {
    toggle.setOnAction(action -> shown.set(!shown.get()));
    enlarge.setOnAction(action -> enlarged.set(!enlarged.get()));
    still.setOnAction(action -> capture().saveStill());
    record.setOnAction(action -> capture().toggleRecording());
    shown.addListener((property, before, now) -> watch());
    visibleProperty().addListener((property, before, now) -> watch());
    simulation.selectedProperty().addListener((property, before, now) -> watch());
  }

  private VideoCapture capture() {
    return video.capture(simulation.selected().number());
  }

  /** Returns whether the picture is visible. */
  private boolean watched() {
    return shown.get() && isVisible();
  }

  private void watch() {
    if (watched()) {
      picture.watch(video.stream(simulation.selected().number()));
    } else {
      picture.rest();
    }
  }

  private void setupBindings() {
    frame.visibleProperty().bind(shown);
    frame.managedProperty().bind(shown);
    enlarged.subscribe(large -> setPictureWidth(large ? LARGE : SMALL));
    ObservableValue<Boolean> filming =
        simulation.selectedProperty().flatMap(FxDroneModel::filmingProperty);
    live.textProperty().bind(messages.text("inset.live"));
    live.visibleProperty()
        .bind(
            Bindings.createBooleanBinding(() -> shown.get() && filming.getValue(), shown, filming));
    for (Button button : List.of(still, enlarge)) {
      button.visibleProperty().bind(shown);
      button.managedProperty().bind(shown);
    }
    describe(still, Feather.CAMERA, "inset.still");
    bindRecord(simulation.selectedProperty().map(drone -> video.capture(drone.number())));
    shown.subscribe(
        now -> {
          describe(toggle, now ? Feather.X : Feather.VIDEO, now ? "inset.hide" : "inset.show");
          pseudoClassStateChanged(SHOWN, now);
        });
    enlarged.subscribe(
        now ->
            describe(
                enlarge,
                now ? Feather.MINIMIZE_2 : Feather.MAXIMIZE_2,
                now ? "inset.reduce" : "inset.enlarge"));
  }

  /** Keeps the record button visible during a recording, even if the inset is hidden. */
  private void bindRecord(ObservableValue<VideoCapture> keeper) {
    ObservableValue<Boolean> recording = keeper.flatMap(VideoCapture::recordingProperty);
    ObservableValue<Number> seconds = keeper.flatMap(VideoCapture::secondsProperty);
    recording.subscribe(
        now -> {
          describe(
              record,
              now ? Feather.STOP_CIRCLE : Feather.CIRCLE,
              now ? "inset.recording" : "inset.record");
          record.pseudoClassStateChanged(RECORDING, now);
        });
    record
        .textProperty()
        .bind(
            Bindings.createStringBinding(
                () -> recording.getValue() ? minutes(seconds.getValue().intValue()) : "",
                recording,
                seconds));
    record
        .visibleProperty()
        .bind(
            Bindings.createBooleanBinding(
                () -> shown.get() || recording.getValue(), shown, recording));
    record.managedProperty().bind(record.visibleProperty());
    record
        .disableProperty()
        .bind(simulation.selectedProperty().flatMap(FxDroneModel::onProperty).map(on -> !on));
  }

  private static String minutes(int seconds) {
    return String.format(Locale.ROOT, "%d:%02d", seconds / 60, seconds % 60);
  }

  private void setPictureWidth(double width) {
    frame.setPrefSize(width, width * FORM);
    picture.setFitWidth(width);
    picture.setFitHeight(width * FORM);
  }

  private String described(VideoFigures now) {
    return now.bitsPerSecond() > 0
        ? messages.now(
            "inset.figures",
            now.framesPerSecond(),
            now.bitsPerSecond() / MEGABIT,
            now.filmMs(),
            now.encodeMs())
        : messages.now("inset.preview", now.framesPerSecond(), now.filmMs());
  }

  private void describe(Button button, Feather icon, String key) {
    button.setGraphic(new FontIcon(icon));
    button.getTooltip().textProperty().bind(messages.text(key));
    button.accessibleTextProperty().bind(messages.text(key));
  }

  private static Button button(String id) {
    Button button = new Button();
    button.setId(id);
    button.setTooltip(new Tooltip());
    return button;
  }
}
