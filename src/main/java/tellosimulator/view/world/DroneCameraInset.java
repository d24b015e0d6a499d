package tellosimulator.view.world;

import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.css.PseudoClass;
import javafx.geometry.Pos;
import javafx.geometry.Rectangle2D;
import javafx.scene.Node;
import javafx.scene.PerspectiveCamera;
import javafx.scene.SnapshotParameters;
import javafx.scene.control.Button;
import javafx.scene.control.Tooltip;
import javafx.scene.image.ImageView;
import javafx.scene.image.WritableImage;
import javafx.scene.layout.HBox;
import javafx.scene.layout.StackPane;
import javafx.scene.paint.Color;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.text.Messages;

/**
 * The picture of the drone's camera in a corner over the scene. Hidden, it is one small button and
 * costs nothing. For the JavaFX thread.
 */
final class DroneCameraInset extends StackPane {

  /** Size of the picture that is taken [pixels]. Decided: small enough without a graphics card. */
  static final int TAKEN_WIDTH = 320;

  static final int TAKEN_HEIGHT = 240;

  private static final PseudoClass SHOWN = PseudoClass.getPseudoClass("shown");

  /** Width of what is shown [pixels]. Decided. */
  private static final double SMALL = 240;

  private static final double LARGE = 400;

  private final Messages messages;
  private final BooleanProperty shown = new SimpleBooleanProperty(this, "shown");
  private final BooleanProperty enlarged = new SimpleBooleanProperty(this, "enlarged");
  private final PictureBudget budget = new PictureBudget();
  private final SnapshotParameters parameters = new SnapshotParameters();
  private final ImageView picture = new ImageView();
  private final Button toggle = button("inset-toggle");
  private final Button enlarge = button("inset-enlarge");
  private final HBox buttons = new HBox(enlarge, toggle);
  private WritableImage taken;

  DroneCameraInset(Messages messages) {
    this.messages = messages;
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
   * Takes a new picture if it is shown and it is time.
   *
   * @param nanos the time of the frame [ns]
   */
  void advance(long nanos, ScenePicture scene) {
    if (shown.get() && budget.allows(nanos)) {
      long begun = System.nanoTime();
      scene.photograph(this::take);
      budget.taken(nanos, System.nanoTime() - begun);
    }
  }

  private void take(Node room, PerspectiveCamera camera) {
    parameters.setCamera(camera);
    parameters.setDepthBuffer(true); // not before: where there is no 3D, JavaFX warns of it
    taken = room.snapshot(parameters, taken);
    picture.setImage(taken);
  }

  private void initializeSelf() {
    setId("inset");
    getStyleClass().add("drone-camera-inset");
    setPickOnBounds(false);
    setMaxSize(USE_PREF_SIZE, USE_PREF_SIZE);
  }

  private void initializeParts() {
    parameters.setFill(Color.BLACK);
    parameters.setViewport(new Rectangle2D(0, 0, TAKEN_WIDTH, TAKEN_HEIGHT));
    picture.setId("inset-picture");
    picture.setPreserveRatio(true);
    buttons.getStyleClass().add("buttons");
    buttons.setMaxSize(USE_PREF_SIZE, USE_PREF_SIZE);
    buttons.setPickOnBounds(false);
  }

  private void layoutParts() {
    StackPane.setAlignment(buttons, Pos.TOP_RIGHT);
    getChildren().addAll(picture, buttons);
  }

  private void setupEventHandlers() {
    toggle.setOnAction(action -> shown.set(!shown.get()));
    enlarge.setOnAction(action -> enlarged.set(!enlarged.get()));
  }

  private void setupBindings() {
    picture.visibleProperty().bind(shown);
    picture.managedProperty().bind(shown);
    picture.fitWidthProperty().bind(enlarged.map(large -> large ? LARGE : SMALL));
    enlarge.visibleProperty().bind(shown);
    enlarge.managedProperty().bind(shown);
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

  private void describe(Button button, Feather icon, String key) {
    button.setGraphic(new FontIcon(icon));
    button.getTooltip().textProperty().bind(messages.text(key));
    button.accessibleTextProperty().bind(messages.text(key));
  }

  private static Button button(String id) {
    Button button = new Button();
    button.setId(id);
    button.setFocusTraversable(false);
    button.setTooltip(new Tooltip());
    return button;
  }
}
