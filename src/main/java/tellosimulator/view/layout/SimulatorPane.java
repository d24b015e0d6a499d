package tellosimulator.view.layout;

import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.beans.binding.DoubleBinding;
import javafx.beans.property.ReadOnlyDoubleProperty;
import javafx.geometry.Insets;
import javafx.geometry.Pos;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;

/**
 * The frame of the window: simulator controls at the left, network controls at the right, log
 * below, the 3D scene in the middle. In full-screen the scene fills everything and the other parts
 * lie over it, those at the sides no higher than they need.
 */
public final class SimulatorPane extends BorderPane {

  /** Between what lies over the scene and the scene's edge [px]. */
  private static final double FLOATING_GAP = 10;

  /** What the log always leaves to the scene [px]. */
  private static final double LEAST_SCENE_HEIGHT = 200;

  /** The parts of the window, by their places. */
  public record Parts(
      Region bar, Middle middle, Region simulatorControls, Region networkControls, Region log) {}

  /**
   * What is in the middle.
   *
   * @param aside lies over the scene, in its upper left corner
   * @param notice lies over the scene, above {@code pilot}
   * @param pilot flies the drone; lies over the scene, at its lower edge
   * @param plan lies over all of them while it is visible
   */
  public record Middle(Region scene, Region aside, Region notice, Region pilot, Region plan) {}

  private final Parts parts;
  private final WindowState state;
  private final StackPane middle = new StackPane();
  private final BorderPane overlay = new BorderPane();

  /** Where nothing lies over the scene but what floats there. */
  private final StackPane free = new StackPane();

  private final Region logHandle = new Region();
  private final VBox bottom = new VBox();

