package tellosimulator.view.plan;

import atlantafx.base.controls.Spacer;
import atlantafx.base.theme.Styles;
import java.util.Locale;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.value.ObservableValue;
import javafx.css.PseudoClass;
import javafx.geometry.Orientation;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.Label;
import javafx.scene.control.Separator;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.ToolBar;
import javafx.scene.layout.BorderPane;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.math.Vec3;
import tellosimulator.view.drone.DroneColors;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;
import tellosimulator.world.Arena;

/**
 * The room from above, in which one places drones, mission pads and obstacles with the mouse: a
 * palette, the plan, and a line that says what is chosen. For the JavaFX thread.
 */
public final class PlanPane extends BorderPane {

  private static final PseudoClass WRONG = PseudoClass.getPseudoClass("wrong");

  private final ObservableValue<Boolean> never = new SimpleBooleanProperty();
  private final BooleanProperty shown = new SimpleBooleanProperty(this, "shown");
  private final ViewContext context;
  private final Language language;
  private final Messages messages;
  private final PlanEditor editor;
  private final PlanView view;
  private final PlanItemText text;
  private final PlanProperties properties;
  private final BooleanProperty measuring = new SimpleBooleanProperty(this, "measuring");
  private final ToolBar bar = new ToolBar();
  private final Label status = new Label();

  public PlanPane(ViewContext context) {
    this.context = context;
    language = context.language();
    messages = language.messages(PlanPane.class);
    editor =
        new PlanEditor(
            context.simulation(),
            context.actions(),
            context.scenario().scenario().challenge().goals());
    view =
        new PlanView(
            editor,
            drone -> DroneColors.of(context.simulation().drones().get(drone - 1)),
            messages.text("front"));
    text = new PlanItemText(language, messages);
    properties = new PlanProperties(editor, language);
    initializeSelf();
    initializeParts();
    layoutParts();
    setupBindings();
    Runnable edit = properties::edit;
    PlanGestures.install(
        editor, view, new PlanGestures.Actions(() -> shown.set(false), edit, measuring));
    PlanMenu.install(editor, view, messages, edit);
    context.pulse().onBeat(nanos -> advance());
  }

  /** Whether it is there. */
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
    status.setId("plan-status");
    status.getStyleClass().add("plan-status");
    status.setMaxWidth(Double.MAX_VALUE);
    for (PaletteItem kind : PaletteItem.values()) {
      bar.getItems().add(palette("add-" + kind.word(), () -> editor.add(kind, middle())));
    }
    Button pad = palette("add-pad", () -> editor.addPad(middle()));
    pad.disableProperty().bind(editor.planProperty().map(now -> now.freePadIds().isEmpty()));
    bar.getItems()
        .addAll(
            pad,
            new Separator(Orientation.VERTICAL),
            tool("undo", Feather.CORNER_UP_LEFT, editor::undo, editor.undoableProperty().not()),
            tool("redo", Feather.CORNER_UP_RIGHT, editor::redo, editor.redoableProperty().not()),
            tool("duplicate", Feather.COPY, editor::duplicate, nothingToRemove()),
            tool("remove", Feather.TRASH_2, editor::remove, nothingToRemove()),
            ruler(),
            tool("whole", Feather.MAXIMIZE_2, view::showWhole, never),
            new Spacer(),
            tool("leave", Feather.X, () -> shown.set(false), never));
  }

  private void layoutParts() {
    setTop(bar);
    setCenter(view);
    setRight(properties);
    setBottom(status);
  }

  private void setupBindings() {
    visibleProperty().bind(shown);
    shown.addListener(
        (property, before, now) -> {
          if (now) {
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
      Arena arena = context.simulation().snapshot().arena();
      view.advance(context.marks().goals(arena), context.marks().contacts());
    }
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

  private BooleanBinding nothingToRemove() {
    return Bindings.createBooleanBinding(() -> !editor.removable(), editor.selectionProperty());
  }

  /** What is in the middle of the plan, where new things go. */
  private Vec3 middle() {
    return view.scale().place(view.getWidth() / 2, view.getHeight() / 2);
  }

  private Button palette(String id, Runnable action) {
    Button button = new Button("", new FontIcon(Feather.PLUS));
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
