package tellosimulator.view.plan;

import atlantafx.base.theme.Styles;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.IntFunction;
import javafx.beans.binding.Bindings;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.value.ObservableValue;
import javafx.css.PseudoClass;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.paint.Color;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.goal.PlacedGoal;
import tellosimulator.goal.Progress;
import tellosimulator.math.Vec3;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * The plan editor: a palette, a plan of the room, and a status line about the selection. Users
 * place drones, mission pads and obstacles with the mouse. Confined to the JavaFX thread.
 */
public final class PlanPane extends BorderPane {

  private static final PseudoClass WRONG = PseudoClass.getPseudoClass("wrong");

  private final ObservableValue<Boolean> never = new SimpleBooleanProperty();
  private final BooleanProperty shown = new SimpleBooleanProperty(this, "shown");
  private final ViewContext context;
  private final Language language;
  private final Messages messages;
  private final PlanEditor editor;
  private final PlanAdditions additions;
  private final PlanView view;
  private final PlanItemText text;
  private final PlanProperties properties;
  private final BooleanProperty measuring = new SimpleBooleanProperty(this, "measuring");
  private final FlowPane palette = new FlowPane();
  private final HBox tools = new HBox();
  private final Label legend;
  private final Label status = new Label();

  public PlanPane(ViewContext context) {
    this.context = context;
    language = context.language();
    messages = language.messages(PlanPane.class);
    editor = new PlanEditor(context.simulation(), context.actions(), context.scenario());
    additions = new PlanAdditions(editor);
    IntFunction<Color> colors =
        drone -> DroneColors.of(context.simulation().drones().get(drone - 1));
    view = new PlanView(editor, colors, language::say);
    text = new PlanItemText(language, messages);
    properties = new PlanProperties(editor, language, colors);
    legend = messages.label("legend", "legend");
    initializeSelf();
    initializeParts();
    setupBindings();
    Runnable edit = properties::edit;
    PlanGestures.install(
        editor, view, new PlanGestures.Actions(() -> shown.set(false), edit, measuring));
    PlanMenu.install(editor, view, messages, edit);
    context.ticker().onTick(nanos -> advance());
  }

  /** Whether the plan is shown. */
  public BooleanProperty shownProperty() {
    return shown;
  }

  private void initializeSelf() {
    setId("plan-pane");
    getStyleClass().add("plan-pane");
    getStylesheets().add(PlanPane.class.getResource("plan.css").toExternalForm());
    setMinSize(0, 0);
    setVisible(false);
  }

  private void initializeParts() {
    view.accessibleTextProperty().bind(messages.text("accessible"));
    view.accessibleHelpProperty().bind(messages.text("how-to"));
    Region circle = new Region();
    circle.getStyleClass().add("circle");
    legend.setId("plan-legend");
    legend.setGraphic(circle);
    legend.setMouseTransparent(true);
    status.setId("plan-status");
    status.getStyleClass().add("plan-status");
    status.setMaxWidth(Double.MAX_VALUE);
    MenuButton goals = palette(new MenuButton(), "add-goal", () -> {});
    for (PaletteItem kind : PaletteItem.values()) {
      if (kind == PaletteItem.REACH) { // the menu with all goals takes the place of the first goal
        palette.getChildren().add(goals);
      }
      if (kind.goal()) {
        goals.getItems().add(goal(kind));
      } else {
        String id = "add-" + kind.word();
        Button button = palette(new Button(), id, () -> additions.add(kind, middle()));
        button.disableProperty().bind(missing(kind));
        palette.getChildren().add(button);
      }
    }
    ObservableValue<List<PlanItem>> selected = editor.selectionProperty();
    tools
        .getChildren()
        .addAll(
            tool("undo", Feather.CORNER_UP_LEFT, editor::undo, editor.undoableProperty().not()),
            tool("redo", Feather.CORNER_UP_RIGHT, editor::redo, editor.redoableProperty().not()),
            tool("duplicate", Feather.COPY, additions::duplicate, selected.map(List::isEmpty)),
            tool(
                "remove",
                Feather.TRASH_2,
                editor::remove,
                selected.map(now -> !editor.removable())),
            ruler(),
            tool("whole", Feather.MAXIMIZE_2, view::showWhole, never),
            tool("leave", Feather.X, () -> shown.set(false), never));
  }

  /**
   * Lays out the parts. Called when the plan is shown for the first time. Measured: a quarter of
   * the window's nodes belong to the plan; if they were styled when the window opens, opening would
   * take a quarter longer.
   */
  private void layoutParts() {
    palette.getStyleClass().add("palette");
    tools.getStyleClass().add("tools");
    tools.setMinWidth(USE_PREF_SIZE);
    HBox top = new HBox(palette, tools);
    top.getStyleClass().add("plan-top");
    HBox.setHgrow(palette, Priority.ALWAYS);
    setTop(top);
    setCenter(new StackPane(view, legend));
    StackPane.setAlignment(legend, Pos.TOP_RIGHT);
    setRight(properties);
    setBottom(status);
  }

