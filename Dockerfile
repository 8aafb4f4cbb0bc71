# The project, set up, for any machine with Docker or Podman: see docs/container.md.
FROM docker.io/library/debian:12

# What neither runs nor builds a package in Python is not unpacked.
RUN printf 'path-exclude=%s\n' '/usr/share/doc/*' '/usr/share/man/*' '/usr/share/locale/*' \
        '/usr/include/boost/*' '/usr/include/eigen3/*' '/usr/lib/*/libboost*.a' '/usr/lib/*/libicu*.a' \
        '/usr/lib/gcc/*/lto1' '/usr/bin/*-lto-dump*' '/usr/bin/cpack' '/usr/bin/ctest' \
        >/etc/dpkg/dpkg.cfg.d/odometry && \
    printf 'path-include=%s\n' '/usr/share/doc/*/copyright' >>/etc/dpkg/dpkg.cfg.d/odometry && \
    useradd --create-home --shell /bin/bash learner

COPY . /odometry
WORKDIR /odometry
ENV HOME=/home/learner LANG=C.UTF-8 ODOMETRY_VIEW_HOST=0.0.0.0

# In the end, what was needed on the way goes: apt's lists, PyBullet's debug symbols and its models.
# Any user may build here, since --user may name one.
RUN PIP_NO_CACHE_DIR=1 ./ws --set-up demo --view && \
    apt-get install -q -y --no-install-recommends ca-certificates git tini && \
    apt-get clean && rm -rf /var/lib/apt/lists/* /var/cache/debconf/*-old /var/lib/dpkg/*-old /var/log/* && \
    strip --strip-debug .venv/lib/python3*/site-packages/*.so && \
    find .venv/lib/python3*/site-packages/pybullet_data -type f ! -name '*.py' -delete && \
    .venv/bin/python3 -c 'import matplotlib.font_manager' && \
    mkdir runs && chmod -R a+rwX .ws .venv runs "$HOME"

USER learner
ENTRYPOINT ["./ws"]
CMD ["demo", "--view"]
