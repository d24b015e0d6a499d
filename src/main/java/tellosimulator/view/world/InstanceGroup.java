package tellosimulator.view.world;

import java.util.List;
import java.util.function.Predicate;
import javafx.scene.DepthTest;
import javafx.scene.Group;
import javafx.scene.Node;
import javafx.scene.paint.Color;
import javafx.scene.paint.PhongMaterial;
import javafx.scene.shape.MeshView;
import javafx.scene.transform.Affine;
import javafx.scene.transform.Scale;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Material;
import tellosimulator.view.fx.FxFrames;

/** Shows a list of instances, with one node for each. Confined to the JavaFX thread. */
final class InstanceGroup extends Group {

  private final FxParts parts;
  private final DepthTest decalDepth;

  /**
   * Creates an empty group.
   *
   * @param decalDepth whether decals are depth-tested; decals that are drawn directly after the
   *     surface below them do not need the test, and do not flicker if it is off
   */
  InstanceGroup(String id, FxParts parts, DepthTest decalDepth) {
    this.parts = parts;
    this.decalDepth = decalDepth;
    setId(id);
  }

  /**
   * Shows a list of instances in place of the previous one. Only nodes whose instances differ
   * change.
   */
  void show(List<Instance> instances) {
    int known = getChildren().size();
    for (int i = 0; i < instances.size(); i++) {
      if (i < known) {
        view(i).show(instances.get(i));
      } else {
        getChildren().add(new InstanceView(instances.get(i)));
      }
    }
    if (known > instances.size()) {
      getChildren().remove(instances.size(), known);
    }
  }

  /** Hides instances that cannot be seen. */
  void cull(Predicate<Instance> mayBeSeen) {
    for (int i = 0; i < getChildren().size(); i++) {
      view(i).setVisible(mayBeSeen.test(view(i).shown));
    }
  }

  private InstanceView view(int index) {
    Node view = getChildren().get(index);
    return (InstanceView) view;
  }

  /** A node that shows an instance. */
  private final class InstanceView extends MeshView {

    private final Affine pose = new Affine();
    private final Scale scale = new Scale();
    private Instance shown;

    InstanceView(Instance first) {
      getTransforms().addAll(pose, scale);
      showPart(first);
      showPlace(first);
      shown = first;
    }

    void show(Instance instance) {
      if (instance.equals(shown)) {
        return;
      }
      if (!instance.part().equals(shown.part())) {
        showPart(instance);
      } else if (instance.opacity() != shown.opacity()) {
        showOpacity(instance.opacity());
      }
      showPlace(instance);
      shown = instance;
    }

    private void showPart(Instance instance) {
      Material material = instance.part().material();
      setMesh(parts.mesh(instance.part().mesh()));
      if (material.shading().coplanar()) {
        setMaterial(parts.converted(material)); // not shared, because its opacity changes
        showOpacity(instance.opacity());
        setDepthTest(decalDepth);
      } else {
        setMaterial(parts.shared(material));
        setDepthTest(DepthTest.INHERIT);
      }
    }

    /** Sets the opacity. Measured: JavaFX expects colours that are premultiplied by alpha. */
    private void showOpacity(double opacity) {
      PhongMaterial material = (PhongMaterial) getMaterial();
      material.setDiffuseColor(new Color(opacity, opacity, opacity, opacity));
    }

    private void showPlace(Instance instance) {
      FxFrames.place(pose, instance.pose());
      Vec3 factors = instance.scale();
      scale.setX(factors.x());
      scale.setY(factors.y());
      scale.setZ(factors.z());
    }
  }
}