  private void setupBindings() {
    visibleProperty().bind(shown);
    shown.addListener(
        (property, before, now) -> {
          if (now) {
            if (getCenter() == null) {
              layoutParts();
            }
            advance();
            view.requestFocus();
          }
        });
    status
        .textProperty()
        .bind(
            Bindings.createStringBinding(
                this::sentence,
                editor.planProperty(),
                editor.selectionProperty(),
                editor.problemProperty(),
                language.localeProperty()));
    editor
        .problemProperty()
        .subscribe(problem -> status.pseudoClassStateChanged(WRONG, problem.isPresent()));
  }

  private void advance() {
    if (shown.get()) {
      editor.advance();
      view.advance(
          new PlanPainter.Remarks(
              goalMarks(), context.marks().contacts(), chosen(), messages.now("front")));
    }
  }

  private OptionalInt chosen() {
    return context.simulation().drones().size() > 1
        ? OptionalInt.of(context.simulation().selected().number())
        : OptionalInt.empty();
  }

  /**
   * Returns the goals of the plan as drawn. During a drag, the drawn goals move with the mouse; the
   * challenge changes only when the mouse is released.
   */
  private List<PlacedGoal> goalMarks() {
    FloorPlan plan = editor.plan();
    Progress now = context.scenario().progressProperty().get();
    boolean asked = now.challenge().equals(plan.challenge());
    return PlacedGoal.of(asked ? now : Progress.start(plan.challenge()), plan.arena());
  }

  /** Returns the state to pass to the plan of a new window. */
  public PlanEditorState memory() {
    return new PlanEditorState(editor.history(), editor.selection(), view.part());
  }

  /** Restores the state of another plan. */
  public void goOn(PlanEditorState memory) {
    editor.goOn(memory.history(), memory.selection());
    memory.part().ifPresent(view::show);
    view.requestFocus();
  }

  private String sentence() {
    if (editor.problemProperty().get().isPresent()) {
      String problem = editor.problemProperty().get().get().name();
      return messages.now("problem-" + problem.toLowerCase(Locale.ROOT).replace('_', '-'));
    }
    if (editor.selection().size() > 1) {
      return messages.now("several", editor.selection().size());
    }
    return editor
        .selected()
        .filter(editor.plan()::has)
        .map(item -> text.of(editor.plan(), item))
        .orElseGet(() -> messages.now("how-to"));
  }

  /** Returns the place in the middle of the view, where new items are added. */
  private Vec3 middle() {
    return view.scale().place(view.getWidth() / 2, view.getHeight() / 2);
  }

  private MenuItem goal(PaletteItem kind) {
    MenuItem item = new MenuItem();
    item.setId("plan-add-" + kind.word());
    item.textProperty().bind(messages.text("add-" + kind.word()));
    item.setOnAction(
        chosen -> {
          additions.add(kind, middle());
          view.requestFocus();
        });
    item.disableProperty().bind(missing(kind));
    return item;
  }

  /** Returns whether items of a kind cannot be added at present. */
  private ObservableValue<Boolean> missing(PaletteItem kind) {
    return editor.planProperty().map(now -> kind.adding(now, Optional.empty()).isEmpty());
  }

  private <B extends ButtonBase> B palette(B button, String id, Runnable action) {
    button.setGraphic(new FontIcon(Feather.PLUS));
    button.textProperty().bind(messages.text(id));
    button.getStyleClass().add(Styles.SMALL);
    return prepared(button, id, action);
  }

  private Button tool(String id, Ikon icon, Runnable action, ObservableValue<Boolean> off) {
    Button button = new Button("", new FontIcon(icon));
    button.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT, Styles.SMALL);
    button.disableProperty().bind(off);
    return prepared(button, id, action);
  }

  private ToggleButton ruler() {
    ToggleButton button = new ToggleButton("", new FontIcon(Feather.CROSSHAIR));
    button.getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT, Styles.SMALL);
    button.selectedProperty().bindBidirectional(measuring);
    return prepared(button, "ruler", () -> {});
  }

  private <B extends ButtonBase> B prepared(B button, String id, Runnable action) {
    button.setId("plan-" + id);
    Tooltips.install(button, messages.text(id + "-tip"));
    button.accessibleTextProperty().bind(messages.text(id + "-tip"));
    button.setOnAction(
        pressed -> {
          action.run();
          view.requestFocus();
        });
    return button;
  }
}