  public SimulatorPane(Parts parts, WindowState state) {
    this.parts = parts;
    this.state = state;
    initializeSelf();
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  private void initializeSelf() {
    setId("simulator-pane");
    getStylesheets().add(SimulatorPane.class.getResource("layout.css").toExternalForm());
    overlay.getStyleClass().add("overlay");
    overlay.setPickOnBounds(false);
    middle.setMinSize(0, 0);
  }

  private void layoutParts() {
    logHandle.setId("log-handle");
    logHandle.getStyleClass().add("log-handle");
    logHandle.setCursor(Cursor.V_RESIZE);
    parts.log().setMinHeight(0);
    VBox.setVgrow(parts.log(), Priority.ALWAYS);
    bottom.getChildren().setAll(logHandle, parts.log());
    bottom.getStyleClass().add("panel");
    for (Node side : new Node[] {parts.simulatorControls(), parts.networkControls()}) {
      side.getStyleClass().add("panel");
      BorderPane.setAlignment(side, Pos.TOP_CENTER);
    }
    layoutFree();
    overlay.setCenter(free);
    middle.getChildren().setAll(parts.middle().scene(), overlay);
    setCenter(middle);
    arrange(state.fullScreenProperty().get());
  }

  /** What lies over the scene and moves aside for nothing. */
  private void layoutFree() {
    Region aside = parts.middle().aside();
    Region pilot = parts.middle().pilot();
    VBox lower = new VBox(FLOATING_GAP, parts.middle().notice(), pilot);
    lower.setAlignment(Pos.CENTER);
    lower.setMaxHeight(USE_PREF_SIZE);
    lower.setPickOnBounds(false);
    StackPane floating = new StackPane(lower, aside);
    floating.setPickOnBounds(false);
    floating.setMinSize(0, 0);
    floating.setPadding(new Insets(FLOATING_GAP));
    StackPane.setAlignment(aside, Pos.TOP_LEFT);
    StackPane.setAlignment(lower, Pos.BOTTOM_CENTER);
    aside.setMaxWidth(USE_PREF_SIZE);
    aside.setPickOnBounds(false);
    parts.middle().notice().setMaxWidth(USE_PREF_SIZE);
    pilot.setMaxSize(USE_PREF_SIZE, USE_PREF_SIZE);
    pilot.getStyleClass().add("floating");
    free.getChildren().setAll(floating, parts.middle().plan());
    free.setPickOnBounds(false);
    free.setMinSize(0, 0);
    floating
        .visibleProperty()
        .bind(parts.middle().plan().visibleProperty().not().and(state.projectorProperty().not()));
  }

  private void setupEventHandlers() {
    logHandle.addEventHandler(MouseEvent.MOUSE_DRAGGED, this::resizeLog);
    logHandle.setOnMouseClicked(
        click -> {
          if (click.getClickCount() == 2) {
            state.logHeightProperty().set(WindowState.LOG_HEIGHT);
          }
        });
  }

  private void setupBindings() {
    state.fullScreenProperty().subscribe(this::arrange);
    BooleanBinding usual = state.projectorProperty().not();
    show(parts.bar(), usual);
    show(parts.simulatorControls(), state.simulatorControlsShownProperty().and(usual));
    show(parts.networkControls(), state.networkControlsShownProperty().and(usual));
    show(bottom, usual);
    logHandle.visibleProperty().bind(state.logOpenProperty());
    logHandle.managedProperty().bind(logHandle.visibleProperty());
    bottom
        .prefHeightProperty()
        .bind(
            Bindings.when(state.logOpenProperty())
                .then(state.logHeightProperty())
                .otherwise(USE_COMPUTED_SIZE));
    parts
        .middle()
        .scene()
        .paddingProperty()
        .bind(
            Bindings.createObjectBinding(
                this::covered,
                free.layoutXProperty(),
                free.layoutYProperty(),
                free.widthProperty(),
                free.heightProperty(),
                overlay.widthProperty(),
                overlay.heightProperty()));
  }

  /** What bar and log leave to the parts at the sides [px]. */
  public DoubleBinding sideHeight() {
    return Bindings.createDoubleBinding(
        () -> getHeight() - parts.bar().getHeight() - (bottom.isVisible() ? bottom.getHeight() : 0),
        heightProperty(),
        parts.bar().heightProperty(),
        bottom.visibleProperty(),
        bottom.heightProperty());
  }

  /** Width of the scene where nothing but what floats there lies over it [px]. */
  public ReadOnlyDoubleProperty freeWidthProperty() {
    return free.widthProperty();
  }

  /** What the other parts cover of the scene at each side, which fills everything below them. */
  private Insets covered() {
    double right = overlay.getWidth() - free.getLayoutX() - free.getWidth();
    double bottom = overlay.getHeight() - free.getLayoutY() - free.getHeight();
    return new Insets(
        Math.max(0, free.getLayoutY()),
        Math.max(0, right),
        Math.max(0, bottom),
        Math.max(0, free.getLayoutX()));
  }

  private static void show(Node part, BooleanBinding shown) {
    part.visibleProperty().bind(shown);
    part.managedProperty().bind(shown);
  }

  private void resizeLog(MouseEvent drag) {
    double wanted = sceneToLocal(drag.getSceneX(), drag.getSceneY()).getY();
    double most = Math.max(WindowState.LEAST_LOG_HEIGHT, getHeight() - LEAST_SCENE_HEIGHT);
    double height = Math.max(WindowState.LEAST_LOG_HEIGHT, Math.min(most, getHeight() - wanted));
    state.logHeightProperty().set(height);
  }

  private void arrange(boolean over) {
    double sideHeight = over ? USE_PREF_SIZE : Double.MAX_VALUE;
    BorderPane emptied = over ? this : overlay;
    emptied.setTop(null);
    emptied.setLeft(null);
    emptied.setRight(null);
    emptied.setBottom(null);
    BorderPane filled = over ? overlay : this;
    parts.simulatorControls().setMaxHeight(sideHeight);
    parts.networkControls().setMaxHeight(sideHeight);
    filled.setTop(parts.bar());
    filled.setLeft(parts.simulatorControls());
    filled.setRight(parts.networkControls());
    filled.setBottom(bottom);
  }
}
