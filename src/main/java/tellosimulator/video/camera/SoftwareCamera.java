package tellosimulator.video.camera;

import java.util.List;
import tellosimulator.scenery.Scene;
import tellosimulator.scenery.mesh.Instance;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.scenery.mesh.Shading;

/**
 * A software rasteriser that uses scanline rasterisation with a depth buffer, perspective-correct
 * bilinear mip-mapped textures, and Gouraud shading. It needs no display, graphics card or toolkit.
 * It reuses its working memory, so that later frames allocate nothing. Used by one thread at a
 * time; the cameras of several threads share a {@link RenderCache}.
 */
public final class SoftwareCamera {

  /**
   * Depth bias of panels, as a factor of 1/z. Decided: it exceeds the rounding errors of coplanar
   * surfaces by far, but still corresponds to only 2.5 mm at a distance of 5 m.
   */
  private static final float PANEL_DEPTH_BIAS = 1.0005f;

  /** Depth bias of decals, which may lie on panels. */
  private static final float DECAL_DEPTH_BIAS = 1.0007f;

  private final RenderCache cache;
  private final ModelViewProjection transform = new ModelViewProjection();
  private final ProjectedVertices vertices = new ProjectedVertices();
  private final Lighting lighting = new Lighting();
  private final ClippedPolygon polygon = new ClippedPolygon();
  private final Gradients gradients = new Gradients();
  private final PolygonRasterizer rasterizer = new PolygonRasterizer();
  private final Span span = new Span();
  private final GouraudShader gouraud = new GouraudShader(gradients, span);
  private final TextureShader.Opaque opaque = new TextureShader.Opaque(gradients, span);
  private final TextureShader.Translucent translucent =
      new TextureShader.Translucent(gradients, span);
  private final int[] triangle = new int[3];

  public SoftwareCamera(RenderCache cache) {
    this.cache = cache;
  }

  /**
   * Renders a scene. Uncovered pixels become black.
   *
   * @param frameBuffer must have the size of the camera's image and the colour space of the cache
   */
  public void draw(Scene scene, PinholeCamera camera, FrameBuffer frameBuffer) {
    CameraIntrinsics intrinsics = camera.intrinsics();
    if (frameBuffer.width() != intrinsics.width() || frameBuffer.height() != intrinsics.height()) {
      throw new IllegalArgumentException(
          "frameBuffer is "
              + frameBuffer.width()
              + " by "
              + frameBuffer.height()
              + ", but the camera has "
              + intrinsics);
    }
    frameBuffer.clear();
    setUp(camera, frameBuffer);
    List<Instance> instances = scene.instances();
    // The room is the first instance and is behind everything else. Drawn last, it fails most depth
    // tests.
    for (int i = instances.size() - 1; i >= 0; i--) {
      if (!isDrawnLast(instances.get(i))) {
        draw(instances.get(i));
      }
    }
    for (Instance instance : instances) {
      if (isDrawnLast(instance)) {
        draw(instance);
      }
    }
  }

  private static boolean isDrawnLast(Instance instance) {
    Shading shading = instance.part().material().shading();
    return shading.coplanar() || shading.blended();
  }

  private void setUp(PinholeCamera camera, FrameBuffer frameBuffer) {
    transform.setCamera(camera);
    rasterizer.setViewport(frameBuffer.width(), frameBuffer.height());
    span.ensureCapacity(frameBuffer.width());
    gouraud.setTarget(frameBuffer);
    opaque.setTarget(frameBuffer);
    translucent.setTarget(frameBuffer);
  }

  private void draw(Instance instance) {
    RenderMesh mesh = cache.mesh(instance.part());
    transform.setModel(instance);
    if (!transform.intersectsFrustum(mesh.center, mesh.radius * instance.largestScale())) {
      return;
    }
    vertices.project(mesh, transform);
    Shading shading = instance.part().material().shading();
    shading
        .lights()
        .ifPresent(lights -> lighting.illuminate(lights, mesh, instance.pose().attitude()));
    opaque.setDepthBias(shading == Shading.PANEL ? PANEL_DEPTH_BIAS : 1);
    translucent.setDepthBias(shading == Shading.DECAL ? DECAL_DEPTH_BIAS : 1);
    translucent.setOpacity(instance.opacity());
    drawTriangles(mesh, instance.part());
  }

  private void drawTriangles(RenderMesh mesh, Part part) {
    boolean lit = part.material().shading().lights().isPresent();
    TextureShader shader = part.material().shading().blended() ? translucent : opaque;
    MipMap texture = null;
    for (int i = 0; i < mesh.triangles(); i++) {
      if (!setUpTriangle(mesh, i)) {
        continue;
      }
      if (lit) {
        gradients.setLight(lighting.intensities(), mesh.normalIndices, 3 * i);
      } else {
        gradients.setFullLight();
      }
      if (mesh.solid[i] && shader == opaque) {
        gouraud.setColor(cache.color(part, mesh.texCoords[6 * i], mesh.texCoords[6 * i + 1]));
        rasterizer.rasterize(polygon, gouraud);
        continue;
      }
      if (texture == null) { // only when needed: building a mip map takes long
        texture = cache.texture(part);
        shader.setTexture(texture, lit);
      }
      gradients.setTexture(mesh.texCoords, 6 * i, texture);
      rasterizer.rasterize(polygon, shader);
    }
  }

  /**
   * Clips and culls a triangle, and sets up its polygon and gradients. Returns whether the triangle
   * may be visible.
   */
  private boolean setUpTriangle(RenderMesh mesh, int index) {
    int a = mesh.positionIndices[3 * index];
    int b = mesh.positionIndices[3 * index + 1];
    int c = mesh.positionIndices[3 * index + 2];
    int[] outcodes = vertices.outcodes;
    if ((outcodes[a] & outcodes[b] & outcodes[c]) != 0) {
      return false;
    }
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
    if (((outcodes[a] | outcodes[b] | outcodes[c]) & ProjectedVertices.NEAR) != 0) {
      polygon.clip(vertices, triangle, transform.near());
    } else if (!polygon.setTriangle(vertices, triangle)) {
      return false;
    }
    return gradients.setTriangle(vertices.homogeneous, triangle);
  }
}
