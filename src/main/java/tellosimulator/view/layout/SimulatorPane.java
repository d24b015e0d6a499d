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
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.layout.WindowState.Flag;

/**
 * The frame of the window, with simulator controls at the left, network controls at the right, the
 * log below, and the 3D scene in the middle. In full screen, the scene fills the window, and the
 * other parts lie over it. The parts at the sides then have their preferred height. Confined to the
 * JavaFX thread.
 */
public final class SimulatorPane extends BorderPane {

  /** Gap between the floating parts, and between them and the scene's edge [px]. */
  private static final double FLOATING_GAP = 10;

  /** Minimum height of the scene [px]. It limits the height of the log. */
  private static final double LEAST_SCENE_HEIGHT = 200;

  /** The parts of the window by their position. */
  public record Parts(
      Region bar, Middle middle, Region simulatorControls, Region networkControls, Region log) {}

  /**
   * The parts in the middle.
   *
   * @param aside a part over the scene, in its upper left corner
   * @param notice a part over the scene, above {@code pilot}
   * @param pilot the flight controls, over the scene at its lower edge
   * @param plan the plan editor, which covers all other parts while it is visible
   */
  public record Middle(Region scene, Region aside, Region notice, Region pilot, Region plan) {}

  private final Parts parts;
  private final WindowState state;
  private final StackPane middle = new StackPane();
  private final BorderPane overlay = Nodes.styled(new BorderPane(), "overlay");

  /** The area of the scene that only floating parts cover. */
  private final StackPane free = new StackPane();

  private final Region logHandle = Nodes.named(new Region(), "log-handle", "log-handle");
  private final VBox bottom = Nodes.styled(new VBox(), "panel");

  public SimulatorPane(Parts parts, WindowState state) {
    this.parts = parts;
    this.state = state;
    setId("simulator-pane");
    getStylesheets().add(SimulatorPane.class.getResource("layout.css").toExternalForm());
    overlay.setPickOnBounds(false);
    middle.setMinSize(0, 0);
    layoutParts();
    setupEventHandlers();
    setupBindings();
  }

  private void layoutParts() {
    logHandle.setCursor(Cursor.V_RESIZE);
    parts.log().setMinHeight(0);
    VBox.setVgrow(parts.log(), Priority.ALWAYS);
    bottom.getChildren().setAll(logHandle, parts.log());
    for (Node side : new Node[] {parts.simulatorControls(), parts.networkControls()}) {
      side.getStyleClass().add("panel");
      BorderPane.setAlignment(side, Pos.TOP_CENTER);
    }
    layoutFree();
    overlay.setCenter(free);
    middle.getChildren().setAll(parts.middle().scene(), overlay);
    setCenter(middle);
    arrange(state.flag(Flag.FULL_SCREEN).get());
  }

  /** Lays out the parts that float over the scene. */
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
        .bind(parts.middle().plan().visibleProperty().not().and(state.flag(Flag.PROJECTOR).not()));
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
    state.flag(Flag.FULL_SCREEN).subscribe(this::arrange);
    BooleanBinding usual = state.flag(Flag.PROJECTOR).not();
    Nodes.showIf(parts.bar(), usual);
    Nodes.showIf(parts.simulatorControls(), state.flag(Flag.SIMULATOR_CONTROLS).and(usual));
    Nodes.showIf(parts.networkControls(), state.flag(Flag.NETWORK_CONTROLS).and(usual));
    Nodes.showIf(bottom, usual);
    Nodes.showIf(logHandle, state.flag(Flag.LOG));
    bottom
        .prefHeightProperty()
        .bind(
            Bindings.when(state.flag(Flag.LOG))
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

  /** Returns the height that the bar and the log leave for the parts at the sides [px]. */
  public DoubleBinding sideHeight() {
    return Bindings.createDoubleBinding(
        () -> getHeight() - parts.bar().getHeight() - (bottom.isVisible() ? bottom.getHeight() : 0),
        heightProperty(),
        parts.bar().heightProperty(),
        bottom.visibleProperty(),
        bottom.heightProperty());
  }

  /** Width of the area of the scene that only floating parts cover [px]. */
  public ReadOnlyDoubleProperty freeWidthProperty() {
    return free.widthProperty();
  }

  /** Returns how much of the scene the other parts cover at each edge in full screen [px]. */
  private Insets covered() {
    double right = overlay.getWidth() - free.getLayoutX() - free.getWidth();
    double bottom = overlay.getHeight() - free.getLayoutY() - free.getHeight();
    return new Insets(
        Math.max(0, free.getLayoutY()),
        Math.max(0, right),
        Math.max(0, bottom),
        Math.max(0, free.getLayoutX()));
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
