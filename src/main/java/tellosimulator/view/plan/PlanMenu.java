package tellosimulator.view.plan;

import java.util.List;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.input.ContextMenuEvent;
import tellosimulator.view.text.Messages;

/** The context menu of the plan, for the selected items. Confined to the JavaFX thread. */
final class PlanMenu {

  private static final double QUARTER = Math.PI / 2;

  private final PlanEditor editor;
  private final PlanAdditions additions;
  private final PlanView view;
  private final Messages messages;
  private final ContextMenu menu = new ContextMenu();

  private PlanMenu(PlanEditor editor, PlanView view, Messages messages) {
    this.editor = editor;
    this.additions = new PlanAdditions(editor);
    this.view = view;
    this.messages = messages;
  }

  /**
   * Installs the menu. The right mouse button and the menu key open it.
   *
   * @param edit opens the properties of the selected item
   */
  static void install(PlanEditor editor, PlanView view, Messages messages, Runnable edit) {
    PlanMenu menu = new PlanMenu(editor, view, messages);
    menu.fill(edit);
    view.setOnContextMenuRequested(menu::open);
  }

  private void fill(Runnable edit) {
    menu.setId("plan-menu");
    Menu align = new Menu();
    align.setId("menu-align");
    align.textProperty().bind(messages.text("menu-align"));
    for (Alignment alignment : Alignment.values()) {
      align.getItems().add(item("align-" + alignment.word(), () -> editor.align(alignment)));
    }
    menu.getItems()
        .addAll(
            item("menu-edit", edit),
            item("menu-duplicate", additions::duplicate),
            item("menu-turn-left", () -> turn(QUARTER)),
            item("menu-turn-right", () -> turn(-QUARTER)),
            align,
            new SeparatorMenuItem(),
            item("menu-remove", editor::remove));
    menu.setOnShowing(
        shown -> {
          align.setDisable(editor.selection().size() < 2);
          menu.getItems().get(menu.getItems().size() - 1).setDisable(!editor.removable());
        });
  }

  private MenuItem item(String id, Runnable action) {
    MenuItem item = new MenuItem();
    item.setId(id);
    item.textProperty().bind(messages.text(id));
    item.setOnAction(chosen -> action.run());
    return item;
  }

  private void open(ContextMenuEvent event) {
    if (!event.isKeyboardTrigger()) {
      view.item(event.getX(), event.getY())
          .filter(item -> !editor.selection().contains(item))
          .ifPresent(item -> editor.select(List.of(item)));
    }
    if (!editor.selection().isEmpty()) {
      menu.show(view, event.getScreenX(), event.getScreenY());
    }
    event.consume();
  }

  private void turn(double angle) {
    editor.place(now -> now.turnedTo(now.heading() + angle));
  }
}
